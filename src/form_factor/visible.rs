//! What a point sees of a polygon past blockers: exactly, by cutting.
//!
//! Seen from a point, a convex blocker hides a convex cone. What of the polygon lies
//! outside all the cones is a list of convex pieces, and Lambert's formula of the pieces is
//! the exact factor to what is seen. No ray is drawn, and no shadow is missed.
//!
//! Sources: Nishita & Nakamae 1985 (light sources cut by what hides them).

use crate::geometry::{Plane, Polygon, clip};
use crate::radiometry::projected_solid_angle;
use glam::DVec3;
use std::f64::consts::PI;

/// Form factor from a differential area at `p` to what it sees of `target`.
///
/// The dimensionless fraction, in `[0, 1]`, of the power leaving a Lambertian element at
/// `p` (unit normal `n`) that arrives at the front of `target` past all `blockers`; 0 when
/// `p` is behind `target`. Blockers are two-sided; one whose plane holds `p` hides nothing.
///
/// # Accuracy
/// Exact but for rounding off the outlines' edges.
// ANCHOR: lambert_visible
pub fn lambert_visible(
    p: DVec3,
    n: DVec3,
    target: &Polygon,
    blockers: &[&Polygon],
) -> f64 {
    if target.plane().height(p) <= 0.0 {
        return 0.0;
    }
    let mut seen = vec![target.vertices().to_vec()];
    for blocker in blockers {
        let cone = cone(p, blocker, target);
        if !cone.is_empty() {
            seen = seen.into_iter().flat_map(|piece| outside(piece, &cone)).collect();
        }
    }
    seen.iter().map(|piece| projected_solid_angle(p, n, piece)).sum::<f64>() / PI
}
// ANCHOR_END: lambert_visible

/// The planes, facing inward, of the cone that the blocker's part in front of the target
/// hides from `p`; none when it hides nothing.
fn cone(p: DVec3, blocker: &Polygon, target: &Polygon) -> Vec<Plane> {
    let height = blocker.plane().height(p);
    if height.abs() <= 1e-12 * p.distance(blocker.vertices()[0]) {
        return Vec::new();
    }
    let before = clip(blocker.vertices(), target.plane());
    let n = before.len();
    // Seen from its back the outline runs clockwise: the planes turn round with it.
    let turn = if height > 0.0 { -1.0 } else { 1.0 };
    let plane = |k: usize| {
        let normal = (before[k] - p).cross(before[(k + 1) % n] - p);
        Some(Plane::through(p, turn * normal.try_normalize()?))
    };
    if n < 3 { Vec::new() } else { (0..n).filter_map(plane).collect() }
}

/// The convex pieces of a convex outline outside a convex cone.
fn outside(piece: Vec<DVec3>, cone: &[Plane]) -> Vec<Vec<DVec3>> {
    let clear = |plane: &Plane| piece.iter().all(|&v| plane.height(v) <= 0.0);
    if cone.iter().any(clear) {
        return vec![piece];
    }
    let mut pieces = Vec::new();
    let mut inside = piece;
    for plane in cone {
        let cut = clip(&inside, plane.flipped());
        if cut.len() >= 3 {
            pieces.push(cut);
        }
        inside = clip(&inside, *plane);
        if inside.len() < 3 {
            break;
        }
    }
    pieces
}

/// Does one convex blocker hide all of one polygon from all of the other?
///
/// Yes when it cuts every segment between their corners: from a fixed point the hidden
/// part is convex, so it holds all that its corners span - first on one side, then, point
/// by point, on the other.
pub(super) fn hides_all(blocker: &Polygon, i: &Polygon, j: &Polygon) -> bool {
    let plane = blocker.plane();
    i.vertices().iter().all(|&a| {
        let ha = plane.height(a);
        j.vertices().iter().all(|&b| {
            let hb = plane.height(b);
            ha * hb < 0.0 && blocker.contains(a + (b - a) * (ha / (ha - hb)), 0.0)
        })
    })
}
