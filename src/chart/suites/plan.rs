//! The plan: the error asked for, the error certified and the error that there is, and what
//! they cost - beside the cheapest setting that would have done, known in hindsight.
//!
//! Who knows the answer can try settings until one just suffices. A plan has to choose
//! beforehand, and must prove that it suffices; so the best in hindsight is certified, too.

use super::field::{LinearLight, Truth};
use crate::certificate::{Certificate, Sampling};
use crate::chart::{Bench, ChartView, Column, Contest, Method, Suite, Trial, WorkDone};
use crate::field::{Fineness, Pass1, Smooth};
use crate::mesh::Element;
use crate::plan::{Plan, Planned};
use crate::room::Room;
use crate::scene::{Scene, built_in};
use crate::solution::{Attempt, Goal, sampling_for};
use std::cell::RefCell;

/// This suite.
pub const SUITE: Suite = Suite {
    name: "plan",
    about: "error asked for and error given, and what the best setting would have cost",
    measure,
    views: &[
        ChartView {
            title: "Error asked for, certified and measured against the time it took",
            across: (Column::Seconds, "CPU seconds"),
            ..view("plan-cornell", |t| t.scene == "cornell" && t.method != LIKELY)
        },
        ChartView {
            title: "Error certified against the error asked for",
            across: (Column::Setting, "error asked for"),
            ..view("plan-certified", |t| {
                SHOWN.contains(&t.scene.as_str()) && t.method == CERTIFIED
            })
        },
    ],
};

const fn view(file: &'static str, shows: fn(&Trial) -> bool) -> ChartView {
    ChartView {
        file,
        title: "",
        across: (Column::Setting, ""),
        upward: (Column::Error, "relative error"),
        least: 1e-4,
        shows,
    }
}

/// Built-in scenes that are planned: all that have something to solve, but for those where
/// noise is left over (the mirror corridor, the glossy floor, the glass ball, the gallery)
/// and the regular Cornell box, which is as the other. Behind the translucent screen 1 % is
/// not reached.
pub const SCENES: [&str; 10] = [
    "cornell",
    "facing-squares",
    "l-room",
    "indirect-room",
    "mirror-room",
    "cornell-mirror",
    "cornell-pane",
    "glazed-room",
    "sky-room",
    "translucent-screen",
];

/// Those of the chart.
const SHOWN: [&str; 5] =
    ["cornell", "facing-squares", "l-room", "mirror-room", "sky-room"];

/// Errors asked for, of plan and hindsight.
pub const TOLERANCES: [f64; 3] = [0.05, 0.02, 0.01];

/// Rooms of which the plan is asked for more, and for less.
pub const WIDER: [&str; 2] = ["cornell", "l-room"];
const WIDE: [f64; 5] = [0.1, 0.05, 0.02, 0.01, 0.005];

/// What the plan's field is off by.
pub const PLAN: &str = "plan: measured";
/// The upper end of the plan's certificate.
pub const CERTIFIED: &str = "plan: certified";
/// The plan's likely error.
pub const LIKELY: &str = "plan: likely";
/// The cheapest setting that suffices, with a certificate.
pub const BEST: &str = "best: certified";
/// The same without.
pub const BARE: &str = "best: not certified";

/// The error asked for of the truth.
const TRUTH: f64 = 0.004;

fn measure(bench: &Bench) -> Vec<Trial> {
    let of = |name: &&str| {
        let asked = if WIDER.contains(name) { &WIDE[..] } else { &TOLERANCES };
        contest(name, asked, &TOLERANCES, bench)
    };
    SCENES.iter().flat_map(of).collect()
}

