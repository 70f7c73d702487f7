//! The figures and numbers of the chapter *What does this scene need?*.

use crate::{chart, ledger};
use radiosity::chart::Trial;
use radiosity::chart::suites::plan::{
    BARE, BEST, CERTIFIED, LIKELY, PLAN, cost, cost_of_light,
};
use radiosity::film::{RgbImage, Shot};
use radiosity::plan::{Plan, Planned, Predicted};
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in, builtins};
use radiosity::solution::Goal;
use radiosity::work::Work;
use std::fmt::Write;
use std::sync::OnceLock;

/// The errors that were asked for of the three meshes.
pub const ASKED: [f64; 3] = [0.2, 0.05, 0.02];

/// What `radiosity chart plan` wrote.
const RECORD: &str = include_str!("../data/plan.csv");

/// Pixels along an edge of a picture.
const SIZE: u32 = 200;

fn cornell() -> &'static Scene {
    static SCENE: OnceLock<Scene> = OnceLock::new();
    SCENE.get_or_init(|| built_in("cornell").expect("it is built in"))
}

/// The Cornell box as it was planned and done.
fn done() -> &'static [Planned; 3] {
    static DONE: OnceLock<[Planned; 3]> = OnceLock::new();
    let room = Room::of(cornell());
    let plan = |asked| {
        let (plan, quiet) = (Plan::of(&room, asked), Work::quiet());
        plan.run(&room, &Goal::default(), &quiet).expect("it can be solved")
    };
    DONE.get_or_init(|| ASKED.map(plan))
}

/// The mesh that came of asking for [`ASKED`]`[k]`, over its light.
pub fn picture(k: usize) -> RgbImage {
    let light = &done()[k].solution;
    let camera = cornell().camera;
    let shot = Shot { camera, width: SIZE, height: SIZE, samples: 2 };
    let picture = shot.smooth(&light.field.mesh, &light.vertex_radiosity);
    let exposure = picture.auto_exposure();
    shot.with_mesh(picture.display(exposure), &light.field.mesh)
}

/// What is said below that picture.
fn caption(k: usize) -> String {
    let light = &done()[k].solution;
    format!(
        "asked for {} %: {} patches, {} elements, certified to {:.1} %",
        100.0 * ASKED[k],
        light.field.patches,
        light.field.mesh.elements.len(),
        100.0 * light.certificate.high
    )
}

/// What `radiosity explain` says of a scene.
fn explained(name: &str) -> String {
    let scene = built_in(name).expect("it is built in");
    let plan = Plan::of(&Room::of(&scene), 0.01);
    let lines: String = plan.decisions.iter().map(|d| d.to_string()).collect();
    format!("```text\n{lines}```\n")
}

/// Where what does not come to a surface goes, in the Cornell box.
fn lost() -> String {
    let survey = Plan::of(&Room::of(cornell()), 0.01).survey;
    let (leaves, backs) = (100.0 * survey.escaping, 100.0 * survey.on_backs);
    format!(
        "(Of what the surfaces send {leaves:.1} % leave, {backs:.1} % fall on backs, which are \
         black, and {:.1} % come to another surface.)",
        100.0 - leaves - backs
    )
}

/// The plans for all plain built-in scenes.
fn plans() -> String {
    let mut text = String::from(
        "| scene | leaves at once | in the way | mean ρ | bounces | shadowed | patches | \
         hemicubes | elements |\n|---|---|---|---|---|---|---|---|---|\n",
    );
    for scene in builtins().iter().map(|b| (b.make)()).filter(Scene::is_plain) {
        let plan = Plan::of(&Room::of(&scene), 0.01);
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

/// One plan of the record: asked, done, predicted, and the best in hindsight.
struct Row<'t> {
    done: &'t Trial,
    certified: f64,
    likely: f64,
    predicted: Predicted,
    best: Option<&'t Trial>,
    bare: Option<&'t Trial>,
}

fn rows(trials: &[Trial]) -> Vec<Row<'_>> {
    trials.iter().filter(|t| t.method == PLAN).filter_map(|t| row(trials, t)).collect()
}

fn row<'t>(trials: &'t [Trial], done: &'t Trial) -> Option<Row<'t>> {
    let of = |method: &str| {
        let same = |t: &&Trial| {
            t.scene == done.scene && t.setting == done.setting && t.method == method
        };
        trials.iter().find(same)
    };
    let scene = built_in(&done.scene).ok()?;
    Some(Row {
        done,
        certified: of(CERTIFIED)?.error,
        likely: of(LIKELY)?.error,
        predicted: Plan::of(&Room::of(&scene), done.setting).predicted,
        best: of(BEST),
        bare: of(BARE),
    })
}

