//! Shapes and small scenes of the tests.
#![allow(dead_code, missing_docs)] // each test uses its part

use glam::{DVec3, dvec3};
use radiosity::geometry::Polygon;
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::Mesh;
use radiosity::scene::{Face, MaterialId, Scene};

/// A rectangle from a corner and two edges; its front is where `a × b` points.
pub fn rectangle(corner: DVec3, a: DVec3, b: DVec3) -> Polygon {
    Polygon::new(vec![corner, corner + a, corner + a + b, corner + b]).unwrap()
}

/// A square of this side about `centre` that looks down.
pub fn lid(side: f64, centre: DVec3) -> Polygon {
    let corner = centre - dvec3(side / 2.0, side / 2.0, 0.0);
    rectangle(corner, DVec3::Y * side, DVec3::X * side)
}

/// A square of this side about `centre` that looks up.
pub fn floor(side: f64, centre: DVec3) -> Polygon {
    lid(side, centre).flipped()
}

/// The six walls of the unit cube, fronts inwards: floor, ceiling, then x = 0, x = 1,
/// y = 0, y = 1.
pub fn cube() -> Vec<Polygon> {
    let (x, y, z, o) = (DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO);
    vec![
        rectangle(o, x, y),
        rectangle(z, y, x),
        rectangle(o, y, z),
        rectangle(x, z, y),
        rectangle(o, z, x),
        rectangle(y, x, z),
    ]
}

/// A scene of black polygons.
pub fn scene_of(polygons: &[Polygon]) -> Scene {
    let face = |polygon: &Polygon| Face {
        outline: polygon.vertices().to_vec(),
        material: MaterialId(0),
    };
    let black = Material::new("black", Coefficients::default()).unwrap();
    let faces = polygons.iter().map(face).collect();
    Scene::assemble("test", vec![black], faces, None).unwrap().0
}

/// Its elements, with edges no longer than `max_edge`.
pub fn mesh_of(polygons: &[Polygon], max_edge: f64) -> Mesh {
    Mesh::uniform(&scene_of(polygons), max_edge)
}