/// On the built-in scene of this name the plan for all errors `asked`, and what is best in
/// hindsight for some.
pub fn contest(
    name: &str,
    asked: &[f64],
    tolerances: &[f64],
    bench: &Bench,
) -> Vec<Trial> {
    let scene = built_in(name).expect("it is built in");
    (bench.progress)(&format!("plan: {name}, hindsight"), 0);
    let truth = Truth::of(&scene, TRUTH);
    let best = Hindsight::of(&scene, &truth, tolerances);
    let told = RefCell::new(vec![]);
    let mut trials =
        Contest::new(name, truth.uncertainty, |light: &LinearLight| truth.judge(light))
            .with(planned(&scene, asked, &told))
            .with(best.method(&scene, BEST))
            .with(best.method(&scene, BARE))
            .run(SUITE.name, bench);
    for (method, of) in
        [(CERTIFIED, (|c| c.high) as fn(&Certificate) -> f64), (LIKELY, |c| c.error)]
    {
        let told = told.borrow();
        let said = |t: &Trial| {
            let (_, certificate) =
                told.iter().rfind(|(asked, _)| *asked == t.setting)?;
            Some(Trial { method: method.into(), error: of(certificate), ..t.clone() })
        };
        let plans = trials.iter().filter(|t| t.method == PLAN);
        let plans: Vec<Trial> = plans.filter_map(said).collect();
        trials.extend(plans);
    }
    trials
}

fn planned<'a>(
    scene: &'a Scene,
    tolerances: &[f64],
    told: &'a RefCell<Vec<(f64, Certificate)>>,
) -> Method<'a, LinearLight> {
    Method::new(PLAN, tolerances, |tolerance, _| {
        let room = Room::of(scene);
        let quiet = crate::work::Work::quiet();
        let done = Plan::of(&room, tolerance).run(&room, &Goal::default(), &quiet);
        let Planned { solution, .. } = done.expect("built-in scenes can be solved");
        told.borrow_mut().push((tolerance, solution.certificate));
        let (field, radiosity) = (solution.field, solution.vertex_radiosity);
        let light = LinearLight { mesh: field.mesh, radiosity, ledger: field.ledger };
        let work = |attempt| of_attempt(attempt, &sampling_for(tolerance));
        (light, solution.attempts.iter().map(work).fold(WorkDone::default(), sum))
    })
}

/// What one attempt of a plan is, with its certificate.
fn of_attempt(pass: &Attempt, sampling: &Sampling) -> WorkDone {
    let (looks, cells) = (pass.rows as u64, cells(&pass.fineness));
    WorkDone {
        factors: looks * pass.patches as u64,
        pixels: looks * cells,
        rays: rays(sampling),
        steps: looks,
        bytes: (pass.elements * size_of::<Element>()) as u64,
    }
}

fn sum(a: WorkDone, b: WorkDone) -> WorkDone {
    WorkDone {
        factors: a.factors + b.factors,
        pixels: a.pixels + b.pixels,
        rays: a.rays + b.rays,
        steps: a.steps + b.steps,
        bytes: a.bytes + b.bytes,
    }
}

fn cells(how: &Fineness) -> u64 {
    3 * u64::from(how.hemicube).pow(2)
}

/// Rays of a certificate: two gathers at each point.
fn rays(sampling: &Sampling) -> u64 {
    2 * (sampling.points * sampling.rays) as u64
}

// ANCHOR: cost
/// What work costs, by counts, and so the same on any machine. About microseconds: of cells
/// drawn, patches seen, hemicubes begun, elements lit, and rays of certificates.
pub fn cost(work: &WorkDone) -> f64 {
    let elements = work.bytes as f64 / size_of::<Element>() as f64;
    0.01 * work.pixels as f64
        + 0.16 * work.factors as f64
        + 20.0 * work.steps as f64
        + 10.0 * elements
        + 0.5 * work.rays as f64
}
// ANCHOR_END: cost

/// The same without certificates.
pub fn cost_of_light(work: &WorkDone) -> f64 {
    cost(&WorkDone { rays: 0, ..*work })
}

/// Fixed settings, all tried on one scene.
#[derive(Debug)]
pub struct Hindsight {
    /// For each tolerance the cheapest that suffices, and its work; none may.
    pub best: Vec<(f64, Option<(Fineness, WorkDone)>)>,
}

