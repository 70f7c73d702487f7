//! Rooms with mirrors, panes, gloss, paper and glass, and rooms that the sky lights.

use super::{Hole, SceneBuilder};
use crate::geometry::Rgb;
use crate::material::Shine;
use crate::scene::{Camera, Scene};
use crate::sky::Sky;
use glam::{DVec3, dvec3};

const OFF_WHITE: Rgb = Rgb::new(0.80, 0.78, 0.75);
const WOOD: Rgb = Rgb::new(0.55, 0.40, 0.26);
const RED: Rgb = Rgb::new(0.63, 0.12, 0.10);
const GREEN: Rgb = Rgb::new(0.16, 0.42, 0.16);
const BLUE: Rgb = Rgb::new(0.16, 0.28, 0.55);
const LAMP: Rgb = Rgb::new(100.0, 92.0, 80.0);

fn grey(value: f64) -> Rgb {
    Rgb::splat(value)
}

fn looking(eye: DVec3, target: DVec3, fov: f64) -> Camera {
    Camera { eye, target, up: DVec3::Y, fov }
}

/// A level rectangle that faces down.
fn panel(x: [f64; 2], y: f64, z: [f64; 2]) -> [DVec3; 4] {
    [(x[0], z[0]), (x[1], z[0]), (x[1], z[1]), (x[0], z[1])]
        .map(|(x, z)| dvec3(x, y, z))
}

/// A closed room, 4 m × 3 m × 2.6 m, whose wall at `z = 0` is a perfect mirror.
pub(super) fn mirror_room() -> Scene {
    let mut builder = SceneBuilder::default();
    let white = builder.material("white", Rgb::ZERO, OFF_WHITE);
    let wood = builder.material("wood", Rgb::ZERO, WOOD);
    let red = builder.material("red", Rgb::ZERO, RED);
    let green = builder.material("green", Rgb::ZERO, GREEN);
    let lamp = builder.material("lamp", LAMP, grey(0.5));
    let shine = Shine::Mirror { reflectance: Rgb::ONE };
    let mirror = builder.shiny("mirror", Rgb::ZERO, Rgb::ZERO, shine);
    let plan = [(0.0, 0.0), (0.0, 3.0), (4.0, 3.0), (4.0, 0.0)];
    builder.room(&plan, 2.6, [wood, white], &[red, white, green, mirror]);
    builder.face(lamp, &panel([1.4, 2.4], 2.6, [1.6, 2.4]));
    builder.block(&[(0.7, 0.6), (0.5, 1.3), (1.2, 1.5), (1.4, 0.8)], 0.7, white);
    let camera = looking(dvec3(2.9, 1.5, 2.8), dvec3(1.7, 1.05, 0.0), 72.0);
    builder.scene("mirror-room", camera)
}

/// A corridor 2 m wide between two mirrors that keep nine tenths, its lamp overhead.
pub(super) fn mirror_corridor() -> Scene {
    let mut builder = SceneBuilder::default();
    let white = builder.material("white", Rgb::ZERO, OFF_WHITE);
    let wood = builder.material("wood", Rgb::ZERO, WOOD);
    let blue = builder.material("blue", Rgb::ZERO, BLUE);
    let red = builder.material("red", Rgb::ZERO, RED);
    let lamp = builder.material("lamp", LAMP, grey(0.5));
    let shine = Shine::Mirror { reflectance: Rgb::new(0.9, 0.9, 0.88) };
    let mirror = builder.shiny("mirror", Rgb::ZERO, Rgb::ZERO, shine);
    let plan = [(0.0, 0.0), (0.0, 5.0), (2.0, 5.0), (2.0, 0.0)];
    builder.room(&plan, 2.4, [wood, white], &[mirror, white, mirror, blue]);
    builder.face(lamp, &panel([0.7, 1.3], 2.4, [1.2, 3.0]));
    builder.block(&[(0.8, 1.0), (0.6, 1.5), (1.1, 1.7), (1.3, 1.2)], 0.9, red);
    let camera = looking(dvec3(1.8, 1.5, 4.7), dvec3(0.2, 0.75, 1.2), 60.0);
    builder.scene("mirror-corridor", camera)
}

/// A room of 5 m × 4 m × 2.8 m with a window of 2.4 m × 1.5 m; `glass` in it, if any.
fn daylight(name: &str, sky: Sky, glass: Option<Shine>, camera: Camera) -> Scene {
    let mut builder = SceneBuilder::default();
    let white = builder.material("white", Rgb::ZERO, OFF_WHITE);
    let wood = builder.material("wood", Rgb::ZERO, WOOD);
    let green = builder.material("green", Rgb::ZERO, GREEN);
    let red = builder.material("red", Rgb::ZERO, RED);
    let plan @ [a, b, c, d] = [(0.0, 0.0), (0.0, 4.0), (5.0, 4.0), (5.0, 0.0)];
    builder.level(&plan, 2.8, [wood, white]);
    let hole = Hole { left: 0.2, right: 0.8, low: 0.9, high: 2.4 };
    let outline = builder.pierced_wall(white, [a, b], 2.8, hole);
    builder.wall(white, [b, c], 2.8);
    builder.wall(green, [c, d], 2.8);
    builder.wall(white, [d, a], 2.8);
    builder.block(&[(1.5, 1.2), (1.5, 2.4), (2.9, 2.4), (2.9, 1.2)], 0.75, wood);
    builder.block(&[(3.6, 0.5), (3.5, 1.2), (4.2, 1.3), (4.3, 0.6)], 1.5, red);
    if let Some(shine) = glass {
        let pane = builder.shiny("pane", Rgb::ZERO, Rgb::ZERO, shine);
        builder.face(pane, &outline);
    }
    Scene { sky: Some(sky), ..builder.scene(name, camera) }
}

