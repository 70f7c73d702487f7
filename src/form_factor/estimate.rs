//! An estimate of what one polygon sees of another: the mean factor, its slope, and how
//! far it is from being linear.
//!
//! ```text
//! F(x → to) ≈ mean + slope · (x − centroid)          for x on from
//! bend² = 1/A ∫ (F(x → to) − mean − slope · (x − centroid))² dA
//! ```
//! Lambert's formula at nine points x (Gauss's three by three), past all that stands
//! between. Where nothing does, the mean is exact whatever the factor does between points.

use super::analytic::exchange;
use super::quadrature::points;
use crate::geometry::Polygon;
use crate::occlusion::{Blockers, lambert_visible};
use glam::{DMat2, DVec2, DVec3};
use smallvec::SmallVec;

/// The factor from the points of one polygon to another.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FactorEstimate {
    /// The form factor, in `[0, 1]`.
    pub mean: f64,
    /// How fast the factor grows, in 1/scene units; along the polygon, and never so steep
    /// that the factor would be negative at a corner.
    pub slope: DVec3,
    /// How far the factor is from mean and slope, in root mean square, `≥ 0`.
    pub bend: f64,
    /// How far the factor is from the mean alone, in root mean square, `≥ 0`.
    pub spread: f64,
    /// What may stand between?
    pub sight: Obstruction,
}

/// How two polygons see each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Obstruction {
    /// Nothing can stand between them.
    Free,
    /// Something may.
    Partial,
    /// One thing hides all of the one from all of the other, or they do not face each
    /// other.
    #[default]
    Hidden,
}

/// Where points agree that nothing is hidden, or all, though something reaches into the
/// shaft, this share of the open factor is bent: a shadow may lie between the points.
const UNSEEN: f64 = 0.2;

/// Unhidden factors are this exact.
const EXACT: f64 = 1e-6;

/// One point: where, its share of the area, the factor there.
type Sample = (DVec3, f64, f64);

/// Estimates the factor from a polygon to the front of another. `sight` is what is known beforehand:
/// pieces of two polygons that see each other freely do so too.
pub fn estimate(
    from: &Polygon,
    to: &Polygon,
    scene: &Blockers,
    sight: Obstruction,
) -> FactorEstimate {
    if sight == Obstruction::Hidden || !face(from, to) {
        return FactorEstimate::default();
    }
    // ANCHOR: obstruction
    let between = match sight {
        Obstruction::Free => Vec::new(),
        _ => scene.between(from, to),
    };
    if between.iter().any(|blocker| blocker.hides_all(from, to)) {
        return FactorEstimate::default();
    }
    // ANCHOR_END: obstruction
    let (normal, area) = (from.normal(), from.area());
    let mut samples: SmallVec<[Sample; 9]> = SmallVec::new();
    let (mut open, mut all, mut none) = (0.0, true, true);
    points(from, 3, |x, part| {
        let factor = lambert_visible(x, normal, to, &between);
        if !between.is_empty() {
            let unhidden = lambert_visible(x, normal, to, &[]);
            open += part / area * unhidden;
            all &= factor > (1.0 - 1e-9) * unhidden;
            none &= factor <= 1e-9 * unhidden;
        }
        samples.push((x, part / area, factor));
    });
    if between.is_empty() {
        let mean = exchange(from, to, EXACT) / area;
        fit(from, &samples, Some(mean), 0.0, Obstruction::Free)
    } else {
        let unseen = if all || none { UNSEEN * open } else { 0.0 };
        fit(from, &samples, None, unseen, Obstruction::Partial)
    }
}

/// The plane nearest to the samples, in the sense of least squares.
fn fit(
    from: &Polygon,
    samples: &[Sample],
    exact: Option<f64>,
    unseen: f64,
    sight: Obstruction,
) -> FactorEstimate {
    let sum = |f: &dyn Fn(&Sample) -> f64| samples.iter().map(f).sum::<f64>();
    let by_points = sum(&|(_, w, f)| w * f);
    let centre: DVec3 = samples.iter().map(|(x, w, _)| *w * *x).sum();
    let (u, v) = from.normal().any_orthonormal_pair();
    let flat = |x: DVec3| DVec2::new(u.dot(x - centre), v.dot(x - centre));
    let (mut moments, mut rise) = (DMat2::ZERO, DVec2::ZERO);
    for &(x, w, f) in samples {
        let d = flat(x);
        moments += w * DMat2::from_cols(d.x * d, d.y * d);
        rise += w * (f - by_points) * d;
    }
    let slope = match moments.determinant() {
        det if det > 0.0 => moments.inverse() * rise,
        _ => DVec2::ZERO,
    };
    let slope = slope.x * u + slope.y * v;
    let mean = exact.unwrap_or(by_points);
    // Nowhere less than nothing.
    let fall = |x: &DVec3| -slope.dot(*x - centre);
    let steepest = from.vertices().iter().map(fall).fold(0.0, f64::max);
    let slope = if steepest > mean { slope * (mean / steepest) } else { slope };
    let off = |of: &dyn Fn(DVec3) -> f64| {
        sum(&|&(x, w, f)| w * (f - of(x)) * (f - of(x))).sqrt()
    };
    let missed = (mean - by_points).abs().max(unseen);
    let bend = off(&|x| by_points + slope.dot(x - centre)).max(missed);
    FactorEstimate { mean, slope, bend, spread: off(&|_| by_points).max(missed), sight }
}

/// Does each have a corner in front of the other?
fn face(i: &Polygon, j: &Polygon) -> bool {
    let above = |p: &Polygon, q: &Polygon| {
        let plane = p.plane();
        q.vertices().iter().any(|&v| plane.height(v) > 0.0)
    };
    above(i, j) && above(j, i)
}
