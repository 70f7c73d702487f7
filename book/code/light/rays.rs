//! Solid angles by casting rays: evenly over the hemisphere, or in proportion to the cosine.

use super::pieces::target;
use glam::{DVec3, dvec2, dvec3};
use radiosity::geometry::Polygon;
use radiosity::radiometry::cosine_direction;
use radiosity::random::Stream;
use std::f64::consts::{PI, TAU};

/// Does a ray from `eye`, below the unit square about the origin, meet it?
fn meets(square: &Polygon, eye: DVec3, direction: DVec3) -> bool {
    let at = eye - direction * (eye.z / direction.z);
    direction.z > 0.0 && square.contains(at, 0.0)
}

/// The mean of `value` over directions that `direction` makes of two uniform numbers.
fn mean(
    eye: DVec3,
    rays: usize,
    seed: u64,
    direction: impl Fn(f64, f64) -> DVec3,
    value: impl Fn(DVec3) -> f64,
) -> f64 {
    let points = Stream::named(seed, &[rays as u64]).points(rays);
    let square = target();
    let of_ray = |[u, v]: [f64; 2]| {
        let direction = direction(u, v);
        if meets(&square, eye, direction) { value(direction) } else { 0.0 }
    };
    points.map(of_ray).sum::<f64>() / rays as f64
}

/// A direction of the upper hemisphere, all equally likely: Archimedes' map.
fn even(u: f64, v: f64) -> DVec3 {
    let (sine, cosine) = (TAU * u).sin_cos();
    let across = (1.0 - v * v).sqrt();
    dvec3(across * cosine, across * sine, v)
}

/// Solid angle of the unit square, from rays that are spread evenly over the hemisphere.
pub fn covered(eye: DVec3, rays: usize, seed: u64) -> f64 {
    TAU * mean(eye, rays, seed, even, |_| 1.0)
}

/// Projected solid angle from the same rays, each with its cosine.
pub fn by_even(eye: DVec3, rays: usize, seed: u64) -> f64 {
    TAU * mean(eye, rays, seed, even, |w| w.z)
}

/// Projected solid angle from rays that carry equal light: their density has the cosine.
pub fn by_cosine(eye: DVec3, rays: usize, seed: u64) -> f64 {
    let direction = |u, v| cosine_direction(dvec2(u, v));
    PI * mean(eye, rays, seed, direction, |_| 1.0)
}
