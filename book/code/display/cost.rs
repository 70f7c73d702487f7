//! What the chart of *The picture* says: samples in a pixel, from measurements that are
//! kept with their date.

use crate::chart::{find, trials};
use radiosity::chart::suites::pictures::DRAWN;

/// What `radiosity chart pictures -o book/data` wrote.
const CSV: &str = include_str!("../../data/pictures.csv");

/// What it says.
pub fn text() -> String {
    let trials = trials(CSV);
    let of = |method: &str, samples: f64| find(&trials, DRAWN, method, samples);
    let (flat, smooth, best) = (of("flat", 1.0), of("smooth", 1.0), of("smooth", 3.0));
    format!(
        "A flat picture takes {:.1} ms, a smooth one {:.1} ms: most of it are weights of \
         corners. Nine samples in a pixel cost nine times as much and bring the error from \
         {:.0} % of the mean to {:.0} %. It does not fall evenly, and it is the same for both: nearly all \
         of it is the outline of the lamp, and how samples fall upon four straight edges is \
         luck.\n",
        1e3 * flat.seconds,
        1e3 * smooth.seconds,
        100.0 * smooth.error,
        100.0 * best.error,
    )
}
