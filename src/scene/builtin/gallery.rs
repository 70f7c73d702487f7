//! The gallery: everything that the two passes can do, in one room.
//!
//! ```text
//!          z = 0 ┌───────── mirror ──────────┐
//!                │  ball on its plinth        │ pictures
//!     window     │            vitrine         │
//!    (pane, sky) │                    screen ╱│ lamp behind it
//!                │      polished floor        │
//!          z = 5 └────────── camera ──────────┘
//!               x = 0                       x = 6
//! ```

use super::{Hole, SceneBuilder};
use crate::geometry::Rgb;
use crate::material::Shine;
use crate::scene::{Camera, MaterialId, Scene};
use crate::sky::Sky;
use glam::{DVec3, dvec3};

/// All of it: 6 m × 5 m × 3 m.
pub(super) fn gallery() -> Scene {
    let mut builder = SceneBuilder::default();
    shell(&mut builder);
    ball_and_vitrine(&mut builder);
    screen(&mut builder);
    let camera = Camera {
        eye: dvec3(4.5, 1.6, 4.9),
        target: dvec3(2.55, 1.05, 0.4),
        up: DVec3::Y,
        fov: 62.0,
    };
    let sky = Sky::overcast(Rgb::new(5.0, 7.0, 11.0), DVec3::Y);
    Scene { sky: Some(sky), ..builder.scene("gallery", camera) }
}

/// Floor, ceiling and walls with what hangs on them.
fn shell(builder: &mut SceneBuilder) {
    let white = builder.material("white", Rgb::ZERO, Rgb::new(0.78, 0.76, 0.73));
    let red = builder.material("red", Rgb::ZERO, Rgb::new(0.58, 0.13, 0.11));
    let lamp = builder.material("lamp", Rgb::new(95.0, 82.0, 62.0), Rgb::splat(0.5));
    let gloss = Shine::Gloss { reflectance: Rgb::splat(0.25), exponent: 120.0 };
    let wood = Rgb::new(0.38, 0.25, 0.15);
    let polished = builder.shiny("polished", wood, Rgb::ZERO, gloss);
    let silver = Shine::Mirror { reflectance: Rgb::new(0.92, 0.92, 0.90) };
    let mirror = builder.shiny("mirror", Rgb::ZERO, Rgb::ZERO, silver);
    let clear = Shine::Pane { index: 1.52, tint: Rgb::new(0.94, 0.97, 0.95) };
    let pane = builder.shiny("pane", Rgb::ZERO, Rgb::ZERO, clear);

    let plan @ [a, b, c, d] = [(0.0, 0.0), (0.0, 5.0), (6.0, 5.0), (6.0, 0.0)];
    builder.level(&plan, 3.0, [polished, white]);
    let window = Hole { left: 0.14, right: 0.62, low: 0.8, high: 2.6 };
    let outline = builder.pierced_wall(white, [a, b], 3.0, window);
    builder.face(pane, &outline);
    builder.wall(white, [b, c], 3.0);
    builder.wall(red, [c, d], 3.0);
    builder.wall(white, [d, a], 3.0);
    let lamps = [[1.1, 1.5], [3.0, 3.4], [4.9, 5.3]];
    for [left, right] in lamps {
        let corners = [(left, 2.0), (right, 2.0), (right, 2.4), (left, 2.4)];
        builder.face(lamp, &corners.map(|(x, z)| dvec3(x, 3.0, z)));
    }
    // On the wall at z = 0: a frame, and the mirror in it.
    let frame = builder.material("frame", Rgb::ZERO, Rgb::new(0.62, 0.45, 0.14));
    on_far_wall(builder, frame, [1.55, 4.05], [0.55, 2.45]);
    on_far_wall(builder, mirror, [1.65, 3.95], [0.65, 2.35]);
    // On the red wall: two pictures.
    let blue = builder.material("blue", Rgb::ZERO, Rgb::new(0.10, 0.22, 0.55));
    let yellow = builder.material("yellow", Rgb::ZERO, Rgb::new(0.80, 0.62, 0.10));
    for (paint, [near, far]) in [(blue, [2.0, 1.2]), (yellow, [0.9, 0.4])] {
        let corners = [(near, 1.1), (near, 2.0), (far, 2.0), (far, 1.1)];
        builder.face(paint, &corners.map(|(z, y)| dvec3(6.0, y, z)));
    }
}

/// A rectangle in the wall at `z = 0`, which it covers.
fn on_far_wall(
    builder: &mut SceneBuilder,
    material: MaterialId,
    x: [f64; 2],
    y: [f64; 2],
) {
    let corners = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])];
    builder.face(material, &corners.map(|(x, y)| dvec3(x, y, 0.0)));
}

/// A ball of glass on a plinth, and a cube that stands in a vitrine of three panes.
fn ball_and_vitrine(builder: &mut SceneBuilder) {
    let stone = builder.material("stone", Rgb::ZERO, Rgb::splat(0.7));
    let green = builder.material("green", Rgb::ZERO, Rgb::new(0.12, 0.45, 0.20));
    let round = Shine::Glass { index: 1.5, tint: Rgb::ONE };
    let glass = builder.shiny("glass", Rgb::ZERO, Rgb::ZERO, round);
    builder.block(&square(1.5, 2.3, 0.25), 0.7, stone);
    builder.ball(dvec3(1.5, 1.01, 2.3), 0.3, 8, glass);
    builder.block(&square(3.1, 1.5, 0.35), 0.6, stone);
    builder.block_on(&square(3.1, 1.5, 0.13), [0.6, 0.9], green);
    let flat = Shine::Pane { index: 1.5, tint: Rgb::new(0.90, 0.97, 0.94) };
    let pane = builder.shiny("vitrine", Rgb::ZERO, Rgb::ZERO, flat);
    let corners = square(3.1, 1.5, 0.32);
    for k in 0..3 {
        let at = |k: usize, y: f64| dvec3(corners[k].0, y, corners[k].1);
        let [low, high] = [0.61, 1.25];
        builder.face(pane, &[at(k, low), at(k + 1, low), at(k + 1, high), at(k, high)]);
    }
}

/// A square plan about `(x, z)`, the near side first.
fn square(x: f64, z: f64, half: f64) -> [(f64, f64); 4] {
    let (w, e, n, s) = (x - half, x + half, z - half, z + half);
    [(w, n), (w, s), (e, s), (e, n)]
}

/// A paper screen in two leaves, and a lamp on a stand behind it.
fn screen(builder: &mut SceneBuilder) {
    let glow = Rgb::new(110.0, 80.0, 44.0);
    let lamp = builder.material("lantern", glow, Rgb::splat(0.5));
    let through = Rgb::new(0.42, 0.38, 0.28);
    let paper = builder.shiny("paper", Rgb::splat(0.42), through, Shine::Dull);
    let leaf = |a: (f64, f64), b: (f64, f64)| {
        let at = |(x, z): (f64, f64), y| dvec3(x, y, z);
        [at(a, 0.05), at(b, 0.05), at(b, 1.7), at(a, 1.7)]
    };
    builder.face(paper, &leaf((4.35, 1.75), (5.0, 2.15)));
    builder.face(paper, &leaf((5.0, 2.15), (5.75, 1.9)));
    builder.block(&square(5.1, 1.5, 0.12), 1.1, lamp);
}
