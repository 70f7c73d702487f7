//! The built-in scenes are what they claim to be.

use glam::DVec3;
use radiosity::geometry::Ray;
use radiosity::scene::{FaceId, Scene, Side, built_in, builtins};
use radiosity::visibility::Visibility;
use serde_json::Value;
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
            let of_face = scene.faces[s.face.0 as usize].material;
            assert!(s.material == of_face || s.side == Side::Back);
        }
        assert!(scene.fronts().is_sorted_by_key(|s| s.face), "{}", b.name);
    }
}

/// What Cornell published, and the reference scene (`tests/data/cornell.json`).
fn published() -> Value {
    serde_json::from_str(include_str!("../data/cornell.json")).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn close(a: DVec3, b: &[f64], tolerance: f64) -> bool {
    a.distance(DVec3::from_slice(b)) <= tolerance
}

/// `faces` corner by corner, in the order of the table; `scale` table units make one.
fn check_faces(scene: &Scene, faces: &Value, scale: f64) {
    let faces = faces.as_object().unwrap();
    assert_eq!(scene.faces.len(), faces.len());
    for (face, (name, corners)) in scene.faces.iter().zip(faces) {
        let corners = corners.as_array().unwrap();
        assert_eq!(face.outline.len(), corners.len(), "{name}");
        for (&got, corner) in face.outline.iter().zip(corners) {
            assert!(
                close(scale * got, &numbers(corner), 1e-12 * scale),
                "{name}: {got}"
            );
        }
        let material = scene.materials[face.material.0 as usize].name();
        let expected = match name.as_str() {
            "green" | "red" => name.as_str(),
            "light" => "lamp",
            _ => "white",
        };
        assert_eq!(material, expected, "{name}");
    }
}

#[test]
fn the_measured_cornell_box_is_the_published_one() {
    let (scene, data) = (scene("cornell"), published());
    check_faces(&scene, &data["measured_mm"], 1000.0);
    for material in &scene.materials[..3] {
        let expected = numbers(&data["reflectance"][material.name()]);
        assert!(close(material.diffuse(), &expected, 1e-9), "{}", material.name());
    }
    let lamp = &scene.materials[3];
    assert!(close(lamp.emission() / 100.0, &numbers(&data["lamp"]), 1e-9));
    assert!(close(
        1000.0 * scene.camera.eye,
        &numbers(&data["camera"]["position"]),
        1e-9
    ));
    let focal_length = data["camera"]["focal_length"].as_f64().unwrap();
    let film = numbers(&data["camera"]["width_height"])[1];
    let fov = 2.0 * (0.5 * film / focal_length).atan().to_degrees();
    assert!((scene.camera.fov - fov).abs() < 1e-9);
}

#[test]
fn the_measured_cornell_box_has_the_published_areas() {
    let areas = scene("cornell").face_areas();
    for ((name, mm2), got) in
        published()["areas_mm2"].as_object().unwrap().iter().zip(areas)
    {
        let hidden = if name == "ceiling" { 13_650.0 } else { 0.0 }; // by the lamp
        // The red wall folds along its shorter diagonal: a little more than flat.
        let tolerance = if name == "red" { 5.0 } else { 1e-6 };
        let off = got * 1e6 - (mm2.as_f64().unwrap() - hidden);
        assert!(off.abs() < tolerance, "{name}: {off} mm²");
    }
}

#[test]
fn the_regular_cornell_box_is_that_of_the_reference() {
    let (scene, data) = (scene("cornell-regular"), published());
    check_faces(&scene, &data["regular"], 1.0);
    for material in &scene.materials[..3] {
        let rho = material.diffuse();
        for (channel, got) in [("R", rho.x), ("G", rho.y)] {
            assert_eq!(data["regular_rho"][channel][material.name()], got);
        }
        let blue = numbers(&data["reflectance"][material.name()])[2];
        assert!((rho.z - blue).abs() <= 0.5e-5);
    }
    let lamp = &scene.materials[3];
    assert_eq!((lamp.emission(), lamp.diffuse()), (DVec3::ONE, DVec3::ZERO));
    // The ceiling is cut around the lamp.
    assert!((scene.face_areas()[4] - (5.5 * 5.6 - 1.3 * 1.05)).abs() < 1e-12);
    assert_eq!(scene.surfaces.iter().filter(|s| s.face == FaceId(4)).count(), 4);
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

/// What is not plain is said to be: mirrors and panes shine, the sky and paper do not.
#[test]
fn scenes_that_shine_are_told_from_plain_ones() {
    for b in builtins() {
        let scene = (b.make)();
        let plain = ["cornell", "cornell-regular", "furnace", "facing-squares"];
        let plain =
            plain.contains(&b.name) || ["l-room", "indirect-room"].contains(&b.name);
        assert_eq!(scene.is_plain(), plain, "{}", b.name);
        let dull = plain || ["sky-room", "translucent-screen"].contains(&b.name);
        assert_eq!(scene.shines(), !dull, "{}", b.name);
        let bare = scene.bare_geometry();
        assert!(bare.is_plain() && bare.face_areas() == scene.face_areas());
        assert!((100..500).contains(&scene.faces.len()) || b.name != "gallery");
    }
}

/// No camera stands behind a wall.
#[test]
fn what_a_camera_looks_at_is_no_black_back() {
    for b in builtins() {
        let scene = (b.make)();
        let eye = scene.camera.eye;
        let visibility = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
        let direction = (scene.camera.target - eye).normalize();
        let hit = visibility.closest(&Ray { origin: eye, direction }, None);
        let Some(hit) = hit else { continue }; // it looks between two squares
        let surface = &scene.surfaces[hit.item as usize];
        let seen = hit.front || scene.material(surface).shine().passes();
        assert!(seen || surface.back.is_some(), "{} looks at a back", b.name);
    }
}
