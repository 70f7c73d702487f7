//! What a point sees of a polygon past blockers: exactly, by cutting.
//!
//! Seen from a point, a convex blocker hides a convex cone. What of the polygon lies
//! outside all the cones is a list of convex pieces, and Lambert's formula of the pieces is
//! the exact factor to what is seen. No ray is drawn, and no shadow is missed.
//!
//! Sources: Nishita & Nakamae 1985 (light sources cut by what hides them).

use super::blocker::Blocker;
use crate::geometry::{Outline, Plane, Polygon, clip, clip_into};
use crate::radiometry::projected_solid_angle;
use glam::DVec3;
use std::f64::consts::PI;

/// Less than this share of what is seen past nothing is rounding.
const SLIVER: f64 = 1e-12;

/// So is less than this share of the angle that the target fills, in rad: a factor is a sum
/// of angles of its edges, which cancel where it is seen edge-on.
const ROUNDING: f64 = 1e-15;

// ANCHOR: lambert_visible
/// Form factor from a differential area at `p` to what it sees of `target`.
///
/// The dimensionless fraction, in `[0, 1]`, of the power leaving a Lambertian element at
/// `p` (unit normal `n`) that arrives at the front of `target` past all `blockers`; 0 when
/// `p` is behind `target`. A sheet whose plane holds `p` hides nothing.
///
/// # Accuracy
/// Exact but for rounding off the outlines' edges.
pub fn lambert_visible(
    p: DVec3,
    n: DVec3,
    target: &Polygon,
    blockers: &[&Blocker],
) -> f64 {
    if target.plane().height(p) <= 0.0 {
        return 0.0;
    }
    let factor = |outline: &[DVec3]| projected_solid_angle(p, n, outline) / PI;
    let mut cones = Vec::new();
    for blocker in blockers {
        blocker.hidden_cones(p, target, &mut cones);
    }
    let all = factor(target.vertices());
    let sum = match &cones[..] {
        [] => all,
        [cone] => all - factor(&inside(target.vertices(), cone)),
        cones => {
            // ANCHOR: cut_cones
            let mut seen = vec![Outline::from(target.vertices())];
            for cone in cones {
                for piece in std::mem::take(&mut seen) {
                    outside(piece, cone, &mut seen);
                }
            }
            seen.iter().map(|piece| factor(piece)).sum()
            // ANCHOR_END: cut_cones
        }
    };
    // Slivers that rounding leaves between two cones let no light through.
    let v = target.vertices();
    let rounding = ROUNDING * (v[0].distance(v[2]) / p.distance(v[0])).min(1.0);
    if sum > (SLIVER * all).max(rounding) { sum } else { 0.0 }
}
// ANCHOR_END: lambert_visible

/// The convex pieces of `target` that the point `p`, in front of it, sees past `blockers`.
pub fn visible_parts(
    p: DVec3,
    target: &Polygon,
    blockers: &[&Blocker],
) -> Vec<Outline> {
    let mut cones = Vec::new();
    for blocker in blockers {
        blocker.hidden_cones(p, target, &mut cones);
    }
    let mut seen = vec![Outline::from(target.vertices())];
    for cone in &cones {
        for piece in std::mem::take(&mut seen) {
            outside(piece, cone, &mut seen);
        }
    }
    seen
}

/// A convex outline parted by a convex cone of planes that face inwards: what is inside it,
/// which may be nothing, and the pieces outside.
pub fn parted(piece: Outline, cone: &[Plane]) -> (Outline, Vec<Outline>) {
    let kept = inside(&piece, cone);
    let mut rest = Vec::new();
    outside(piece, cone, &mut rest);
    (kept, rest)
}

/// What of a convex outline lies inside a convex cone.
pub fn inside(outline: &[DVec3], cone: &[Plane]) -> Outline {
    let mut rest = Outline::from(outline);
    let mut cut = Outline::new();
    for plane in cone {
        if rest.iter().any(|&v| plane.height(v) < 0.0) {
            clip_into(&rest, *plane, &mut cut);
            std::mem::swap(&mut rest, &mut cut);
        }
    }
    rest
}

/// Adds to `pieces` the convex pieces of a convex outline that lie outside a convex cone.
fn outside(piece: Outline, cone: &[Plane], pieces: &mut Vec<Outline>) {
    let clear = |plane: &Plane| piece.iter().all(|&v| plane.height(v) <= 0.0);
    if cone.iter().any(clear) {
        pieces.push(piece);
        return;
    }
    // ANCHOR: cut_outside
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
    // ANCHOR_END: cut_outside
}
