//! Measures the chart of *Who carries which light?*: time and noise of a picture by paths.
//!
//! `RAYON_NUM_THREADS=1 cargo run -p book --bin measure-transport >
//! book/data/transport-DATE.csv`. CPU time of one thread, so that it matters little what
//! else the machine does. Takes a minute.

use book::timing::cpu_milliseconds_of_all;
use book::transport::parts;
use radiosity::film::Shot;
use radiosity::geometry::Rgb;
use radiosity::trace::{PathTracer, Strategy, Traced};

const SIZE: u32 = 64;
const SAMPLES: [usize; 3] = [16, 64, 256];

/// Root of the mean square of the standard errors, over the mean; pixels that see a lamp
/// are left out, as their edges drown the rest.
fn noise(traced: &Traced, brightest: f64) -> f64 {
    let pixels = traced.picture.pixels.iter().zip(&traced.error);
    let dark = pixels.filter(|(l, _)| l.max_element() < brightest);
    let (mut squares, mut sum) = (0.0, 0.0);
    for (&l, &error) in dark {
        squares += (error * error).dot(Rgb::splat(1.0 / 3.0));
        sum += l.dot(Rgb::splat(1.0 / 3.0));
    }
    let count = traced.error.len() as f64;
    (squares / count).sqrt() / (sum / count)
}

fn main() {
    let scene = parts::scene();
    let camera = scene.camera;
    let shot = Shot { camera, width: SIZE, height: SIZE, samples: 1 };
    let emission = scene.materials.iter().map(|m| m.emission().max_element());
    let lamp = 0.2 * emission.fold(0.0, f64::max) / std::f64::consts::PI;
    println!("method,setting,milliseconds,max_error,reference");
    for (name, strategy) in [
        ("lamps", Strategy::Lamps),
        ("lobes", Strategy::Lobes),
        ("both", Strategy::Both),
    ] {
        let tracer = PathTracer::of(&scene).by(strategy);
        for samples in SAMPLES {
            let start = cpu_milliseconds_of_all();
            let traced = tracer.picture(&shot, samples, 1, &|_, _, _| {});
            let spent = cpu_milliseconds_of_all() - start;
            let noise = noise(&traced, lamp);
            println!("{name},{samples},{spent:.1},{noise:.5},its own standard error");
        }
    }
}
