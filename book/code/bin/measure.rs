//! Measures the chart of the chapter *The hemicube*: error and time of a row of factors.
//!
//! `cargo run --release -p book --bin measure > book/data/hemicube-DATE.csv`, on a machine
//! that does nothing else. Takes about a minute.

use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::geometry::Polygon;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::scene::built_in;
use std::hint::black_box;
use std::time::Instant;

/// Rows that are measured, spread evenly over the elements.
const ROWS: usize = 16;

/// Accuracy of the factors that all others are held against.
const REFERENCE: f64 = 1e-8;

fn main() {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let mesh = Mesh::uniform(&scene, 0.1);
    let elements = mesh.elements.len();
    let exact = rows(&Analytic::new(&scene, &mesh, REFERENCE, 0), elements);
    println!("method,setting,milliseconds,max_error,reference");
    let report = |method: &str, setting: String, factors: &dyn FormFactors| {
        let mut best = f64::INFINITY;
        let mut got = Vec::new();
        for _ in 0..3 {
            let start = Instant::now();
            got = black_box(rows(factors, elements));
            best = best.min(1e3 * start.elapsed().as_secs_f64() / ROWS as f64);
        }
        let worst = |pairs: fn(&Polygon, &Polygon) -> bool| {
            let mut worst = 0.0_f64;
            for (k, (got, exact)) in got.iter().zip(&exact).enumerate() {
                let from = &mesh.elements[element(k, elements)].polygon;
                for (j, to) in mesh.polygons().enumerate() {
                    if pairs(from, to) {
                        worst = worst.max((got[j] - exact[j]).abs());
                    }
                }
            }
            worst
        };
        let say = |method: &str, worst: f64| {
            println!("{method},{setting},{best:.4},{worst:.3e},analytic {REFERENCE:e}");
        };
        say(method, worst(|_, _| true));
        if method == "hemicube" {
            say("hemicube (far pairs)", worst(far));
        }
    };
    for resolution in [16, 32, 64, 128, 256, 512, 1024] {
        let cube = Hemicube::new(&mesh, resolution);
        report("hemicube", resolution.to_string(), &cube);
    }
    for rays in [100, 1_000, 10_000, 100_000] {
        report("rays", rays.to_string(), &Cast::new(&mesh, rays, 1));
    }
    for tolerance in [1e-2, 1e-3, 1e-4, 1e-5] {
        let analytic = Analytic::new(&scene, &mesh, tolerance, 1);
        report("analytic", format!("{tolerance:e}"), &analytic);
    }
}

/// The five-times rule: farther apart than five times the larger one's diameter.
fn far(a: &Polygon, b: &Polygon) -> bool {
    let size = a.diameter().max(b.diameter());
    a.centroid().distance(b.centroid()) > 5.0 * size
}

/// The element of the `k`th row.
fn element(k: usize, elements: usize) -> usize {
    k * elements / ROWS
}

fn rows(factors: &dyn FormFactors, elements: usize) -> Vec<Vec<f64>> {
    let row = |k: usize| {
        let mut row = vec![0.0; elements];
        factors.row(ElementId(element(k, elements) as u32), &mut row);
        row
    };
    (0..ROWS).map(row).collect()
}
