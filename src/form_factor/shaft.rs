//! What may stand between two polygons: the shaft, the convex hull of both.
//!
//! A blocker outside the shaft hides nothing of one from the other. Walls of a convex room
//! lie outside all its shafts, so that most pairs of a room need no visibility at all.
//!
//! Sources: Haines & Wallace 1991 (shaft culling).

use crate::geometry::{Plane, Polygon};
use crate::scene::Scene;
use crate::visibility::Visibility;
use glam::DVec3;

/// The surfaces of a scene, ready to be asked what stands between two polygons.
pub struct Shafts {
    visibility: Visibility,
    surfaces: Vec<Polygon>,
    margin: f64,
}

impl Shafts {
    /// Those of a scene.
    pub fn of(scene: &Scene) -> Shafts {
        let surfaces: Vec<Polygon> =
            scene.surfaces.iter().map(|s| s.polygon.clone()).collect();
        let visibility = Visibility::new(&surfaces);
        Shafts { visibility, surfaces, margin: 1e-9 * scene.diagonal() }
    }

    /// The surfaces, in order of the scene's.
    pub fn surfaces(&self) -> &[Polygon] {
        &self.surfaces
    }

    /// Rays against the surfaces.
    pub fn visibility(&self) -> &Visibility {
        &self.visibility
    }

    /// The surfaces that reach into the shaft between two polygons, in order: all that may
    /// hide some of one from some of the other.
    pub fn between(&self, i: &Polygon, j: &Polygon) -> Vec<u32> {
        let shaft = Shaft::between(i, j, self.margin);
        let mut found = shaft.candidates(&self.visibility);
        found.retain(|&k| !shaft.misses(&self.surfaces[k as usize]));
        found
    }

    /// Those of `blockers` that reach into the shaft.
    pub(super) fn narrowed<'a>(
        &self,
        blockers: &[&'a Polygon],
        i: &Polygon,
        j: &Polygon,
    ) -> Vec<&'a Polygon> {
        if blockers.is_empty() {
            return Vec::new();
        }
        let shaft = Shaft::between(i, j, self.margin);
        blockers.iter().copied().filter(|b| !shaft.misses(b)).collect()
    }
}

/// Planes that have both polygons on their front.
struct Shaft {
    planes: Vec<Plane>,
    margin: f64,
}

impl Shaft {
    /// The shaft between two polygons; what protrudes less than `margin` is outside.
    fn between(i: &Polygon, j: &Polygon, margin: f64) -> Shaft {
        let mut planes = vec![i.plane(), j.plane()];
        for (from, to) in [(i, j), (j, i)] {
            for (a, b) in from.edges() {
                planes
                    .extend(to.vertices().iter().filter_map(|&c| side(a, b, c, i, j)));
            }
        }
        Shaft { planes, margin }
    }

    /// Is the whole of `blocker` outside?
    fn misses(&self, blocker: &Polygon) -> bool {
        self.planes.iter().any(|plane| {
            blocker.vertices().iter().all(|&v| plane.height(v) <= self.margin)
        })
    }

    /// The items, in order, that may reach into the shaft.
    fn candidates(&self, scene: &Visibility) -> Vec<u32> {
        let outside = |low: DVec3, high: DVec3| {
            let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
            let top = |p: &Plane| p.height(middle) + p.normal.abs().dot(half);
            self.planes.iter().any(|p| top(p) <= self.margin)
        };
        let mut found = Vec::new();
        scene.visit(outside, |item| found.push(item));
        found.sort_unstable();
        found.dedup();
        found
    }
}

/// The plane through the edge `a b` and the corner `c`, if both polygons are on one side.
fn side(a: DVec3, b: DVec3, c: DVec3, i: &Polygon, j: &Polygon) -> Option<Plane> {
    let normal = (b - a).cross(c - a).try_normalize()?;
    let plane = Plane::through(a, normal);
    let size = a.distance(c).max(a.distance(b));
    let (mut low, mut high) = (0.0_f64, 0.0_f64);
    for &v in i.vertices().iter().chain(j.vertices()) {
        let h = plane.height(v);
        (low, high) = (low.min(h), high.max(h));
    }
    let rounding = 1e-12 * size;
    if low >= -rounding {
        Some(plane)
    } else if high <= rounding {
        Some(plane.flipped())
    } else {
        None
    }
}
