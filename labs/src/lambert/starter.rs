//! Your work. The brief is `book/src/labs/lambert.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run lambert --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use radiosity::prelude::DVec3;
use std::f64::consts::PI;

/// Task 1: γ n·Γ of the edge from `a` to `b`.
pub fn edge(a: DVec3, b: DVec3, n: DVec3) -> f64 {
    todo!("lambert, task 1: what one edge adds")
}

/// Task 2: the form factor from the origin to a polygon wholly above the horizon.
pub fn all_above(n: DVec3, corners: &[DVec3]) -> f64 {
    todo!("lambert, task 2: a polygon above the horizon")
}

/// Task 3: what of an outline lies above the plane through the origin with normal `n`.
pub fn clip(n: DVec3, corners: &[DVec3]) -> Vec<DVec3> {
    todo!("lambert, task 3: the part above the horizon")
}

/// Task 4: the form factor from the point `p` to any polygon.
pub fn form_factor(p: DVec3, n: DVec3, corners: &[DVec3]) -> f64 {
    todo!("lambert, task 4: any polygon")
}

/// What is handed in.
pub const WORK: Work = Work { edge, all_above, clip, form_factor };
