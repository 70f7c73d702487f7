//! Your work. The brief is `book/src/labs/race.md`; `given.rs` holds the pair.
//! Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run race --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use super::given::{Pair, gauss};

/// Task 1: how far answers are off, over seeds, as a share of the exact value.
pub fn off(answers: &[f64], exact: f64) -> f64 {
    todo!("race, task 1: the root mean square error")
}

/// Task 2: which trials (time, error) no other one beats.
pub fn frontier(trials: &[(f64, f64)]) -> Vec<usize> {
    todo!("race, task 2: the frontier")
}

/// Task 3: the slope of trials (time, error) on logarithmic axes.
pub fn slope(trials: &[(f64, f64)]) -> f64 {
    todo!("race, task 3: the slope")
}

/// Task 4: the form factor of a pair, from at most `effort` evaluations of its kernel.
pub fn factor(pair: &Pair, effort: u32) -> f64 {
    todo!("race, task 4: a method of your own")
}

/// What is handed in.
pub const WORK: Work = Work { off, frontier, slope, factor };
