//! Methods side by side: what their comparison says where the answer is known.

use radiosity::chart::{Comparison, Effort};
use radiosity::film::Shot;
use radiosity::geometry::Rgb;
use radiosity::scene::{Scene, built_in, builtins};

fn compared(name: &str, tolerance: f64, paths: usize, size: u32) -> Comparison {
    let scene = built_in(name).unwrap_or_else(|error| panic!("{error}"));
    let camera = scene.camera;
    let shot = Shot { camera, width: size, height: size, samples: 3 };
    let effort = Effort { tolerance, paths, seed: 1 };
    Comparison::of(&scene, &shot, &effort, &|| 0.0, &|_, _, _| {})
}

/// Nothing shines in the furnace, so four methods agree; classical ray tracing sees
/// `1 + ρ` of `1/(1 − ρ)`: three quarters.
#[test]
fn the_furnace_looks_alike_but_to_classical_ray_tracing() {
    let found = compared("furnace", 0.01, 64, 16);
    for panel in &found.panels {
        let expected = if panel.name == "ray-tracing" { 0.75 } else { 1.0 };
        let off = panel.brightness - expected;
        assert!(off.abs() < 0.02, "{}: {}", panel.name, panel.brightness);
    }
    assert_eq!(found.reference().rms, 0.0);
    assert!(found.counts.iter().all(|counts| *counts));
    let traced = found.panel("ray-tracing").unwrap();
    assert!((traced.error - 0.25).abs() < 0.02, "{}", traced.error);
    // The difference map says the same, pixel by pixel.
    let mean = found.difference(traced).pixels.iter().map(|d| d.x).sum::<f64>() / 256.0;
    assert!((mean - 0.25).abs() < 0.03, "{mean}");
}

/// The two-pass picture of a room with a mirror is right but for the error of pass 1; who
/// leaves a pass or a bounce out is off by a tenth and more.
#[test]
fn only_two_passes_show_all_light() {
    let found = compared("mirror-room", 0.05, 64, 48);
    let error = |name: &str| found.panel(name).unwrap().error;
    assert!(error("two-pass") < 0.04, "{}", error("two-pass"));
    for name in ["classical-radiosity", "ray-tracing", "radiosity"] {
        assert!(error(name) > 0.1, "{name}: {}", error(name));
    }
    let table = found.csv("a room\nwith a mirror");
    assert!(table.starts_with("# a room\n# with a mirror\nmethod,cpu_seconds,"));
    assert_eq!(table.lines().count(), 2 + 1 + 5 + 1);
}

/// Classical radiosity: nothing shines any more, and no more light leaves than before.
#[test]
fn dulled_scenes_are_passive_and_do_not_shine() {
    for scene in builtins().iter().map(|b| (b.make)()) {
        let dull: Scene = scene.dulled();
        assert!(!dull.shines(), "{}", scene.name);
        assert_eq!(dull.face_areas(), scene.face_areas());
        for (was, is) in scene.materials.iter().zip(&dull.materials) {
            let out = is.diffuse() + is.translucence();
            assert!(out.max_element() < 1.0);
            let before = was.diffuse() + was.translucence();
            assert!((before - out).max_element() <= 1e-12, "{}", was.name());
            assert_eq!(is.emission(), was.emission());
        }
    }
    let mirror = built_in("cornell-mirror").unwrap().dulled();
    let silver = mirror.materials.iter().find(|m| m.name() == "mirror").unwrap();
    assert_eq!(silver.diffuse(), Rgb::new(0.95, 0.95, 0.93));
    let pane = built_in("cornell-pane").unwrap().dulled();
    let pane = pane.materials.iter().find(|m| m.name() == "pane").unwrap();
    assert!((pane.diffuse().x - 0.0769).abs() < 1e-4); // 2R/(1 + R), R = 0.04
}
