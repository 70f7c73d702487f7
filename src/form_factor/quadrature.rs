//! Gauss–Legendre points on segments and on polygons.
//!
//! ```text
//! ∫₋₁¹ f ≈ Σ wₖ f(xₖ)      exact for polynomials up to degree 2n−1
//! ```
//! For `f` analytic but for a singularity at distance `d` from an interval of length `s`
//! the error falls as `ρ^(−2n)` with `ρ = y + √(y² + 1)`, `y = 2d/s`: [`points_for`] turns
//! this into the number of points that an accuracy needs (Trefethen 2013, ch. 19).

use crate::geometry::Polygon;
use glam::DVec3;
use std::sync::LazyLock;

/// The largest number of points that [`gauss`] has.
pub(super) const MOST: usize = 12;

/// `(x, w)` of the `n`-point rule on `[0, 1]`; `n` in `1..=MOST`.
pub(super) fn gauss(n: usize) -> &'static [(f64, f64)] {
    static RULES: LazyLock<Vec<Vec<(f64, f64)>>> =
        LazyLock::new(|| (1..=MOST).map(rule).collect());
    &RULES[n - 1]
}

/// The zeros of the Legendre polynomial by Newton's method, and their weights.
fn rule(n: usize) -> Vec<(f64, f64)> {
    let point = |k: usize| {
        let mut x = (std::f64::consts::PI * (k as f64 + 0.75) / (n as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..100 {
            let (mut p, mut before) = (1.0, 0.0);
            for m in 0..n {
                let m = m as f64;
                (p, before) = (((2.0 * m + 1.0) * x * p - m * before) / (m + 1.0), p);
            }
            slope = n as f64 * (x * p - before) / (x * x - 1.0);
            let step = p / slope;
            x -= step;
            if step.abs() < 1e-16 {
                break;
            }
        }
        (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(point).collect()
}

/// How many points per direction give the accuracy `relative` (to the integrand's largest
/// value) on a domain of diameter `size` when the integrand is singular at `distance`; `None`: too many.
pub(super) fn points_for(relative: f64, size: f64, distance: f64) -> Option<usize> {
    if distance <= 0.0 {
        return None;
    }
    let y = 2.0 * distance / size;
    let rate = y.asinh(); // ln(y + √(y² + 1))
    // At most 64/15 ρ^(−2n) of the largest value (Trefethen); the rest is for two directions.
    let n = ((5.0 / relative).ln() / (2.0 * rate)).ceil().max(1.0);
    (n <= MOST as f64).then_some(n as usize)
}

/// `∫ f dA` over a convex polygon by `n × n` points for each quadrilateral of a fan.
pub(super) fn over(
    polygon: &Polygon,
    n: usize,
    mut f: impl FnMut(DVec3) -> f64,
) -> f64 {
    let mut sum = 0.0;
    points(polygon, n, |x, area| sum += area * f(x));
    sum
}

/// The points of [`over`], each with the area that it stands for.
pub(crate) fn points(polygon: &Polygon, n: usize, mut at: impl FnMut(DVec3, f64)) {
    let v = polygon.vertices();
    let normal = polygon.normal();
    let mut first = 1;
    while first < v.len() - 1 {
        // A quadrilateral, or a triangle as one whose last two corners coincide.
        let (a, b, c) = (v[0], v[first], v[first + 1]);
        let d = v.get(first + 2).copied().unwrap_or(c);
        for &(s, ws) in gauss(n) {
            for &(t, wt) in gauss(n) {
                let (low, high) = (a.lerp(b, s), d.lerp(c, s));
                let along = (b - a).lerp(c - d, t);
                let area = along.cross(high - low).dot(normal);
                if area > 0.0 {
                    at(low.lerp(high, t), ws * wt * area);
                }
            }
        }
        first += 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    #[test]
    fn the_rule_of_n_points_is_exact_to_degree_2n_minus_1() {
        for n in 1..=MOST {
            for degree in 0..2 * n as i32 {
                let sum: f64 = gauss(n).iter().map(|(x, w)| w * x.powi(degree)).sum();
                assert!(
                    (sum * (degree + 1) as f64 - 1.0).abs() < 1e-13,
                    "{n} {degree}"
                );
            }
        }
    }

    #[test]
    fn areas_and_moments_of_outlines_are_exact() {
        let outline = [(0.0, 0.0), (2.0, 0.0), (3.0, 1.0), (1.5, 2.0), (0.0, 1.5)];
        for corners in 3..=5 {
            let v = outline[..corners].iter().map(|&(x, y)| dvec3(x, y, 1.0)).collect();
            let polygon = Polygon::new(v).unwrap();
            let area = over(&polygon, 3, |_| 1.0);
            assert!((area - polygon.area()).abs() < 1e-14);
            let moment = over(&polygon, 3, |p| p.x);
            assert!((moment - polygon.centroid().x * area).abs() < 1e-13);
        }
    }
}
