//! Solvers: the race to one accuracy, the way to the first picture, and smooth light
//! against random walks.

use crate::chart::patches::Patches;
use crate::chart::race::{Race, contestants};
use crate::chart::{
    Bench, ChartView, Column, Contest, Method, Suite, Trial, Verdict, WorkDone,
};
use crate::form_factor::analytic::Analytic;
use crate::form_factor::hemicube::Hemicube;
use crate::form_factor::{Cached, FormFactors, Matrix};
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::scene::built_in;
use crate::solve::{Brightest, Enclosure, GaussSeidel, Overshoot, Shoot, Solver};

/// This suite.
pub const SUITE: Suite = Suite {
    name: "solvers",
    about: "the race of the solvers; the first picture; patches against random walks",
    measure,
    views: &[
        ChartView {
            file: "solvers-time",
            title: "Processor time of each solver against the number of bounces",
            across: (Column::Setting, "1/(1 − ρ): how often light bounces"),
            upward: (Column::Seconds, "CPU seconds to an error of 1e-4"),
            least: 0.0,
            shows: in_race,
        },
        ChartView {
            file: "solvers-work",
            title: "Transfers between elements against the number of bounces",
            across: (Column::Setting, "1/(1 − ρ): how often light bounces"),
            upward: (Column::Factors, "transfers to an error of 1e-4"),
            least: 0.0,
            shows: in_race,
        },
        ChartView {
            file: "first-picture",
            title: "Relative error of the radiosity against the time since the start",
            across: (Column::Seconds, "CPU seconds since the start, factors included"),
            upward: (Column::Error, "relative error"),
            least: 1e-3,
            shows: |t| t.scene == FIRST_PICTURE,
        },
        ChartView {
            file: "patches-or-walks",
            title: "Error of the patches' irradiance against processor time",
            across: (Column::Seconds, "CPU seconds"),
            upward: (Column::Error, "relative error of 8 × 8 patches a wall"),
            least: 1e-4,
            shows: |t| t.scene == PATCHES,
        },
    ],
};

/// Scenes of the suite.
pub const RACE: &str = "race in the L-shaped room";
/// See [`RACE`].
pub const FIRST_PICTURE: &str = "Cornell box from nothing";
/// See [`RACE`].
pub const PATCHES: &str = "patches of the Cornell box";

/// Who came in, in the race.
fn in_race(t: &Trial) -> bool {
    t.scene == RACE && t.error <= ACCURACY
}

/// The longest edge of an element in the race, m.
const EDGE: f64 = 0.6;

/// What the solvers are to reach.
pub const ACCURACY: f64 = 1e-4;

/// How often light bounces: reflectances 0.5, 0.9, 0.99 and 0.999.
pub const BOUNCES: [f64; 4] = [2.0, 10.0, 100.0, 1000.0];

fn measure(bench: &Bench) -> Vec<Trial> {
    [race(bench), first_picture(bench), patches(bench)].concat()
}

/// Who did not come in has an error above [`ACCURACY`].
fn race(bench: &Bench) -> Vec<Trial> {
    let race = Race::new(EDGE, ACCURACY);
    let contestants = contestants();
    let mut contest = Contest::new(RACE, 0.0, |bound: &f64| Verdict::of(*bound));
    for contestant in &contestants {
        contest = contest.with(Method::new(contestant.name, &BOUNCES, |bounces, _| {
            let finish = race.run(contestant, 1.0 - 1.0 / bounces);
            (finish.bound, finish.work)
        }));
    }
    contest.run(SUITE.name, bench)
}

/// Longest edge of an element of the Cornell box, m, for the first picture.
const FIRST_EDGE: f64 = 0.05;

/// Cells along an edge of its hemicubes.
const CELLS: u32 = 256;

const SHOTS: [f64; 9] = [10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 4000.0];

