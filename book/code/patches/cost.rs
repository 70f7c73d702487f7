//! What the chapter says of its chart, from measurements that are kept with their date.

use crate::chart;
use radiosity::chart::Trial;
use radiosity::chart::suites::meshes::{ALL, CORNELL, INDIRECT, MARKED};
use std::fmt::Write;

/// What `radiosity chart meshes` wrote.
const CSV: &str = include_str!("../../data/meshes.csv");

/// The trials of a method on a scene, in order.
fn line<'t>(
    trials: &'t [Trial],
    scene: &str,
    method: &str,
) -> impl Iterator<Item = &'t Trial> + Clone {
    trials.iter().filter(move |t| t.scene == scene && t.method == method)
}

/// The third round of marked elements: how many, how far off, and how many times as many
/// elements it takes to do as well when all are split: on that line, between two marks.
pub fn gain(scene: &'static str) -> (f64, f64, f64) {
    let trials = &chart::trials(CSV);
    let third = line(trials, scene, MARKED).nth(2).expect("there are three rounds");
    let all: Vec<&Trial> = line(trials, scene, ALL).collect();
    let between = |w: &[&Trial]| {
        let t = (w[0].error / third.error).ln() / (w[0].error / w[1].error).ln();
        w[0].setting * (w[1].setting / w[0].setting).powf(t)
    };
    let crossing =
        all.windows(2).find(|w| w[0].error >= third.error && w[1].error <= third.error);
    let needed = crossing.map_or(f64::INFINITY, between);
    (third.setting, third.error, needed / third.setting)
}

/// What the chart says.
pub fn text() -> String {
    let [(n, off, by), (elements, room, indirect)] = [CORNELL, INDIRECT].map(gain);
    format!(
        "With {n} elements the Cornell box is {:.1} % off; split all over it takes {by:.1} \
         times as many. The room that is lit through a gap is {:.1} % off with {elements} \
         elements, and takes {indirect:.1} times as many.\n",
        100.0 * off,
        100.0 * room,
    )
}

/// The factors of the Cornell box, against all between its elements.
pub fn table() -> String {
    let mut text = String::from(
        "| elements *n* | error | rows kept: *m n* | computed | all pairs: *n*² |\n\
         |---|---|---|---|---|\n",
    );
    let trials = chart::trials(CSV);
    for t in line(&trials, CORNELL, MARKED) {
        let kept = t.work.bytes as f64 / size_of::<(u32, f64)>() as f64;
        let [kept, computed, all] =
            [kept, t.work.factors as f64, t.setting.powi(2)].map(|n| 1e-6 * n);
        let _ = writeln!(
            text,
            "| {} | {:.1} % | {kept:.2} M | {computed:.2} M | {all:.2} M |",
            t.setting,
            100.0 * t.error,
        );
    }
    text
}
