//! The chart of the chapter, from measurements that are kept with their date.

use crate::chart::{self, Point};

/// What `cargo bench --bench second_pass` printed.
const CSV: &str = include_str!("../../data/second-pass-2026-11-22.csv");

fn points() -> Vec<Point> {
    let points = chart::points(CSV).expect("a line of the CSV does not fit");
    // The record is in seconds.
    points
        .into_iter()
        .map(|p| Point { milliseconds: 1e3 * p.milliseconds, ..p })
        .collect()
}

/// The chart as SVG.
pub fn svg() -> String {
    chart::svg(
        "Root mean square error of a picture against the time for it",
        &points(),
        "milliseconds for 512 × 512 pixels, one thread",
        "error of a pixel, relative to the mean",
    )
}

/// By how much less time two passes reach an error than paths do; `(seconds, error,
/// times)` of the first picture that is no worse than `error`, against paths of this name.
pub fn gain(error: f64, by: &str) -> (f64, f64, f64) {
    let points = points();
    let two = points.iter().filter(|p| p.method == "two passes" && p.error <= error);
    let two = two
        .min_by(|a, b| a.milliseconds.total_cmp(&b.milliseconds))
        .expect("some picture is that good");
    let paths = points.iter().rfind(|p| p.method == by).expect("measured");
    // Their error falls as one over the root of the time.
    let needed = paths.milliseconds * (paths.error / two.error).powi(2);
    (1e-3 * two.milliseconds, two.error, needed / two.milliseconds)
}

/// What the chart says.
pub fn text() -> String {
    let (seconds, error, times) = gain(0.02, "paths");
    let (_, _, bare) = gain(0.02, "paths without mirror");
    // To one digit: a spread of 64 samples is not known better.
    let round = |times: f64| {
        let unit = 10f64.powf(times.log10().floor());
        (times / unit).round() * unit
    };
    format!(
        "Both passes together take {seconds:.1} s of one thread for an error of {:.1} % of \
         the mean. By the law of one over the root, paths would take {:.0} times as long \
         for the same: what the mirror throws on the walls they find by chance, on the \
         small lamp. That makes the comparison easy to win; so here is the harder one. In \
         the same box *without* a mirror paths would still take {:.0} times as long.\n",
        100.0 * error,
        round(times),
        round(bare)
    )
}
