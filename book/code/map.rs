//! Maps: one number for each pixel, in false colour, with its key; and what is mapped.

use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::film::{FalseColour, Picture, RgbImage};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Material};
use radiosity::scene::{Face, MaterialId, Scene};
use std::fmt::Write;

/// Pixels along an edge of a map.
pub const PLACES: u32 = 64;

/// A square of this `side`, its middle at `centre`, its edges along x and y; its front
/// looks down.
pub fn square(side: f64, centre: DVec3) -> Polygon {
    let corner = |(x, y): (f64, f64)| centre + 0.5 * side * dvec3(x, y, 0.0);
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
    Polygon::new(corners.map(corner).to_vec()).expect("a square is a polygon")
}

/// `value` at the middle of each pixel of a square map from `low` to `high`; rows run from
/// the top, where y is `high.y`.
pub fn over(low: DVec2, high: DVec2, value: impl Fn(DVec2) -> f64) -> Vec<f64> {
    let along = |k: u32| (f64::from(k) + 0.5) / f64::from(PLACES);
    let at = |k: u32| dvec2(along(k % PLACES), 1.0 - along(k / PLACES));
    (0..PLACES * PLACES).map(|k| value(low + (high - low) * at(k))).collect()
}

/// A map in colours: equal steps of colour are equal ratios, from `low` to `high`.
pub fn draw(values: &[f64], low: f64, high: f64) -> RgbImage {
    let mut picture = Picture::new(PLACES, PLACES);
    for (pixel, value) in picture.pixels.iter_mut().zip(values) {
        *pixel = Rgb::splat(value.abs());
    }
    FalseColour { low, high }.draw(&picture)
}

/// The key to [`draw`]: each of `steps` colours with its number.
pub fn key(low: f64, high: f64, steps: usize, say: impl Fn(f64) -> String) -> String {
    let mut text = String::from("<span class=\"key\">");
    for (value, [r, g, b]) in (FalseColour { low, high }).legend(steps) {
        let style = format!("background:#{r:02x}{g:02x}{b:02x}");
        let _ = write!(text, "<i style=\"{style}\"></i> {}&ensp;", say(value));
    }
    text + "</span>\n"
}

/// A fraction as per cent, without needless digits.
pub fn per_cent(value: f64) -> String {
    format!("{} %", (value * 1e4).round() / 1e2)
}

/// A scene of grey faces, each with its emitted radiosity, W/m², and its reflectance.
pub fn grey(faces: impl IntoIterator<Item = (Polygon, f64, f64)>) -> Scene {
    let (mut materials, mut outlines) = (Vec::new(), Vec::new());
    for (k, (polygon, emission, diffuse)) in faces.into_iter().enumerate() {
        let (emission, diffuse) = (Rgb::splat(emission), Rgb::splat(diffuse));
        let coefficients =
            Coefficients { emission, diffuse, ..Coefficients::default() };
        let material = Material::new(format!("m{k}"), coefficients);
        materials.push(material.expect("a reflectance below 1"));
        let material = MaterialId(k as u32);
        outlines.push(Face { outline: polygon.vertices().to_vec(), material });
    }
    let scene = Scene::assemble("grey", materials, outlines, None);
    scene.expect("polygons are fit faces").0
}

/// A scene of black faces, for form factors alone.
pub fn black<'a>(faces: impl IntoIterator<Item = &'a Polygon>) -> Scene {
    grey(faces.into_iter().map(|polygon| (polygon.clone(), 0.0, 0.0)))
}
