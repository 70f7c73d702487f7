//! The chart of the chapter, from measurements that are kept with their date.

use crate::chart::{self, Point};

/// What `cargo run --release -p book --bin measure-form-factors` printed.
const CSV: &str = include_str!("../../data/form-factors-2026-11-22.csv");

fn measured() -> Vec<Point> {
    chart::points(CSV).expect("a line of the CSV does not fit")
}

/// The chart as SVG.
pub fn svg() -> String {
    chart::svg(
        "Relative error of a form factor against the time to find it",
        &measured(),
        "milliseconds for a factor",
        "relative error",
    )
}

/// What `cargo bench --bench form_factors` printed last: faces, and milliseconds a row.
const SCALING: &str = include_str!("../../data/scaling-2026-11-22.csv");

/// The chart of the time per row against the number of faces, as SVG. The columns of the
/// CSV stand in the places of time and error.
pub fn scaling_svg() -> String {
    chart::svg(
        "Time to find a row of analytic factors against the number of faces",
        &chart::points(SCALING).expect("a line of the CSV does not fit"),
        "faces",
        "milliseconds for a row",
    )
}

/// How the time per row grows from a thousand faces to the most: fitted exponents.
pub fn scaling_text() -> String {
    let points = chart::points(SCALING).expect("a line of the CSV does not fit");
    let exponent = |method: &str| {
        let mut of =
            points.iter().filter(|p| p.method == method && p.milliseconds > 1e3);
        let (first, last) =
            (of.next().expect("measured"), of.next_back().expect("measured"));
        (last.error / first.error).ln() / (last.milliseconds / first.milliseconds).ln()
    };
    format!(
        "From a thousand faces on, the time of a row grows as faces to the power {:.2} in the \
         empty box and {:.2} in the Cornell room: **more slowly than n log n**, since small \
         faces are far from each other in their own sizes, and need fewer points.\n",
        exponent("empty box"),
        exponent("Cornell room"),
    )
}

/// What the chart says, with its numbers.
pub fn text() -> String {
    let points = measured();
    let find = |method: &str, setting: &str| {
        let fits = |p: &&Point| p.method == method && p.setting == setting;
        points.iter().find(fits).expect("it was measured")
    };
    let exact = find("exchange", "1e-12");
    let last = |method: &str| {
        points.iter().rfind(|p| p.method == method).expect("it was measured")
    };
    let meanwhile = |method: &str| {
        let fits =
            |p: &&Point| p.method == method && p.milliseconds <= exact.milliseconds;
        100.0 * points.iter().rfind(fits).expect("it was measured").error
    };
    format!(
        "`exchange`, by the contour integral, takes {:.1} µs and is right to {:.0e}: for a \
         pair with nothing between, **nothing else is worth its time**. In that time the \
         points are off by {:.0} %, and middles by {:.1} %. Points are of first order here, \
         and four edges are cut: a digit costs ten thousand times the work. Middles are of \
         second order, and two edges are cut: a digit costs ten times the work. Of random \
         pairs, {} leave an error of {:.1} %, and ten times as many need not do better. As \
         many rays come to {:.1} %. The hemicube stands still at {:.0} %: proximity.\n",
        1e3 * exact.milliseconds,
        exact.error,
        meanwhile("points"),
        meanwhile("middles"),
        last("random pairs").setting,
        100.0 * last("random pairs").error,
        100.0 * last("rays").error,
        100.0 * last("hemicube").error
    )
}
