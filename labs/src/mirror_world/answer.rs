//! One right answer: images, clipped to the window that the mirror is.
#![deny(warnings)]

use super::given::{clip, crossing, lambert, plane};
use super::{Cards, Work};
use radiosity::prelude::{DVec3, Plane, dvec3};

/// Task 1: as far behind the mirror as the point is in front.
pub fn image(mirror: Plane, x: DVec3) -> DVec3 {
    x - 2.0 * mirror.height(x) * mirror.normal
}

/// Task 2: a mirror turns left into right, and so clockwise into counter-clockwise.
pub fn image_of(mirror: Plane, corners: &[DVec3]) -> Vec<DVec3> {
    let seen = clip(mirror, corners);
    seen.iter().rev().map(|&corner| image(mirror, corner)).collect()
}

/// Task 3: the sides of a pyramid with its tip in the eye, and its base.
pub fn through(eye: DVec3, window: &[DVec3], corners: &[DVec3]) -> Vec<DVec3> {
    let base = plane(window);
    if base.height(eye) <= 0.0 {
        return Vec::new();
    }
    let mut seen = clip(base.flipped(), corners);
    for (k, &a) in window.iter().enumerate() {
        let b = window[(k + 1) % window.len()];
        seen = clip(plane(&[eye, b, a]), &seen);
    }
    seen
}

/// Task 4: the image of the lamp, through the window that the mirror is.
pub fn by_mirror(p: DVec3, n: DVec3, mirror: &[DVec3], lamp: &[DVec3]) -> f64 {
    lambert(p, n, &through(p, mirror, &image_of(plane(mirror), lamp)))
}

/// Task 5: the straight line to the image tells where the mirror is hit.
pub fn reaches(x: DVec3, p: DVec3, mirror: &[DVec3], cards: Cards) -> bool {
    let flat = plane(mirror);
    if flat.height(x) <= 0.0 || flat.height(p) <= 0.0 {
        return false;
    }
    let Some(hit) = crossing(p, image(flat, x), mirror) else { return false };
    let free = |a, b| cards.iter().all(|card| crossing(a, b, card).is_none());
    free(p, hit) && free(hit, x)
}

/// Task 6: the images stand side by side; image k has been reflected |k| times.
pub fn corridor(reflectance: f64, levels: usize) -> f64 {
    let corners = [(-0.5, -0.5), (-0.5, 0.5), (0.5, 0.5), (0.5, -0.5)];
    let lamp = corners.map(|(x, y)| dvec3(x, y, 1.0));
    let beside =
        |k: f64| lambert(DVec3::ZERO, DVec3::Z, &lamp.map(|c| c + DVec3::X * k));
    let of_level = |k: usize| 2.0 * reflectance.powi(k as i32) * beside(k as f64);
    beside(0.0) + (1..=levels).map(of_level).sum::<f64>()
}

/// What is handed in.
pub const WORK: Work = Work { image, image_of, through, by_mirror, reaches, corridor };