/// Daylight from an overcast sky through a pane of glass.
pub(super) fn glazed_room() -> Scene {
    let sky = Sky::overcast(Rgb::new(30.0, 32.0, 36.0), DVec3::Y);
    let glass = Shine::Pane { index: 1.52, tint: Rgb::new(0.94, 0.96, 0.95) };
    let camera = looking(dvec3(4.7, 1.5, 3.8), dvec3(2.1, 0.75, 0.6), 62.0);
    daylight("glazed-room", sky, Some(glass), camera)
}

/// Daylight from a uniform sky through an open window.
pub(super) fn sky_room() -> Scene {
    let sky = Sky::uniform(Rgb::new(18.0, 20.0, 24.0), DVec3::Y);
    let camera = looking(dvec3(0.3, 1.5, 3.8), dvec3(3.2, 0.9, 0.9), 66.0);
    daylight("sky-room", sky, None, camera)
}

/// A room of 4 m × 4 m × 2.6 m that a paper screen divides; the lamp is behind the screen.
///
/// Before the screen it is lit by what comes through the paper, and round its edges.
pub(super) fn translucent_screen() -> Scene {
    let mut builder = SceneBuilder::default();
    let white = builder.material("white", Rgb::ZERO, OFF_WHITE);
    let wood = builder.material("wood", Rgb::ZERO, WOOD);
    let rose = builder.material("rose", Rgb::ZERO, Rgb::new(0.80, 0.58, 0.52));
    let blue = builder.material("blue", Rgb::ZERO, BLUE);
    let lamp = builder.material("lamp", 2.0 * LAMP, grey(0.5));
    let through = Rgb::new(0.45, 0.42, 0.34);
    let paper = builder.shiny("paper", grey(0.4), through, Shine::Dull);
    let plan = [(0.0, 0.0), (0.0, 4.0), (4.0, 4.0), (4.0, 0.0)];
    builder.room(&plan, 2.6, [wood, white], &[rose, white, blue, white]);
    builder.face(lamp, &panel([1.6, 2.4], 2.6, [0.3, 0.9]));
    let sheet = [(3.4, 0.05), (0.6, 0.05), (0.6, 2.1), (3.4, 2.1)];
    builder.face(paper, &sheet.map(|(x, y)| dvec3(x, y, 1.6)));
    builder.block(&[(1.3, 0.9), (1.3, 1.3), (1.7, 1.3), (1.7, 0.9)], 1.5, white);
    builder.block(&[(2.5, 2.1), (2.3, 2.6), (2.8, 2.8), (3.0, 2.3)], 0.6, white);
    let camera = looking(dvec3(1.2, 1.5, 3.9), dvec3(2.15, 0.95, 1.6), 66.0);
    builder.scene("translucent-screen", camera)
}

/// A room of 4 m × 4 m × 2.6 m with a polished floor; a lamp glows low on its far wall.
pub(super) fn glossy_floor() -> Scene {
    let mut builder = SceneBuilder::default();
    let white = builder.material("white", Rgb::ZERO, OFF_WHITE);
    let red = builder.material("red", Rgb::ZERO, RED);
    let blue = builder.material("blue", Rgb::ZERO, BLUE);
    let lamp = builder.material("lamp", LAMP, grey(0.5));
    let shine = Shine::Gloss { reflectance: grey(0.4), exponent: 80.0 };
    let polished =
        builder.shiny("polished", Rgb::new(0.30, 0.22, 0.15), Rgb::ZERO, shine);
    let plan = [(0.0, 0.0), (0.0, 4.0), (4.0, 4.0), (4.0, 0.0)];
    builder.room(&plan, 2.6, [polished, white], &[red, white, blue, white]);
    let low = [(1.4, 0.5), (2.6, 0.5), (2.6, 1.3), (1.4, 1.3)];
    builder.face(lamp, &low.map(|(x, y)| dvec3(x, y, 0.0)));
    builder.face(lamp, &panel([1.6, 2.4], 2.6, [1.8, 2.6]));
    builder.block(&[(0.6, 1.2), (0.6, 1.8), (1.2, 1.8), (1.2, 1.2)], 0.9, white);
    builder.block(&[(2.9, 1.0), (2.8, 1.5), (3.3, 1.6), (3.4, 1.1)], 0.5, white);
    let camera = looking(dvec3(2.0, 1.5, 3.9), dvec3(2.0, 0.7, 0.8), 68.0);
    builder.scene("glossy-floor", camera)
}

/// A room of 2 m × 2 m × 2 m with a ball of glass, of 288 faces, below a small lamp.
pub(super) fn glass_ball() -> Scene {
    let mut builder = SceneBuilder::default();
    let white = builder.material("white", Rgb::ZERO, OFF_WHITE);
    let red = builder.material("red", Rgb::ZERO, RED);
    let green = builder.material("green", Rgb::ZERO, GREEN);
    let lamp = builder.material("lamp", 5.0 * LAMP, grey(0.5));
    let shine = Shine::Glass { index: 1.5, tint: Rgb::ONE };
    let glass = builder.shiny("glass", Rgb::ZERO, Rgb::ZERO, shine);
    let plan = [(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)];
    builder.room(&plan, 2.0, [white, white], &[red, white, green, white]);
    builder.face(lamp, &panel([0.8, 1.1], 2.0, [0.7, 1.0]));
    builder.ball(dvec3(1.1, 0.6, 0.9), 0.4, 12, glass);
    let camera = looking(dvec3(1.0, 1.0, 1.95), dvec3(1.0, 0.75, 0.5), 70.0);
    builder.scene("glass-ball", camera)
}
