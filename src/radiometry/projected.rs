//! Projected solid angles: how much light something sends to a surface.

use crate::geometry::{Plane, clip};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

// ANCHOR: projected_solid_angle
/// Projected solid angle of an outline from `p` with unit normal `n`, in sr, in `[0, π]`:
/// `∫ cosθ dω` over what lies above the horizon of `p`. Either side of the outline counts.
///
/// ```text
/// Ω⊥ = |½ Σₖ γₖ  n · (Rₖ₊₁ × Rₖ)/|Rₖ₊₁ × Rₖ||      Rₖ = vertexₖ − p
/// ```
/// with `γₖ` the angle between `Rₖ` and `Rₖ₊₁` (Lambert 1760; Baum et al. 1989).
///
/// # Accuracy
/// Exact but for rounding off the outline's edges. On an edge the direction of
/// `Rₖ₊₁ × Rₖ` is lost; that edge counts 0.
pub fn projected_solid_angle(p: DVec3, n: DVec3, outline: &[DVec3]) -> f64 {
    debug_assert!(n.is_normalized(), "n must have unit length: {n}");
    // ANCHOR: horizon
    let horizon = Plane::through(p, n);
    if outline.iter().all(|&v| horizon.height(v) >= 0.0) {
        lambert_sum(p, n, outline)
    } else {
        lambert_sum(p, n, &clip(outline, horizon))
    }
    // ANCHOR_END: horizon
}

fn lambert_sum(p: DVec3, n: DVec3, outline: &[DVec3]) -> f64 {
    let Some(&last) = outline.last() else { return 0.0 };
    // ANCHOR: lambert_sum
    let mut sum = 0.0;
    let mut a = last - p;
    for &vertex in outline {
        let b = vertex - p;
        let across = b.cross(a); // positive sums for fronts
        sum += angle_over_sine(across.length_squared(), a.dot(b)) * n.dot(across);
        a = b;
    }
    (0.5 * sum).abs()
    // ANCHOR_END: lambert_sum
}
// ANCHOR_END: projected_solid_angle

/// `γ/|a × b|`, from `|a × b|²` and `a · b`; 0 where `a` and `b` lie on one line.
///
/// By `atan2`, not `acos`, which at 1e-7 rad is off by 4e-4 (relative), at 1e-8 by all. An
/// edge that looks small, as most do, needs neither that nor a root:
///
/// ```text
/// γ/(|a||b| sin γ) = (atan t)/t / (a·b),     (atan t)/t = 1 − t²/3 + t⁴/5 − …,  t = tan γ
/// ```
/// For `t² < .04` twelve terms are exact to 2e-18.
fn angle_over_sine(sine_squared: f64, cosine: f64) -> f64 {
    if cosine > 0.0 && sine_squared < 0.04 * cosine * cosine {
        let t2 = sine_squared / (cosine * cosine);
        let term = |sum: f64, k: i32| 1.0 / (2 * k + 1) as f64 - t2 * sum;
        return (0..12).rev().fold(0.0, term) / cosine;
    }
    let sine = sine_squared.sqrt();
    if sine > 0.0 { sine.atan2(cosine) / sine } else { 0.0 }
}

// ANCHOR: projected_cap
/// Projected solid angle of a cap (a cone) of half-angle `beta` whose axis leans by `tilt`
/// from the normal; both in radians, `[0, π]`. In sr, in `[0, π]`: `∫ cosθ dω` over what
/// of the cap is above the horizon.
///
/// ```text
/// above the horizon    Ω⊥ = π sin²β cosθ                                     θ + β ≤ π/2
/// cut by the horizon   Ω⊥ = (φ − sinφ cosφ) + cos²θ sinφ cosφ + sin²β cosθ t
///     w = √(sin²β − cos²θ)     tan φ = w/cosβ     tan t = −w/(cosβ cosθ)
/// ```
/// `2φ` is the angle of the horizon that the cap covers, `2t` the part of the cap's rim
/// that is above the horizon. A cap wider than a hemisphere is the sky less its rest.
///
/// Found by Lambert's contour integral `½ ∮ n·(ω × dω)` along the rim and the horizon; in
/// this form its three terms are as small as the cap, and so is their rounding.
///
/// # Accuracy
/// Rounding; of a cap that is almost below the horizon, rounding of a whole one.
pub fn projected_solid_angle_of_cap(beta: f64, tilt: f64) -> f64 {
    debug_assert!((0.0..=PI).contains(&beta) && (0.0..=PI).contains(&tilt));
    if beta > FRAC_PI_2 {
        return PI - projected_solid_angle_of_cap(PI - beta, PI - tilt);
    }
    let ((sb, cb), ct) = (beta.sin_cos(), tilt.cos());
    if ct.abs() >= sb {
        // not cut: wholly above, or wholly below
        return if ct > 0.0 { PI * sb * sb * ct } else { 0.0 };
    }
    let w = ((sb - ct) * (sb + ct)).sqrt();
    let (phi, t) = (w.atan2(cb), w.atan2(-cb * ct));
    let (sin_phi, cos_phi) = phi.sin_cos();
    let cut = less_its_sine(2.0 * phi) / 2.0;
    (cut + ct * ct * sin_phi * cos_phi + sb * sb * ct * t).max(0.0)
}
// ANCHOR_END: projected_cap

/// `x − sin x`, which cancels for small `x ≥ 0`: there by its series.
fn less_its_sine(x: f64) -> f64 {
    if x > 0.5 {
        return x - x.sin();
    }
    // x³/6 (1 − x²/20 (1 − x²/42 (…))): six factors leave 1e-17 at ½
    let nested = [156.0, 110.0, 72.0, 42.0, 20.0].iter();
    x.powi(3) / 6.0 * nested.fold(1.0 - x * x / 210.0, |s, n| 1.0 - x * x / n * s)
}

