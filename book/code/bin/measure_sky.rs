//! Measures the chart of *Light from the sky*: error and time of the ground's
//! irradiance below a clear sky with a sun, by directions drawn in three ways and by
//! all texels.
//!
//! `cargo run --release -p book --bin measure-sky > book/data/sky-DATE.csv`.
//! One thread; takes some seconds.

use book::sky::shadow::Draw;
use book::sky::skies::sunny;
use book::timing::report;
use glam::{DVec3, dvec2};
use radiosity::random::Stream;
use radiosity::sky::Sky;
use std::hint::black_box;

fn main() {
    println!("method,setting,milliseconds,max_error,reference");
    let sky = Sky::panorama(sunny(), DVec3::Y);
    let exact = sky.irradiance(DVec3::Y).y;
    report("all texels", "exact", exact, 1, &|_| sky.irradiance(black_box(DVec3::Y)).y);
    let methods = [
        ("even", Draw::Even),
        ("by the cosine", Draw::Cosine),
        ("by brightness", Draw::Bright),
    ];
    for (name, draw) in methods {
        for rays in [64_usize, 256, 1024, 4096, 16384] {
            let find = |seed| {
                let mut stream = Stream::named(seed, &[rays as u64]);
                let mut ray =
                    || draw.light(&sky, dvec2(stream.next(), stream.next())).1.y;
                (0..rays).map(|_| ray()).sum::<f64>() / rays as f64
            };
            report(name, &rays.to_string(), exact, 64, &find);
        }
    }
}
