//! Splitting: areas kept, balance, no light through walls. (T-vertices: also row 39 of
//! `tests/stability/mesh.rs`.)

use crate::common::rooms::{rectangle, scene};
use glam::{DVec3, dvec3};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::random::Stream;
use radiosity::scene::built_in;

fn area(mesh: &Mesh) -> f64 {
    mesh.polygons().map(|p| p.area()).sum()
}

/// Splits some elements, drawn at random, a few times over.
fn split_at_random(mut mesh: Mesh, rounds: u64) -> Mesh {
    for round in 0..rounds {
        let mut random = Stream::named(7, &[round]);
        let marks: Vec<bool> =
            mesh.elements.iter().map(|_| random.next() < 0.2).collect();
        mesh = mesh.split(&marks);
    }
    mesh
}

#[test]
fn splitting_keeps_area_patches_and_vertices() {
    for name in ["cornell", "l-room", "indirect-room"] {
        let scene = built_in(name).unwrap();
        let before = Mesh::patched(&scene, 0.2 * scene.diagonal());
        let after = split_at_random(before.clone(), 4);
        assert!((area(&after) / area(&before) - 1.0).abs() < 1e-12, "{name}");
        assert_eq!(before.patches.len(), after.patches.len(), "{name}");
        assert_eq!(before.vertices[..], after.vertices[..before.vertices.len()]);
        for (patch, old) in after.patches.iter().zip(&before.patches) {
            let of = |mesh: &Mesh, ids: std::ops::Range<u32>| {
                ids.map(|k| mesh.elements[k as usize].polygon.area()).sum::<f64>()
            };
            let (new, old) =
                (of(&after, patch.elements.clone()), of(&before, old.elements.clone()));
            assert!((new / old - 1.0).abs() < 1e-12, "{name}");
        }
    }
}

/// On a conforming start, no edge holds more than one T-vertex, and every one is anchored.
#[test]
fn splitting_stays_balanced() {
    let square = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let scene = scene([(square, 1.0, 0.5)]);
    let mesh = split_at_random(Mesh::patched(&scene, 0.25), 5);
    let mut anchored = 0;
    for element in &mesh.elements {
        for (a, b) in element.polygon.edges() {
            let inside: Vec<usize> = (0..mesh.vertices.len())
                .filter(|&k| {
                    let v = mesh.vertices[k];
                    let t = (v - a).dot(b - a) / a.distance_squared(b);
                    (1e-6..1.0 - 1e-6).contains(&t) && a.lerp(b, t).distance(v) < 1e-12
                })
                .collect();
            assert!(inside.len() <= 1, "{a} {b}: {inside:?}");
            anchored += inside.len();
            for k in inside {
                assert!(mesh.t_vertices().any(|t| t.0 as usize == k));
            }
        }
    }
    assert_eq!(anchored, mesh.t_vertices().count());
    assert!(anchored > 10);
}

/// A wall on a floor: elements of both sides keep vertices of their own, however finely
/// they are split, and none is anchored to the other side.
#[test]
fn split_elements_share_no_vertex_through_a_wall() {
    let floor = rectangle(DVec3::ZERO, 2.0 * DVec3::X, 2.0 * DVec3::Y);
    let wall = rectangle(dvec3(0.9, -1.0, 0.0), 4.0 * DVec3::Y, DVec3::Z);
    let scene = scene([(floor, 0.0, 0.5), (wall, 1.0, 0.5)]);
    let mesh = split_at_random(Mesh::patched(&scene, 0.5), 3);
    let floor = mesh.elements.iter().filter(|e| mesh.surface_of(e) == 0);
    let mut values = vec![Rgb::ZERO; mesh.vertices.len()];
    for element in floor.clone() {
        let left = element.polygon.centroid().x < 0.9;
        for corner in &element.corners {
            values[corner.0 as usize] = Rgb::splat(if left { 1.0 } else { 2.0 });
        }
    }
    mesh.anchor(&mut values);
    for element in floor {
        let left = element.polygon.centroid().x < 0.9;
        let expected = if left { 1.0 } else { 2.0 };
        for corner in &element.corners {
            assert_eq!(values[corner.0 as usize].x, expected);
        }
    }
}