/// `∫ cosᵏθ dω` over the hemisphere above a surface, in sr; `k ≥ 0`.
///
/// ```text
/// ∫ cosᵏθ dω = 2π/(k + 1)        k = 0: the hemisphere, 2π;  k = 1: the π of B = π L
/// ```
pub fn cosine_power_integral(k: f64) -> f64 {
    TAU / (k + 1.0)
}

/// Local direction (z is the normal) with density `cosθ/π`, from a point of the unit square.
///
/// The square is mapped to the disc without folding (Shirley & Chiu 1997), and the disc
/// raised to the hemisphere (Nusselt's analog, Malley's method).
pub fn cosine_direction(u: DVec2) -> DVec3 {
    // ANCHOR: cosine_direction
    let o = 2.0 * u - DVec2::ONE;
    let (radius, angle) = if o.x.abs() > o.y.abs() {
        (o.x, PI / 4.0 * (o.y / o.x))
    } else if o.y != 0.0 {
        (o.y, PI / 2.0 - PI / 4.0 * (o.x / o.y))
    } else {
        return DVec3::Z;
    };
    let (sine, cosine) = angle.sin_cos();
    let (x, y) = (radius * cosine, radius * sine);
    DVec3::new(x, y, (1.0 - radius * radius).max(0.0).sqrt())
    // ANCHOR_END: cosine_direction
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{dvec2, dvec3};

    #[test]
    fn the_whole_hemisphere_projects_to_pi() {
        let far = 1e9;
        let v = [(-far, -far), (far, -far), (far, far), (-far, far)];
        let sky = v.map(|(x, y)| dvec3(x, y, 1.0));
        let got = projected_solid_angle(DVec3::ZERO, DVec3::Z, &sky);
        assert!((got - PI).abs() < 1e-8, "{got}");
    }

    #[test]
    fn cosine_directions_are_units_above_the_horizon() {
        for k in 0..100 {
            let u = dvec2(k as f64 / 100.0, (k * 37 % 100) as f64 / 100.0);
            let w = cosine_direction(u);
            assert!(w.z >= 0.0 && (w.length() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn the_series_meets_the_difference() {
        for k in 1..=50 {
            let x = f64::from(k) / 100.0;
            // rounding of the difference itself, and no more
            let error = (less_its_sine(x) - (x - x.sin())).abs();
            assert!(error < 1.2e-16, "{x}: {error:e}");
        }
        let (x, exact) = (0.5, 0.020_574_461_395_796_997);
        assert!((less_its_sine(x) / exact - 1.0).abs() < 1e-15);
    }

    /// A cap as a polygon of many corners, in one piece, whatever of it is below.
    fn polygon_cap(beta: f64, tilt: f64, corners: u32) -> f64 {
        let axis = dvec3(tilt.sin(), 0.0, tilt.cos());
        let (x, y) = axis.any_orthonormal_pair();
        // Between the inscribed and the circumscribed polygon, with the cap's own area
        let step = TAU / f64::from(corners);
        let rim = beta.tan() * (step / step.sin()).sqrt();
        let corner = |k: u32| {
            let (s, c) = (step * f64::from(k)).sin_cos();
            axis + rim * (c * x + s * y)
        };
        let outline: Vec<DVec3> = (0..corners).map(corner).collect();
        projected_solid_angle(DVec3::ZERO, DVec3::Z, &outline)
    }

    #[test]
    fn a_cap_is_the_limit_of_polygons() {
        for beta in [0.001, 0.1, 0.7, 1.4] {
            for tilt in [0.0, 0.3, 1.0, 1.5, 1.5705, 1.5711, 1.6, 2.0, 3.0] {
                let got = projected_solid_angle_of_cap(beta, tilt);
                let near = polygon_cap(beta, tilt, 4000);
                let error = (got - near).abs() / beta.sin().powi(2);
                assert!(error < 2e-5, "{beta} {tilt}: {got} {near}");
            }
        }
    }

    #[test]
    fn a_cap_and_the_rest_of_the_sky_make_the_sky() {
        for beta in [0.1, 1.0, 1.57, 1.6, 2.5, PI] {
            for tilt in [0.0, 1.0, FRAC_PI_2, 2.0, PI] {
                let rest = projected_solid_angle_of_cap(PI - beta, PI - tilt);
                let got = projected_solid_angle_of_cap(beta, tilt);
                assert!((got + rest - PI).abs() < 1e-14, "{beta} {tilt}");
            }
        }
        assert_eq!(projected_solid_angle_of_cap(PI, 0.4), PI);
    }

    /// Half sunk, the cap's closed form is `β − sinβ cosβ ≈ ⅔ β³`: no digit is lost.
    #[test]
    fn a_tiny_cap_on_the_horizon_keeps_its_digits() {
        for beta in [1e-6, 1e-4, 1e-2] {
            let got = projected_solid_angle_of_cap(beta, FRAC_PI_2);
            // ⅔β³ (1 − β²/5 + 2β⁴/105 …); the tilt itself is known to 6e-17
            let b2 = beta * beta;
            let exact =
                beta.powi(3) * (2.0 / 3.0) * (1.0 - b2 / 5.0 * (1.0 - b2 * 2.0 / 21.0));
            let error = (got / exact - 1.0).abs();
            assert!(error < 1e-14 + 2e-16 / beta, "{beta}: {error:e}");
        }
    }
}
