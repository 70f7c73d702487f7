//! What the chart of the chapter says: the error of paths over time, from measurements that
//! are kept with their date.

use crate::chart::{find, trials};
use radiosity::chart::Trial;
use radiosity::chart::suites::pictures::STRATEGIES;

/// What `radiosity chart pictures -o book/data` wrote.
const CSV: &str = include_str!("../../data/pictures.csv");

/// How many times as long `method` takes as `both` does, for the same error.
pub fn longer(method: &str) -> f64 {
    let trials = trials(CSV);
    let worth = |method: &str| {
        let fits = |t: &&Trial| t.scene == STRATEGIES && t.method == method;
        let all: Vec<f64> =
            trials.iter().filter(fits).map(|t| t.error.powi(2) * t.seconds).collect();
        all.iter().sum::<f64>() / all.len() as f64
    };
    worth(method) / worth("both")
}

/// What the chart says.
pub fn text() -> String {
    let trials = trials(CSV);
    let both = find(&trials, STRATEGIES, "both", 256.0);
    let minutes = both.seconds * (both.error / 0.02).powi(2) / 60.0;
    format!(
        "All fall as one over the root of the time. For the same error, directions of the \
         lobe alone take {:.1} times as long as both ways together, lamps alone {:.1} times. \
         That is so little because most of the noise has one cause: light that the mirror \
         throws. There the lamp cannot be asked, for a mirror stands between, and directions \
         find it rarely. To an error of 2 % even both together take about {minutes:.0} minutes \
         on one thread, for 64 × 64 pixels.\n",
        longer("lobes"),
        longer("lamps"),
    )
}
