//! Bounds of a partly hidden factor: what is certainly seen, what may be.
//!
//! ```text
//! Σ F over pairs of pieces with nothing between  ≤  F  ≤  the same over pairs not hidden
//! ```
//! Both polygons are halved in turn. A pair of pieces with nothing in its shaft counts
//! exactly, for both bounds; one that a blocker hides wholly for neither; the rest, in the
//! end, for the upper bound only. No point is sampled, so nothing can be missed.

use super::Accuracy;
use super::analytic::{Analytic, exchange};
use crate::geometry::Polygon;
use crate::mesh::ElementId;
use crate::occlusion::{Blocker, Blockers};

impl Analytic {
    /// Two numbers, in scene units squared, between which `A_i F_ij` lies for certain (but
    /// for rounding, 1e-12 of the smaller area). `halvings` is how often the pair is halved
    /// at the most: each may double the work, and narrows the gap by a few per cent at first, by a sixth in the end.
    pub fn bounds(&self, i: ElementId, j: ElementId, halvings: u32) -> (f64, f64) {
        let (a, b) = (self.polygon(i), self.polygon(j));
        let (Some(a), Some(b)) = (a.clipped(b.plane()), b.clipped(a.plane())) else {
            return (0.0, 0.0);
        };
        let blockers = self.blockers();
        between(&a, &b, blockers, &blockers.between(&a, &b), halvings)
    }
}

// ANCHOR: bounds
fn between(
    a: &Polygon,
    b: &Polygon,
    scene: &Blockers,
    blockers: &[&Blocker],
    halvings: u32,
) -> (f64, f64) {
    let blockers = scene.narrowed(blockers, a, b);
    if blockers.iter().any(|blocker| blocker.hides_all(a, b)) {
        return (0.0, 0.0);
    }
    if blockers.is_empty() || halvings == 0 {
        let all = exchange(a, b, Accuracy::Best);
        return (if blockers.is_empty() { all } else { 0.0 }, all);
    }
    let (cut, other) = if a.diameter() > b.diameter() { (a, b) } else { (b, a) };
    cut.halves().fold((0.0, 0.0), |(low, high), half| {
        let (l, h) = between(&half, other, scene, &blockers, halvings - 1);
        (low + l, high + h)
    })
}
// ANCHOR_END: bounds
