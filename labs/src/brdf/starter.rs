//! Your work. The brief is `book/src/labs/brdf.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run brdf --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::{Brdf, Work};
use radiosity::prelude::{DVec3, Frame, dvec3};
use std::f64::consts::PI;

/// Task 1: Lambert's BRDF, in 1/sr.
pub fn lambert(reflectance: f64, wi: DVec3, wo: DVec3) -> f64 {
    todo!("brdf, task 1: Lambert's BRDF")
}

/// Task 2: the normalised Phong lobe, in 1/sr.
pub fn phong(exponent: f64, wi: DVec3, wo: DVec3) -> f64 {
    todo!("brdf, task 2: Phong's lobe")
}

/// Task 3: the directional albedo of any BRDF.
pub fn albedo(brdf: Brdf, wo: DVec3, rings: usize) -> f64 {
    todo!("brdf, task 3: the directional albedo")
}

/// Task 4: a direction drawn from the lobe.
pub fn sample(exponent: f64, wo: DVec3, u: [f64; 2]) -> DVec3 {
    todo!("brdf, task 4: a sample of the lobe")
}

/// Task 4: the density of the samples, in 1/sr.
pub fn pdf(exponent: f64, wi: DVec3, wo: DVec3) -> f64 {
    todo!("brdf, task 4: the density of the samples")
}

/// Task 5: is a material passive?
pub fn passive(diffuse: [f64; 3], specular: [f64; 3]) -> bool {
    todo!("brdf, task 5: passive or not")
}

/// What is handed in.
pub const WORK: Work = Work { lambert, phong, albedo, sample, pdf, passive };
