//! The checks of this lab.
//!
//! ```text
//! midpoint rule, k places in each of four variables:  error ~ k⁻² = evaluations^(−1/2)
//! ```
//! Tasks 1 to 3 are right to rounding. Task 4 is free: what is asked of it are powers
//! of the effort, not values.

mod errors;
mod factors;
mod frontiers;
mod slopes;
mod whole;

use super::Work;
use crate::lab::{Check, check};

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "off", "the error over seeds is right", 2, errors::off),
    check(2, "frontier", "what nothing beats is found", 2, frontiers::apart),
    check(2, "equals", "of equal times, errors and trials, too", 1, frontiers::equals),
    check(3, "slope", "the slope is that of the logarithms", 2, slopes::slope),
    check(3, "zeros", "trials without a logarithm do not count", 1, slopes::zeros),
    check(4, "allowed", "never more evaluations than allowed", 1, factors::allowed),
    check(4, "limit", "with effort the factor is right", 3, factors::limit),
    check(4, "edge", "a common edge does no harm", 1, factors::edge),
    check(4, "faster", "it beats the midpoint rule", 2, factors::faster),
    check(5, "chart", "the chart says so, too", 1, whole::chart),
];
