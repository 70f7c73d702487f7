//! Squares and meshes of the tests on form factors.

use super::rooms::{black, box_walls, moved, rectangle};
use glam::{DVec3, dvec3};
use radiosity::geometry::Polygon;
use radiosity::mesh::Mesh;

/// A square of this side about `centre` that looks down.
pub fn lid(side: f64, centre: DVec3) -> Polygon {
    let corner = centre - dvec3(side / 2.0, side / 2.0, 0.0);
    rectangle(corner, DVec3::Y * side, DVec3::X * side)
}

/// A square of this side about `centre` that looks up.
pub fn floor(side: f64, centre: DVec3) -> Polygon {
    lid(side, centre).flipped()
}

/// The walls of the unit cube, fronts inwards, opposite ones in pairs.
pub fn cube() -> Vec<Polygon> {
    box_walls([1.0; 3]).to_vec()
}

/// The elements of black polygons, with edges no longer than `max_edge`.
pub fn mesh_of(polygons: &[Polygon], max_edge: f64) -> Mesh {
    Mesh::uniform(&black(polygons.iter().cloned()), max_edge)
}

/// Two unit squares face to face at distance 1, and a rectangle that stands half-way.
pub fn squares_with_screen(
    u: std::ops::Range<f64>,
    v: std::ops::Range<f64>,
) -> Vec<Polygon> {
    let square = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let lid = moved(&square, |p| p + DVec3::Z).flipped();
    let screen = rectangle(
        dvec3(u.start, v.start, 0.5),
        DVec3::X * (u.end - u.start),
        DVec3::Y * (v.end - v.start),
    );
    vec![square, lid, screen]
}
