//! The shaft of two polygons: what lies outside hides nothing of one from the other.

use super::blocker::Blocker;
use crate::geometry::{Plane, Polygon};
use glam::DVec3;

/// Planes that have both polygons on their front.
#[derive(Debug)]
pub struct Shaft {
    planes: Vec<Plane>,
    margin: f64,
}

impl Shaft {
    /// The shaft of two polygons; what protrudes less than `margin` into it is outside.
    pub fn between(i: &Polygon, j: &Polygon, margin: f64) -> Shaft {
        let mut planes = vec![i.plane(), j.plane()];
        for (from, to) in [(i, j), (j, i)] {
            for (a, b) in from.edges() {
                planes
                    .extend(to.vertices().iter().filter_map(|&c| side(a, b, c, i, j)));
            }
        }
        Shaft { planes, margin }
    }

    pub(super) fn misses(&self, blocker: &Blocker) -> bool {
        self.misses_all(blocker.corners())
    }

    /// Does it miss the convex hull of these points, for certain?
    pub fn misses_all(&self, points: &[DVec3]) -> bool {
        let below =
            |plane: &Plane| points.iter().all(|&v| plane.height(v) <= self.margin);
        self.planes.iter().any(below)
    }

    pub(super) fn misses_box(&self, low: DVec3, high: DVec3) -> bool {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let top = |p: &Plane| p.height(middle) + p.normal.abs().dot(half);
        self.planes.iter().any(|p| top(p) <= self.margin)
    }
}

/// The plane through the edge `a b` and the corner `c`, if both polygons are on one side.
fn side(a: DVec3, b: DVec3, c: DVec3, i: &Polygon, j: &Polygon) -> Option<Plane> {
    let across = (b - a).cross(c - a);
    let (length, size) = (across.length(), a.distance(c).max(a.distance(b)));
    if length <= 1e-12 * size * size {
        return None;
    }
    // Through the point that has the smaller coordinates: a lamp may be far away.
    let near = if c.length_squared() < a.length_squared() { c } else { a };
    let plane = Plane::through(near, across / length);
    let rounding = 1e-12 * size;
    let (mut above, mut below) = (false, false);
    for &v in i.vertices().iter().chain(j.vertices()) {
        let h = plane.height(v);
        above |= h > rounding;
        below |= h < -rounding;
        if above && below {
            return None;
        }
    }
    Some(if below { plane.flipped() } else { plane })
}
