//! What the charts of *Light from the sky* say, from measurements that are kept with their
//! date.

use crate::chart::{find, trials};
use radiosity::chart::suites::sky::{Draw, OVERCAST, SUNNY};

/// What `radiosity chart sky -o book/data` wrote.
const CSV: &str = include_str!("../../data/sky.csv");

/// What the chart of the sunny sky says.
pub fn text() -> String {
    let trials = trials(CSV);
    let of = |draw: Draw| find(&trials, SUNNY, draw.name(), 1024.0);
    let (even, bright) = (of(Draw::Even), of(Draw::Bright));
    let all = trials.iter().find(|t| t.method == "all texels").expect("measured");
    format!(
        "Of 1024 directions, even ones leave an error of {:.0} %, those drawn by brightness \
         {:.1} %: some {:.0} thousand times as many even ones would be needed. Summing all texels takes \
         {:.1} ms - but only for a point that sees all of the sky.\n",
        100.0 * even.error,
        100.0 * bright.error,
        1e-3 * (even.error / bright.error).powi(2),
        1e3 * all.seconds,
    )
}

/// What the chart of the overcast sky says.
pub fn clouds() -> String {
    let trials = trials(CSV);
    let of = |draw: Draw| find(&trials, OVERCAST, draw.name(), 1024.0);
    let worth = |draw: Draw| of(draw).error.powi(2) * of(draw).seconds;
    format!(
        "Under clouds there is no sun to miss: of 1024 directions even ones leave {:.1} %, \
         those by the cosine {:.1} %, those by brightness {:.1} %. For the same error even \
         ones take {:.1} times as long as those by the cosine.\n",
        100.0 * of(Draw::Even).error,
        100.0 * of(Draw::Cosine).error,
        100.0 * of(Draw::Bright).error,
        worth(Draw::Even) / worth(Draw::Cosine),
    )
}
