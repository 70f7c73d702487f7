//! The checks of this lab.
//!
//! ```text
//! |T̂ − T| ≲ h²        a mean over rings of the width h: the rule at their middle
//! ```
//! Everything else is exact: tolerances are those of rounding.

mod faces;
mod scenes;
mod sheets;

use super::Work;
use crate::check::{Bug, Suspect};
use crate::lab::{Check, check};

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "faces", "one face reflects by Fresnel's law", 2, faces::fresnel),
    check(1, "brewster", "p vanishes at Brewster's angle", 1, faces::brewster),
    check(2, "panes", "a pane passes what it should, at any angle", 2, faces::panes),
    check(2, "tables", "known panes are right", 1, faces::tables),
    check(3, "mean", "of diffuse light it passes the mean", 2, faces::mean),
    check(4, "clear", "a lamp is seen through a pane", 2, scenes::clear),
    check(4, "wall", "and not through the wall beside it", 1, scenes::wall),
    check(4, "sides", "backs and what is below send nothing", 1, scenes::sides),
    check(5, "sheet", "both faces reflect and pass", 2, sheets::sheet),
    check(6, "frosted", "a frosted window is a lamp", 2, sheets::frosted),
];

/// What one mistake each makes of what is asked.
type Suspects<A, T> = [(Bug, fn(&A) -> T)];

/// The numbers that each mistake makes of all that is asked.
fn suspects<A>(wrong: &Suspects<A, f64>, asked: &[A]) -> Vec<Suspect> {
    wrong.iter().map(|(bug, f)| (*bug, asked.iter().map(f).collect())).collect()
}
