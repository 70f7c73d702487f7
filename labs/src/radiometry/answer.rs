//! One right answer.
#![deny(warnings)]

use super::Work;
use super::given::{Sent, Spot};
use radiosity::prelude::{DVec3, dvec3};
use std::f64::consts::PI;

/// Task 1: flux for each area.
pub fn radiosity(flux: f64, area: f64) -> f64 {
    flux / area
}

/// Task 1: B = πL, the π being ∫ cosθ dω over the hemisphere.
pub fn radiance(flux: f64, area: f64) -> f64 {
    radiosity(flux, area) / PI
}

/// The cosine at `spot` towards `to`; 0 from behind.
fn cosine(spot: Spot, to: DVec3) -> f64 {
    spot.normal.dot((to - spot.at).normalize()).max(0.0)
}

/// Task 2: the flux spreads over a sphere, 4πr²; the receiver stands aslant in it.
pub fn from_bulb(flux: f64, bulb: DVec3, receiver: Spot) -> f64 {
    let r2 = bulb.distance_squared(receiver.at);
    flux * cosine(receiver, bulb) / (4.0 * PI * r2)
}

/// Task 2: L cosθ dω, where dω = A cosθ'/r² is how large the source looks.
pub fn from_surface(radiance: f64, area: f64, source: Spot, receiver: Spot) -> f64 {
    let r2 = source.at.distance_squared(receiver.at);
    let (here, there) = (cosine(receiver, source.at), cosine(source, receiver.at));
    radiance * area * here * there / r2
}

/// Task 3: ∫∫ L cosθ sinθ dθ dφ, cell by cell.
pub fn from_sky(sky: &dyn Fn(DVec3) -> f64, rings: usize) -> f64 {
    let step = 0.5 * PI / rings as f64;
    let mut sum = 0.0;
    for ring in 0..rings {
        let (sine, cosine) = ((ring as f64 + 0.5) * step).sin_cos();
        for piece in 0..4 * rings {
            let (y, x) = ((piece as f64 + 0.5) * step).sin_cos();
            sum += sky(dvec3(sine * x, sine * y, cosine)) * cosine * sine;
        }
    }
    sum * step * step
}

/// Task 4: the share ρ of what arrives leaves again, alike in all directions.
pub fn reflected(irradiance: f64, reflectance: f64) -> Sent {
    let radiosity = reflectance * irradiance;
    Sent { radiosity, radiance: radiosity / PI }
}

/// What is handed in.
pub const WORK: Work =
    Work { radiosity, radiance, from_bulb, from_surface, from_sky, reflected };
