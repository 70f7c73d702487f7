//! What the chart of *Progressive refinement* says.

use crate::chart::{find, trials};
use radiosity::chart::suites::solvers::FIRST_PICTURE;

/// A paragraph with its numbers.
pub fn text() -> String {
    let trials = trials(include_str!("../../data/solvers.csv"));
    let find = |method, setting| find(&trials, FIRST_PICTURE, method, setting);
    let (early, guessed) = (find("shoot", 100.0), find("shoot with ambient", 100.0));
    let (first, last) = (find("all rows first", 1.0), find("all rows first", 8.0));
    format!(
        "A hundred shots take {:.0} ms; the picture is {:.0} % off then, and {:.0} % \
         with the ambient term. Whoever computes all rows first waits {:.0} ms for the \
         first sweep, which is {:.0} % off, but a few more sweeps are nearly free. \
         All end at {:.1} %, give or take: that is the hemicubes' own error.\n",
        1e3 * early.seconds,
        100.0 * early.error,
        100.0 * guessed.error,
        1e3 * first.seconds,
        100.0 * first.error,
        100.0 * last.error,
    )
}
