//! Your work. The brief is `book/src/labs/solid-angle.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run solid-angle --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use radiosity::prelude::DVec3;
use std::f64::consts::PI;

/// Task 1: A cosθ/r², in sr, of a small surface that is seen from the origin.
pub fn small(at: DVec3, normal: DVec3, area: f64) -> f64 {
    todo!("solid-angle, task 1: a small surface")
}

/// Task 2: the solid angle of a triangle from the origin, in sr, with its sign.
pub fn triangle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    todo!("solid-angle, task 2: a triangle")
}

/// Task 3: the solid angle of a flat polygon from `point`, in sr, with its sign.
pub fn polygon(point: DVec3, corners: &[DVec3]) -> f64 {
    todo!("solid-angle, task 3: a polygon")
}

/// Task 4: the sum over the faces of a closed surface, in sr.
pub fn surface(point: DVec3, faces: &[Vec<DVec3>]) -> f64 {
    todo!("solid-angle, task 4: a closed surface")
}

/// What is handed in.
pub const WORK: Work = Work { small, triangle, polygon, surface };
