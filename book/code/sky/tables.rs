//! What falls on planes, and what a texel is worth.

use super::skies::Kind;
use glam::dvec3;
use radiosity::geometry::Rgb;
use radiosity::sky::Panorama;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

/// Irradiance of planes that lean towards the sun's side, in per cent of the ground's.
pub fn tilts() -> String {
    let mut text = String::from(
        "| plane leans by | ½ (1 + cosβ) | uniform | overcast | sunny, to the sun | sunny, \
         away |\n|---|---|---|---|---|---|\n",
    );
    let skies = Kind::ALL.map(Kind::sky);
    let up = super::skies::sun();
    let flat = dvec3(up.x, 0.0, up.z).normalize();
    for degrees in [0.0_f64, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let [to, away] =
            [1.0, -1.0].map(|sign| sign * sin * flat + dvec3(0.0, cos, 0.0));
        let of = |k: usize, normal| {
            100.0 * skies[k].irradiance(normal).y
                / skies[k].irradiance(glam::DVec3::Y).y
        };
        let _ = writeln!(
            text,
            "| {degrees}° | {:.1} % | {:.1} % | {:.1} % | {:.1} % | {:.1} % |",
            50.0 * (1.0 + cos),
            of(0, to),
            of(1, to),
            of(2, to),
            of(2, away)
        );
    }
    text
}

/// Solid angle of a texel by row, 64 × 32: right, and without the sine.
pub fn texels() -> String {
    let (width, height) = (64, 32);
    let panorama = Panorama::new(width, vec![Rgb::ONE; width * height]).expect("sound");
    let flat = TAU / width as f64 * PI / height as f64;
    let mut text = String::from(
        "| row | its middle, from the zenith | a texel, sr | Δφ Δθ, sr | too much |\n\
         |---|---|---|---|---|\n",
    );
    for row in [0, 1, 4, 8, 15] {
        let omega = panorama.solid_angle(row);
        let _ = writeln!(
            text,
            "| {row} | {:.1}° | {omega:.6} | {flat:.6} | × {:.2} |",
            180.0 * (row as f64 + 0.5) / height as f64,
            flat / omega
        );
    }
    let _ = writeln!(
        text,
        "| all {height} | | {:.4} = 4π | {:.4} = 2π² | × {:.2} |",
        panorama.total().x,
        flat * (width * height) as f64,
        flat * (width * height) as f64 / panorama.total().x
    );
    text
}
