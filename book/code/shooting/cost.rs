//! The chart of *Progressive refinement*: the time to a picture, from measurements that
//! are kept with their date.

use crate::chart::{self, Point};

/// What `cargo run --release -p book --bin measure-shooting` printed.
const CSV: &str = include_str!("../../data/shooting-2026-11-22.csv");

fn points() -> Vec<Point> {
    chart::points(CSV).expect("a line of the CSV does not fit")
}

/// Error over time, factors included.
pub fn svg() -> String {
    chart::svg(
        "Relative error of the radiosity against the time since the start, form \
         factors included",
        &points(),
        "milliseconds since the start, one thread",
        "relative error",
    )
}

/// What it says.
pub fn text() -> String {
    let points = points();
    let find = |method: &str, setting: &str| {
        let fits = |p: &&Point| p.method == method && p.setting == setting;
        points.iter().find(fits).expect("it was measured")
    };
    let (early, guessed) = (find("shoot", "100"), find("with ambient", "100"));
    let (first, last) = (find("all rows first", "1"), find("all rows first", "8"));
    format!(
        "A hundred shots take {:.0} ms; the picture is {:.0} % off then, and {:.0} % \
         with the ambient term. Who computes all rows first waits {:.0} ms for the \
         first sweep, which is {:.0} % off, but a few more sweeps are nearly free. \
         All end at {:.1} %, give or take: that is the hemicubes' own error.\n",
        early.milliseconds,
        100.0 * early.error,
        100.0 * guessed.error,
        first.milliseconds,
        100.0 * first.error,
        100.0 * last.error,
    )
}
