//! The camera that a scene gets when it brings none.

use glam::{DVec3, dvec3};
use radiosity::scene::{Camera, FaceId, MaterialId, Scene, Side, Surface, built_in};

fn scene(name: &str) -> Scene {
    built_in(name).unwrap_or_else(|error| panic!("{error}"))
}

fn showing(scene: &Scene) -> Camera {
    Camera::showing(&scene.surfaces, DVec3::Y)
}

/// How far the eye lies within the scene's box; negative outside.
fn depth(scene: &Scene, eye: DVec3) -> f64 {
    let (low, high) = scene.bounds();
    (eye - low).min(high - eye).min_element()
}

#[test]
fn a_closed_room_is_seen_from_inside() {
    for name in ["furnace", "l-room", "indirect-room"] {
        let scene = scene(name);
        let camera = showing(&scene);
        assert!(depth(&scene, camera.eye) > 0.05, "{name}: {camera:?}");
    }
    // Three corners of the L lie in the room, the fourth does not.
    let eye = showing(&scene("l-room")).eye;
    assert!(eye.x < 2.0 || eye.z < 2.0, "{eye}");
}

#[test]
fn an_open_box_is_looked_into() {
    for name in ["cornell", "cornell-regular"] {
        let scene = scene(name);
        let camera = showing(&scene);
        assert!(depth(&scene, camera.eye) < 0.0);
        // Through the open front, which looks along −z.
        let towards = (camera.eye - camera.target).normalize();
        assert!(towards.z < -0.9, "{name}: {towards}");
    }
}

#[test]
fn an_object_is_seen_from_outside_and_a_sheet_from_its_front() {
    let mut scene = scene("furnace");
    for s in &mut scene.surfaces {
        s.polygon = s.polygon.flipped();
    }
    assert!(depth(&scene, showing(&scene).eye) < 0.0);
    for s in &scene.surfaces {
        let sheet = Surface {
            polygon: s.polygon.clone(),
            material: MaterialId(0),
            face: FaceId(0),
            side: Side::Front,
            back: None,
        };
        let camera = Camera::showing(&[sheet], DVec3::Y);
        assert!(s.polygon.plane().height(camera.eye) > 0.1, "{camera:?}");
        assert!((camera.target - camera.eye).cross(camera.up).length() > 0.1);
    }
}

#[test]
fn the_camera_moves_with_the_scene() {
    let (small, mut large) = (scene("cornell"), scene("cornell"));
    let shift = dvec3(100.0, -50.0, 20.0);
    for s in &mut large.surfaces {
        let moved = s.polygon.vertices().iter().map(|v| 1000.0 * *v + shift);
        s.polygon = radiosity::geometry::Polygon::new(moved.collect()).unwrap();
    }
    let (there, back) = (showing(&large), showing(&small));
    assert!((there.eye - (1000.0 * back.eye + shift)).length() < 1e-6);
}
