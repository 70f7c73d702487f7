//! Squares and meshes of the tests on form factors.

use super::rooms::{black, box_walls, rectangle};
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
