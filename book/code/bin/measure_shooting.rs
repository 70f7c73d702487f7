//! Measures the chart of *Progressive refinement*: time and error from a scene without any
//! form factors to its radiosity.
//!
//! `cargo run --release -p book --bin measure-shooting > book/data/shooting-DATE.csv`. CPU
//! time of one thread, so that it matters little what else the machine does. Takes some
//! seconds.

use book::shooting::Room;
use book::timing::cpu_milliseconds;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::{Cached, FormFactors, Lost, Matrix, Row};
use radiosity::mesh::ElementId;
use radiosity::scene::built_in;
use radiosity::solve::{Brightest, GaussSeidel, Overshoot, Shoot, Solver};

/// Longest edge of an element, in metres.
const MAX_EDGE: f64 = 0.05;

/// Cells along an edge of the hemicubes.
const RESOLUTION: u32 = 256;

/// After how many steps the error is taken.
const SHOTS: [usize; 9] = [10, 20, 50, 100, 200, 500, 1000, 2000, 4000];
const SWEEPS: [usize; 5] = [1, 2, 3, 5, 8];

/// How often all is done.
const RUNS: usize = 8;

/// A row after the other, on this thread.
fn all_rows(factors: &dyn FormFactors) -> Matrix {
    let mut row = vec![0.0; factors.len()];
    let mut one = |id: u32| {
        let lost: Lost = factors.row(ElementId(id), &mut row);
        Row::of(&row, lost)
    };
    Matrix::from_rows((0..factors.len() as u32).map(&mut one).collect())
}

/// Prints a line after each of `stages`; `spent` is the time before the first step.
/// Short times are seen in the mean of [`RUNS`].
fn report<S: Solver>(
    method: &str,
    before: f64,
    start: &dyn Fn() -> S,
    stages: &[usize],
    error: &dyn Fn(&S) -> f64,
) {
    let mut spent = vec![0.0; stages.len()];
    let mut errors = Vec::new();
    for run in 0..RUNS {
        let (mut solver, mut made) = (start(), 0);
        for (&stage, spent) in stages.iter().zip(&mut spent) {
            let start = cpu_milliseconds();
            while made < stage && solver.next().is_some() {
                made += 1;
            }
            *spent += (cpu_milliseconds() - start) / RUNS as f64;
            if run == 0 {
                errors.push(error(&solver));
            }
        }
    }
    let mut sum = before;
    for ((stage, spent), error) in stages.iter().zip(spent).zip(errors) {
        sum += spent;
        println!("{method},{stage},{sum:.2},{error:.3e},analytic factors");
    }
}

fn main() {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let room = Room::of(&scene, MAX_EDGE);
    let cubes = Hemicube::new(&room.mesh, RESOLUTION);
    let start = cpu_milliseconds();
    let matrix = all_rows(&cubes);
    let all = cpu_milliseconds() - start;
    let shoot = || Shoot::new(&room.enclosure, fresh(&cubes), Brightest::ByPower);
    let overshoot = || Overshoot::new(&room.enclosure, fresh(&cubes));
    let sweeps = || GaussSeidel::new(&room.enclosure, &matrix);
    println!("method,setting,milliseconds,max_error,reference");
    report("shoot", 0.0, &shoot, &SHOTS, &|s| room.error(s.radiosity()));
    report("with ambient", 0.0, &shoot, &SHOTS, &|s| room.error(&s.with_ambient()));
    report("overshoot", 0.0, &overshoot, &SHOTS, &|s| room.error(s.radiosity()));
    report("all rows first", all, &sweeps, &SWEEPS, &|s| room.error(s.radiosity()));
}

/// Rows that are not yet computed. There are few, and they live as long as the program.
fn fresh<'a>(cubes: &'a Hemicube) -> &'a Cached<'a> {
    Box::leak(Box::new(Cached::new(cubes)))
}
