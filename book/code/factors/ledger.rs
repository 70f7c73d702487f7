//! The energy ledger of the closed cube, by methods that agree on every row's sum.

use crate::map;
use glam::{DVec3, dvec3};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::shortcuts::point_to_point;
use radiosity::geometry::Polygon;
use radiosity::mesh::{ElementId, Mesh};
use std::fmt::Write;

/// A room of 1 × 1 × 2, its faces looking inward.
fn room() -> Vec<Polygon> {
    let (w, d, h) = (DVec3::X, DVec3::Y, 2.0 * DVec3::Z);
    let face = |corner: DVec3, a: DVec3, b: DVec3| {
        let corners = vec![corner, corner + a, corner + a + b, corner + b];
        Polygon::new(corners).expect("a rectangle is a polygon")
    };
    vec![
        face(DVec3::ZERO, w, d),
        face(h, d, w),
        face(DVec3::ZERO, d, h),
        face(w, h, d),
        face(DVec3::ZERO, h, w),
        face(dvec3(0.0, 1.0, 0.0), w, h),
    ]
}

/// What a row sums to, how far `A F` is from its mirror image, and floor to ceiling.
struct Laws {
    closure: f64,
    reciprocity: f64,
    ceiling: f64,
    absorbed: Option<f64>,
}

/// Of every face's reflectance, in the room whose floor sends 1 W.
const REFLECTANCE: f64 = 0.8;

/// What all faces absorb of the watt: `Σ A B (1 − ρ)`; `None` when sweeps do not settle.
fn absorbed(rows: &[Vec<f64>], area: &[f64]) -> Option<f64> {
    let n = rows.len();
    let emitted = |i: usize| if i == 0 { 1.0 / area[0] } else { 0.0 };
    let mut radiosity: Vec<f64> = (0..n).map(emitted).collect();
    let total = |b: &[f64]| area.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut before = 0.0;
    for _ in 0..1000 {
        let gathered = |i: usize| {
            let row = rows[i].iter().zip(&radiosity);
            emitted(i) + REFLECTANCE * row.map(|(f, b)| f * b).sum::<f64>()
        };
        radiosity = (0..n).map(gathered).collect();
        let now = total(&radiosity);
        if (now - before).abs() < 1e-12 * now {
            return Some(now * (1.0 - REFLECTANCE));
        }
        before = now;
    }
    None
}

fn laws(rows: &[Vec<f64>], area: &[f64]) -> Laws {
    let n = rows.len();
    let sum = |row: &Vec<f64>| (row.iter().sum::<f64>() - 1.0).abs();
    let apart = |k: usize| {
        let (i, j) = (k / n, k % n);
        let exchange = [area[i] * rows[i][j], area[j] * rows[j][i]];
        (exchange[0] - exchange[1]).abs() / area[i].max(area[j])
    };
    Laws {
        closure: rows.iter().map(sum).fold(0.0, f64::max),
        reciprocity: (0..n * n).map(apart).fold(0.0, f64::max),
        ceiling: rows[0][1],
        absorbed: absorbed(rows, area),
    }
}

/// The table of laws as Markdown.
pub fn markdown() -> String {
    let room = room();
    let scene = map::black(&room);
    let mesh = Mesh::whole(&scene);
    let area: Vec<f64> = room.iter().map(Polygon::area).collect();
    let rows = |factors: &dyn FormFactors| -> Vec<Vec<f64>> {
        let row = |k: u32| {
            let mut row = vec![0.0; room.len()];
            factors.row(ElementId(k), &mut row);
            row
        };
        (0..room.len() as u32).map(row).collect()
    };
    let other = |i: &Polygon, j: &Polygon| match std::ptr::eq(i, j) {
        true => 0.0, // what is flat does not see itself
        false => point_to_point(i, j),
    };
    let points = |i: &Polygon| room.iter().map(|j| other(i, j)).collect();
    let by_points: Vec<Vec<f64>> = room.iter().map(points).collect();
    let repaired = by_points.iter().map(|row| {
        let sum: f64 = row.iter().sum();
        row.iter().map(|f| f / sum).collect()
    });
    let mut text = String::from(
        "| factors | row sum off by | `A F` apart by | floor to ceiling | absorbed of 1 W \
         |\n|---|---|---|---|---|\n",
    );
    for (name, rows) in [
        ("exact", rows(&Analytic::new(&scene, &mesh, 1e-12, 0))),
        ("hemicube, 256", rows(&Hemicube::new(&mesh, 256))),
        ("point to point", by_points.clone()),
        ("the same, rows divided by their sums", repaired.collect()),
    ] {
        let Laws { closure, reciprocity, ceiling, absorbed } = laws(&rows, &area);
        let absorbed =
            absorbed.map_or("grows without end".into(), |w| format!("{w:.4} W"));
        let _ = writeln!(
            text,
            "| {name} | {closure:.0e} | {reciprocity:.0e} | {ceiling:.4} | {absorbed} |"
        );
    }
    text
}
