//! The charts of the chapters on surfaces, from measurements that are kept with their date.

use crate::chart::{self, Point};
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use std::fmt::Write;

/// What `cargo run --release -p book --bin measure-surfaces` printed.
const CSV: &str = include_str!("../../data/surfaces-2026-11-22.csv");

fn points(methods: &[&str]) -> Vec<Point> {
    let points = chart::points(CSV).expect("a line of the CSV does not fit");
    points.into_iter().filter(|p| methods.contains(&p.method.as_str())).collect()
}

/// The one measurement of this method and setting.
fn point(method: &str, setting: &str) -> Point {
    let mut of_method = points(&[method]).into_iter();
    of_method.find(|p| p.setting == setting).expect("it was measured")
}

/// The chart of *BRDF*: one integral over the lobe, by three kinds of samples.
pub fn samples() -> String {
    chart::svg(
        "Relative error of the reflected light against the time to find it",
        &points(&["even", "cosine", "lobe"]),
        "milliseconds for one point",
        "relative error",
    )
}

/// What that chart says.
pub fn samples_text() -> String {
    let error = |method: &str| 100.0 * point(method, "1000").error;
    // To one digit: errors of 32 runs are known to a tenth.
    let samples = |method: &str| {
        let ratio = (error(method) / error("lobe")).powi(2);
        let unit = 10f64.powf(ratio.log10().floor());
        (ratio / unit).round() * unit
    };
    format!(
        "Of 1000 directions, those drawn from the lobe leave an error of {:.1} %, those by \
         the cosine {:.1} %, even ones {:.1} %. All errors fall as one over the root, so \
         that it takes about {:.0} directions by the cosine, or {:.0} even ones, to replace one \
         from the lobe. The narrower the lobe, the more.\n",
        error("lobe"),
        error("cosine"),
        error("even"),
        samples("cosine"),
        samples("even"),
    )
}

/// The chart of *Albedo*: closed form, grid, samples.
pub fn albedo() -> String {
    chart::svg(
        "Relative error of a directional albedo against the time to find it",
        &points(&["closed form", "grid", "lobe"]),
        "milliseconds for one albedo",
        "relative error",
    )
}

/// What that chart says.
pub fn albedo_text() -> String {
    let exact = point("closed form", "exact").milliseconds;
    let [coarse, grid] = ["4", "8"].map(|rings| point("grid", rings));
    format!(
        "The closed form takes {:.2} µs. A grid of 8 × 32 directions takes {:.0} times as \
         long, and is off by {:.0e}; one of 4 × 16, by {:.0} %. The lobe is smooth: once its \
         cells are narrower than the lobe, a grid finds it to rounding, and samples cannot \
         follow.\n",
        1e3 * exact,
        grid.milliseconds / exact,
        grid.error,
        100.0 * coarse.error,
    )
}

/// What it costs to keep more of a surface than its albedo, in numbers to be found.
pub fn numbers() -> String {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let elements = Mesh::uniform(&scene, 0.05).elements.len() as f64;
    let mut text = format!(
        "| kept of a surface | numbers for each element | unknowns, {elements} elements | \
         pairs |\n|---|---|---|---|\n"
    );
    for (what, directions) in
        [("albedo", 1.0), ("radiance in 64 directions", 64.0), ("in 1024", 1024.0)]
    {
        let unknowns = elements * directions;
        let _ = writeln!(
            text,
            "| {what} | {directions} | {unknowns} | {:.0e} |",
            unknowns * unknowns
        );
    }
    text
}
