//! One right answer.
#![deny(warnings)]

use super::{Brdf, Work};
use radiosity::prelude::{DVec3, Frame, dvec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// Task 1: the π is the integral of the cosine.
pub fn lambert(reflectance: f64, wi: DVec3, wo: DVec3) -> f64 {
    if wi.z > 0.0 && wo.z > 0.0 { reflectance / PI } else { 0.0 }
}

/// The mirror image: turned half round the normal.
fn mirrored(w: DVec3) -> DVec3 {
    dvec3(-w.x, -w.y, w.z)
}

/// Task 2: the constant makes the albedo 1 for light that falls straight in.
pub fn phong(exponent: f64, wi: DVec3, wo: DVec3) -> f64 {
    if wi.z <= 0.0 || wo.z <= 0.0 {
        return 0.0;
    }
    let cosine = mirrored(wo).dot(wi).max(0.0);
    (exponent + 2.0) / (2.0 * PI) * cosine.powf(exponent)
}

/// Task 3: rings and pieces, each looked at in its middle.
pub fn albedo(brdf: Brdf, wo: DVec3, rings: usize) -> f64 {
    let step = FRAC_PI_2 / rings as f64;
    let mut sum = 0.0;
    for ring in 0..rings {
        let (sine, cosine) = ((ring as f64 + 0.5) * step).sin_cos();
        for piece in 0..4 * rings {
            let (y, x) = ((piece as f64 + 0.5) * step).sin_cos();
            sum += brdf(dvec3(sine * x, sine * y, cosine), wo) * cosine * sine;
        }
    }
    sum * step * step
}

/// Task 4: the share `1 − cosⁿ⁺¹α` of all samples lies within `α`.
pub fn sample(exponent: f64, wo: DVec3, u: [f64; 2]) -> DVec3 {
    let cosine = (1.0 - u[0]).powf(1.0 / (exponent + 1.0));
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let (y, x) = (2.0 * PI * u[1]).sin_cos();
    Frame::about(mirrored(wo)).world_from_local(dvec3(sine * x, sine * y, cosine))
}

/// Task 4: as the lobe, but with the constant of a density.
pub fn pdf(exponent: f64, wi: DVec3, wo: DVec3) -> f64 {
    let cosine = mirrored(wo).dot(wi).max(0.0);
    (exponent + 1.0) / (2.0 * PI) * cosine.powf(exponent)
}

/// Task 5: in every channel by itself.
pub fn passive(diffuse: [f64; 3], specular: [f64; 3]) -> bool {
    diffuse.iter().zip(specular).all(|(d, s)| d + s <= 1.0)
}

/// What is handed in.
pub const WORK: Work = Work { lambert, phong, albedo, sample, pdf, passive };
