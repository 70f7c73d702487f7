//! What the charts of the chapter say.

use crate::chart::{self, find, trials};
use radiosity::chart::Trial;
use radiosity::chart::suites::form_factors::{HIDDEN, TOUCHING};

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

/// What the chart of the touching pair says, with its numbers.
pub fn text() -> String {
    let trials = trials(include_str!("../../data/form-factors.csv"));
    let find = |method, setting| find(&trials, TOUCHING, method, setting);
    let exact = find("Lambert's formula", 1e-10);
    let meanwhile = |method: &str| {
        let fits = |t: &&Trial| {
            t.scene == TOUCHING && t.method == method && t.seconds <= exact.seconds
        };
        100.0 * trials.iter().rfind(fits).map_or(f64::NAN, |t| t.error)
    };
    let last = |method: &'static str| 100.0 * find(method, 1e5).error;
    format!(
        "`exchange`, by the contour integral, takes {:.1} µs and is right to {:.0e}: for a \
         pair with nothing between, **nothing else is worth its time**. In that time the \
         points are off by {:.0} %, and middles by {:.1} %. Points are of first order here, \
         and four edges are cut: a digit costs ten thousand times the work. Middles are of \
         second order, and two edges are cut: a digit costs ten times the work. Of random \
         pairs, 100 000 leave an error of {:.1} %, and ten times as many need not do better. \
         As many rays come to {:.2} %. The hemicube stands still at {:.0} %: proximity.\n",
        1e6 * exact.seconds,
        exact.error.max(1e-16),
        meanwhile("point to point"),
        meanwhile("Lambert at the middles"),
        last("random pairs"),
        last("rays"),
        100.0 * find("one hemicube", 1024.0).error
    )
}

/// What the chart of the half hidden pair says.
pub fn hidden_text() -> String {
    let trials = trials(include_str!("../../data/form-factors.csv"));
    let find = |method, setting| find(&trials, HIDDEN, method, setting);
    let blind = find("point to point", 32.0);
    let exact = find("Lambert's formula", 1e-4);
    let rays = find("rays", 1e5);
    format!(
        "Behind a screen the rules without visibility go on to be sure of themselves, and find \
         {:.1} times what is there, however finely they cut. Lambert's formula, cut along the \
         edges of what is seen, is right to {:.0e} in {:.2} ms; rays come to {:.1} % in \
         {:.0} ms; one hemicube sees {}, as its one eye stands behind the screen.\n",
        1.0 + blind.error,
        exact.error,
        1e3 * exact.seconds,
        100.0 * rays.error,
        1e3 * rays.seconds,
        match find("one hemicube", 1024.0).error {
            e if e > 0.99 => "nothing".to_string(),
            e => format!("{:.0} % too little or too much", 100.0 * e),
        }
    )
}
