//! Measures the chart of *The picture*: time to draw a solution, and what more samples in a
//! pixel gain.
//!
//! `cargo run -p book --bin measure-picture > book/data/picture-DATE.csv`. CPU time of one
//! thread, so that it matters little what else the machine does; the crate itself is
//! optimised in every profile.

use book::pipeline::stages::solved;
use book::timing::cpu_milliseconds;
use radiosity::film::{Picture, Shot};
use radiosity::scene::built_in;

/// Pixels along an edge.
const SIZE: u32 = 256;

/// Samples along an edge of a pixel, and of those that are the truth.
const SAMPLES: [u32; 5] = [1, 2, 3, 4, 6];
const TRUTH: u32 = 16;

/// How often each is drawn.
const RUNS: u32 = 10;

/// Root mean square over the pixels, relative to that of the truth.
fn error(picture: &Picture, truth: &Picture) -> f64 {
    let pairs = picture.pixels.iter().zip(&truth.pixels);
    let off: f64 = pairs.map(|(&a, &b)| (a - b).length_squared()).sum();
    let norm: f64 = truth.pixels.iter().map(|p| p.length_squared()).sum();
    (off / norm).sqrt()
}

fn report(method: &str, draw: &dyn Fn(&Shot) -> Picture) {
    let camera = built_in("cornell").expect("`cornell` is built in").camera;
    let shot = |samples| Shot { camera, width: SIZE, height: SIZE, samples };
    let truth = draw(&shot(TRUTH));
    for samples in SAMPLES {
        let start = cpu_milliseconds();
        (1..RUNS).for_each(|_| drop(draw(&shot(samples))));
        let picture = draw(&shot(samples));
        let spent = (cpu_milliseconds() - start) / f64::from(RUNS);
        let error = error(&picture, &truth);
        println!("{method},{samples},{spent:.3},{error:.3e},{TRUTH} samples an edge");
    }
}

fn main() {
    let solution = solved();
    println!("method,setting,milliseconds,max_error,reference");
    // All on this one thread, so that its clock tells the whole of it.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.expect("one thread is not too many").install(|| {
        report("flat", &|shot| shot.flat(&solution.mesh, &solution.radiosity));
        report("smooth", &|shot| {
            shot.smooth(&solution.mesh, &solution.vertex_radiosity)
        });
    });
}