/// From a scene without any form factors to its radiosity: how good is the picture, and
/// when? The truth are analytic factors to 1e-4, solved to ten digits.
fn first_picture(bench: &Bench) -> Vec<Trial> {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let mesh = Mesh::uniform(&scene, FIRST_EDGE);
    let enclosure = Enclosure::of(&scene, &mesh);
    let (cubes, n) = (Hemicube::new(&mesh, CELLS), mesh.elements.len() as u64);
    let exact = Analytic::new(&scene, &mesh, 1e-4, 0).matrix(&|| ());
    let truth = solved(&enclosure, &exact);
    let norm = |off: &mut dyn Iterator<Item = Rgb>| enclosure.norm_squared(off);
    let reflected =
        norm(&mut truth.iter().zip(&enclosure.emission).map(|(&b, &e)| b - e));
    let judge = |found: &Vec<Rgb>| {
        let off = norm(&mut found.iter().zip(&truth).map(|(&b, &t)| b - t));
        Verdict::of((off / reflected).max_element().sqrt())
    };
    let work = |steps: f64, rows: usize| {
        let rows = rows as u64;
        let pixels = rows * 3 * u64::from(CELLS).pow(2);
        WorkDone {
            steps: steps as u64,
            factors: rows * n,
            pixels,
            ..WorkDone::default()
        }
    };
    let (enclosure, cubes) = (&enclosure, &cubes);
    let shooting = |name: &str, shown: fn(&Shoot) -> Vec<Rgb>| {
        Method::new(name, &SHOTS, move |shots, _| {
            let rows = Cached::new(cubes);
            let mut solver = Shoot::new(enclosure, &rows, Brightest::ByPower);
            (&mut solver).take(shots as usize).for_each(drop);
            (shown(&solver), work(shots, rows.computed()))
        })
    };
    let contest = Contest::new(FIRST_PICTURE, 1e-4, judge)
        .with(shooting("shoot", |s| s.radiosity().to_vec()))
        .with(shooting("shoot with ambient", |s| s.with_ambient()))
        .with(Method::new("overshoot", &SHOTS, |shots, _| {
            let rows = Cached::new(cubes);
            let mut solver = Overshoot::new(enclosure, &rows);
            (&mut solver).take(shots as usize).for_each(drop);
            (solver.radiosity().to_vec(), work(shots, rows.computed()))
        }))
        .with(Method::new(
            "all rows first",
            &[1.0, 2.0, 3.0, 5.0, 8.0],
            |sweeps, _| {
                let matrix = cubes.matrix(&|| ());
                let mut solver = GaussSeidel::new(enclosure, &matrix);
                (&mut solver).take(sweeps as usize).for_each(drop);
                (solver.radiosity().to_vec(), work(sweeps, n as usize))
            },
        ));
    contest.run(SUITE.name, bench)
}

/// To ten digits.
fn solved(enclosure: &Enclosure, factors: &Matrix) -> Vec<Rgb> {
    let mut solver = GaussSeidel::new(enclosure, factors);
    solver.run(enclosure.largest_reflectance().max_element(), 1e-10, 10_000);
    solver.radiosity().to_vec()
}

/// Patches of the Cornell box: eight along each wall, m.
pub const PATCH: f64 = 0.07;

/// Errors of the field that smooth light is asked for.
const TOLERANCES: [f64; 6] = [0.1, 0.05, 0.03, 0.02, 0.014, 0.01];

/// Walks from each patch.
const WALKS: [f64; 5] = [16.0, 64.0, 256.0, 1024.0, 4096.0];

fn patches(bench: &Bench) -> Vec<Trial> {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let patches = Patches::new(&scene, PATCH);
    let unbiased = Method::random("unbiased gathering", &WALKS, |walks, seed| {
        patches.by_walks(walks as usize, seed)
    });
    let contest =
        Contest::new(PATCHES, Patches::TRUTH, |h: &Vec<Rgb>| patches.verdict(h))
            .with(Method::new("smooth light", &TOLERANCES, |t, _| patches.by_smooth(t)))
            .with(unbiased.seeds(2)); // an answer has hundreds of patches
    contest.run(SUITE.name, bench)
}
