//! The sky: light from directions, for rays that leave the scene.
//!
//! A sky has a radiance for every direction and no place: it is infinitely far away,
//! and looks the same from everywhere in the scene. The analytic skies shine from above
//! the horizon only; a panorama from all around.
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
//! | [`Sky::cie`]       | the sun's side is to be brighter       | the sun itself: it has none |
//! | [`Sky::panorama`]  | a real place is to shine               | detail below a texel    |
//!
//! ```
//! use radiosity::{geometry::Rgb, glam::DVec3, sky::Sky};
//! use std::f64::consts::PI;
//! let fog = Sky::uniform(Rgb::ONE, DVec3::Z);
//! assert!((fog.irradiance(DVec3::Z) - PI).length() < 1e-12); // H = π L on open ground
//! let cloudy = Sky::overcast(Rgb::ONE, DVec3::Z); // its zenith thrice as bright as below
//! assert!((cloudy.irradiance(DVec3::Z) - 7.0 / 9.0 * PI).length() < 1e-12);
//! ```
//!
//! **Not here:** what of the sky an element sees past the scene ([`crate::solve`]); the
//! image files of pictures ([`crate::film`]). Chapter *Light from the sky* (L21).
//! Sources: Moon & Spencer 1942 (overcast); CIE S 011 / ISO 15469 (general skies);
//! Blinn & Newell 1976 (environment maps); Debevec 1998.

mod cie;
mod file;
mod grid;
mod panorama;
mod suns;

pub use cie::cie_coefficients;
pub use file::{SkyError, SkyTrouble};
pub use panorama::{Panorama, PanoramaError};
pub use suns::Sun;

use crate::geometry::Rgb;
use cie::Cie;
use glam::{DMat3, DQuat, DVec2, DVec3};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Radiance by direction, in W/(m² sr), nowhere negative.
#[derive(Clone, Debug, PartialEq)]
pub struct Sky {
    /// Columns: the right, the up and the back of whoever stands in the panorama and
    /// looks at its middle.
    world_from_sky: DMat3,
    light: SkyLight,
}

/// A direction drawn at the horizon may be turned beneath it, by rounding.
const HORIZON: f64 = -1e-12;

#[derive(Clone, Debug, PartialEq)]
enum SkyLight {
    Uniform(Rgb),
    Overcast(Rgb),
    Cie(Arc<Cie>),
    Panorama(Arc<Panorama>),
}

/// What a [`Sky`] was made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind<'a> {
    /// By [`Sky::uniform`]: the radiance.
    Uniform(Rgb),
    /// By [`Sky::overcast`]: the radiance of the zenith.
    Overcast(Rgb),
    /// By [`Sky::cie`].
    Cie {
        /// Its five coefficients.
        coefficients: [f64; 5],
        /// The direction to the sun.
        sun: DVec3,
        /// The radiance of the zenith.
        zenith: Rgb,
    },
    /// By [`Sky::panorama`].
    Panorama(&'a Panorama),
}

impl Sky {
    /// The same `radiance`, in W/(m² sr), from everywhere above the horizon; `up` has
    /// unit length.
    pub fn uniform(radiance: Rgb, up: DVec3) -> Sky {
        debug_assert!(radiance.min_element() >= 0.0, "negative radiance: {radiance}");
        Sky { world_from_sky: world_from_sky(up), light: SkyLight::Uniform(radiance) }
    }

    /// The overcast sky of Moon & Spencer 1942, `L = Lz (1 + 2 sin e)/3` at elevation
    /// `e`: three times as bright at the `zenith`, in W/(m² sr), as at the horizon.
    /// `up` has unit length.
    pub fn overcast(zenith: Rgb, up: DVec3) -> Sky {
        debug_assert!(zenith.min_element() >= 0.0, "negative radiance: {zenith}");
        Sky { world_from_sky: world_from_sky(up), light: SkyLight::Overcast(zenith) }
    }

    /// A general sky of the CIE: five `coefficients` (see [`cie_coefficients`]; the
    /// second is negative), the direction to the `sun`, radiance at the `zenith` in
    /// W/(m² sr). Light scattered by the air only: the sun's disc is not in it. `sun`
    /// and `up` have unit length, and the sun stands above the horizon.
    ///
    /// ```text
    /// L/Lz = f(χ) φ(Z) / (f(Zs) φ(0))     Z from the zenith, χ from the sun, Zs between
    /// φ(Z) = 1 + a exp(b / cos Z)         f(χ) = 1 + c (exp dχ − exp dπ/2) + e cos²χ
    /// ```
    pub fn cie(coefficients: [f64; 5], sun: DVec3, zenith: Rgb, up: DVec3) -> Sky {
        debug_assert!(coefficients[1] < 0.0, "no sky: {coefficients:?}");
        debug_assert!(sun.is_normalized(), "sun must have unit length: {sun}");
        debug_assert!(zenith.min_element() >= 0.0, "negative radiance: {zenith}");
        let world_from_sky = world_from_sky(up);
        let sun = world_from_sky.transpose() * sun;
        let light = SkyLight::Cie(Arc::new(Cie::new(coefficients, sun, zenith)));
        Sky { world_from_sky, light }
    }

    /// A picture of all directions, the ground's too, turned so that its row 0 is `up`,
    /// of unit length.
    ///
    /// With up at `+Y` its middle column looks along `−Z`; else all is turned the
    /// shortest way from `+Y` to `up`: with up at `+Z` the middle looks along `+Y`.
    pub fn panorama(panorama: Panorama, up: DVec3) -> Sky {
        let light = SkyLight::Panorama(Arc::new(panorama));
        Sky { world_from_sky: world_from_sky(up), light }
    }

