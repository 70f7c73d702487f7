//! The charts of the page, from measurements that are kept with their date.

use crate::chart::{self, Point};

/// What `cargo bench --bench hierarchy` printed.
const CSV: &str = include_str!("../../data/links-2026-11-22.csv");

/// One run.
struct Run {
    scene: &'static str,
    method: &'static str,
    elements: f64,
    links: f64,
    seconds: f64,
    flat: f64,
}

fn runs() -> Vec<Run> {
    let run = |line: &'static str| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |k: usize| cells.get(k)?.parse::<f64>().ok();
        Some(Run {
            scene: cells.first()?,
            method: cells.get(1)?,
            elements: number(2)?,
            links: number(3)?,
            seconds: number(4)?,
            flat: number(5)?,
        })
    };
    let runs: Option<Vec<Run>> = CSV.lines().skip(1).map(run).collect();
    runs.expect("a line of the CSV does not fit")
}

fn points(across: impl Fn(&Run) -> f64, upward: impl Fn(&Run) -> f64) -> Vec<Point> {
    let cornell = runs().into_iter().filter(|run| run.scene == "cornell-regular");
    let point = |run: Run| Point {
        method: run.method.into(),
        setting: format!("{}", run.elements),
        milliseconds: across(&run),
        error: upward(&run),
    };
    cornell.map(point).collect()
}

/// Links, or factors of a matrix, over elements.
pub fn growth() -> String {
    chart::svg(
        "Links, and factors of a matrix, against the number of elements",
        &points(|run| run.elements, |run| run.links),
        "elements",
        "links or factors",
    )
}

/// Error over time.
pub fn svg() -> String {
    chart::svg(
        "Relative error of the Cornell box against the time to solve it; marks are labelled \
         by elements",
        &points(|run| run.seconds, |run| run.flat),
        "seconds of one processor",
        "relative error, flat",
    )
}

/// The slope of links over elements, from 500 elements on.
fn slope(scene: &str) -> f64 {
    let runs = runs();
    let fits = |r: &&Run| r.scene == scene && r.method == "links" && r.elements > 500.0;
    let mut of = runs.iter().filter(fits);
    let (first, last) =
        (of.next().expect("measured"), of.next_back().expect("measured"));
    (last.links / first.links).ln() / (last.elements / first.elements).ln()
}

/// How many times sooner links have the error of the matrix with so many elements.
fn gain(scene: &str, method: &str) -> (f64, f64) {
    let runs = runs();
    let of = |method: &'static str| {
        runs.iter().filter(move |r| r.scene == scene && r.method == method)
    };
    let full = runs
        .iter()
        .find(|r| r.scene == scene && r.method == method && r.elements >= 2000.0)
        .expect("measured");
    let sooner = of("links").find(|r| r.flat <= full.flat).expect("measured");
    (full.elements, full.seconds / sooner.seconds)
}

/// What the charts say.
pub fn text() -> String {
    let (elements, exact) = gain("cornell-regular", "analytic matrix");
    let (_, cubes) = gain("cornell-regular", "hemicube matrix");
    let (of_cube, cube) = gain("cube", "hemicube matrix");
    format!(
        "Links grow as elements to the power {:.2} in the Cornell box and {:.2} in a closed \
         cube; factors as the square. The error that a matrix of {elements} elements has, \
         links have **{exact:.0} times sooner** than analytic factors and {cubes:.0} times \
         sooner than hemicubes; in the cube, where nothing hides anything, {cube:.1} times \
         sooner than a matrix of {of_cube}. Below a thousand elements a matrix does as well \
         there.\n",
        slope("cornell-regular"),
        slope("cube"),
    )
}