impl Row<'_> {
    /// How many times the time of the best, its work, and its work without certificates.
    fn ratios(&self) -> Option<[f64; 3]> {
        let (best, bare) = (self.best?, self.bare?);
        Some([
            self.done.seconds / best.seconds,
            cost(&self.done.work) / cost(&best.work),
            cost_of_light(&self.done.work) / cost_of_light(&bare.work),
        ])
    }

    fn asked(&self) -> String {
        format!("{} %", (1e3 * self.done.setting).round() / 10.0)
    }
}

/// Asked and given.
fn given(rows: &[Row]) -> String {
    let mut text = String::from(
        "| scene | asked | certified | likely | measured | hemicubes (predicted) | CPU s \
         (predicted) |\n|---|---|---|---|---|---|---|\n",
    );
    for row in rows {
        let [certified, likely, measured] =
            [row.certified, row.likely, row.done.error].map(|e| 100.0 * e);
        let _ = writeln!(
            text,
            "| `{}` | {} | {certified:.2} % | {likely:.2} % | {measured:.2} % | {} ({:.0}) | \
             {:.2} ({:.1}) |",
            row.done.scene,
            row.asked(),
            row.done.work.steps,
            row.predicted.hemicubes,
            row.done.seconds,
            row.predicted.seconds
        );
    }
    text
}

/// The plan beside the best in hindsight.
fn hindsight(rows: &[Row]) -> String {
    let mut text = String::from(
        "| scene | asked | plan, CPU s | best, certified | best, not certified | times the \
         time | times the work | without certificates |\n|---|---|---|---|---|---|---|---|\n",
    );
    for row in rows {
        let (Some(best), Some(bare)) = (row.best, row.bare) else { continue };
        let Some([time, work, light]) = row.ratios() else { continue };
        let _ = writeln!(
            text,
            "| `{}` | {} | {:.2} | {:.2} | {:.2} | {time:.1} | {work:.1} | {light:.1} |",
            row.done.scene,
            row.asked(),
            row.done.seconds,
            best.seconds,
            bare.seconds
        );
    }
    text
}

/// What that table says.
fn regret(rows: &[Row]) -> String {
    let met = rows.iter().filter(|r| r.certified <= r.done.setting);
    let ratios: Vec<[f64; 3]> = met.filter_map(Row::ratios).collect();
    let sum = |of: &dyn Fn(&Row) -> Option<f64>| -> f64 {
        rows.iter().filter(|r| r.best.is_some()).filter_map(of).sum()
    };
    let plan = sum(&|r| Some(r.done.seconds));
    let [best, bare] =
        [sum(&|r| r.best.map(|t| t.seconds)), sum(&|r| r.bare.map(|t| t.seconds))];
    let worst = |k: usize| ratios.iter().map(|r| r[k]).fold(0.0, f64::max);
    format!(
        "Over all of it the plan takes **{:.1} times** the time of the best in hindsight, \
         certificates included; where it meets what was asked, {:.1} times at worst, and by \
         counts {:.1} times. (Where it does not, it has tried several times.) The light alone, \
         without certificates, is {:.1} times the work at worst: where the proof costs most, \
         the plan need not be stingy with light. Whoever needs no proof would have been done in \
         {:.2} of the plan's time.\n",
        plan / best,
        worst(0),
        worst(1),
        worst(2),
        bare / plan
    )
}

/// What the record says of the worst that happened.
fn missed(rows: &[Row]) -> String {
    let off = |row: &&Row| row.done.work.steps as f64 / row.predicted.hemicubes;
    let Some(worst) = rows.iter().max_by(|a, b| off(a).total_cmp(&off(b))) else {
        return String::new();
    };
    let mut text = format!(
        "**`{}`, asked for {}: {:.1} times the hemicubes that were predicted, {:.1} s \
         instead of {:.1}.**",
        worst.done.scene,
        worst.asked(),
        off(&worst),
        worst.done.seconds,
        worst.predicted.seconds
    );
    for row in rows.iter().filter(|row| row.certified > row.done.setting) {
        let _ = write!(
            text,
            " And `{}`, asked for {}, came to {:.2} %.",
            row.done.scene,
            row.asked(),
            100.0 * row.certified
        );
    }
    text.push('\n');
    text
}

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    let trials = chart::trials(RECORD);
    let rows = rows(&trials);
    let mut files = vec![
        ("generated/needs-cornell.md".to_string(), explained("cornell")),
        ("generated/needs-lost.md".into(), lost()),
        ("generated/needs-furnace.md".into(), explained("furnace")),
        ("generated/needs-plans.md".into(), plans()),
        ("generated/needs-given.md".into(), given(&rows)),
        ("generated/needs-hindsight.md".into(), hindsight(&rows)),
        ("generated/needs-regret.md".into(), regret(&rows)),
        ("generated/needs-missed.md".into(), missed(&rows)),
        ("generated/needs-ledger.md".into(), ledger::table(&done()[2].solution)),
    ];
    for k in 0..ASKED.len() {
        files.push((format!("generated/needs-mesh-{k}.md"), caption(k)));
    }
    files
}
