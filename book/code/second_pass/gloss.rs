//! A glossy floor at three widths of its lobe.

use super::views::Lit;
use glam::DVec3;
use radiosity::film::RgbImage;
use radiosity::material::{Coefficients, Material, Shine};
use radiosity::scene::built_in;
use radiosity::trace::{Cone, Look};

/// Pixels along an edge.
const SIZE: u32 = 160;

/// So much brighter than what lets the lamp stay below white.
const EXPOSURE: f64 = 6.0;

/// The exponents of the lobe.
pub const EXPONENTS: [f64; 3] = [10.0, 100.0, 2000.0];

/// The built-in scene, its gloss with another exponent.
fn lit(n: f64) -> Lit {
    let mut scene = built_in("glossy-floor").expect("it is built in");
    for material in &mut scene.materials {
        if let Shine::Gloss { reflectance, .. } = material.shine() {
            let coefficients = Coefficients {
                emission: material.emission(),
                diffuse: material.diffuse(),
                translucence: material.translucence(),
                shine: Shine::Gloss { reflectance, exponent: n },
            };
            let other = Material::new(material.name(), coefficients);
            *material = other.expect("it was passive, and still is");
        }
    }
    Lit::of(scene, 0.1)
}

/// The picture.
pub fn picture(n: f64) -> RgbImage {
    let shown = lit(n).two_passes(SIZE, Look::default());
    // The lamp is all that clamps.
    shown.picture.display(EXPOSURE * shown.picture.auto_exposure())
}

/// How wide the lobe is.
pub fn caption(n: f64) -> String {
    let cone = Cone::holding(0.9, n, DVec3::Z);
    let half_angle = cone.half_angle.to_degrees();
    format!("n = {n}: nine tenths of the lobe within {half_angle:.0}° of its axis")
}
