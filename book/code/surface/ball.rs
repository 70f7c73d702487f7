//! A ball under a lamp, which shows the lobe, and in a glow from everywhere, which shows
//! the albedo.

use glam::{DVec3, dvec3};
use radiosity::film::{Picture, RgbImage};
use radiosity::geometry::{Frame, Rgb};
use radiosity::material::{Brdf, Coefficients, Lobe, Material, Shine};
use std::f64::consts::{PI, TAU};

/// Pixels along an edge of a ball's picture.
const SIZE: u32 = 128;

/// Places along an edge of a pixel that are looked at.
const FINE: u32 = 4;

/// The exponents of the gloss lobe in the three settings under the lamp.
pub const EXPONENTS: [f64; 3] = [4.0, 20.0, 100.0];

/// The exponents of the three normalised lobes in the furnace.
pub const WIDTHS: [f64; 3] = [1.0, 10.0, 100.0];

/// The exponents of the three lobes without their constant in the furnace.
pub const BARE: [f64; 3] = [1.0, 4.0, 20.0];

/// Radiance 1 in the furnace is this grey, so that there is room above it.
const GREY: f64 = 0.45;

/// The lamp is far away to the upper left, before the ball.
const LAMP: DVec3 = dvec3(-0.48, 0.6, 0.64);

/// Of the lamp, on a surface that faces it, W/m²: a white diffuse one looks as bright as 1.
const IRRADIANCE: f64 = PI;

/// The glow from everywhere beside it, W/(m² sr).
const GLOW: f64 = 0.04;

/// The reflectances of the ball: red paint under a thin gloss.
const DIFFUSE: Rgb = Rgb::new(0.55, 0.12, 0.08);
const SPECULAR: f64 = 0.08;

/// A ball seen from afar along −z; `radiance` is of the unit normal, or of what is behind.
fn ball(radiance: impl Fn(Option<DVec3>) -> Rgb) -> Picture {
    let at = |k: u32| 2.2 * ((f64::from(k) + 0.5) / f64::from(SIZE * FINE) - 0.5);
    let look = |k: u32, l: u32| {
        let (x, y) = (at(k), -at(l));
        let z2 = 1.0 - x * x - y * y;
        radiance((z2 > 0.0).then(|| dvec3(x, y, z2.sqrt())))
    };
    let mut picture = Picture::new(SIZE, SIZE);
    for (pixel, value) in picture.pixels.iter_mut().enumerate() {
        let (x, y) = (pixel as u32 % SIZE, pixel as u32 / SIZE);
        let places =
            (0..FINE * FINE).map(|k| (FINE * x + k % FINE, FINE * y + k / FINE));
        *value = places.map(|(k, l)| look(k, l)).sum::<Rgb>() / f64::from(FINE * FINE);
    }
    picture
}

/// The ball's BRDF, with a gloss lobe of this exponent.
pub fn brdf(exponent: f64) -> Brdf {
    let coefficients = Coefficients {
        diffuse: DIFFUSE,
        shine: Shine::Gloss { reflectance: Rgb::splat(SPECULAR), exponent },
        ..Coefficients::default()
    };
    Material::new("paint", coefficients).expect("the paint is passive").brdf()
}

/// The ball under the lamp: `L = f H cosθ`, and the glow that it sends back.
pub fn lit(exponent: f64) -> Picture {
    let brdf = brdf(exponent);
    ball(|normal| {
        let Some(normal) = normal else { return Rgb::splat(GLOW) };
        let frame = Frame::about(normal);
        let [wi, wo] = [LAMP, DVec3::Z].map(|w| frame.local_from_world(w));
        let irradiance = IRRADIANCE * wi.z.max(0.0);
        brdf.value(wi, wo) * irradiance + GLOW * brdf.albedo(wo.z.clamp(0.0, 1.0))
    })
}

/// [`lit`] as it is shown.
pub fn lit_picture(exponent: f64) -> RgbImage {
    lit(exponent).display(1.0)
}

/// The caption of the opening picture.
pub fn caption() -> String {
    format!(
        "A ball of red paint under a lamp. It reflects {} of the red light diffusely, \
         {SPECULAR} of all light in a gloss lobe of exponent {}.",
        DIFFUSE.x, EXPONENTS[1]
    )
}

/// The caption under one of the three settings.
pub fn lit_caption(n: f64) -> String {
    let peak = SPECULAR * Lobe::Phong { exponent: n }.value(DVec3::Z, DVec3::Z);
    let half = 2.0 * 0.5f64.powf(1.0 / n).acos().to_degrees();
    format!("n = {n}: the gloss is {peak:.2} 1/sr in its middle, and {half:.0}° wide")
}

/// A ball whose directional albedo is this function of the cosine, in a glow of radiance 1.
fn in_furnace(albedo: impl Fn(f64) -> f64) -> RgbImage {
    let glow = |normal: Option<DVec3>| normal.map_or(1.0, |n| albedo(n.z.min(1.0)));
    ball(|normal| Rgb::splat(glow(normal))).display(GREY)
}

fn phong(n: f64) -> Lobe {
    Lobe::Phong { exponent: n }
}

/// `cosⁿα` without its constant: what a BRDF of this directional albedo sends back.
pub fn bare(n: f64, cosine: f64) -> f64 {
    TAU / (n + 2.0) * phong(n).albedo(cosine)
}

/// The white Lambert ball in the furnace.
pub fn lambert_picture() -> RgbImage {
    in_furnace(|cosine| Lobe::Lambert.albedo(cosine))
}

/// A normalised Phong ball in the furnace.
pub fn rim_picture(n: f64) -> RgbImage {
    in_furnace(|cosine| phong(n).albedo(cosine))
}

/// A Phong ball without the constant in the furnace.
pub fn bare_picture(n: f64) -> RgbImage {
    in_furnace(|cosine| bare(n, cosine))
}

/// The caption of the furnace: Lambert, normalised, bare.
pub fn furnace_caption() -> String {
    format!(
        "Three balls in a glow of radiance 1 from everywhere. Left: a white Lambert ball. \
         You cannot see it, and that is right. Middle: a normalised Phong ball, n = {}; \
         at 80° it sends back {:.0} %. Right: the same without its constant, n = {}: {:.2} \
         times what came, from its middle.",
        WIDTHS[1],
        100.0 * phong(WIDTHS[1]).albedo(80f64.to_radians().cos()),
        BARE[0],
        bare(BARE[0], 1.0)
    )
}

/// The caption under a normalised ball.
pub fn rim_caption(n: f64) -> String {
    let at = |degrees: f64| 100.0 * phong(n).albedo(degrees.to_radians().cos());
    format!(
        "n = {n}: {:.0} % at 0°, {:.0} % at 60°, {:.0} % at 80°",
        at(0.0),
        at(60.0),
        at(80.0)
    )
}

/// The caption under a ball without its constant.
pub fn bare_caption(n: f64) -> String {
    format!("n = {n}: ×{:.2} in the middle", bare(n, 1.0))
}
