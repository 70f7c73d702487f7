//! Faces that let light through and lie in the plane of another face: light meets one after
//! the other.
//!
//! ```text
//! opaque front | sheet | pane | … ─▶ light        the smaller before the larger, a hair apart
//! ```
//! A pane in the plane of a lamp, a sheet on a window. Of two faces in one place rays would
//! meet one, and cuts would weaken light by both. So the upper one is lifted to a hair, and
//! for whoever follows light nothing coincides.
//!
//! | the one beneath   | is lifted before its front                                   |
//! |-------------------|--------------------------------------------------------------|
//! | is opaque         | whatever lets light through: behind it nothing would show    |
//! | lets light pass   | the smaller, or of equal ones the earlier                    |

use super::Surface;
use super::overlap::{self, SAME};
use crate::geometry::{Plane, Polygon};
use glam::{DAffine3, DVec3};
use std::collections::BTreeMap;

/// A hair, as a share of the scene's diagonal: some hundred times what counts as rounding,
/// and far less than any element. Within it light changes from one side of an edge to the
/// other.
const HAIR: f64 = 2e-7;

/// Of the diagonal no more counts than this many times the smaller of two surfaces: what
/// comes in from the side, between them, is less than a ten-thousandth of all.
const LARGER: f64 = 1e2;

/// Lifts faces that let light through, as `passes` says, before those that they lie on.
pub(super) fn lift(
    surfaces: &mut [Surface],
    faces: usize,
    passes: &dyn Fn(&Surface) -> bool,
) {
    if !surfaces.iter().any(passes) {
        return;
    }
    let ranks = overlap::ranks(surfaces, faces);
    // The one that is lifted lets light pass; of two such it is the first in rank.
    let place = |s: &Surface| (!passes(s), ranks[s.face]);
    let order: Vec<(bool, usize)> = surfaces.iter().map(place).collect();
    // By rank: for each face that is lifted, its surfaces with those beneath them.
    let mut lying: BTreeMap<usize, Vec<(usize, usize)>> = BTreeMap::new();
    for (i, j) in overlap::overlapping(surfaces, &|a, b| a.dot(b).abs() > SAME) {
        let (upper, lower) = if order[i] < order[j] { (i, j) } else { (j, i) };
        let (opaque, rank) = order[upper];
        if !opaque {
            lying.entry(rank).or_default().push((upper, lower));
        }
    }
    let diagonal = overlap::diagonal(surfaces);
    for pairs in lying.into_values().rev() {
        let looks = |k: usize| surfaces[k].polygon.normal();
        let before = |&(upper, lower): &(usize, usize)| {
            let alike = looks(upper).dot(looks(lower)) > 0.0;
            let (opaque, rank) = order[lower];
            (!opaque, !alike, rank)
        };
        let Some(&(upper, lower)) = pairs.iter().min_by_key(|pair| before(pair)) else {
            continue;
        };
        let (face, way) = (surfaces[upper].face, looks(lower));
        let missing = |&(upper, lower): &(usize, usize)| {
            let [upper, lower] = [upper, lower].map(|k| &surfaces[k].polygon);
            let smaller = upper.diameter().min(lower.diameter());
            HAIR * diagonal.min(LARGER * smaller) + depth(upper, lower, way)
        };
        // Negative where it stands before it already, farther than a hair.
        let by = pairs.iter().map(missing).fold(f64::NEG_INFINITY, f64::max);
        let by = DAffine3::from_translation(by * way);
        for surface in surfaces.iter_mut().filter(|s| s.face == face) {
            surface.polygon = surface.polygon.moved(&by);
        }
    }
}

/// How deep some of `upper` lies below `lower`, seen against `way`; negative when it stands
/// before it. The corners of the smaller are asked: the plane of the larger is known better.
fn depth(upper: &Polygon, lower: &Polygon, way: DVec3) -> f64 {
    let plane = |p: &Polygon| -> Plane {
        if p.normal().dot(way) > 0.0 { p.plane() } else { p.plane().flipped() }
    };
    let deepest = |depths: &mut dyn Iterator<Item = f64>| {
        depths.fold(f64::NEG_INFINITY, f64::max)
    };
    match upper.diameter() <= lower.diameter() {
        true => {
            let lower = plane(lower);
            deepest(&mut upper.vertices().iter().map(|&v| -lower.height(v)))
        }
        false => {
            let upper = plane(upper);
            deepest(&mut lower.vertices().iter().map(|&v| upper.height(v)))
        }
    }
}
