//! The chart of the chapter: the noise of paths over time, from measurements that are kept.

use crate::chart::{self, Point};

/// What `cargo run -p book --bin measure-transport` printed.
const CSV: &str = include_str!("../../data/transport-2026-11-22.csv");

fn points() -> Vec<Point> {
    chart::points(CSV).expect("a line of the CSV does not fit")
}

/// Error over time.
pub fn svg() -> String {
    chart::svg(
        "Noise of a picture by paths against the time it took, for three ways to find lamps",
        &points(),
        "milliseconds for 64 × 64 pixels",
        "RMS standard error / mean",
    )
}

/// How many times as long `method` takes as `both` does, for the same noise.
pub fn longer(method: &str) -> f64 {
    let worth = |method: &str| {
        let all: Vec<f64> = points()
            .iter()
            .filter(|p| p.method == method)
            .map(|p| p.error.powi(2) * p.milliseconds)
            .collect();
        all.iter().sum::<f64>() / all.len() as f64
    };
    worth(method) / worth("both")
}

/// What the chart says.
pub fn text() -> String {
    let points = points();
    let both = points.iter().rfind(|p| p.method == "both").expect("it was measured");
    let minutes = both.milliseconds * (both.error / 0.02).powi(2) / 60_000.0;
    format!(
        "All fall as one over the root of the time. For the same noise, directions of the \
         lobe alone take {:.1} times as long as both ways together, lamps alone {:.1} times. \
         That is so little because most of the noise has one cause: light that the mirror \
         throws. There the lamp cannot be asked, for a mirror stands between, and directions \
         find it rarely. To a noise of 2 % even both together take about {minutes:.0} minutes on \
         one thread, for 64 × 64 pixels.\n",
        longer("lobes"),
        longer("lamps"),
    )
}
