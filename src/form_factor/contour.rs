//! Two polygons with nothing between them: the contour integral, to rounding.
//!
//! ```text
//! A_i F_ij = 1/(2π) ∮∮ ln r dx_i · dx_j          over both outlines (Stokes)
//! ```
//! For each pair of edges the inner integral has a closed form,
//!
//! ```text
//! ∫ ln√(u² + h²) du = u ln√(u² + h²) − u + h atan(u/h)
//! ```
//! with `u` counted along the edge from the foot of the point and `h` its distance from
//! the line. The outer integral is cut where the point passes the other edge; a part that
//! comes near it - touches it, even: a shared edge - is integrated with points that crowd
//! doubly exponentially at its ends, which the logarithm there does not disturb.
//!
//! Sources: Sparrow 1963 (contour form); Schröder & Hanrahan 1993 (that a closed form
//! exists); Takahasi & Mori 1974 (double exponential rule).

use super::quadrature::{MOST, gauss};
use glam::DVec3;
use std::f64::consts::{PI, TAU};
use std::sync::LazyLock;

/// `A_i F_ij` in scene units squared for two outlines, each wholly in front of the other.
///
/// # Accuracy
/// About 1e-13 times the product of the outlines' lengths: to rounding for pairs that are
/// near. It cancels for far and tiny pairs, which Lambert's formula serves better.
pub fn exchange_by_contour(i: &[DVec3], j: &[DVec3]) -> f64 {
    let edges = |v: &[DVec3]| -> Vec<(DVec3, DVec3)> {
        (0..v.len()).map(|k| (v[k], v[(k + 1) % v.len()])).collect()
    };
    let (of_i, of_j) = (edges(i), edges(j));
    // Any unit of length would do: ∮∮ dx·dx = 0. The pair's own keeps logarithms small.
    let unit = i[0].distance(j[0]).max(i[0].distance(i[1])).max(j[0].distance(j[1]));
    // ANCHOR: pairs_of_edges
    let mut sum = 0.0;
    for &e in &of_i {
        for &f in &of_j {
            sum += edge_pair(e, f, unit);
        }
    }
    (sum / TAU).max(0.0)
    // ANCHOR_END: pairs_of_edges
}

fn edge_pair((e0, e1): (DVec3, DVec3), (f0, f1): (DVec3, DVec3), unit: f64) -> f64 {
    let (length, along) = length_and_direction(e0, e1);
    let (other, towards) = length_and_direction(f0, f1);
    let cosine = along.dot(towards);
    if cosine.abs() < 1e-15 || length == 0.0 || other == 0.0 {
        return 0.0;
    }
    let inner = |s: f64| log_integral(e0 + s * along - f0, towards, other, unit);
    // The distance between the edges is least at one of these places.
    let mut cuts = [0.0, (f0 - e0).dot(along), (f1 - e0).dot(along), 0.0, length];
    let skew = 1.0 - cosine * cosine;
    if skew > 1e-12 {
        cuts[3] = (cosine * towards.dot(e0 - f0) - along.dot(e0 - f0)) / skew;
    }
    cuts.iter_mut().for_each(|s| *s = s.clamp(0.0, length));
    cuts.sort_by(f64::total_cmp);
    let gap = |s: f64| {
        let p = e0 + s * along - f0;
        (p - towards * p.dot(towards).clamp(0.0, other)).length()
    };
    let parts = cuts.windows(2).filter(|c| c[1] - c[0] > 1e-15 * length);
    cosine
        * parts.map(|c| part(c[0], c[1], gap(c[0]).min(gap(c[1])), &inner)).sum::<f64>()
}

fn length_and_direction(a: DVec3, b: DVec3) -> (f64, DVec3) {
    let length = a.distance(b);
    (length, (b - a) / length)
}

/// The closed form: `∫ ln(r/unit)` along an edge that starts at 0, seen from `p`.
fn log_integral(p: DVec3, towards: DVec3, length: f64, unit: f64) -> f64 {
    // ANCHOR: log_integral
    let foot = p.dot(towards);
    let h = p.cross(towards).length(); // √(p² − foot²) would lose half the digits
    let at = |u: f64| {
        let r = u.hypot(h);
        if r == 0.0 { 0.0 } else { u * (r / unit).ln() - u + h * u.atan2(h) }
    };
    at(length - foot) - at(-foot)
    // ANCHOR_END: log_integral
}

/// `∫ f` over `[a, b]`, where `f` is singular at distance `gap` from the nearer end.
fn part(a: f64, b: f64, gap: f64, f: &impl Fn(f64) -> f64) -> f64 {
    let length = b - a;
    if gap >= length {
        // ρ = 4.6 for a singularity as far off the end as the part is long: 4.6⁻²⁴ = 1e-16.
        return length
            * gauss(MOST).iter().map(|&(x, w)| w * f(a + length * x)).sum::<f64>();
    }
    let middle = 0.5 * (a + b);
    // A part of a few roundings has no middle.
    if gap > 0.1 * length && a < middle && middle < b {
        return part(a, middle, gap, f) + part(middle, b, gap, f);
    }
    let crowded =
        CROWDED.iter().map(|&(x, w)| w * (f(a + length * x) + f(b - length * x)));
    length * crowded.sum::<f64>()
}

/// The double exponential rule on `[0, ½]`; its mirror image serves `[½, 1]`.
static CROWDED: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| {
    const STEP: f64 = 1.0 / 16.0;
    let node = |k: i32| {
        let t = STEP * k as f64;
        // x = ½(1 − tanh(½π sinh t)), written so that small x keep their digits.
        let e = (-PI * t.sinh()).exp();
        let x = e / (1.0 + e);
        let weight = STEP * PI * t.cosh() * e / (1.0 + e).powi(2);
        (x, if k == 0 { 0.5 * weight } else { weight })
    };
    (0..=54).map(node).filter(|&(_, w)| w > 1e-18).collect()
});