    /// The direction, of unit length, at these angles in radians: `elevation` above the
    /// horizon; `azimuth` from the panorama's middle (`−Z` while up is `+Y`) to the
    /// right.
    pub fn direction(&self, elevation: f64, azimuth: f64) -> DVec3 {
        let ((x, z), (y, flat)) = (azimuth.sin_cos(), elevation.sin_cos());
        self.world_from_sky * DVec3::new(flat * x, y, -flat * z)
    }

    /// The direction away from the ground, of unit length.
    pub fn up(&self) -> DVec3 {
        self.world_from_sky.y_axis
    }

    /// What it was made of.
    pub fn kind(&self) -> Kind<'_> {
        match &self.light {
            SkyLight::Uniform(radiance) => Kind::Uniform(*radiance),
            SkyLight::Overcast(zenith) => Kind::Overcast(*zenith),
            SkyLight::Cie(cie) => Kind::Cie {
                coefficients: cie.coefficients,
                sun: self.world_from_sky * cie.sun,
                zenith: cie.zenith,
            },
            SkyLight::Panorama(panorama) => Kind::Panorama(panorama),
        }
    }

    /// Does any light come from it?
    pub fn shines(&self) -> bool {
        match &self.light {
            SkyLight::Uniform(l) | SkyLight::Overcast(l) => *l != Rgb::ZERO,
            SkyLight::Cie(cie) => cie.zenith != Rgb::ZERO,
            SkyLight::Panorama(panorama) => panorama.total() != Rgb::ZERO,
        }
    }

    /// The radiance, in W/(m² sr), that comes from `direction`, of unit length: what a
    /// ray finds that leaves the scene that way.
    pub fn radiance(&self, direction: DVec3) -> Rgb {
        let d = self.sky_from_world(direction);
        match &self.light {
            SkyLight::Panorama(panorama) => panorama.radiance(d),
            _ if d.y < HORIZON => Rgb::ZERO,
            SkyLight::Uniform(l) => *l,
            SkyLight::Overcast(zenith) => *zenith * ((1.0 + 2.0 * d.y) / 3.0),
            SkyLight::Cie(cie) => cie.radiance(d),
        }
    }

    /// Irradiance, in W/m², of a plane with unit `normal` that sees all of the sky
    /// before it: no ground, no neighbours.
    ///
    /// # Accuracy
    /// Uniform and overcast: closed forms, exact but for rounding. CIE: 1e-7 of π times
    /// the zenith's radiance. Panorama: exact texel by texel, but for 1e-6 of the
    /// radiance along the plane's horizon.
    pub fn irradiance(&self, normal: DVec3) -> Rgb {
        let n = self.sky_from_world(normal);
        let (cos, sin) = (n.y, n.x.hypot(n.z));
        match &self.light {
            SkyLight::Uniform(l) => *l * (PI * (1.0 + cos) / 2.0),
            // ANCHOR: overcast
            SkyLight::Overcast(zenith) => {
                let behind = PI - sin.atan2(cos); // from the plane's back to the ground
                let rising = 4.0 / 3.0 * (behind * cos + sin);
                *zenith * ((PI * (1.0 + cos) / 2.0 + rising) / 3.0)
            }
            // ANCHOR_END: overcast
            SkyLight::Cie(cie) => cie.irradiance(n),
            SkyLight::Panorama(panorama) => panorama.irradiance(n),
        }
    }

    /// A direction drawn by two numbers in `[0, 1)`, and its probability density in
    /// 1/sr: in proportion to the radiance (its mean over the channels; of the CIE's
    /// skies, nearly so). A sun in one texel is neither missed nor counted twice. Never
    /// 0.
    pub fn sample(&self, u: DVec2) -> (DVec3, f64) {
        let around = |sin: f64| {
            let ((x, z), cos) = ((TAU * u.y).sin_cos(), (1.0 - sin * sin).sqrt());
            DVec3::new(cos * x, sin, cos * z)
        };
        let direction = match &self.light {
            SkyLight::Uniform(_) => around(u.x),
            // ∫₀ˢ (1 + 2t) dt / 2 = (s + s²)/2 = u, solved for s.
            SkyLight::Overcast(_) => around(((1.0 + 8.0 * u.x).sqrt() - 1.0) / 2.0),
            SkyLight::Cie(cie) => cie.sample(u),
            SkyLight::Panorama(panorama) => panorama.sample(u),
        };
        let direction = self.world_from_sky * direction;
        (direction, self.pdf(direction))
    }

    /// The density, in 1/sr, with which [`Sky::sample`] draws `direction`, of unit
    /// length; 0 where it never does.
    pub fn pdf(&self, direction: DVec3) -> f64 {
        let d = self.sky_from_world(direction);
        match &self.light {
            SkyLight::Panorama(panorama) => panorama.pdf(d),
            _ if d.y < HORIZON => 0.0,
            SkyLight::Uniform(_) => 1.0 / TAU,
            SkyLight::Overcast(_) => (1.0 + 2.0 * d.y) / (2.0 * TAU),
            SkyLight::Cie(cie) => cie.pdf(d),
        }
    }

    fn sky_from_world(&self, direction: DVec3) -> DVec3 {
        self.world_from_sky.transpose() * direction
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
