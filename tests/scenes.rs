//! The built-in scenes are what they claim to be.

use glam::DVec3;
use radiosity::scene::{FaceId, Scene, built_in, builtins};
use std::collections::HashMap;

fn scene(name: &str) -> Scene {
    built_in(name).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_scene_has_its_name_a_light_and_sound_ids() {
    for b in builtins() {
        let scene = (b.make)();
        assert_eq!(scene.name, b.name);
        assert!(scene.has_emitter(), "{}", b.name);
        for s in &scene.surfaces {
            assert!((s.face.0 as usize) < scene.faces.len());
            assert_eq!(s.material, scene.faces[s.face.0 as usize].material);
        }
        assert!(scene.surfaces.is_sorted_by_key(|s| s.face), "{}", b.name);
    }
}

/// The measured box, in mm², as `Σ` over the pieces of a face.
#[test]
fn the_measured_cornell_box_has_the_measured_areas() {
    let areas = scene("cornell").face_areas();
    let expected = [
        (0, 308_231.04),          // floor
        (1, 310_915.2 - 13_650.), // ceiling less lamp
        (2, 303_376.64),          // back
        (5, 13_650.0),            // lamp
        (6, 27_633.0),            // short block's top
        (12, 54_905.098_123_9),   // a side of the tall block
    ];
    for (face, mm2) in expected {
        assert!((areas[face] * 1e6 - mm2).abs() < 1e-6, "{face}: {}", areas[face]);
    }
    // Folded along its shorter diagonal, not flattened: a little more than flat.
    assert!((areas[4] * 1e6 - 306_901.954).abs() < 5.0, "{}", areas[4]);
}

#[test]
fn the_regular_cornell_box_has_16_faces_and_a_cut_ceiling() {
    let scene = scene("cornell-regular");
    assert_eq!(scene.faces.len(), 16);
    let areas = scene.face_areas();
    assert!((areas[4] - (5.5 * 5.6 - 1.3 * 1.05)).abs() < 1e-12, "{}", areas[4]);
    assert!((areas[5] - 1.3 * 1.05).abs() < 1e-12);
    assert_eq!(scene.surfaces.iter().filter(|s| s.face == FaceId(4)).count(), 4);
    assert_eq!(
        scene.material(&scene.surfaces[0]).diffuse().to_array(),
        [0.73626, 0.73667, 0.73782]
    );
}

/// Every edge of a closed room is walked once each way; blocks stand open on the floor.
#[test]
fn closed_scenes_are_closed() {
    let bits = |v: DVec3| v.to_array().map(f64::to_bits);
    for name in ["furnace", "l-room", "indirect-room"] {
        let scene = scene(name);
        let mut edges: HashMap<_, i32> = HashMap::new();
        for face in &scene.faces {
            if scene.materials[face.material.0 as usize].name() == "lamp" {
                continue; // lies within a wall or the ceiling
            }
            for (k, &a) in face.outline.iter().enumerate() {
                let b = face.outline[(k + 1) % face.outline.len()];
                *edges.entry((bits(a), bits(b))).or_default() += 1;
                *edges.entry((bits(b), bits(a))).or_default() -= 1;
            }
        }
        let open: Vec<_> = edges.iter().filter(|(_, n)| **n != 0).collect();
        let standing = |e: &[u64; 3]| f64::from_bits(e[1]) == 0.0;
        assert!(open.iter().all(|((a, b), _)| standing(a) && standing(b)), "{name}");
        assert_eq!(open.len(), if name == "indirect-room" { 16 } else { 0 }, "{name}");
    }
}

/// `⅓ Σ A x·n` is minus the volume when fronts look inwards; cutting changes nothing.
#[test]
fn closed_scenes_hold_their_volume() {
    let blocks = 0.75 * 0.97 + 1.3 * 0.25;
    for (name, volume) in [
        ("furnace", 1.0),
        ("l-room", 2.6 * (2.0 * 5.0 + 3.0 * 2.0)),
        ("indirect-room", 2.8 * (6.0 * 4.0 - 0.1 * 2.5) - blocks),
    ] {
        let scene = scene(name);
        // About a point of the floor, so that the blocks' missing undersides count 0.
        let flux = |s: &radiosity::scene::Surface| {
            s.polygon.area() * s.polygon.normal().dot(s.polygon.centroid())
        };
        let got = -scene.surfaces.iter().map(flux).sum::<f64>() / 3.0;
        assert!((got - volume).abs() < 1e-12 * volume, "{name}: {got} for {volume}");
    }
}

/// The main part of the room lies behind the lamp, wholly.
#[test]
fn the_indirect_room_is_lit_by_reflection_only() {
    let scene = scene("indirect-room");
    let lamp = scene.surfaces.iter().find(|s| scene.material(s).emits()).unwrap();
    let plane = lamp.polygon.plane();
    let mut seen = 0;
    for surface in &scene.surfaces {
        let corners = surface.polygon.vertices();
        if corners.iter().all(|v| v.x <= 4.0) {
            seen += 1;
            assert!(corners.iter().all(|&v| plane.height(v) < 0.0));
        }
    }
    assert!(seen > 5, "{seen}");
}

#[test]
fn the_furnace_takes_any_reflectance_below_one() {
    assert_eq!(scene("furnace:0.25").materials[0].diffuse(), DVec3::splat(0.25));
    assert_eq!(scene("furnace:0.5"), scene("furnace"));
    for bad in ["furnace:1", "furnace:-0.1", "furnace:nan", "furnace:", "furnace:x"] {
        let error = built_in(bad).unwrap_err().to_string();
        assert!(error.contains("[0, 1)"), "{error}");
    }
    let error = built_in("cornel").unwrap_err().to_string();
    assert!(error.contains("`cornel`") && error.contains("cornell-regular"), "{error}");
}
