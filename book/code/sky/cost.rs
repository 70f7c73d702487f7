//! The chart of *Light from the sky*, from measurements that are kept with their date.

use crate::chart::{self, Point};

/// What `cargo run --release -p book --bin measure-sky` printed.
const CSV: &str = include_str!("../../data/sky-2026-11-22.csv");

fn points() -> Vec<Point> {
    chart::points(CSV).expect("a line of the CSV does not fit")
}

/// Error against time of the irradiance below the sunny sky.
pub fn svg() -> String {
    chart::svg(
        "Relative error of the ground's irradiance against the time to find it",
        &points(),
        "milliseconds for one point",
        "relative error",
    )
}

/// What that chart says.
pub fn text() -> String {
    let of = |method: &str, setting: &str| {
        let found =
            points().into_iter().find(|p| p.method == method && p.setting == setting);
        found.expect("it was measured")
    };
    let [even, bright] = ["even", "by brightness"].map(|method| of(method, "1024"));
    let all = of("all texels", "exact");
    format!(
        "Of 1024 directions, even ones leave an error of {:.0} %, those drawn by brightness \
         {:.1} %: {:.0} times as many even ones would be needed. Summing all texels takes \
         {:.1} ms - but only for a point that sees all of the sky.\n",
        100.0 * even.error,
        100.0 * bright.error,
        (even.error / bright.error).powi(2),
        all.milliseconds,
    )
}
