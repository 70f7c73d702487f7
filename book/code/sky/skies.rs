//! The skies of the chapter, all with the same irradiance of the ground.

use glam::DVec3;
pub use radiosity::chart::suites::sky::{GROUND, WIDTH, sun, sunny};
use radiosity::film::{Picture, RgbImage};
use radiosity::geometry::Rgb;
use radiosity::sky::{Panorama, Sky};
use std::f64::consts::PI;

/// The skies of the first figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// The same from everywhere above.
    Uniform,
    /// Moon & Spencer's.
    Overcast,
    /// The CIE's clear sky, and a sun of one texel: painted.
    Sunny,
}

impl Kind {
    /// All of them.
    pub const ALL: [Kind; 3] = [Kind::Uniform, Kind::Overcast, Kind::Sunny];

    /// The sky, with y up.
    pub fn sky(self) -> Sky {
        match self {
            Kind::Uniform => Sky::uniform(Rgb::splat(GROUND / PI), DVec3::Y),
            Kind::Overcast => {
                Sky::overcast(Rgb::splat(GROUND * 9.0 / (7.0 * PI)), DVec3::Y)
            }
            Kind::Sunny => Sky::panorama(sunny(), DVec3::Y),
        }
    }
}

/// The texel that holds the sun.
pub fn sun_texel(panorama: &Panorama) -> usize {
    let lit = |k: &usize| panorama.texels()[*k].x;
    let all = 0..panorama.texels().len();
    all.max_by(|a, b| lit(a).total_cmp(&lit(b))).expect("it has texels")
}

/// The panorama as a picture, the sun far beyond its white.
pub fn picture() -> RgbImage {
    let panorama = sunny();
    let mut picture = Picture::new(WIDTH as u32, WIDTH as u32 / 2);
    picture.pixels.copy_from_slice(panorama.texels());
    picture.display(1.0 / GROUND * PI)
}
