//! Your work. The brief is `book/src/labs/sky.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run sky --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::{Map, Work};
use radiosity::prelude::{DVec2, DVec3, dvec3};
use std::f64::consts::{PI, TAU};

/// Task 1: the solid angle of a texel in `row`, in sr.
pub fn texel(width: usize, height: usize, row: usize) -> f64 {
    todo!("sky, task 1: what a texel is worth")
}

/// Task 2: the direction to the middle of a texel.
pub fn direction(width: usize, height: usize, column: usize, row: usize) -> DVec3 {
    todo!("sky, task 2: where a texel is")
}

/// Task 3: the irradiance of a plane with this unit normal, in W/m².
pub fn irradiance(map: &Map, normal: DVec3) -> f64 {
    todo!("sky, task 3: what falls on a plane")
}

/// Task 4: a direction drawn by brightness, and its density in 1/sr.
pub fn sample(map: &Map, u: DVec2) -> (DVec3, f64) {
    todo!("sky, task 4: a direction by brightness")
}

/// What is handed in.
pub const WORK: Work = Work { texel, direction, irradiance, sample };
