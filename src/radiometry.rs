//! Solid angle, and the quantities of light that are measured with it.
//!
//! ```text
//! Ω = ∫ dω   solid angle, sr, 0 … 4π        Ω⊥ = ∫ cosθ dω   projected, sr, 0 … π
//! Φ flux, W      H = dΦ/dA irradiance, W/m²     B = dΦ/dA radiosity (exitance), W/m²
//! L = d²Φ/(dA cosθ dω) radiance, W/(m² sr)      B = π L for a diffuse surface
//! ```
//!
//! | function                 | use it when                           | it fails when       |
//! |--------------------------|---------------------------------------|---------------------|
//! | [`solid_angle`]          | how large does a polygon look?        | `p` lies on it      |
//! | [`projected_solid_angle`]| how much light does it send to `p`?   | `p` lies on an edge |
//! | [`cosine_direction`]     | rays are to carry equal light each    | never               |
//!
//! **Not here:** visibility; the form factor is [`crate::form_factor`]'s.
//! Chapter *Light and solid angle* (L02, L03). Sources: Lambert 1760; Nusselt 1928;
//! Van Oosterom & Strackee 1983; Baum, Rushmeier & Winget 1989.

use crate::geometry::{Plane, Polygon, Rgb, clip};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// Radiance of a diffuse surface, W/(m² sr), from its radiosity, W/m²: `L = B/π`.
pub fn radiance_from_radiosity(radiosity: Rgb) -> Rgb {
    radiosity / PI
}

/// Radiosity of a diffuse surface, W/m², from its radiance, W/(m² sr): `B = π L`.
pub fn radiosity_from_radiance(radiance: Rgb) -> Rgb {
    radiance * PI
}

/// Signed solid angle of the triangle `a b c` from the origin, in sr, in `(-2π, 2π)`.
///
/// Positive when `a b c` run counter-clockwise as seen from the origin.
///
/// ```text
/// tan(Ω/2) = a·(b×c) / (abc + (a·b)c + (b·c)a + (c·a)b)
/// ```
/// (Van Oosterom & Strackee 1983). By `atan2`, so that it holds from 1e-8 sr to 2π.
///
/// # Accuracy
/// Rounding, times the condition of the triple product. A triangle in a plane with the
/// origin counts 0, or ±2π when the origin lies inside it.
pub fn solid_angle_triangle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let above = a.dot(b.cross(c));
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    -2.0 * above.atan2(below)
}

/// Solid angle of `polygon` from `p`, in sr, in `[0, 2π]`; either side of it counts.
///
/// The sum over a fan of triangles, each by [`solid_angle_triangle`].
pub fn solid_angle(p: DVec3, polygon: &Polygon) -> f64 {
    let v = polygon.vertices();
    let fan = |k: usize| solid_angle_triangle(v[0] - p, v[k] - p, v[k + 1] - p);
    (1..v.len() - 1).map(fan).sum::<f64>().abs()
}

// ANCHOR: projected_solid_angle
/// Projected solid angle of an outline from `p` with unit normal `n`, in sr, in `[0, π]`:
/// `∫ cosθ dω` over what lies above the horizon of `p`. Either side of the outline counts.
///
/// ```text
/// Ω⊥ = ½ Σₖ γₖ  n · (Rₖ × Rₖ₊₁)/|Rₖ × Rₖ₊₁|        Rₖ = vertexₖ − p
/// ```
/// with `γₖ` the angle between `Rₖ` and `Rₖ₊₁` (Lambert 1760; Baum et al. 1989).
///
/// # Accuracy
/// Exact but for rounding off the outline's edges. On an edge the direction of
/// `Rₖ × Rₖ₊₁` is lost; that edge counts 0.
pub fn projected_solid_angle(p: DVec3, n: DVec3, outline: &[DVec3]) -> f64 {
    debug_assert!(n.is_normalized(), "n must have unit length: {n}");
    let horizon = Plane::through(p, n);
    if outline.iter().all(|&v| horizon.height(v) >= 0.0) {
        lambert_sum(p, n, outline)
    } else {
        lambert_sum(p, n, &clip(outline, horizon))
    }
}

fn lambert_sum(p: DVec3, n: DVec3, outline: &[DVec3]) -> f64 {
    let Some(&last) = outline.last() else { return 0.0 };
    let mut sum = 0.0;
    let mut a = last - p;
    for &vertex in outline {
        let b = vertex - p;
        let across = a.cross(b);
        let sine = across.length();
        // atan2, not acos: at 1e-7 rad acos is off by 4e-4 (relative), at 1e-8 by all.
        if sine > 0.0 {
            sum += sine.atan2(a.dot(b)) / sine * n.dot(across);
        }
        a = b;
    }
    (0.5 * sum).abs()
}
// ANCHOR_END: projected_solid_angle

/// Local direction (z is the normal) with density `cosθ/π`, from a point of the unit square.
///
/// The square is mapped to the disc without folding (Shirley & Chiu 1997), and the disc
/// raised to the hemisphere (Nusselt's analog, Malley's method).
pub fn cosine_direction(u: DVec2) -> DVec3 {
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
}

/// The solid angle of a cap of half-angle `beta` (radians, `[0, π]`), in sr.
///
/// ```text
/// Ω = 2π (1 − cos β) = 4π sin²(β/2)
/// ```
/// The second form, which does not cancel for small caps.
pub fn solid_angle_of_cap(beta: f64) -> f64 {
    2.0 * TAU * (beta / 2.0).sin().powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{dvec2, dvec3};

    #[test]
    fn an_octant_is_an_eighth_of_the_sphere() {
        let octant = solid_angle_triangle(DVec3::X, DVec3::Y, DVec3::Z);
        assert!((octant.abs() - PI / 2.0).abs() < 1e-15);
    }

    /// The side that the source looks at must not matter for a tiny source either:
    /// 1e-8 sr by atan2 has 15 digits, by acos none.
    #[test]
    fn a_tiny_square_keeps_its_digits() {
        let s = 1e-4;
        let square =
            [dvec3(0., 0., 1.), dvec3(s, 0., 1.), dvec3(s, s, 1.), dvec3(0., s, 1.)];
        // Closed form for a corner square: asin(ab/√((1+a²)(1+b²))), via atan2.
        let exact = (s * s).atan2((1.0 + 2.0 * s * s).sqrt());
        let got = solid_angle(DVec3::ZERO, &Polygon::new(square.to_vec()).unwrap());
        assert!((got / exact - 1.0).abs() < 1e-12, "{got} {exact}");
    }

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
}
