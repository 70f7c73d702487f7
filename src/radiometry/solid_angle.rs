//! Solid angles: how large something looks, as an area on the unit sphere.

use crate::geometry::Polygon;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

// ANCHOR: solid_angle_triangle
/// Signed solid angle of the triangle `a b c` from the origin, in sr, in `(-2π, 2π)`.
///
/// Positive when `a b c` run counter-clockwise as seen from the origin.
///
/// ```text
/// tan(Ω/2) = −a·((b−a)×(c−a)) / (abc + (a·b)c + (b·c)a + (c·a)b)
/// ```
/// (Van Oosterom & Strackee 1983). By `atan2`, so that it holds from 1e-8 sr to 2π; from
/// edges, not corners, so that a small triangle keeps its digits.
///
/// # Accuracy
/// Rounding, 1e-16, times how much farther away or wider than near the triangle is: twelve
/// digits from 1e-8 sr to within 1e-3 sr of 2π. A triangle in a plane with the origin
/// counts 0, or ±2π when the origin lies inside it.
pub fn solid_angle_triangle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    // ANCHOR: triangle
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let above = a.dot((b - a).cross(c - a));
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    -2.0 * above.atan2(below)
    // ANCHOR_END: triangle
}
// ANCHOR_END: solid_angle_triangle

/// Solid angle of `polygon` from `p`, in sr, in `[0, 2π]`; either side of it counts.
///
/// The sum over a fan of triangles, each by [`solid_angle_triangle`].
///
/// # Accuracy
/// As [`solid_angle_triangle`]. On the polygon itself the answer may be anything from 0
/// to 2π, the value of either side.
pub fn solid_angle(p: DVec3, polygon: &Polygon) -> f64 {
    of_outline(p, polygon.vertices())
}

// ANCHOR: of_outline
fn of_outline(p: DVec3, v: &[DVec3]) -> f64 {
    let fan = |k: usize| solid_angle_triangle(v[0] - p, v[k] - p, v[k + 1] - p);
    (1..v.len() - 1).map(fan).sum::<f64>().abs()
}
// ANCHOR_END: of_outline

/// Solid angle of a rectangle `a` × `b` at `distance`, seen from above one of its
/// corners; lengths in one unit, in sr, in `[0, π/2]`.
///
/// ```text
/// tan Ω = a b / (d √(a² + b² + d²))
/// ```
/// Four of them, with signs, make any rectangle seen from anywhere, if none is small.
///
/// # Accuracy
/// Rounding, at all sizes. At distance 0 it fills a quarter of the half-space: π/2.
pub fn solid_angle_of_corner(a: f64, b: f64, distance: f64) -> f64 {
    (a * b).atan2(distance * a.hypot(b).hypot(distance))
}

/// Solid angle of a rectangle `a` × `b` at `distance`, seen from above its middle;
/// lengths in one unit, in sr, in `[0, 2π]`.
///
/// ```text
/// Ω = 4 atan(a b / (2d √(a² + b² + 4d²)))        ≈ a b/d² far away
/// ```
///
/// # Accuracy
/// Rounding, at all sizes.
pub fn solid_angle_of_rectangle(a: f64, b: f64, distance: f64) -> f64 {
    4.0 * solid_angle_of_corner(0.5 * a, 0.5 * b, distance)
}

// ANCHOR: solid_angle_of_box
/// Solid angle of the axis-parallel box from `low` to `high` as seen from `p`, in sr, in
/// `[0, 4π]`.
///
/// From outside, the sum over the one, two or three faces that show their outside. From
/// inside 4π, from a face 2π, from an edge π, from a corner π/2.
///
/// # Accuracy
/// As [`solid_angle_triangle`]: rounding from 1e-8 sr on.
pub fn solid_angle_of_box(p: DVec3, low: DVec3, high: DVec3) -> f64 {
    debug_assert!(low.cmple(high).all(), "low {low} must not exceed high {high}");
    if p.cmpge(low).all() && p.cmple(high).all() {
        let touched = (p.cmpeq(low) | p.cmpeq(high)).bitmask().count_ones();
        return 4.0 * PI / f64::from(1 << touched);
    }
    let mut sum = 0.0;
    for axis in 0..3 {
        let at = if p[axis] < low[axis] {
            low[axis]
        } else if p[axis] > high[axis] {
            high[axis]
        } else {
            continue; // neither of the two faces shows its outside
        };
        sum += of_outline(p, &face(low, high, axis, at));
    }
    sum
}
// ANCHOR_END: solid_angle_of_box

