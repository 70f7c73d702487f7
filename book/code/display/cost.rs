//! The chart of *The picture*: samples in a pixel, from measurements that are kept with
//! their date.

use crate::chart::{self, Point};

/// What `cargo run -p book --bin measure-picture` printed.
const CSV: &str = include_str!("../../data/picture-2026-11-22.csv");

fn points() -> Vec<Point> {
    chart::points(CSV).expect("a line of the CSV does not fit")
}

/// Error over time.
pub fn svg() -> String {
    chart::svg(
        "Error of a picture of the solved Cornell box against the time to draw it",
        &points(),
        "milliseconds, one thread",
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
    let (flat, smooth) = (find("flat", "1"), find("smooth", "1"));
    let best = find("smooth", "3");
    format!(
        "A flat picture takes {:.1} ms, a smooth one {:.1} ms: most of it are weights of corners. \
         Nine samples in a pixel cost nine times as much and bring the error from {:.0} % to \
         {:.0} %. It does not fall evenly, and it is the same for both: nearly all of it is the \
         outline of the lamp, and how samples fall upon four straight edges is luck.\n",
        flat.milliseconds,
        smooth.milliseconds,
        100.0 * smooth.error,
        100.0 * best.error,
    )
}
