//! The experiment of the report question: how much is missing when mirrors are cut off?
//!
//! `cargo run -p labs --example corridor` runs it on the student's work.

use super::Work;
use radiosity::prelude::{DVec3, dvec3};

/// The share of the light that is missing after so many levels.
pub fn missing(work: &Work, reflectance: f64, levels: usize) -> f64 {
    1.0 - (work.corridor)(reflectance, levels) / (work.corridor)(reflectance, 2000)
}

/// The mirror x = 1, looking at the eye, from below up to this height.
pub fn mirror(height: f64) -> [DVec3; 4] {
    let corners = [(-20.0, -1.0), (-20.0, height), (20.0, height), (20.0, -1.0)];
    corners.map(|(y, z)| dvec3(1.0, y, z))
}

/// The factor from the origin, normal z, to the unit square above it, by that mirror.
pub fn by_mirror_up_to(work: &Work, height: f64) -> f64 {
    let lamp = [(-0.5, -0.5), (-0.5, 0.5), (0.5, 0.5), (0.5, -0.5)];
    let lamp = lamp.map(|(x, y)| dvec3(x, y, 1.0));
    (work.by_mirror)(DVec3::ZERO, DVec3::Z, &mirror(height), &lamp)
}
