//! What each stage takes, from measurements that are kept with their date.

use crate::chart::{self, Point};
use std::fmt::Write;

/// What `cargo run --release -p book --bin measure-pipeline` printed: stage, setting,
/// elements, milliseconds, megabytes.
const CSV: &str = include_str!("../../data/pipeline-2026-11-22.csv");

/// One line of it.
struct Measured {
    stage: &'static str,
    elements: f64,
    milliseconds: f64,
    megabytes: f64,
}

fn measured() -> Vec<Measured> {
    let line = |line: &'static str| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |k: usize| cells[k].parse().expect("a number in the CSV");
        Measured {
            stage: cells[0],
            elements: number(2),
            milliseconds: number(3),
            megabytes: number(4),
        }
    };
    CSV.lines().skip(1).map(line).collect()
}

/// The stages, in order, and what they are called in the CSV.
const STAGES: [&str; 4] = ["split", "form factors", "solve", "render"];

/// The elements of the meshes that were measured.
fn sizes() -> Vec<f64> {
    let of_split = measured().into_iter().filter(|m| m.stage == STAGES[0]);
    of_split.map(|m| m.elements).collect()
}

fn of(stage: &str, elements: f64) -> Measured {
    let fits = |m: &Measured| m.stage == stage && m.elements == elements;
    measured().into_iter().find(fits).expect("it was measured")
}

/// The mesh that captions speak of: the finest.
pub fn shown() -> f64 {
    sizes().into_iter().fold(0.0, f64::max)
}

/// What is done once for a room on that mesh, in seconds.
pub fn solve_share() -> f64 {
    STAGES[..3].iter().map(|stage| of(stage, shown()).milliseconds / 1e3).sum()
}

/// What a picture takes on that mesh, in milliseconds.
pub fn picture_share() -> f64 {
    of(STAGES[3], shown()).milliseconds
}

/// A time, in the unit that suits it.
fn time(milliseconds: f64) -> String {
    match milliseconds {
        t if t >= 1e3 => format!("{:.1} s", t / 1e3),
        t if t >= 10.0 => format!("{t:.0} ms"),
        t if t >= 1.0 => format!("{t:.1} ms"),
        t => format!("{t:.2} ms"),
    }
}

/// Sizes and times as a Markdown table.
pub fn table() -> String {
    let mut text = String::from(
        "| elements n | pairs n² | F, non-zeros | 1 split | 2 form factors | 3 solve | \
         4 render |\n|---|---|---|---|---|---|---|\n",
    );
    for n in sizes() {
        let pairs = n * n / 1e3;
        let memory = of(STAGES[1], n).megabytes;
        let _ = write!(text, "| {n} | {pairs:.0} thousand | {memory:.1} MB |");
        for stage in STAGES {
            let _ = write!(text, " {} |", time(of(stage, n).milliseconds));
        }
        text.push('\n');
    }
    text
}

/// The chart as SVG; elements and milliseconds stand in the places of time and error.
pub fn svg() -> String {
    let points: Vec<Point> =
        chart::points(CSV).expect("a line of the CSV does not fit");
    chart::svg(
        "Time of each stage of the pipeline against the number of elements",
        &points,
        "elements",
        "milliseconds, one thread",
    )
}

/// By which power of the number of elements a stage grows, from the second mesh on.
fn exponent(stage: &str) -> f64 {
    let sizes = sizes();
    let (first, last) = (sizes[1], sizes[sizes.len() - 1]);
    let time = |n: f64| of(stage, n).milliseconds;
    (time(last) / time(first)).ln() / (last / first).ln()
}

/// What the chart says.
pub fn text() -> String {
    let share = of(STAGES[1], shown()).milliseconds / 1e3 / solve_share();
    let [split, factors, solve, render] = STAGES.map(exponent);
    format!(
        "**The form factors take {:.0} % of what is done once.** From the second mesh \
         on, the times grow as n to the power {split:.1} (split), {factors:.1} (form \
         factors), {solve:.1} (solve) and {render:.1} (render).\n",
        100.0 * share
    )
}
