//! Your work. The brief is `book/src/labs/certify.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run certify --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use super::given::{Point, Room};

/// Task 1: the residual at a point, W/m², by one of its two gathers.
pub fn residual(point: &Point, gather: usize) -> f64 {
    todo!("certify, task 1: the residual")
}

/// Task 2: the norm of the residual, squared, right in the mean.
pub fn squared(points: &[Point]) -> f64 {
    todo!("certify, task 2: the norm, past the noise")
}

/// Task 3: the least and the largest norm of the error.
pub fn worst_case(norm: f64, reflectance: f64) -> [f64; 2] {
    todo!("certify, task 3: the worst case")
}

/// Task 4: an error of this norm, relative to the light that was reflected.
pub fn relative(norm: f64, points: &[Point]) -> f64 {
    todo!("certify, task 4: relative to what?")
}

/// Task 5: the error of each piece, W/m², from the residual of each.
pub fn propagated(room: &Room, residual: &[f64]) -> Vec<f64> {
    todo!("certify, task 5: propagated")
}

/// What is handed in.
pub const WORK: Work = Work { residual, squared, worst_case, relative, propagated };
