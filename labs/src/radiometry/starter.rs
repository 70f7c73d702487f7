//! Your work. The brief is `book/src/labs/radiometry.md`; `given.rs` holds the types.
//! Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run radiometry --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use super::given::{Sent, Spot};
use radiosity::prelude::{DVec3, dvec3};
use std::f64::consts::PI;

/// Task 1: the radiosity of a diffuse lamp, W/m².
pub fn radiosity(flux: f64, area: f64) -> f64 {
    todo!("radiometry, task 1: the radiosity of a lamp")
}

/// Task 1: the radiance of a diffuse lamp, W/(m² sr).
pub fn radiance(flux: f64, area: f64) -> f64 {
    todo!("radiometry, task 1: the radiance of a lamp")
}

/// Task 2: the irradiance from a small bulb, W/m².
pub fn from_bulb(flux: f64, bulb: DVec3, receiver: Spot) -> f64 {
    todo!("radiometry, task 2: the irradiance from a bulb")
}

/// Task 2: the irradiance from a small diffuse surface, W/m².
pub fn from_surface(radiance: f64, area: f64, source: Spot, receiver: Spot) -> f64 {
    todo!("radiometry, task 2: the irradiance from a small surface")
}

/// Task 3: the irradiance from all directions above the surface, W/m².
pub fn from_sky(sky: &dyn Fn(DVec3) -> f64, rings: usize) -> f64 {
    todo!("radiometry, task 3: the irradiance from everywhere")
}

/// Task 4: what a diffuse surface sends back.
pub fn reflected(irradiance: f64, reflectance: f64) -> Sent {
    todo!("radiometry, task 4: what a surface sends back")
}

/// What is handed in.
pub const WORK: Work =
    Work { radiosity, radiance, from_bulb, from_surface, from_sky, reflected };
