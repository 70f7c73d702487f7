//! All that a point sees, unrolled so that equal areas are equal solid angles.
//!
//! Archimedes: a sphere and the cylinder around it have equal areas between any two
//! heights. So a map with height upwards and azimuth to the right keeps solid angles.

use crate::hemicube::view::{paint, scene};
use glam::{DVec3, dvec3};
use radiosity::film::{Picture, RgbImage};
use radiosity::geometry::Ray;
use radiosity::radiometry::solid_angle;
use radiosity::scene::Scene;
use radiosity::visibility::{Hit, Visibility};
use std::f64::consts::{PI, TAU};

/// Where the eye is, in the Cornell box, in metres.
pub const EYE: DVec3 = dvec3(0.278, 0.274, 0.12);

/// Heights of the three eyes under the lamp, in metres.
pub const HEIGHTS: [f64; 3] = [0.36, 0.43, 0.5];

/// Where the three eyes are.
pub fn under_the_lamp(height: f64) -> DVec3 {
    dvec3(0.278, height, 0.28)
}

/// Width and height of the map, in pixels.
const SIZE: (u32, u32) = (192, 96);

/// The direction of a pixel: its height is the sine of the elevation.
fn direction(pixel: u32) -> DVec3 {
    let (width, height) = SIZE;
    let (x, y) = (f64::from(pixel % width) + 0.5, f64::from(pixel / width) + 0.5);
    let up = 1.0 - 2.0 * y / f64::from(height);
    let (sine, cosine) = (TAU * x / f64::from(width)).sin_cos();
    let across = (1.0 - up * up).sqrt();
    dvec3(-across * sine, up, -across * cosine) // the edges look at the open front
}

/// What each pixel's ray meets.
fn seen(scene: &Scene, eye: DVec3) -> Vec<Option<Hit>> {
    let visibility = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
    let look = |k: u32| Ray { origin: eye, direction: direction(k) };
    (0..SIZE.0 * SIZE.1).map(|k| visibility.closest(&look(k), None)).collect()
}

/// The map.
pub fn picture(eye: DVec3) -> RgbImage {
    let scene = scene();
    let seen = seen(&scene, eye);
    let colour = |hit: Option<Hit>| match hit {
        Some(hit) => paint(&scene, hit.item),
        None => [24, 32, 72],
    };
    let index = Picture::new(SIZE.0, SIZE.1);
    let mut picture = index.map(|_| [0; 3]);
    for (pixel, hit) in picture.pixels_mut().zip(seen) {
        pixel.0 = colour(hit);
    }
    picture
}

/// What the eye sees by name of the paint, in steradians, by counting pixels; what it sees
/// of nothing is `open`.
pub fn shares(eye: DVec3) -> Vec<(String, f64)> {
    let scene = scene();
    let seen = seen(&scene, eye);
    let pixel = 4.0 * PI / seen.len() as f64;
    let name = |hit: &Option<Hit>| match hit {
        Some(hit) => scene.material(&scene.surfaces[hit.item as usize]).name().into(),
        None => "open".to_string(),
    };
    let mut shares: Vec<(String, f64)> = Vec::new();
    for name in seen.iter().map(name) {
        match shares.iter_mut().find(|(known, _)| *known == name) {
            Some((_, share)) => *share += pixel,
            None => shares.push((name, pixel)),
        }
    }
    shares.sort_by(|a, b| a.1.total_cmp(&b.1));
    shares
}

/// The lamp as the eye sees it: counted, and exact.
pub fn lamp(eye: DVec3) -> (f64, f64) {
    let scene = scene();
    let lamps = scene.surfaces.iter().filter(|s| scene.material(s).emits());
    let exact = lamps.map(|s| solid_angle(eye, &s.polygon)).sum();
    let counted = shares(eye).into_iter().find(|(name, _)| name == "lamp");
    (counted.map_or(0.0, |(_, share)| share), exact)
}

/// The caption of the opening picture.
pub fn caption() -> String {
    let (counted, exact) = lamp(EYE);
    let (width, height) = SIZE;
    format!(
        "Scene <code>cornell</code>, eye at ({}, {}, {}) m, {width} × {height} rays. All \
         directions, unrolled: up is up, and left and right edge meet. **Every pixel is \
         the same solid angle.** The lamp (yellow) fills {:.2} % of them, which makes \
         {counted:.4} sr; exact are {exact:.4} sr. Dark blue: the open front.",
        EYE.x,
        EYE.y,
        EYE.z,
        100.0 * counted / (4.0 * PI)
    )
}

/// The caption under one of the three eyes.
pub fn lamp_caption(height: f64) -> String {
    let eye = under_the_lamp(height);
    let below = scene().bounds().1.y - eye.y;
    let (_, exact) = lamp(eye);
    format!("{below:.2} m below the lamp: {exact:.3} sr")
}

/// A small lamp at [`EYE`] that shines 1 W evenly in all directions: where its light goes.
pub fn ledger() -> String {
    let mut text =
        String::from("| where | solid angle, sr | power, W |\n|---|---|---|\n");
    let shares = shares(EYE);
    for (name, share) in &shares {
        let name = if name == "open" { "escapes by the open front" } else { name };
        let power = share / (4.0 * PI);
        text.push_str(&format!("| {name} | {share:.4} | {power:.4} |\n"));
    }
    let sum: f64 = shares.iter().map(|(_, share)| share).sum();
    text.push_str(&format!("| **sum** | {sum:.4} | {:.4} |\n", sum / (4.0 * PI)));
    text
}
