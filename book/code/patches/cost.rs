//! The chart of the chapter: error over elements, from measurements that are kept.

use crate::chart::{self, Point};
use std::fmt::Write;

/// What `cargo run --release -p book --bin measure-patches` printed.
const CSV: &str = include_str!("../../data/patches-2026-11-22.csv");

fn points() -> Vec<Point> {
    chart::points(CSV).expect("a line of the CSV does not fit")
}

/// Error over elements.
pub fn svg() -> String {
    chart::svg(
        "Relative error of the smooth field against the number of elements, when all are \
         split and when those are that the oracle marks",
        &points(),
        "elements",
        "relative error",
    )
}

/// How many elements a method takes to the error of `to`, on its line between two points.
fn elements_for(points: &[Point], method: &str, error: f64) -> f64 {
    let line: Vec<&Point> = points.iter().filter(|p| p.method == method).collect();
    let crossing = line.windows(2).find(|w| w[0].error >= error && w[1].error <= error);
    let between = |w: &[&Point]| {
        let t = (w[0].error / error).ln() / (w[0].error / w[1].error).ln();
        w[0].milliseconds * (w[1].milliseconds / w[0].milliseconds).powf(t)
    };
    crossing.map_or(f64::INFINITY, between)
}

/// The third round of marked elements, and how many times as many elements it takes to do as
/// well when all are split.
pub fn gain(scene: &str) -> (Point, f64) {
    let points = points();
    let marked = format!("{scene} marked");
    let mut of_scene = points.iter().filter(|p| p.method == marked);
    let third = of_scene.nth(2).expect("there are three rounds").clone();
    let all = elements_for(&points, &format!("{scene} all"), third.error);
    let gain = all / third.milliseconds;
    (third, gain)
}

/// What the chart says.
pub fn text() -> String {
    let [(box_, by), (room, indirect)] = ["box", "indirect"].map(gain);
    format!(
        "With {} elements the Cornell box is {:.1} % off; split all over it takes {by:.1} \
         times as many. The room that is lit through a gap is {:.1} % off with {} elements, \
         and takes {indirect:.1} times as many.\n",
        box_.setting,
        100.0 * box_.error,
        100.0 * room.error,
        room.setting,
    )
}

/// The factors of the Cornell box, against all between its elements.
pub fn table() -> String {
    let mut text = String::from(
        "| elements *n* | error | rows kept: *m n* | computed | all pairs: *n*² |\n\
         |---|---|---|---|---|\n",
    );
    for line in CSV.lines().filter(|line| line.starts_with("box marked")) {
        let cells: Vec<f64> =
            line.split(',').skip(2).filter_map(|cell| cell.parse().ok()).collect();
        let &[n, error, m, factors] = &cells[..] else { continue };
        let millions = |count: f64| format!("{:.2} M", 1e-6 * count);
        let _ = writeln!(
            text,
            "| {n} | {:.1} % | {} | {} | {} |",
            100.0 * error,
            millions(m * n),
            millions(factors),
            millions(n * n)
        );
    }
    text
}
