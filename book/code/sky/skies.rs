//! The skies of the chapter, all with the same irradiance of the ground.

use glam::{DVec3, dvec3};
use radiosity::film::{Picture, RgbImage};
use radiosity::geometry::Rgb;
use radiosity::sky::{Panorama, Sky, cie_coefficients};
use std::f64::consts::PI;

/// What falls on open ground under each, W/m².
pub const GROUND: f64 = 100.0;

/// Texels in a row of the painted panoramas; half as many rows.
pub const WIDTH: usize = 128;

/// Share of the ground's light that comes from the sun, where there is one.
pub const SUN: f64 = 0.75;

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

/// Towards the sun: high on the left, behind whoever looks at the panorama's middle.
pub fn sun() -> DVec3 {
    dvec3(-0.62, 0.62, 0.48).normalize()
}

/// The texel that holds the sun.
pub fn sun_texel(panorama: &Panorama) -> usize {
    let lit = |k: &usize| panorama.texels()[*k].x;
    let all = 0..panorama.texels().len();
    all.max_by(|a, b| lit(a).total_cmp(&lit(b))).expect("it has texels")
}

/// The CIE's clear sky (12), bluer above and away from the sun, and the sun in one
/// texel; dark ground.
pub fn sunny() -> Panorama {
    let coefficients = cie_coefficients(12).expect("12 is one of 15");
    let clear = Sky::cie(coefficients, sun(), Rgb::ONE, DVec3::Y);
    let ground = clear.irradiance(DVec3::Y).x;
    let paint = |d: DVec3| {
        let grey = clear.radiance(d).x * GROUND * (1.0 - SUN) / ground;
        let away = 1.0 - sun().dot(d).max(0.0).powi(4);
        let blue = away * (0.3 + 0.7 * d.y).max(0.0);
        Rgb::new(1.0 - 0.5 * blue, 1.0 - 0.2 * blue, 1.0 + 0.5 * blue) * grey
    };
    let painted = Panorama::painted(WIDTH, WIDTH / 2, paint).expect("all are positive");
    // Where is it? A panorama of which only one texel is lit answers.
    let mut texels = painted.texels().to_vec();
    let near = |k: &usize| {
        let (column, row) = (k % WIDTH, k / WIDTH);
        middle(column, row).dot(sun())
    };
    let k = (0..texels.len()).max_by(|a, b| near(a).total_cmp(&near(b)));
    let k = k.expect("it has texels");
    let (omega, cos) = (painted.solid_angle(k / WIDTH), middle(k % WIDTH, k / WIDTH).y);
    texels[k] += Rgb::new(1.0, 0.93, 0.8) * (GROUND * SUN / (omega * cos));
    Panorama::new(WIDTH, texels).expect("all are positive")
}

/// The direction to the middle of a texel.
fn middle(column: usize, row: usize) -> DVec3 {
    let elevation = PI / 2.0 - PI * (row as f64 + 0.5) / (WIDTH / 2) as f64;
    let azimuth = 2.0 * PI * ((column as f64 + 0.5) / WIDTH as f64 - 0.5);
    Sky::uniform(Rgb::ONE, DVec3::Y).direction(elevation, azimuth)
}

/// The panorama as a picture, the sun far beyond its white.
pub fn picture() -> RgbImage {
    let panorama = sunny();
    let mut picture = Picture::new(WIDTH as u32, WIDTH as u32 / 2);
    picture.pixels.copy_from_slice(panorama.texels());
    picture.display(1.0 / GROUND * PI)
}
