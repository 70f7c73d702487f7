//! The exchange past blockers, by points: more of them where they disagree.

use super::analytic::exchange_of_facing;
use super::quadrature::over;
use crate::geometry::Polygon;
use crate::occlusion::{Blocker, Blockers, lambert_visible};

/// A part of one polygon that looks at another.
pub(super) struct Part<'p> {
    pub from: &'p Polygon,
    pub to: &'p Polygon,
    /// What a few points have found, if they have been asked.
    pub estimate: Option<f64>,
    /// The absolute error that is allowed, scene units squared.
    pub allowed: f64,
    /// So many times it may be divided.
    pub depth: u32,
}

/// `∫ F(x → to) dA` over a part, past those of `all` blockers that may be `between`; what
/// none of them hides to an absolute error of `open`. Also how far the rules disagree.
pub(super) fn past_blockers(
    all: &Blockers,
    part: &Part,
    between: &[&Blocker],
    open: f64,
) -> (f64, f64) {
    let &Part { from, to, estimate, allowed, depth } = part;
    let blockers = all.narrowed(between, from, to);
    if blockers.is_empty() {
        let found = exchange_of_facing(from, to, open);
        return (found, open * from.area().min(to.area()));
    }
    if blockers.iter().any(|blocker| blocker.hides_all(from, to)) {
        return (0.0, 0.0);
    }
    let by_points = |part: &Polygon, n: usize| {
        over(part, n, |x| lambert_visible(x, part.normal(), to, &blockers))
    };
    let coarse = estimate.unwrap_or_else(|| by_points(from, 2));
    let parts: Vec<Polygon> = from.halves().flat_map(|half| half.halves()).collect();
    let fine: Vec<f64> = parts.iter().map(|part| by_points(part, 2)).collect();
    let sum = fine.iter().sum::<f64>();
    let change = (coarse - sum).abs();
    if depth == 0 || change <= allowed {
        // Two rules may agree by chance, where both miss a shadow: ask a third. All may
        // miss a slit of light: where none sees any, ask the corners.
        let third = match sum {
            0.0 => from.area() * seen_by_corners(from, to, &blockers),
            _ => parts.iter().map(|part| by_points(part, 3)).sum(),
        };
        let apart = (third - sum).abs();
        if depth == 0 || apart <= allowed {
            return (if sum == 0.0 { sum } else { third }, apart.max(change));
        }
    }
    let found = parts.iter().zip(&fine).map(|(part, &found)| {
        let (estimate, allowed) = (Some(found), 0.5 * allowed);
        let part = Part { from: part, to, estimate, allowed, depth: depth - 1 };
        past_blockers(all, &part, &blockers, open)
    });
    found.fold((0.0, 0.0), |(sum, off), (part, apart)| (sum + part, off + apart))
}

/// The most that a corner of one polygon, moved in a hair, sees of the other.
fn seen_by_corners(from: &Polygon, to: &Polygon, blockers: &[&Blocker]) -> f64 {
    let middle = from.centroid();
    let corners = from.vertices().iter().map(|v| v.lerp(middle, 1e-3));
    let seen =
        corners.map(|corner| lambert_visible(corner, from.normal(), to, blockers));
    seen.fold(0.0, f64::max)
}
