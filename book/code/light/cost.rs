//! The charts of the chapters on light, from measurements that are kept with their date.

use crate::chart::{self, Point};

/// What `cargo run --release -p book --bin measure light` printed.
const CSV: &str = include_str!("../../data/light-2026-11-22.csv");

/// The measurements of one chapter: those whose method starts with `group`.
fn points(group: &str) -> Vec<Point> {
    let points = chart::points(CSV).expect("a line of the CSV does not fit");
    let of_group = |mut p: Point| {
        p.method = p.method.strip_prefix(group)?.trim_start().into();
        Some(p)
    };
    points.into_iter().filter_map(of_group).collect()
}

/// The chart of *Solid angle*.
pub fn solid_angle() -> String {
    chart::svg(
        "Relative error of a solid angle against the time to find it",
        &points("Ω"),
        "milliseconds for a solid angle",
        "relative error",
    )
}

/// How many times as long `method` takes at `setting` as the exact formula.
fn times(group: &str, method: &str, setting: &str) -> f64 {
    let points = points(group);
    let find = |method: &str, setting: &str| {
        let fits = |p: &&Point| p.method == method && p.setting == setting;
        points.iter().find(fits).expect("it was measured").milliseconds
    };
    find(method, setting) / find("exact", "closed form")
}

/// A number to two digits: times differ from run to run.
fn about(v: f64) -> f64 {
    let unit = 10f64.powf(v.log10().floor() - 1.0);
    (v / unit).round() * unit
}

/// What the chart of *Solid angle* says.
pub fn solid_angle_text() -> String {
    format!(
        "The exact formula costs as much as {:.0} pieces. Pieces win a factor of four in \
         error for a factor of four in time: they are second order in their edge, and \
         there are two edges to cut. 100 000 rays take {:.0} times as long as the exact \
         formula, and know three digits.\n",
        64.0 / times("Ω", "pieces", "64"),
        about(times("Ω", "rays", "100000"))
    )
}

/// The chart of *Radiometry*.
pub fn irradiance() -> String {
    chart::svg(
        "Relative error of an irradiance against the time to find it",
        &points("H"),
        "milliseconds for an irradiance",
        "relative error",
    )
}

/// What the chart of *Radiometry* says.
pub fn irradiance_text() -> String {
    let points = points("H");
    let error = |method: &str| {
        let fits = |p: &&Point| p.method == method && p.setting == "10000";
        100.0 * points.iter().find(fits).expect("it was measured").error
    };
    format!(
        "Of the same number of rays, those that are drawn by the cosine tell more: 10 000 of \
         them leave an error of {:.2} %, as many even ones {:.2} %, for those spend half of \
         their number on directions that hardly count. One evaluation of Lambert's formula \
         takes as long as some {:.0} rays, and is exact.\n",
        error("cosine rays"),
        error("even rays"),
        about(100.0 / times("H", "cosine rays", "100"))
    )
}
