//! The chart of the chapter, from measurements that are kept with their date.

use crate::chart::{self, Point};

/// What `cargo run --release -p book --bin measure` printed.
const CSV: &str = include_str!("../../data/hemicube-2026-11-22.csv");

fn points() -> Vec<Point> {
    chart::points(CSV).expect("a line of the CSV does not fit")
}

/// The chart as SVG.
pub fn svg() -> String {
    chart::svg(
        "Largest error of a form factor against the time for a row of them",
        &points(),
        "milliseconds for a row",
        "largest error of a factor",
    )
}

/// What the chart says, in a paragraph with its numbers.
pub fn text() -> String {
    let points = points();
    let hemicube = |pairs: &str, setting: &str| {
        let fits = |p: &&Point| p.method == pairs && p.setting == setting;
        points.iter().find(fits).expect("the resolution was measured")
    };
    let near = hemicube("hemicube", "1024");
    let far = hemicube("hemicube (far pairs)", "128");
    let finest = hemicube("hemicube (far pairs)", "1024");
    let as_good = |method: &str| {
        let fits = |p: &&Point| p.method == method && p.error <= far.error;
        points.iter().find(fits).expect("the method reaches that error")
    };
    let times = |p: &Point| p.milliseconds / far.milliseconds;
    let (analytic, rays) = (as_good("analytic"), as_good("rays"));
    format!(
        "Two failures can be read off. Over *all* pairs the hemicube is off by {:.3}, even \
         at resolution 1024: that is proximity, where elements meet in a corner, and finer \
         cells do not help. Over *far* pairs the error falls to {:.5} at resolution 128, and \
         is {:.5} at 1024: there aliasing has sunk below what the centre gets wrong. \
         **Beyond 128, time is wasted here.** A row at 128 takes {:.2} ms. To be as good \
         as that, over all pairs, analytic factors (tolerance {}) take {:.0} times as long, \
         and {} rays {:.0} times.\n",
        near.error,
        far.error,
        finest.error,
        far.milliseconds,
        analytic.setting,
        times(analytic),
        rays.setting,
        times(rays)
    )
}
