//! The chart of work against sharpness, from its record.

use crate::chart;

const RECORD: &str = include_str!("../../data/certificate-2026-11-22.csv");

/// The chart.
pub fn svg() -> String {
    chart::svg(
        "Half the width of the interval against time",
        &chart::points(RECORD).unwrap_or_default(),
        "milliseconds, one thread",
        "half width over error",
    )
}

/// What it says.
pub fn text() -> String {
    let points = chart::points(RECORD).unwrap_or_default();
    let usual = points.iter().find(|p| p.method == "64 rays" && p.setting == "3200");
    match usual {
        Some(p) => format!(
            "The usual work, 3200 points of 2 × 64 rays, takes {:.0} ms and knows the \
             error to ± {:.0} % of itself.\n",
            p.milliseconds,
            100.0 * p.error
        ),
        None => String::new(),
    }
}
