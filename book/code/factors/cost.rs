//! What the charts of the chapter say.

use crate::chart::{self, find, trials};
use radiosity::chart::suites::form_factors::{HIDDEN, TOUCHING};
use radiosity::chart::suites::scaling;
use radiosity::chart::{Column, Trial, exponent};

/// What `radiosity chart scaling` wrote.
const SCALING: &str = include_str!("../../data/scaling.csv");

/// How the time of rows grows with the number of faces: exponents, fitted from a thousand
/// faces on.
pub fn scaling_text() -> String {
    let trials = chart::trials(SCALING);
    let power = |scene: &str, method: &str| {
        let fits =
            |t: &&Trial| t.scene == scene && t.method == method && t.setting > 1e3;
        let large: Vec<&Trial> = trials.iter().filter(fits).collect();
        exponent(&large, Column::Setting, Column::Seconds)
    };
    let [exact, cubes] =
        ["analytic", "hemicubes"].map(|m| scaling::ROWS.map(|scene| power(scene, m)));
    format!(
        "From a thousand faces on, the time of analytic rows grows as faces to the power \
         {:.2} in the empty box and {:.2} in the Cornell room: **more slowly than n log n**, \
         since small faces are far from each other in their own sizes, and need fewer points. \
         Those of hemicubes grow by {:.2} and {:.2}: first the cells are the work, then the \
         faces.\n",
        exact[0], exact[1], cubes[0], cubes[1],
    )
}

/// How the time of a ray grows with the number of triangles, and what one takes.
pub fn rays_text() -> String {
    let trials = chart::trials(SCALING);
    let of = |method: &str| -> Vec<&Trial> {
        let fits = |t: &&Trial| t.scene == scaling::TRIANGLES && t.method == method;
        trials.iter().filter(fits).collect()
    };
    let (rays, tree) = (of("rays"), of("making ready"));
    let [first, .., last] = rays[..] else { panic!("rays were not measured") };
    let each = |t: &Trial| 1e6 * t.seconds / t.work.rays as f64;
    let power = |of: &[&Trial]| exponent(of, Column::Setting, Column::Seconds);
    format!(
        "A ray takes {:.2} µs among {} triangles and {:.2} µs among {}: the power is {:.2}: \
         a **logarithm** of what could be met, and what no cache holds any more. The tree's is \
         {:.2}.\n",
        each(first),
        first.setting,
        each(last),
        last.setting,
        power(&rays),
        power(&tree)
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
