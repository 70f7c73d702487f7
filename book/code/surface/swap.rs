//! Lamp and eye exchanged: a map of a BRDF over both angles, which mirrors itself in its
//! diagonal when the BRDF is reciprocal.

use crate::map;
use glam::{DVec2, DVec3, dvec3};
use radiosity::film::RgbImage;
use radiosity::material::Lobe;
use std::f64::consts::FRAC_PI_2;

/// The lobe of the maps.
const LOBE: Lobe = Lobe::Phong { exponent: 10.0 };

/// The range of the colours, 1/sr.
const RANGE: (f64, f64) = (0.03, 30.0);

/// How the incoming light is weighted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// `L = f H`, where the irradiance has the cosine.
    Reciprocal,
    /// `L = f L`, without a cosine: Phong's own formula, a BRDF divided by the cosine.
    NoCosine,
}

impl Rule {
    /// Both, the right one first.
    pub const ALL: [Rule; 2] = [Rule::Reciprocal, Rule::NoCosine];
}

/// Light comes in at one angle (radians), on one side; the eye is at another, opposite.
pub fn value(theta_in: f64, theta_out: f64, rule: Rule) -> f64 {
    let at = |side: f64, theta: f64| -> DVec3 {
        dvec3(side * theta.sin(), 0.0, theta.cos())
    };
    let (wi, wo) = (at(-1.0, theta_in), at(1.0, theta_out));
    match rule {
        Rule::Reciprocal => LOBE.value(wi, wo),
        Rule::NoCosine => LOBE.value(wi, wo) / wi.z,
    }
}

/// The map: the lamp's angle to the right, the eye's upward, 0 to 90°.
pub fn picture(rule: Rule) -> RgbImage {
    let high = DVec2::splat(FRAC_PI_2);
    let values = map::over(DVec2::ZERO, high, |angles| value(angles.x, angles.y, rule));
    map::draw(&values, RANGE.0, RANGE.1)
}

/// The key to the maps.
pub fn key() -> String {
    map::key(RANGE.0, RANGE.1, 4, |v| format!("{} 1/sr", (v * 100.0).round() / 100.0))
}

/// The value for a lamp at 80° and an eye at 50°, and the other way round.
pub fn exchanged(rule: Rule) -> [f64; 2] {
    let [a, b] = [80f64, 50.0].map(f64::to_radians);
    [value(a, b, rule), value(b, a, rule)]
}

/// The caption under a map.
pub fn caption(rule: Rule) -> String {
    let [there, back] = exchanged(rule);
    let name = match rule {
        Rule::Reciprocal => "With the cosine",
        Rule::NoCosine => "Without it",
    };
    format!("{name}: lamp 80°, eye 50°: {there:.2} 1/sr; exchanged: {back:.2} 1/sr")
}
