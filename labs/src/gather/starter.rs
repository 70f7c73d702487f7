//! Your work. The brief is `book/src/labs/gather.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run gather --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use super::given::{Balance, Room, Solved};

/// Task 1: what arrives at element `i`, W/m².
pub fn arriving(room: &Room, b: &[f64], i: usize) -> f64 {
    todo!("gather, task 1: what arrives")
}

/// Task 2: the radiosities after one bounce, W/m², all from the old ones.
pub fn bounce(room: &Room, b: &[f64]) -> Vec<f64> {
    todo!("gather, task 2: a bounce")
}

/// Task 3: one sweep through the elements, in place, each from the newest values.
pub fn sweep(room: &Room, b: &mut [f64]) {
    todo!("gather, task 3: a sweep")
}

/// Task 4: what is missing in the equation of each element, W/m².
pub fn residual(room: &Room, b: &[f64]) -> Vec<f64> {
    todo!("gather, task 4: the residual")
}

/// Task 5: where the light is, in W.
pub fn balance(room: &Room, b: &[f64]) -> Balance {
    todo!("gather, task 5: the balance")
}

/// Task 6: radiosities that are off by `accuracy` at the most, W/m².
pub fn solve(room: &Room, accuracy: f64) -> Solved {
    todo!("gather, task 6: a solution, for certain")
}

/// What is handed in.
pub const WORK: Work = Work { arriving, bounce, sweep, residual, balance, solve };
