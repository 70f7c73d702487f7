//! Your work. The brief is `book/src/labs/cone.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run cone --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::given::{Cap, Glance, Hit};
use super::{Light, Work, World};
use radiosity::prelude::{DVec3, Frame, dvec3};
use radiosity::random::Stream;
use std::f64::consts::PI;

/// Task 1: the solid angle of a cone.
pub fn solid_angle(half_angle: f64) -> f64 {
    todo!("cone, task 1: the solid angle of a cone")
}

/// Task 2: its projected solid angle.
pub fn projected(half_angle: f64, tilt: f64) -> f64 {
    todo!("cone, task 2: the projected solid angle of a cone")
}

/// Task 3: the share of a cone that a round lamp covers.
pub fn share(cone: Cap, lamp: Cap) -> f64 {
    todo!("cone, task 3: a round lamp in a cone")
}

/// Task 4: a direction in a cone.
pub fn ray(cone: Cap, u: [f64; 2]) -> DVec3 {
    todo!("cone, task 4: a ray in a cone")
}

/// Task 5: the mean radiance over a cone.
pub fn mean(light: Light, cone: Cap, strata: usize, random: &mut Stream) -> f64 {
    todo!("cone, task 5: many rays, one in each cell")
}

/// Task 6: the radiance that a glance meets.
pub fn gloss(world: World, look: Glance, depth: usize, random: &mut Stream) -> f64 {
    todo!("cone, task 6: gloss in gloss")
}

/// What is handed in.
pub const WORK: Work = Work { solid_angle, projected, share, ray, mean, gloss };
