//! Rooms made for one question each.

use super::SceneBuilder;
use crate::geometry::Rgb;
use crate::material::{Coefficients, Material};
use crate::scene::{Camera, Scene};
use glam::{DVec3, dvec3};

const OFF_WHITE: Rgb = Rgb::new(0.80, 0.78, 0.75);
const WOOD: Rgb = Rgb::new(0.55, 0.40, 0.26);

/// The white furnace: the closed unit cube, every face with `E = 1` and reflectance `rho`.
///
/// Every point sees what it is itself, so `B = 1/(1 − ρ)` everywhere. `None` when `rho` is
/// not in `[0, 1)`.
pub(super) fn furnace(rho: f64) -> Option<Scene> {
    let coefficients = Coefficients {
        emission: Rgb::ONE,
        diffuse: Rgb::splat(rho),
        ..Default::default()
    };
    Material::new("glowing", coefficients).ok()?;
    let mut builder = SceneBuilder::default();
    let glowing = builder.material("glowing", Rgb::ONE, Rgb::splat(rho));
    let plan = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
    builder.room(&plan, 1.0, [glowing, glowing], &[glowing; 4]);
    let camera = Camera {
        eye: dvec3(0.9, 0.6, 0.92),
        target: dvec3(0.5, 0.5, 0.5),
        up: DVec3::Y,
        fov: 75.0,
    };
    let name = if rho == 0.5 { "furnace".into() } else { format!("furnace-{rho}") };
    Some(builder.scene(&name, camera))
}

/// Two unit squares face to face at distance 1; the lower one emits, both reflect 0.5.
///
/// The factor between them is 0.199825 (Siegel & Howell); all other light escapes.
pub(super) fn facing_squares() -> Scene {
    let mut builder = SceneBuilder::default();
    let lamp = builder.material("lamp", Rgb::ONE, Rgb::splat(0.5));
    let grey = builder.material("grey", Rgb::ZERO, Rgb::splat(0.5));
    let (o, x, y, z) = (DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z);
    builder.face(lamp, &[o, z, x + z, x]);
    builder.face(grey, &[y, y + x, y + x + z, y + z]);
    let camera = Camera {
        eye: dvec3(1.3, 0.5, 3.0),
        target: dvec3(0.5, 0.5, 0.5),
        up: DVec3::Y,
        fov: 36.0,
    };
    builder.scene("facing-squares", camera)
}

/// An L-shaped room, 5 m × 5 m × 2.6 m, its lamp in the ceiling at the end of one leg.
///
/// Floor and ceiling have six corners and are not convex; the ceiling is cut around the
/// lamp as well. The far end of the other leg sees the lamp not at all.
pub(super) fn l_room() -> Scene {
    let mut builder = SceneBuilder::default();
    let white = builder.material("white", Rgb::ZERO, OFF_WHITE);
    let wood = builder.material("wood", Rgb::ZERO, WOOD);
    let blue = builder.material("blue", Rgb::ZERO, Rgb::new(0.20, 0.32, 0.55));
    let yellow = builder.material("yellow", Rgb::ZERO, Rgb::new(0.75, 0.55, 0.15));
    let lamp = builder.material("lamp", Rgb::new(100.0, 90.0, 75.0), Rgb::splat(0.5));
    let plan = [(0.0, 0.0), (0.0, 5.0), (2.0, 5.0), (2.0, 2.0), (5.0, 2.0), (5.0, 0.0)];
    builder.room(
        &plan,
        2.6,
        [wood, white],
        &[blue, white, white, white, yellow, white],
    );
    let panel = [(3.4, 0.6), (4.4, 0.6), (4.4, 1.4), (3.4, 1.4)];
    builder.face(lamp, &panel.map(|(x, z)| dvec3(x, 2.6, z)));
    let camera = Camera {
        eye: dvec3(0.7, 1.5, 4.8),
        target: dvec3(1.45, 1.2, 1.0),
        up: DVec3::Y,
        fov: 62.0,
    };
    builder.scene("l-room", camera)
}

/// A closed room of two parts, 6 m × 4 m × 2.8 m, joined by an opening 1.5 m wide.
///
/// The lamp hangs on the far side of the partition and looks away from the main part,
/// which lies wholly behind the lamp's plane: no light comes there but by reflection.
pub(super) fn indirect_room() -> Scene {
    let mut builder = SceneBuilder::default();
    let white = builder.material("white", Rgb::ZERO, OFF_WHITE);
    let wood = builder.material("wood", Rgb::ZERO, WOOD);
    let rose = builder.material("rose", Rgb::ZERO, Rgb::new(0.80, 0.58, 0.52));
    let green = builder.material("green", Rgb::ZERO, Rgb::new(0.25, 0.50, 0.28));
    let blue = builder.material("blue", Rgb::ZERO, Rgb::new(0.25, 0.38, 0.60));
    let lamp = builder.material("lamp", Rgb::new(300.0, 300.0, 300.0), Rgb::splat(0.5));
    // The partition runs from z = 0 to z = 2.5, between x = 4 and x = 4.1.
    let plan = [
        (0.0, 0.0),
        (0.0, 4.0),
        (6.0, 4.0),
        (6.0, 0.0),
        (4.1, 0.0),
        (4.1, 2.5),
        (4.0, 2.5),
        (4.0, 0.0),
    ];
    let walls = [white, white, rose, white, white, white, white, blue];
    builder.room(&plan, 2.8, [wood, white], &walls);
    let panel = [(0.5, 0.6), (2.3, 0.6), (2.3, 1.8), (0.5, 1.8)];
    builder.face(lamp, &panel.map(|(y, z)| dvec3(4.1, y, z)));
    builder.block(&[(2.3, 1.2), (1.9, 2.1), (2.8, 2.5), (3.2, 1.6)], 0.75, white);
    builder.block(&[(2.9, 3.0), (2.9, 3.5), (3.4, 3.5), (3.4, 3.0)], 1.3, green);
    let camera = Camera {
        eye: dvec3(0.2, 1.6, 0.5),
        target: dvec3(3.3, 1.1, 2.6),
        up: DVec3::Y,
        fov: 58.0,
    };
    builder.scene("indirect-room", camera)
}
