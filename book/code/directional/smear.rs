//! What bins make of a lobe that is narrower.

use glam::dvec3;
use radiosity::directional::{Bins, Scatter};
use radiosity::geometry::Rgb;
use radiosity::material::{Coefficients, Lobe, Material, Shine};
use std::f64::consts::PI;
use std::fmt::Write;

/// Bins along an edge of the chessboard.
pub const SIDES: [u32; 4] = [4, 8, 16, 32];

/// Exponents of the lobe.
pub const EXPONENTS: [f64; 3] = [20.0, 200.0, 1000.0];

/// What `side²` bins leave of the peak of a lobe, for light from 45°: a share.
pub fn peak_left(exponent: f64, side: u32) -> f64 {
    let shine = Shine::Gloss { reflectance: Rgb::ONE, exponent };
    let c = Coefficients { shine, ..Coefficients::default() };
    let brdf = Material::new("gloss", c).expect("it is passive").brdf();
    let (bins, wi) = (Bins::new(side), dvec3(0.5, 0.5, 0.5_f64.sqrt()));
    let wo = dvec3(-wi.x, -wi.y, wi.z);
    let [from, to] = [wi, wo].map(|w| bins.bin_of(w).expect("above") as usize);
    let binned = Scatter::of(&brdf, bins).share(from, to).x * bins.len() as f64 / PI;
    binned / brdf.value(wi, wo).x
}

/// The width of a lobe, in degrees, where it has fallen to a half.
fn width(exponent: f64) -> f64 {
    2.0 * 0.5_f64.powf(1.0 / exponent).acos().to_degrees()
}

/// The share left, for each lobe and number of bins.
pub fn table() -> String {
    let mut text = String::from("| exponent | width of the lobe | its peak, 1/sr |");
    for side in SIDES {
        let _ = write!(text, " in {} bins |", side * side);
    }
    text += "\n|---|---|---|---|---|---|---|\n";
    for exponent in EXPONENTS {
        let wi = dvec3(0.5, 0.5, 0.5_f64.sqrt());
        let peak = Lobe::Phong { exponent }.value(wi, dvec3(-wi.x, -wi.y, wi.z));
        let _ = write!(text, "| {exponent} | {:.0}° | {peak:.1} |", width(exponent));
        for side in SIDES {
            let _ = write!(text, " {:.0} % |", 100.0 * peak_left(exponent, side));
        }
        text.push('\n');
    }
    text
}