/// Patches all over the scene.
const PATCHES: [f64; 5] = [60.0, 120.0, 200.0, 350.0, 600.0];

/// Cells along the edge of a hemicube.
const CELLS: [u32; 2] = [32, 16];

/// Errors that interpolating direct light and reflected light may make.
const BENDS: [f64; 4] = [0.1, 0.04, 0.016, 0.006];

impl Hindsight {
    /// Tries them, coarse ones first; what is finer in all than one that cost more than
    /// what suffices will cost more, too.
    pub fn of(scene: &Scene, truth: &Truth, tolerances: &[f64]) -> Hindsight {
        let mut found =
            Hindsight { best: tolerances.iter().map(|t| (*t, None)).collect() };
        let mut dear: Vec<Fineness> = vec![];
        for how in settings(scene) {
            let finer = |d: &Fineness| {
                how.hemicube >= d.hemicube
                    && how.patch <= d.patch
                    && how.direct <= d.direct
            };
            if dear.iter().any(finer) {
                continue;
            }
            let (light, work) = run(scene, &how);
            match found.is_cheap(&work) {
                true => found.enter(truth.judge(&light).error, how, work),
                false => dear.push(how),
            }
        }
        found
    }

    /// Is there a tolerance for which nothing cheaper suffices?
    fn is_cheap(&self, work: &WorkDone) -> bool {
        let cheaper = |best: &Option<(Fineness, WorkDone)>| {
            best.is_none_or(|(_, known)| cost(work) < cost(&known))
        };
        self.best.iter().any(|(_, best)| cheaper(best))
    }

    fn enter(&mut self, error: f64, how: Fineness, work: WorkDone) {
        for (tolerance, best) in &mut self.best {
            let better = best.is_none_or(|(_, known)| cost(&work) < cost(&known));
            if error <= *tolerance && better {
                *best = Some((how, work));
            }
        }
    }

    fn method<'a>(
        &'a self,
        scene: &'a Scene,
        name: &'static str,
    ) -> Method<'a, LinearLight> {
        let found = self.best.iter().filter(|(_, best)| best.is_some());
        let settings: Vec<f64> = found.map(|(tolerance, _)| *tolerance).collect();
        Method::new(name, &settings, move |tolerance, _| {
            let best = self.best.iter().find(|(t, _)| *t == tolerance);
            let (how, _) = best.and_then(|(_, b)| *b).expect("it is a setting");
            let (light, mut work) = run(scene, &how);
            if name == BEST {
                let sampling = sampling_for(tolerance);
                let _ = light.certified(&Room::of(scene), sampling);
                work.rays = rays(&sampling);
            }
            (light, work)
        })
    }
}

/// All that are tried.
fn settings(scene: &Scene) -> impl Iterator<Item = Fineness> {
    let area: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
    let usual = Smooth.first(&Room::of(scene), 0.01);
    let of = move |hemicube, patches: f64, bend| Fineness {
        patch: (area / patches).sqrt(),
        hemicube,
        direct: bend,
        reflected: bend,
        solver: 0.02 * bend,
        ..usual
    };
    let bends = move |hemicube, patches| {
        BENDS.into_iter().map(move |bend| of(hemicube, patches, bend))
    };
    let patches = move |hemicube| {
        PATCHES.into_iter().flat_map(move |patches| bends(hemicube, patches))
    };
    CELLS.into_iter().flat_map(patches)
}

fn run(scene: &Scene, how: &Fineness) -> (LinearLight, WorkDone) {
    let quiet = crate::work::Work::quiet();
    let found = Smooth.field(&Room::of(scene), how, &quiet);
    let looks = found.rows as u64;
    let work = WorkDone {
        factors: looks * found.patches as u64,
        pixels: looks * cells(how),
        steps: looks,
        bytes: (found.mesh.elements.len() * size_of::<Element>()) as u64,
        ..WorkDone::default()
    };
    (LinearLight::smooth(scene, found), work)
}
