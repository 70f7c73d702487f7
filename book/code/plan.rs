//! The figures and numbers of the chapter *What does this scene need?*.

use crate::{chart, ledger};
use radiosity::film::{RgbImage, Shot};
use radiosity::plan::{Plan, Planned, Predicted};
use radiosity::scene::{Scene, built_in, builtins};
use radiosity::solve::Ask;
use std::fmt::Write;
use std::sync::OnceLock;

/// The errors that were asked for of the three meshes.
pub const ASKED: [f64; 3] = [0.2, 0.05, 0.02];

/// What `cargo run --release -p book --bin measure-plan` printed.
const RECORD: &str = include_str!("../data/plan-2026-11-22.csv");

/// Pixels along an edge of a picture.
const SIZE: u32 = 200;

fn cornell() -> &'static Scene {
    static SCENE: OnceLock<Scene> = OnceLock::new();
    SCENE.get_or_init(|| built_in("cornell").expect("it is built in"))
}

/// The Cornell box as it was planned and done.
fn done() -> &'static [Planned; 3] {
    static DONE: OnceLock<[Planned; 3]> = OnceLock::new();
    let plan = |asked| Plan::of(cornell(), asked).run(&Ask::default(), &|_, _, _| {});
    DONE.get_or_init(|| ASKED.map(plan))
}

/// The mesh that came of asking for [`ASKED`]`[k]`, over its light.
pub fn picture(k: usize) -> RgbImage {
    let light = &done()[k].solution;
    let camera = cornell().camera;
    let shot = Shot { camera, width: SIZE, height: SIZE, samples: 2 };
    let picture = shot.smooth(&light.mesh, &light.vertex_radiosity);
    let exposure = picture.auto_exposure();
    shot.with_mesh(picture.display(exposure), &light.mesh)
}

/// What is said below that picture.
fn caption(k: usize) -> String {
    let light = &done()[k].solution;
    format!(
        "asked for {} %: {} patches, {} elements, certified to {:.1} %",
        100.0 * ASKED[k],
        light.patches,
        light.mesh.elements.len(),
        100.0 * light.certificate.high
    )
}

/// What `radiosity explain` says of a scene.
fn explained(name: &str) -> String {
    let scene = built_in(name).expect("it is built in");
    let plan = Plan::of(&scene, 0.01);
    let lines: String = plan.decisions.iter().map(|d| d.to_string()).collect();
    format!("```text\n{lines}```\n")
}

/// The plans for all plain built-in scenes.
fn plans() -> String {
    let mut text = String::from(
        "| scene | leaves at once | in the way | mean ρ | bounces | shadowed | patches | \
         hemicubes | elements |\n|---|---|---|---|---|---|---|---|---|\n",
    );
    for scene in builtins().iter().map(|b| (b.make)()).filter(Scene::is_plain) {
        let plan = Plan::of(&scene, 0.01);
        let (seen, work) = (&plan.survey, plan.predicted);
        let shadows = plan.decisions.iter().find(|d| d.what == "shadows");
        let shadowed = match shadows {
            Some(d) => format!("{:.0} %", 100.0 * d.value),
            None => "-".into(),
        };
        let _ = writeln!(
            text,
            "| `{}` | {:.0} % | {} | {:.2} | {} | {shadowed} | {} | {:.0} | {:.0} |",
            scene.name,
            100.0 * seen.escaping_lamps,
            seen.blockers,
            seen.mean_reflectance,
            seen.bounces(0.01),
            work.patches,
            work.hemicubes,
            work.elements
        );
    }
    text
}

/// A line of the record, and what is predicted for it.
struct Row {
    scene: &'static str,
    asked: &'static str,
    /// `milliseconds,at_most,likely,passes,patches,hemicubes,elements`
    spent: Vec<f64>,
    predicted: Predicted,
}

fn rows() -> Vec<Row> {
    let row = |line: &'static str| {
        let mut cells = line.split(',');
        let (scene, asked) = (cells.next()?, cells.next()?);
        let spent: Vec<f64> = cells.filter_map(|x| x.parse().ok()).collect();
        let tolerance: f64 = asked.trim_end_matches(" %").parse().ok()?;
        let predicted = Plan::of(&built_in(scene).ok()?, tolerance / 100.0).predicted;
        (spent.len() == 7).then_some(Row { scene, asked, spent, predicted })
    };
    RECORD.lines().skip(1).filter_map(row).collect()
}

/// Asked and given.
fn given() -> String {
    let mut text = String::from(
        "| scene | asked | certified | likely | passes | hemicubes (predicted) | elements \
         (predicted) | CPU s (predicted) |\n|---|---|---|---|---|---|---|---|\n",
    );
    for Row { scene, asked, spent, predicted } in rows() {
        let _ = writeln!(
            text,
            "| `{scene}` | {asked} | {:.2} % | {:.2} % | {} | {} ({:.0}) | {} ({:.0}) | \
             {:.1} ({:.1}) |",
            100.0 * spent[1],
            100.0 * spent[2],
            spent[3],
            spent[5],
            predicted.hemicubes,
            spent[6],
            predicted.elements,
            spent[0] / 1e3,
            predicted.seconds
        );
    }
    text
}

/// What the record says of the worst that happened.
fn missed() -> String {
    let off = |row: &Row| row.spent[5] / row.predicted.hemicubes;
    let rows = rows();
    let Some(worst) = rows.iter().max_by(|a, b| off(a).total_cmp(&off(b))) else {
        return String::new();
    };
    let mut text = format!(
        "**`{}`, asked for {}: {:.0} times the hemicubes that were predicted, {:.0} s \
         instead of {:.0}.**",
        worst.scene,
        worst.asked,
        off(worst),
        worst.spent[0] / 1e3,
        worst.predicted.seconds
    );
    let asked = |row: &Row| row.asked.trim_end_matches(" %").parse().unwrap_or(0.0);
    for row in rows.iter().filter(|row| 100.0 * row.spent[1] > asked(row)) {
        let _ = write!(
            text,
            " And `{}`, asked for {}, came to {:.2} %.",
            row.scene,
            row.asked,
            100.0 * row.spent[1]
        );
    }
    text.push('\n');
    text
}

fn cost() -> String {
    chart::svg(
        "Certified error against time, for errors asked for from 10 % to 0.5 %",
        &chart::points(RECORD).unwrap_or_default(),
        "milliseconds, one thread",
        "certified error",
    )
}

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/needs-cornell.md".to_string(), explained("cornell")),
        ("generated/needs-furnace.md".into(), explained("furnace")),
        ("generated/needs-plans.md".into(), plans()),
        ("generated/needs-given.md".into(), given()),
        ("generated/needs-missed.md".into(), missed()),
        ("generated/needs-cost.svg".into(), cost()),
        ("generated/needs-ledger.md".into(), ledger::table(&done()[2].solution)),
    ];
    for k in 0..ASKED.len() {
        files.push((format!("generated/needs-mesh-{k}.md"), caption(k)));
    }
    files
}
