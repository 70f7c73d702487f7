//! Anything that a law must hold for: polygons, poses, rooms with a block in them.

use super::rooms::{box_walls, coloured_scene, moved};
use glam::{DQuat, DVec3, dvec3};
use proptest::prelude::*;
use radiosity::geometry::{Plane, Polygon, Rgb};
use radiosity::scene::Scene;
use std::f64::consts::TAU;

pub fn vector(range: std::ops::Range<f64>) -> impl Strategy<Value = DVec3> {
    [range.clone(), range.clone(), range].prop_map(DVec3::from)
}

pub fn turn() -> impl Strategy<Value = DQuat> {
    (vector(-1.0..1.0), 0.0..TAU).prop_map(|(axis, angle)| {
        DQuat::from_axis_angle(axis.normalize_or(DVec3::Z), angle)
    })
}

/// A convex polygon of 3 to 6 corners and a size near 1, anywhere within a few sizes.
pub fn polygon() -> impl Strategy<Value = Polygon> {
    let gaps = prop::collection::vec(0.3..1.0_f64, 3..7);
    (gaps, [0.3..1.0_f64, 0.3..1.0], turn(), vector(-1.5..1.5)).prop_filter_map(
        "corners in half a turn hold no area",
        |(gaps, [a, b], turn, shift)| {
            let all: f64 = gaps.iter().sum();
            let mut angle = 0.0;
            let corners = gaps.iter().map(|gap| {
                angle += gap / all * TAU;
                turn * dvec3(a * angle.cos(), b * angle.sin(), 0.0) + shift
            });
            Polygon::new(corners.collect()).ok()
        },
    )
}

/// A plane that passes near the middle of `polygon`, for cutting it.
pub fn cut(polygon: &Polygon, direction: DVec3, shift: f64) -> Plane {
    let across = direction.reject_from_normalized(polygon.normal());
    let normal = across
        .try_normalize()
        .unwrap_or_else(|| polygon.normal().any_orthonormal_vector());
    Plane::through(polygon.centroid() + shift * normal, normal)
}

/// A room of some size with a turned block in it, standing or floating; every wall and
/// the block of a colour of its own; one or more walls emit. `open`: the last wall is
/// missing.
#[derive(Clone, Debug)]
pub struct Room {
    /// Outline, emitted radiosity, reflectance.
    pub faces: Vec<(Polygon, Rgb, Rgb)>,
    /// Is a wall missing?
    pub open: bool,
}

impl Room {
    pub fn scene(&self) -> Scene {
        coloured_scene(self.faces.iter().cloned())
    }
}

pub fn room(open: bool) -> impl Strategy<Value = Room> {
    let sides = [0.5..3.0_f64, 0.5..3.0, 0.5..3.0];
    let colours = prop::collection::vec(vector(0.0..0.9), 7);
    let block = ([0.1..0.3_f64, 0.1..0.3, 0.1..0.4], 0.0..TAU, prop::bool::ANY);
    (sides, colours, block, 1..8_usize).prop_map(move |(sides, colours, block, lit)| {
        let emission = |k: usize| match lit >> k & 1 {
            1 => Rgb::new(1.0, 0.7, 0.0) * (1.0 + k as f64),
            _ => Rgb::ZERO,
        };
        let walls = box_walls(sides).into_iter().enumerate();
        let mut faces: Vec<_> =
            walls.map(|(k, wall)| (wall, emission(k), colours[k])).collect();
        if open {
            faces.pop();
        }
        let ([a, b, c], angle, floats) = block;
        let sides = DVec3::from(sides);
        let size = sides * dvec3(a, b, c);
        let lift = if floats { 0.3 * sides.z } else { 0.0 };
        let turn = DQuat::from_rotation_z(angle);
        // Half the diagonal of the plan fits whichever way it is turned.
        let scale = sides.truncate().min_element() / size.truncate().length();
        let size = dvec3(size.x * scale.min(1.0), size.y * scale.min(1.0), size.z);
        let place = |v: DVec3| {
            turn * (v - dvec3(0.5, 0.5, 0.0) * size)
                + dvec3(0.5 * sides.x, 0.5 * sides.y, lift)
        };
        for wall in box_walls(size.to_array()) {
            let bottom = wall.normal().z > 0.5;
            if floats || !bottom {
                faces.push((moved(&wall, place).flipped(), Rgb::ZERO, colours[6]));
            }
        }
        Room { faces, open }
    })
}

/// A box without anything in it, somewhere in space: nothing hides anything.
pub fn convex_room() -> impl Strategy<Value = Room> {
    let colours = prop::collection::vec(vector(0.0..0.9), 6);
    let sides = [0.5..3.0_f64, 0.5..3.0, 0.5..3.0];
    (sides, colours, turn(), vector(-9.0..9.0), 0..6_usize).prop_map(
        |(sides, colours, turn, shift, lit)| {
            let walls = box_walls(sides).into_iter().zip(colours).enumerate();
            let face = |(k, (wall, colour)): (usize, (Polygon, Rgb))| {
                let emission =
                    if k == lit { Rgb::new(3.0, 2.0, 0.5) } else { Rgb::ZERO };
                (moved(&wall, |v| turn * v + shift), emission, colour)
            };
            Room { faces: walls.map(face).collect(), open: false }
        },
    )
}
