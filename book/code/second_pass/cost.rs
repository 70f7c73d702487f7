//! What the charts of the chapter say, from measurements that are kept with their date.

use crate::chart::{find, trials};
use radiosity::chart::suites::second_pass::{GLOSS, LOBE, MIRROR, PLAIN};

/// What `radiosity chart second-pass -o book/data` wrote.
const CSV: &str = include_str!("../../data/second-pass.csv");

/// The tolerance of pass 1 that is looked at.
const TOLERANCE: f64 = 0.02;

/// The error of two passes, and how many times as long paths take for the same: theirs falls
/// as one over the root of the time.
pub fn gain(scene: &str) -> (f64, f64) {
    let trials = trials(CSV);
    let two = find(&trials, scene, "two passes", TOLERANCE);
    let paths = find(&trials, scene, "paths", 64.0);
    let needed = paths.seconds * (paths.error / two.error).powi(2);
    (two.error, needed / two.seconds)
}

/// To one digit: the spread of 64 samples is not known better.
fn round(v: f64) -> f64 {
    let unit = 10f64.powf(v.log10().floor());
    (v / unit).round() * unit
}

fn per_cent(v: f64) -> String {
    let v = 100.0 * v;
    if v < 10.0 { format!("{v:.1} %") } else { format!("{v:.0} %") }
}

/// What the charts of whole pictures say.
pub fn text() -> String {
    let trials = trials(CSV);
    let two = find(&trials, MIRROR, "two passes", TOLERANCE);
    let gathered = |scene| find(&trials, scene, "light gathered anew", 64.0);
    let first = |scene| find(&trials, scene, "two passes", 0.1);
    format!(
        "Both passes together take {:.1} s of one thread for an error of {} of the mean. By \
         the law of one over the root, paths would take {:.0} times as long for the same: \
         what the mirror throws on the walls they find by chance, on the small lamp. That \
         makes the comparison easy to win; so here is the harder one. In the same box \
         *without* a mirror paths would still take {:.0} times as long.\n\n\
         Light gathered anew with 64 rays at each pixel, on top of a coarse pass 1, is off \
         by {} without a mirror, where the stored light itself is off by {}; with the \
         mirror, by {}: now pass 2 has to find by chance what pass 1 had known. In that time \
         a finer pass 1 does more.\n",
        two.seconds,
        per_cent(two.error),
        round(gain(MIRROR).1),
        round(gain(PLAIN).1),
        per_cent(gathered(PLAIN).error),
        per_cent(first(PLAIN).error),
        per_cent(gathered(MIRROR).error),
    )
}

/// What the chart of a glossy floor says.
pub fn gloss() -> String {
    let trials = trials(CSV);
    let off = |method: &str, n: f64| per_cent(find(&trials, GLOSS, method, n).error);
    format!(
        "With one ray for each sample the floor is off by {}, with 32 by {}; with 8 rays, \
         but one random cone of the stack, by {}, with 32 cones by {}. The lamp is what is \
         bright: **cones first, rays after**. One fixed cone comes to {} at the best. It has \
         no noise, but the wrong shape, and no number of rays mends that.\n",
        off("N rays and 8 cones", 1.0),
        off("N rays and 8 cones", 32.0),
        off("8 rays and N cones", 1.0),
        off("8 rays and N cones", 32.0),
        off("N rays in one cone", 32.0),
    )
}

/// What the chart of one lamp in one lobe says.
pub fn lobe() -> String {
    let trials = trials(CSV);
    let off = |method: &str, n: f64| per_cent(find(&trials, LOBE, method, n).error);
    format!(
        "A lamp that begins 5° off the axis. 16 cones are off by {}, 16 rays by {}; the one \
         cone by {}, and always will be.\n",
        off("N stacked cones", 16.0),
        off("N rays", 16.0),
        off("one cone of 90 %", 1.0),
    )
}
