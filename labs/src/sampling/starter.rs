//! Your work. The brief is `book/src/labs/sampling.md`; `given.rs` holds the types.
//! Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run sampling --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use super::given::{Estimate, Pair, Seen};
use radiosity::prelude::{DVec3, Frame, dvec3};
use radiosity::random::Stream;
use std::f64::consts::PI;

/// Task 1: the mean of many values, and its standard error.
pub fn estimate(values: &[f64]) -> Estimate {
    todo!("sampling, task 1: a mean and its error")
}

/// Task 2: a direction about z, in proportion to its cosine.
pub fn direction(u: f64, v: f64) -> DVec3 {
    todo!("sampling, task 2: a direction")
}

/// Task 3: the form factor of a pair by so many rays.
pub fn by_rays(pair: &Pair, samples: usize, stream: &mut Stream) -> Estimate {
    todo!("sampling, task 3: the form factor by rays")
}

/// Task 4: the form factor of a pair by so many pairs of points.
pub fn by_points(pair: &Pair, samples: usize, stream: &mut Stream) -> Estimate {
    todo!("sampling, task 4: the form factor by points")
}

/// What is handed in.
pub const WORK: Work = Work { estimate, direction, by_rays, by_points };
