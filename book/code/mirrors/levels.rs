//! What is missing when reflections are cut at a level.

use super::unfolded::{floor, lamp, mirror, rectangle, scene};
use crate::chart::{self, Point};
use glam::DVec3;
use radiosity::geometry::Polygon;
use radiosity::material::Coefficients;
use radiosity::virtual_world::VirtualWorld;
use std::fmt::Write;
use std::sync::OnceLock;

/// Between what the floor lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mirrors {
    /// Two mirrors face to face, endless.
    Two,
    /// Four mirrors, up to the lamp.
    Four,
}

/// The walls about the unit square, from `z = 0` on, each so wide and so high.
fn walls(count: usize, wide: f64, high: f64) -> Vec<Polygon> {
    let turned = |k: usize| {
        let out = [DVec3::NEG_X, DVec3::X, DVec3::NEG_Y, DVec3::Y][k];
        let along = DVec3::Z.cross(out);
        let corner = 0.5 * out - 0.5 * wide * along;
        // fronts look inwards: Z × (Z × out) = −out
        rectangle(corner, high * DVec3::Z, wide * along)
    };
    (0..count).map(turned).collect()
}

fn world(mirrors: Mirrors, share: f64, levels: u32) -> VirtualWorld {
    let walls = match mirrors {
        Mirrors::Two => walls(2, 4000.0, 2000.0),
        Mirrors::Four => walls(4, 1.0, 1.0),
    };
    let (floor, lamp) = (floor(), lamp());
    let dull = Coefficients::default();
    let mut faces = vec![(&floor, dull), (&lamp, dull)];
    faces.extend(walls.iter().map(|wall| (wall, mirror(share))));
    VirtualWorld::of(&scene(&faces), levels)
}

/// What the middle of the floor sees of the lamp, by so many levels at the most.
pub fn sums(mirrors: Mirrors, share: f64, levels: u32) -> Vec<f64> {
    let world = world(mirrors, share, 0);
    let found = world.factors_by_level(DVec3::ZERO, DVec3::Z, &lamp(), levels);
    let sum = |sum: &mut f64, f: &DVec3| {
        *sum += f.x;
        Some(*sum)
    };
    found.iter().scan(0.0, sum).collect()
}

/// One curve: which mirrors, their share, and the factor by all levels.
struct Curve {
    mirrors: Mirrors,
    share: f64,
    limit: f64,
    sums: Vec<f64>,
}

const LEVELS: u32 = 64;

fn curves() -> &'static [Curve] {
    static CURVES: OnceLock<Vec<Curve>> = OnceLock::new();
    CURVES.get_or_init(|| {
        let of = |(mirrors, share, limit): (Mirrors, f64, Option<f64>)| {
            let sums = sums(mirrors, share, LEVELS);
            // Where the mirrors absorb, nothing that counts is left after 64 levels of ½.
            let limit = limit.unwrap_or(sums[LEVELS as usize]);
            Curve { mirrors, share, limit, sums }
        };
        [
            (Mirrors::Two, 1.0, Some(5f64.sqrt().recip())),
            (Mirrors::Two, 0.9, Some(0.421_364_518_2)),
            (Mirrors::Two, 0.5, None),
            (Mirrors::Four, 1.0, Some(1.0)),
            (Mirrors::Four, 0.5, None),
        ]
        .map(of)
        .into()
    })
}

impl Curve {
    fn missing(&self, level: usize) -> f64 {
        1.0 - self.sums[level] / self.limit
    }

    fn name(&self) -> String {
        let count = match self.mirrors {
            Mirrors::Two => "two",
            Mirrors::Four => "four",
        };
        format!("{count} mirrors, k = {}", self.share)
    }
}

/// The chart as SVG.
pub fn svg() -> String {
    let mut points = Vec::new();
    for curve in curves() {
        for level in [1, 2, 4, 8, 16, 32] {
            let error = curve.missing(level);
            if error > 1e-6 {
                points.push(Point {
                    method: curve.name(),
                    setting: level.to_string(),
                    milliseconds: level as f64,
                    error,
                });
            }
        }
    }
    let title = "The share of a lamp's light that is missing after so many reflections";
    chart::svg(title, &points, "levels", "missing share")
}

/// The numbers of the chart.
pub fn table() -> String {
    let mut text = String::from(
        "| mirrors | F of all levels | none | 1 | 2 | 4 | 8 |\n|---|---|---|---|---|---|---|\n",
    );
    for curve in curves() {
        let _ = write!(text, "| {} | {:.6} |", curve.name(), curve.limit);
        for level in [0, 1, 2, 4, 8] {
            let missing = 100.0 * curve.missing(level);
            let digits = if missing < 1.0 { 2 } else { 1 };
            let _ = write!(text, " {missing:.digits$} % |");
        }
        text.push('\n');
    }
    text
}

/// How many chains of mirrors there are.
pub fn images() -> String {
    let mut text =
        String::from("| levels | two mirrors | four mirrors |\n|---|---|---|\n");
    for levels in 0..=5 {
        let count = |mirrors| world(mirrors, 1.0, levels).images().len() - 1;
        let [two, four] = [Mirrors::Two, Mirrors::Four].map(count);
        let _ = writeln!(text, "| {levels} | {two} | {four} |");
    }
    text
}
