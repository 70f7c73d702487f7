//! The figures and numbers of the chapter *Side by side*.

use crate::{chart, ledger, map};
use radiosity::chart::suites::pictures::{CORNELL, MIRROR, PANE};
use radiosity::chart::{Comparison, Effort, Panel, Trial};
use radiosity::film::{FalseColour, RgbImage, Shot};
use radiosity::scene::built_in;
use std::fmt::Write;
use std::sync::OnceLock;

/// The scene of the pictures.
pub const SCENE: &str = "cornell-mirror";

/// The panels of the pictures, in their order.
pub const METHODS: [&str; 5] =
    ["classical-radiosity", "ray-tracing", "radiosity", "two-pass", "reference"];

/// What `radiosity chart pictures -o book/data` wrote.
const RECORD: &str = include_str!("../data/pictures.csv");

/// The methods of the table, each at its setting.
const ROWS: [(&str, f64); 5] = [
    ("classical radiosity", 0.02),
    ("ray tracing", 4.0),
    ("radiosity", 0.02),
    ("two passes", 0.02),
    ("paths", 64.0),
];

/// Pixels along an edge of a picture, and random paths through each of the reference.
const SIZE: u32 = 160;
const PATHS: usize = 36;

/// What is asked of pass 1.
const TOLERANCE: f64 = 0.05;

/// Differences relative to the mean of the reference.
const DIFFERENCES: FalseColour = FalseColour { low: 0.01, high: 1.0 };

fn found() -> &'static Comparison {
    static FOUND: OnceLock<Comparison> = OnceLock::new();
    FOUND.get_or_init(|| {
        let scene = built_in(SCENE).expect("it is built in");
        let camera = scene.camera;
        let shot = Shot { camera, width: SIZE, height: SIZE, samples: 3 };
        let effort = Effort { tolerance: TOLERANCE, paths: PATHS, seed: 0 };
        Comparison::of(&scene, &shot, &effort, &|| 0.0, &|_, _, _| {})
    })
}

fn panel(name: &str) -> &'static Panel {
    found().panel(name).expect("it is one of the methods")
}

/// What a method shows.
pub fn picture(name: &str) -> RgbImage {
    panel(name).picture.display(found().exposure)
}

/// Where it is off.
pub fn difference(name: &str) -> RgbImage {
    DIFFERENCES.draw(&found().difference(panel(name)))
}

/// What is said below a picture; errors are those of the record.
fn caption(name: &str) -> String {
    let off = match name {
        "reference" => {
            format!("{PATHS} paths a pixel, noise {:.0} %", 100.0 * found().noise)
        }
        _ => {
            let (method, setting) = recorded(name);
            let trials = chart::trials(RECORD);
            let trial = chart::find(&trials, MIRROR, method, setting);
            format!("off by {:.1} %", 100.0 * trial.error)
        }
    };
    format!("**{}**: {}; {off}\n", name.replace('-', " "), panel(name).about)
}

/// What the record calls the method of a panel, and its setting.
fn recorded(name: &str) -> (&'static str, f64) {
    match name {
        "classical-radiosity" => ("classical radiosity", TOLERANCE),
        "ray-tracing" => ("ray tracing", 4.0),
        "radiosity" => ("radiosity", TOLERANCE),
        _ => ("two passes", TOLERANCE),
    }
}

/// How good the reference of the pictures is, and what the errors are taken from.
fn reference() -> String {
    let trials = chart::trials(RECORD);
    let walks = chart::find(&trials, MIRROR, "two passes", TOLERANCE).uncertainty;
    let off = found().difference(panel("two-pass"));
    let counted = off.pixels.iter().zip(&found().counts).filter(|(_, counts)| **counts);
    let mut squares: Vec<f64> = counted.map(|(d, _)| d.x * d.x).collect();
    squares.sort_by(|a, b| b.total_cmp(a));
    let few = squares.len() / 100;
    let share = squares[..few].iter().sum::<f64>() / squares.iter().sum::<f64>();
    format!(
        "**The reference is a poor one here.** The noise of {PATHS} paths a pixel is {:.0} % of the \
         mean. Hardly ever does a path come by the mirror upon the lamp, and then its pixel is far too \
         bright: a hundredth of the pixels makes {:.0} % of what the picture of two passes differs \
         from it (squared). Such a reference can tell who is off by half, and not who is off by a \
         tenth. So the errors under the pictures are not taken from it, but from [longer \
         measurements](#what-it-costs), whose own noise is {:.1} %.",
        100.0 * found().noise,
        100.0 * share,
        100.0 * walks
    )
}

/// Whose light the reference shows.
fn classes() -> String {
    let mut text =
        String::from("| light | paths | carried by | share |\n|---|---|---|---|\n");
    let sum = found().classes.total().element_sum();
    for row in found().classes.rows() {
        let (name, word, owner) =
            (row.class.name(), row.class.word(), row.class.owner().name());
        let share = 100.0 * row.mean.element_sum() / sum;
        let word = word.replace('|', "\\|");
        let _ = writeln!(text, "| {name} | {word} | {owner} | {share:.0} % |");
    }
    text
}

/// The record as a table.
fn table() -> String {
    let mut text = String::from(
        "| scene | method | CPU s | error | brightness | paths need, CPU s |\n\
         |---|---|---|---|---|---|\n",
    );
    let trials = chart::trials(RECORD);
    for scene in [CORNELL, MIRROR, PANE] {
        let paths = chart::find(&trials, scene, "paths", 64.0);
        for (method, setting) in ROWS {
            let fits = |t: &&Trial| {
                (t.scene.as_str(), t.method.as_str(), t.setting)
                    == (scene, method, setting)
            };
            // Where nothing shines, nothing was dulled.
            let Some(t) = trials.iter().find(fits) else { continue };
            let error = match t.error > t.uncertainty {
                true => format!("{:.1} %", 100.0 * t.error),
                false => format!("below {:.1} %", 100.0 * t.uncertainty),
            };
            let error_told = t.error.max(t.uncertainty);
            let _ = writeln!(
                text,
                "| `{scene}` | {method} | {:.2} | {error} | {:.2} | {:.2} |",
                t.seconds,
                1.0 + t.energy.unwrap_or_default(),
                paths.seconds * (paths.error / error_told).powi(2),
            );
        }
    }
    text
}

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    let FalseColour { low, high } = DIFFERENCES;
    let mut files = vec![
        ("generated/side-classes.md".to_string(), classes()),
        ("generated/side-table.md".into(), table()),
        ("generated/side-noise.md".into(), reference()),
        ("generated/side-key.md".into(), map::key(low, high, 5, map::per_cent)),
        ("generated/side-ledger.md".into(), ledger::table(&found().solution)),
    ];
    for name in METHODS {
        files.push((format!("generated/side-{name}.md"), caption(name)));
    }
    files
}
