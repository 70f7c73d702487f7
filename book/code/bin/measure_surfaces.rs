//! Measures the charts of the chapters on surfaces: error and time of one integral over a
//! Phong lobe of exponent 50, looked at from 45°.
//!
//! `cargo run --release -p book --bin measure-surfaces > book/data/surfaces-DATE.csv`.
//! One thread; takes some seconds.

use book::surface::samples::{Draw, LOBE, drawn, eye, on_a_grid};
use book::timing::report;
use std::hint::black_box;

fn main() {
    println!("method,setting,milliseconds,max_error,reference");
    let exact = LOBE.albedo(eye().z);
    report("closed form", "exact", exact, 1, &|_| LOBE.albedo(black_box(eye().z)));
    for rings in [4_u32, 8, 16, 32, 64] {
        report("grid", &rings.to_string(), exact, 1, &|_| on_a_grid(black_box(rings)));
    }
    for (name, draw) in
        [("even", Draw::Even), ("cosine", Draw::Cosine), ("lobe", Draw::Lobe)]
    {
        for samples in [100, 1_000, 10_000, 100_000] {
            let find = |seed| drawn(draw, samples, seed);
            report(name, &samples.to_string(), exact, 32, &find);
        }
    }
}
