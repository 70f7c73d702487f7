//! The chart of the chapter, from measurements that are kept with their date.

use crate::chart;

/// What `cargo run --release -p book --bin measure` printed.
const CSV: &str = include_str!("../../data/hemicube-2026-11-22.csv");

/// The chart as SVG.
pub fn svg() -> String {
    let points = chart::points(CSV).expect("a line of the CSV does not fit");
    chart::svg(
        "Largest error of a form factor against the time for a row of them",
        &points,
        "milliseconds for a row",
        "largest error of a factor",
    )
}
