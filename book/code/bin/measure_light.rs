//! Measures the charts of the chapters on light: error and time of one solid angle, and of
//! one projected solid angle.
//!
//! `cargo run --release -p book --bin measure-light > book/data/light-DATE.csv`, on a
//! machine that does nothing else. Takes some seconds.

use book::light::pieces::{by_pieces, target};
use book::light::rays::{by_cosine, by_even, covered};
use book::timing::report;
use glam::{DVec3, dvec3};
use radiosity::radiometry::{projected_solid_angle, solid_angle};
use std::hint::black_box;

/// The eye: 1 below the middle of the unit square.
const EYE: DVec3 = dvec3(0.0, 0.0, -1.0);

/// Rays that are cast in one go.
const RAYS: [usize; 4] = [100, 1_000, 10_000, 100_000];

/// Runs whose errors are averaged: the error of a single one is luck.
const RUNS: u64 = 32;

fn main() {
    println!("method,setting,milliseconds,max_error,reference");
    let square = target();
    let exact = solid_angle(EYE, &square);
    report("Ω exact", "closed form", exact, 1, &|_| {
        solid_angle(black_box(EYE), &square)
    });
    for cuts in [1_u32, 2, 4, 8, 16, 32, 64] {
        let setting = (cuts * cuts).to_string();
        report("Ω pieces", &setting, exact, 1, &|_| by_pieces(black_box(EYE), cuts));
    }
    for rays in RAYS {
        let setting = rays.to_string();
        report("Ω rays", &setting, exact, RUNS, &|seed| covered(EYE, rays, seed));
    }
    let exact = projected_solid_angle(EYE, DVec3::Z, square.vertices());
    report("H exact", "closed form", exact, 1, &|_| {
        projected_solid_angle(black_box(EYE), DVec3::Z, square.vertices())
    });
    for rays in RAYS {
        let setting = rays.to_string();
        report("H even rays", &setting, exact, RUNS, &|seed| by_even(EYE, rays, seed));
        report("H cosine rays", &setting, exact, RUNS, &|seed| {
            by_cosine(EYE, rays, seed)
        });
    }
}
