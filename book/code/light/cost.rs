//! What the charts of the chapters on light say.

use crate::chart::{find, trials};
use radiosity::chart::Trial;
use radiosity::chart::suites::light::{IRRADIANCE, SOLID_ANGLE};

fn light() -> Vec<Trial> {
    trials(include_str!("../../data/light.csv"))
}

/// A number to two digits: times differ from run to run.
fn about(v: f64) -> f64 {
    let unit = 10f64.powf(v.log10().floor() - 1.0);
    (v / unit).round() * unit
}

/// What the chart of *Solid angle* says.
pub fn solid_angle_text() -> String {
    let trials = light();
    let find = |method, setting| find(&trials, SOLID_ANGLE, method, setting);
    let exact = find("closed form", 1.0).seconds;
    format!(
        "The exact formula costs as much as {:.0} pieces. Pieces win a factor of four in \
         error for a factor of four in time: they are second order in their edge, and \
         there are two edges to cut. 100 000 rays take {:.0} times as long as the exact \
         formula, and know three digits.\n",
        64.0 * exact / find("k × k pieces", 8.0).seconds,
        about(find("rays", 1e5).seconds / exact)
    )
}

/// What the chart of *Radiometry* says.
pub fn irradiance_text() -> String {
    let trials = light();
    let find = |method, setting| find(&trials, IRRADIANCE, method, setting);
    let (cosine, even) = ("rays by the cosine", "even rays");
    format!(
        "Of the same number of rays, those that are drawn by the cosine tell more: 10 000 of \
         them leave an error of {:.2} %, as many even ones {:.2} %, for those spend half of \
         their number on directions that hardly count. One evaluation of Lambert's formula \
         takes as long as some {:.0} rays, and is exact.\n",
        100.0 * find(cosine, 1e4).error,
        100.0 * find(even, 1e4).error,
        about(100.0 * find("closed form", 1.0).seconds / find(cosine, 100.0).seconds)
    )
}
