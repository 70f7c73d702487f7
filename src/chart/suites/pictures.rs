//! Pictures: radiosity, two passes, ray tracing and paths, of boxes with and without what
//! shines; how paths find lamps; and how a solution is drawn.

use super::look::Onlooker;
use super::truth::PictureTruth;
use crate::chart::{Bench, ChartView, Column, Contest, Method, Suite, Trial, WorkDone};
use crate::field::Classical;
use crate::film::{Picture, Shot};
use crate::mesh::Mesh;
use crate::room::Room;
use crate::scene::built_in;
use crate::solution::{Goal, solve_on};
use crate::trace::Strategy;

/// This suite.
pub const SUITE: Suite = Suite {
    name: "pictures",
    about: "radiosity, two passes, ray tracing and paths at equal error",
    measure,
    views: &[
        view("pictures-cornell", |t| t.scene == CORNELL),
        view("pictures-mirror", |t| t.scene == MIRROR),
        view("pictures-pane", |t| t.scene == PANE),
        ChartView {
            title: "Noise of a picture by paths against the time it took",
            ..view("pictures-strategies", |t| t.scene == STRATEGIES)
        },
        ChartView {
            title: "Error of a picture of the solved Cornell box against the time to draw it",
            ..view("pictures-drawn", |t| t.scene == DRAWN)
        },
    ],
};

const fn view(file: &'static str, shows: fn(&Trial) -> bool) -> ChartView {
    ChartView {
        file,
        title: "Error of a picture against the time for it, by four methods",
        across: (Column::Seconds, "CPU seconds, one thread"),
        upward: (Column::Error, "error of a pixel, relative to the mean"),
        least: 1e-3,
        shows,
    }
}

/// Scenes of the suite.
pub const CORNELL: &str = "cornell";
/// See [`CORNELL`].
pub const MIRROR: &str = "cornell-mirror";
/// See [`CORNELL`].
pub const PANE: &str = "cornell-pane";
/// See [`CORNELL`].
pub const STRATEGIES: &str = "cornell-mirror by paths";
/// See [`CORNELL`].
pub const DRAWN: &str = "cornell solved";

/// Three ways of paths to find lamps.
pub const WAYS: [(&str, Strategy); 3] =
    [("lamps", Strategy::Lamps), ("lobes", Strategy::Lobes), ("both", Strategy::Both)];

fn measure(bench: &Bench) -> Vec<Trial> {
    let tolerances = [0.1, 0.05, 0.02, 0.01];
    let mut trials = vec![];
    for name in [CORNELL, MIRROR, PANE] {
        let look = Onlooker::at(name, 128, PIXELS, WALKS);
        trials.extend(at_equal_error(&look, name, &tolerances, &PATHS, bench));
    }
    let look = Onlooker::at("cornell-mirror", 64, PIXELS, WALKS);
    trials.extend(strategies(&look, &[16.0, 64.0, 256.0], bench));
    trials.extend(drawn(256, &[1.0, 2.0, 3.0, 4.0, 6.0], 24, bench));
    trials
}

/// Paths through each pixel.
const PATHS: [f64; 4] = [4.0, 16.0, 64.0, 256.0];

/// How many pixels are held against walks, and how many of these there are for each, twice.
const PIXELS: usize = 3000;
const WALKS: usize = 800;

/// All methods at one look: pass 1 at `tolerances`, so many `paths` to a pixel.
pub fn at_equal_error(
    look: &Onlooker,
    name: &str,
    tolerances: &[f64],
    paths: &[f64],
    bench: &Bench,
) -> Vec<Trial> {
    let contest = look.contest(name);
    let contest = match look.shines() {
        true => contest.with(look.dulled(tolerances)),
        false => contest,
    };
    contest
        .with(look.radiosity(tolerances))
        .with(look.two_passes(tolerances))
        .with(look.ray_tracing(&[4.0]))
        .with(look.paths("paths", Strategy::Both, paths))
        .run(SUITE.name, bench)
}

/// One look by paths that find lamps in three ways.
pub fn strategies(look: &Onlooker, paths: &[f64], bench: &Bench) -> Vec<Trial> {
    let mut contest = look.contest(STRATEGIES);
    for (name, strategy) in WAYS {
        contest = contest.with(look.paths(name, strategy, paths));
    }
    contest.run(SUITE.name, bench)
}

/// One solution, drawn flat and smooth with so many samples along an edge of a pixel; the
/// same with `truth` samples is right.
pub fn drawn(size: u32, samples: &[f64], truth: u32, bench: &Bench) -> Vec<Trial> {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let mesh = Mesh::uniform(&scene, 0.1);
    let (method, quiet) = (Classical::default(), crate::work::Work::quiet());
    let solution = solve_on(&Room::of(&scene), &method, mesh, &Goal::default(), &quiet);
    let solution = solution.expect("hemicubes know the Cornell box");
    let shot =
        |samples| Shot { camera: scene.camera, width: size, height: size, samples };
    let flat = |n: u32| shot(n).flat(&solution.field.mesh, &solution.radiosity);
    let smooth =
        |n: u32| shot(n).smooth(&solution.field.mesh, &solution.vertex_radiosity);
    let ways: [(&str, &dyn Fn(u32) -> Picture); 2] =
        [("flat", &flat), ("smooth", &smooth)];
    let mut trials = vec![];
    for (name, draw) in ways {
        let all = (0..(size * size) as usize).collect();
        let right = draw(truth);
        let right = PictureTruth::of(all, |_| right.clone());
        // Samples on a grid: what they miss falls as one over their number along an edge.
        let uncertainty = right.judge(&draw(truth / 2)).error;
        let work = |n: f64| WorkDone {
            pixels: (n * n) as u64 * u64::from(size * size),
            ..WorkDone::default()
        };
        let method = Method::new(name, samples, |n, _| (draw(n as u32), work(n)));
        let contest =
            Contest::new(DRAWN, uncertainty, |seen: &Picture| right.judge(seen));
        trials.extend(contest.with(method).run(SUITE.name, bench));
    }
    trials
}
