//! Measures the chart of the chapter *Form factors*: one pair that shares an edge.
//!
//! `cargo run --release -p book --bin measure-form-factors >
//! book/data/form-factors-DATE.csv`, on a machine that does nothing else. Takes some
//! seconds.

use book::factors::pair::{floor, middles, points, random_pairs, scene, wall};
use book::timing::report;
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::exchange;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::named::perpendicular_rectangles;
use radiosity::mesh::{ElementId, Mesh};
use std::hint::black_box;

/// Runs whose errors are averaged: the error of a single one is luck.
const RUNS: u64 = 32;

fn main() {
    println!("method,setting,milliseconds,max_error,reference");
    let exact = perpendicular_rectangles(1.0, 1.0, 1.0);
    let (floor, wall) = (floor(), wall());
    report("exchange", "1e-12", exact, 1, &|_| {
        exchange(black_box(&floor), &wall, 1e-12)
    });
    for cuts in [1_u32, 2, 4, 8, 16, 32] {
        let setting = (cuts * cuts).to_string();
        report("points", &setting, exact, 1, &|_| points(black_box(cuts)));
        report("middles", &setting, exact, 1, &|_| middles(black_box(cuts)));
    }
    for pairs in [100, 1_000, 10_000, 100_000] {
        report("random pairs", &pairs.to_string(), exact, RUNS, &|seed| {
            random_pairs(pairs, seed).0
        });
    }
    let scene = scene();
    let mesh = Mesh::whole(&scene);
    let to_the_wall = |factors: &dyn FormFactors| {
        let mut row = [0.0; 2];
        factors.row(ElementId(0), &mut row);
        row[1]
    };
    for rays in [100, 1_000, 10_000, 100_000] {
        report("rays", &rays.to_string(), exact, RUNS, &|seed| {
            to_the_wall(&Cast::new(&mesh, rays, seed))
        });
    }
    for cells in [16, 64, 256] {
        let cube = Hemicube::new(&mesh, cells);
        report("hemicube", &cells.to_string(), exact, 1, &|_| to_the_wall(&cube));
    }
}
