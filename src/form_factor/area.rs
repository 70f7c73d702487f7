//! Form factors by points on both areas, and what to do about their variance.
//!
//! ```text
//! A_i F_ij ≈ A_i A_j mean(V k)        k = cosθ_i cosθ_j / (π r²), points x on i and y on j
//! ```
//! Where the two share an edge `k` grows as `1/r²`: its mean is finite, its variance is not,
//! and no standard error can be trusted. The cure is a **control variate**. The exact
//! factor of the pair with nothing between is known, so only what is hidden is sampled:
//!
//! ```text
//! A_i F_ij = A_i F_ij(unhidden) − A_i A_j mean((1 − V) k)
//! ```
//! Between points near a shared edge nothing fits, so `(1 − V) k` stays bounded.
//!
//! **Use it when** one pair is due and blockers are many. **It fails when** blockers
//! reach into the shared edge itself, and, without the control, at every shared edge.
//!
//! Sources: Goral et al. 1984 (area integrals); Hammersley & Handscomb 1964 (controls).

use super::Accuracy;
use super::analytic::exchange;
use crate::geometry::{Polygon, Ray};
use crate::random::Stream;
use crate::visibility::Visibility;
use glam::DVec3;
use std::f64::consts::PI;

/// A mean and how far it may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaEstimate {
    /// `A_i F_ij`, scene units squared.
    pub exchange: f64,
    /// Its standard error, as if the points were independent; they fill their space more
    /// evenly, and the true error is smaller. Meaningless where the variance is infinite.
    pub standard_error: f64,
}

/// The plain estimate: the kernel where the two points see each other.
pub fn sampled(
    i: &Polygon,
    j: &Polygon,
    scene: &Visibility,
    n: usize,
    seed: u64,
) -> AreaEstimate {
    let (mean, error) = mean_of(i, j, n, seed, |x, y| {
        let kernel = kernel(i, x, j, y);
        if kernel > 0.0 && sees(scene, x, y) { kernel } else { 0.0 }
    });
    AreaEstimate { exchange: mean, standard_error: error }
}

// ANCHOR: controlled
/// The estimate with the exact, unhidden factor as control: samples what is hidden.
pub fn controlled(
    i: &Polygon,
    j: &Polygon,
    scene: &Visibility,
    n: usize,
    seed: u64,
) -> AreaEstimate {
    let (hidden, error) = mean_of(i, j, n, seed, |x, y| {
        let kernel = kernel(i, x, j, y);
        if kernel > 0.0 && !sees(scene, x, y) { kernel } else { 0.0 }
    });
    AreaEstimate {
        exchange: exchange(i, j, Accuracy::Best) - hidden,
        standard_error: error,
    }
}
// ANCHOR_END: controlled

/// The point-to-point kernel `cosθ cosθ'/(π r²)`, 1/scene units²; 0 behind either.
pub fn kernel(i: &Polygon, x: DVec3, j: &Polygon, y: DVec3) -> f64 {
    let r = y - x;
    let (cos_i, cos_j) = (i.normal().dot(r), -j.normal().dot(r));
    let r2 = r.length_squared();
    if cos_i > 0.0 && cos_j > 0.0 { cos_i * cos_j / (PI * r2 * r2) } else { 0.0 }
}

/// Does nothing stand between two points? What holds either end does not count.
fn sees(scene: &Visibility, x: DVec3, y: DVec3) -> bool {
    let distance = x.distance(y);
    let ray = Ray { origin: x, direction: (y - x) / distance };
    scene.closest(&ray, None).is_none_or(|hit| hit.distance >= distance * (1.0 - 1e-9))
}

/// `A_i A_j` times the mean of `f` over pairs of points, and its standard error.
fn mean_of(
    i: &Polygon,
    j: &Polygon,
    n: usize,
    seed: u64,
    f: impl Fn(DVec3, DVec3) -> f64,
) -> (f64, f64) {
    assert!(n > 1, "one point has no standard error");
    let (mut sum, mut squares) = (0.0, 0.0);
    for [a, b, c, d] in Stream::named(seed, &[]).points(n) {
        let value = f(i.point_at([a, b]), j.point_at([c, d]));
        (sum, squares) = (sum + value, squares + value * value);
    }
    let (n, areas) = (n as f64, i.area() * j.area());
    let mean = sum / n;
    let variance = (squares / n - mean * mean).max(0.0) * n / (n - 1.0);
    (areas * mean, areas * (variance / n).sqrt())
}
