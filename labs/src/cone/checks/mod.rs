//! The checks of this lab.
//!
//! ```text
//! E ω = (1 + c)/2 · axis     E cos² = (1 + c + c²)/3          even rays, c = cos a
//! σ ≲ 0.7 n^(−3/2)           a half-lit cone by one ray in each of n · n cells
//! σ = 0.5 n^(−1)             by n · n rays anywhere
//! ```
//! Closed forms are asked for to 1e-9; of rays, what their number allows.

mod cones;
mod glances;
mod rays;

use super::Work;
use super::given::Cap;
use crate::check::{Bug, Suspect};
use crate::draw::direction;
use crate::lab::{Check, check};
use radiosity::prelude::DVec3;
use radiosity::random::Stream;

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "cones", "cones of any width have their solid angle", 2, cones::sizes),
    check(1, "narrow", "narrow cones keep their digits", 1, cones::narrow),
    check(2, "tilted", "and their projected solid angle", 2, cones::tilted),
    check(3, "cut", "a rim that runs through the cone is found", 2, cones::cut),
    check(3, "clear", "so is a lamp beside it, in it, and all round", 1, cones::clear),
    check(4, "even", "rays are even in the cone", 2, rays::even),
    check(5, "mean", "the mean over the cone is right", 1, rays::mean),
    check(5, "strata", "one ray falls in each cell", 2, rays::strata),
    check(6, "mirrored", "gloss looks about the mirrored ray", 1, glances::mirrored),
    check(6, "hall", "reflections of reflections add up", 2, glances::hall),
];

/// What one mistake each makes of what is asked.
type Suspects<A, T> = [(Bug, fn(&A) -> T)];

/// The numbers that each mistake makes of all that is asked.
fn suspects<A>(wrong: &Suspects<A, f64>, asked: &[A]) -> Vec<Suspect> {
    wrong.iter().map(|(bug, f)| (*bug, asked.iter().map(f).collect())).collect()
}

/// A cone in a random direction.
fn cone(stream: &mut Stream, half_angle: f64) -> Cap {
    Cap { axis: direction(stream), half_angle }
}

/// A direction at this angle from a cone's axis.
fn beside(stream: &mut Stream, cone: Cap, angle: f64) -> DVec3 {
    let across = direction(stream).reject_from_normalized(cone.axis).normalize();
    angle.cos() * cone.axis + angle.sin() * across
}
