//! What the chart of the chapter says.

use crate::chart::{find, trials};
use radiosity::chart::Trial;
use radiosity::chart::suites::form_factors::{MEASURED, ROWS};

/// A paragraph with its numbers.
pub fn text() -> String {
    let trials = trials(include_str!("../../data/form-factors.csv"));
    let hemicube = |pairs: &str, setting| find(&trials, ROWS, pairs, setting);
    let near = hemicube("hemicube", 1024.0);
    let far = hemicube("hemicube: far pairs", 128.0);
    let finest = hemicube("hemicube: far pairs", 1024.0);
    let as_good = |method: &str| {
        let fits =
            |t: &&Trial| t.scene == ROWS && t.method == method && t.error <= far.error;
        trials.iter().find(fits).expect("the method reaches that error")
    };
    let times = |t: &Trial| t.seconds / far.seconds;
    let (analytic, rays) = (as_good("Lambert's formula"), as_good("rays"));
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
        1e3 * far.seconds / MEASURED as f64,
        analytic.setting,
        times(analytic),
        rays.setting,
        times(rays)
    )
}