/// The face of a box across `axis`, moved to `at`.
fn face(low: DVec3, high: DVec3, axis: usize, at: f64) -> [DVec3; 4] {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    [(low, low), (high, low), (high, high), (low, high)].map(|(a, b)| {
        let mut corner = DVec3::splat(at);
        (corner[u], corner[v]) = (a[u], b[v]);
        corner
    })
}

/// Solid angle of a cap (a cone) of half-angle `beta`, in radians, `[0, π]`; in sr.
///
/// ```text
/// Ω = 2π (1 − cos β) = 4π sin²(β/2)
/// ```
/// The second form, which does not cancel for small caps.
pub fn solid_angle_of_cap(beta: f64) -> f64 {
    2.0 * TAU * (beta / 2.0).sin().powi(2)
}

/// Solid angle of a sphere of this `radius` whose centre is `distance` away, in one unit
/// of length; in sr, in `[0, 4π]`.
///
/// ```text
/// Ω = 2π (1 − cos β) = 2π s²/(1 + √(1 − s²))        s = sin β = radius/distance
/// ```
/// The second form, which does not cancel for far spheres. On the sphere 2π, inside 4π.
pub fn solid_angle_of_sphere(radius: f64, distance: f64) -> f64 {
    // ANCHOR: sphere
    if distance < radius {
        return 2.0 * TAU;
    }
    let sine = radius / distance;
    TAU * sine * sine / (1.0 + ((1.0 - sine) * (1.0 + sine)).sqrt())
    // ANCHOR_END: sphere
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    #[test]
    fn an_octant_is_an_eighth_of_the_sphere() {
        let octant = solid_angle_triangle(DVec3::X, DVec3::Y, DVec3::Z);
        assert!((octant.abs() - PI / 2.0).abs() < 1e-15);
    }

    /// 1e-8 sr by atan2 has twelve digits left of a square one away, by acos none.
    #[test]
    fn a_tiny_square_keeps_its_digits() {
        let s = 1e-4;
        let square =
            [dvec3(0., 0., 1.), dvec3(s, 0., 1.), dvec3(s, s, 1.), dvec3(0., s, 1.)];
        let exact = solid_angle_of_corner(s, s, 1.0);
        let got = solid_angle(DVec3::ZERO, &Polygon::new(square.to_vec()).unwrap());
        assert!((got / exact - 1.0).abs() < 1e-12, "{got} {exact}");
    }

    #[test]
    fn a_box_around_the_eye_is_all_there_is() {
        let (low, high) = (DVec3::ZERO, dvec3(1.0, 2.0, 3.0));
        for (p, part) in [
            (dvec3(0.3, 0.3, 0.3), 1.0),
            (dvec3(0.0, 0.3, 0.3), 2.0),
            (dvec3(0.0, 2.0, 0.3), 4.0),
            (dvec3(1.0, 2.0, 3.0), 8.0),
        ] {
            assert_eq!(solid_angle_of_box(p, low, high), 4.0 * PI / part, "{p}");
        }
    }

    /// The faces of a box cover the sphere once: what is not seen through its outside is
    /// seen through the inside of the others.
    #[test]
    fn a_box_shows_as_much_outside_as_inside() {
        let (low, high) = (DVec3::ZERO, dvec3(1.0, 2.0, 3.0));
        for p in [dvec3(-1., 1., 1.), dvec3(2., -3., 1.), dvec3(4., 5., 6.)] {
            let sides = (0..3).flat_map(|k| [(k, low[k]), (k, high[k])]);
            let all: f64 =
                sides.map(|(k, at)| of_outline(p, &face(low, high, k, at))).sum();
            let got = solid_angle_of_box(p, low, high);
            assert!((all - 2.0 * got).abs() < 1e-15, "{p}: {all} {got}");
        }
    }

    #[test]
    fn a_sphere_is_the_cap_it_fills() {
        for k in 1..=90 {
            let beta = f64::from(k).to_radians();
            let got = solid_angle_of_sphere(beta.sin(), 1.0);
            let error = (got - solid_angle_of_cap(beta)).abs();
            // At 90° the sine says little about the angle: √ε.
            assert!(error < if k > 85 { 1e-7 } else { 1e-14 }, "{k}: {error}");
        }
        assert_eq!(solid_angle_of_sphere(1.0, 0.5), 4.0 * PI);
        let far = solid_angle_of_sphere(1e-8, 1.0);
        assert!((far / (PI * 1e-16) - 1.0).abs() < 1e-15);
    }
}
