//! Played students of this lab: the answer with one mistake each. `cargo lab ci` proves
//! that every one is caught and named; `cargo lab run hemicube --wrong NAME` shows what
//! the student would read. They are written on their own: not by the formulas by which the
//! checks suspect a mistake.

mod buffer;
mod row;
mod weigh;

use super::Work;
use crate::lab::Wrong;

/// All played students, task by task.
pub const ALL: &[&[Wrong<Work>]] = &[weigh::ALL, buffer::ALL, row::ALL];
