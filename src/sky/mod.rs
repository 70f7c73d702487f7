//! The sky: light from directions, for rays that leave the scene.
//!
//! A sky has a radiance for every direction and no place: it is infinitely far away, and
//! looks the same from everywhere in the scene. The analytic skies shine from above the
//! horizon only; a panorama from all around.
//!
//! ```text
//! H(n) = ∫ L(ω) max(0, n·ω) dω          irradiance of a plane that sees all of the sky
//! uniform:   L = const                   H = π L (1 + cosβ)/2        β = angle of n to up
//! overcast:  L = Lz (1 + 2 sin e)/3      H = Lz/3 [π (1 + cosβ)/2 +
//!                                            4/3 ((π − β) cosβ + sinβ)]
//! panorama:  L = the texel's             H = Σ Lₖ ∫ₖ max(0, n·ω) dω
//! ```
//! with the elevation `e` above the horizon.
//!
//! | made by            | use it when                            | it fails when           |
//! |--------------------|----------------------------------------|-------------------------|
//! | [`Sky::uniform`]   | a law is to be checked, fog            | never                   |
//! | [`Sky::overcast`]  | daylight is predicted: the worst case  | never                   |
//!
//! **Not here:** what of the sky an element sees past the scene ([`crate::solve`]); the
//! image files of pictures ([`crate::film`]).
//! Chapter *Light from the sky* (L21). Sources: Moon & Spencer 1942 (overcast); CIE S 011 /
//! ISO 15469 (general skies); Blinn & Newell 1976 (environment maps); Debevec 1998.

use crate::geometry::Rgb;
use glam::{DMat3, DQuat, DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// Radiance by direction, in W/(m² sr), nowhere negative.
#[derive(Clone, Debug, PartialEq)]
pub struct Sky {
    /// Columns: the right, the up and the back of whoever stands in the panorama and looks
    /// at its middle.
    world_from_sky: DMat3,
    light: Light,
}

#[derive(Clone, Debug, PartialEq)]
enum Light {
    Uniform(Rgb),
    Overcast(Rgb),
}

impl Sky {
    /// The same `radiance`, in W/(m² sr), from everywhere above the horizon; `up` has unit
    /// length.
    pub fn uniform(radiance: Rgb, up: DVec3) -> Sky {
        debug_assert!(radiance.min_element() >= 0.0, "negative radiance: {radiance}");
        Sky { world_from_sky: world_from_sky(up), light: Light::Uniform(radiance) }
    }

    /// The overcast sky of Moon & Spencer 1942, `L = Lz (1 + 2 sin e)/3` at elevation `e`:
    /// three times as bright at the `zenith`, in W/(m² sr), as at the horizon. `up` has
    /// unit length.
    pub fn overcast(zenith: Rgb, up: DVec3) -> Sky {
        debug_assert!(zenith.min_element() >= 0.0, "negative radiance: {zenith}");
        Sky { world_from_sky: world_from_sky(up), light: Light::Overcast(zenith) }
    }

    /// The direction away from the ground, of unit length.
    pub fn up(&self) -> DVec3 {
        self.world_from_sky.y_axis
    }

    /// Does any light come from it?
    pub fn shines(&self) -> bool {
        match &self.light {
            Light::Uniform(l) | Light::Overcast(l) => *l != Rgb::ZERO,
        }
    }

    /// The radiance, in W/(m² sr), that comes from `direction`, of unit length: what a ray
    /// finds that leaves the scene that way.
    pub fn radiance(&self, direction: DVec3) -> Rgb {
        let d = self.world_from_sky.transpose() * direction;
        match &self.light {
            _ if d.y < 0.0 => Rgb::ZERO,
            Light::Uniform(l) => *l,
            Light::Overcast(zenith) => *zenith * ((1.0 + 2.0 * d.y) / 3.0),
        }
    }

    /// Irradiance, in W/m², of a plane with unit `normal` that sees all of the sky before
    /// it: no ground, no neighbours.
    ///
    /// # Accuracy
    /// Uniform and overcast: closed forms, exact but for rounding.
    pub fn irradiance(&self, normal: DVec3) -> Rgb {
        let cos = self.up().dot(normal);
        match &self.light {
            Light::Uniform(l) => *l * (PI * (1.0 + cos) / 2.0),
            Light::Overcast(zenith) => {
                let sin = self.up().cross(normal).length();
                let behind = PI - sin.atan2(cos); // from the plane's back to the ground
                let rising = 4.0 / 3.0 * (behind * cos + sin);
                *zenith * ((PI * (1.0 + cos) / 2.0 + rising) / 3.0)
            }
        }
    }

    /// A direction drawn by two numbers in `[0, 1)`, and its probability density in 1/sr;
    /// likelier where the sky is brighter.
    pub fn sample(&self, u: DVec2) -> (DVec3, f64) {
        let sin = match &self.light {
            Light::Uniform(_) => u.x,
            // ∫₀ˢ (1 + 2t) dt / 2 = (s + s²)/2 = u, solved for s.
            Light::Overcast(_) => ((1.0 + 8.0 * u.x).sqrt() - 1.0) / 2.0,
        };
        let (x, z) = (TAU * u.y).sin_cos();
        let cos = (1.0 - sin * sin).max(0.0).sqrt();
        let direction = self.world_from_sky * DVec3::new(cos * x, sin, cos * z);
        (direction, self.pdf(direction))
    }

    /// The density, in 1/sr, with which [`Sky::sample`] draws `direction`, of unit length;
    /// 0 where it never does.
    pub fn pdf(&self, direction: DVec3) -> f64 {
        let sin = self.up().dot(direction);
        match &self.light {
            _ if sin < 0.0 => 0.0,
            Light::Uniform(_) => 1.0 / TAU,
            Light::Overcast(_) => (1.0 + 2.0 * sin) / (2.0 * TAU),
        }
    }
}

/// The shortest turn that takes `+Y` to `up`. For `up = −Y` it is half a turn about z.
fn world_from_sky(up: DVec3) -> DMat3 {
    debug_assert!(up.is_normalized(), "up must have unit length: {up}");
    if up == DVec3::Y {
        return DMat3::IDENTITY;
    }
    let turn = if up.y < 1e-12 - 1.0 {
        DQuat::from_rotation_z(PI)
    } else {
        DQuat::from_rotation_arc(DVec3::Y, up)
    };
    DMat3::from_quat(turn)
}
