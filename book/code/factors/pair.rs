//! One pair, many ways: a floor and a wall that share an edge, both unit squares.

use crate::map;
use glam::{DVec3, dvec3};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::form_factor::shortcuts::point_to_point;
use radiosity::geometry::Polygon;
use radiosity::random::Stream;
use radiosity::scene::Scene;
use std::f64::consts::PI;

/// A rectangle from a corner and two edges; its front is where `a × b` points.
fn rectangle(corner: DVec3, a: DVec3, b: DVec3) -> Polygon {
    let corners = vec![corner, corner + a, corner + a + b, corner + b];
    Polygon::new(corners).expect("a rectangle is a polygon")
}

/// The floor, z up.
pub fn floor() -> Polygon {
    rectangle(DVec3::ZERO, DVec3::X, DVec3::Y)
}

/// The wall above its edge x = 0, which looks along x.
pub fn wall() -> Polygon {
    rectangle(DVec3::ZERO, DVec3::Y, DVec3::Z)
}

/// Both, as a scene: the floor first.
pub fn scene() -> Scene {
    map::black(&[floor(), wall()])
}

/// The pieces of a unit square from a corner along two edges.
fn pieces(a: DVec3, b: DVec3, cuts: u32) -> Vec<Polygon> {
    let step = 1.0 / f64::from(cuts);
    let piece = |k: u32| {
        let (i, j) = (f64::from(k % cuts), f64::from(k / cuts));
        rectangle(step * (i * a + j * b), step * a, step * b)
    };
    (0..cuts * cuts).map(piece).collect()
}

/// The sum of point to point over all pairs of `cuts × cuts` pieces each.
pub fn points(cuts: u32) -> f64 {
    let floor = pieces(DVec3::X, DVec3::Y, cuts);
    let wall = pieces(DVec3::Y, DVec3::Z, cuts);
    let from =
        |i: &Polygon| i.area() * wall.iter().map(|j| point_to_point(i, j)).sum::<f64>();
    floor.iter().map(from).sum()
}

/// The mean of Lambert's formula over the middles of `cuts × cuts` pieces of the floor.
pub fn middles(cuts: u32) -> f64 {
    let wall = wall();
    let floor = pieces(DVec3::X, DVec3::Y, cuts);
    let from = |i: &Polygon| i.area() * lambert_polygon(i.centroid(), DVec3::Z, &wall);
    floor.iter().map(from).sum()
}

/// The kernel at so many random pairs of points, and its largest value.
pub fn random_pairs(pairs: usize, seed: u64) -> (f64, f64) {
    let (mut sum, mut largest) = (0.0, 0.0_f64);
    for [a, b, c, d] in Stream::named(seed, &[pairs as u64]).points(pairs) {
        let r = dvec3(0.0, c, d) - dvec3(a, b, 0.0);
        let square = r.length_squared();
        let kernel = r.z * -r.x / (PI * square * square);
        sum += kernel;
        largest = largest.max(kernel);
    }
    (sum / pairs as f64, largest)
}
