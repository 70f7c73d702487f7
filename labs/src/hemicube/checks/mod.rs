//! The checks of this lab. Each task is judged on values that do not come from the
//! student's other tasks, so that one mistake fails one task; task 6 tries all of them
//! together.

mod buffer;
mod row;
mod weigh;
mod whole;

use super::Work;
use super::bugs::FULL_SIDES;
use super::given::{Weights, cells};
use crate::check::Verdict;
use crate::lab::{Check, check};
use buffer::{BACKS, FAR, NEAR, OWN, buffer};
use row::{Part, row};

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "top", "a cell of the top has the right weight", 1, weigh::top),
    check(1, "side", "a cell of a side has the right weight", 1, weigh::side),
    check(2, "sum", "the weights of the five faces sum to 1", 1, weigh::sum),
    check(2, "weights", "each weight is right, in its place", 2, weigh::weights),
    check(3, "nearest", "the nearest surface is seen", 1, |w, s| buffer(w, s, NEAR)),
    check(3, "far", "a far surface is seen too", 1, |w, s| buffer(w, s, FAR)),
    check(3, "backs", "a back blocks and is black", 1, |w, s| buffer(w, s, BACKS)),
    check(3, "own", "the element does not see itself", 1, |w, s| buffer(w, s, OWN)),
    check(4, "row", "each element gets the weights of its cells", 2, |w, s| {
        row(w, s, Part::Row, 0.0)
    }),
    check(4, "lost", "the other weights are lost, and counted", 1, |w, s| {
        row(w, s, Part::Lost, 0.0)
    }),
    check(4, "cleared", "what was in the row before is gone", 1, |w, s| {
        row(w, s, Part::Row, 1.0)
    }),
    check(5, "shooting", "the factors obey reciprocity", 2, row::shooting),
    check(6, "known", "a unit square 1 above is seen as 0.2395", 2, whole::known),
    check(6, "elsewhere", "a rectangle elsewhere is right", 1, whole::elsewhere),
    check(6, "closed", "a closed room is seen whole", 1, whole::closed),
    check(6, "hidden", "a card hides what is behind it", 2, whole::hidden),
    check(6, "open", "what leaves an open box is counted", 1, whole::open),
];

/// Are the tables as long as a hemicube of `n` cells needs them?
fn sized(weights: &Weights, n: usize) -> Result<(), Verdict> {
    let (top, side) = (weights.top.len(), weights.side.len());
    if (top, side) == (cells(n, 0), cells(n, 1)) {
        return Ok(());
    }
    let (right_top, right_side) = (cells(n, 0), cells(n, 1));
    let message = format!(
        "for n = {n} the tables have {top} and {side} cells, expected {right_top} and \
         {right_side}"
    );
    Err(Verdict::fail(message, (side == n * n).then_some(FULL_SIDES)))
}
