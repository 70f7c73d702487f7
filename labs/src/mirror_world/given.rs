//! What the student is given: clipping, Lambert's formula, and who stands in whose way.

use radiosity::geometry;
use radiosity::prelude::{DVec3, Plane};
use radiosity::radiometry::projected_solid_angle;
use std::f64::consts::PI;

/// The plane of an outline; its front is where the corners run counter-clockwise.
pub fn plane(corners: &[DVec3]) -> Plane {
    Plane::through(corners[0], across(corners).normalize())
}

/// What of a convex outline lies in front of a plane, corners in the same order; none
/// when all lies behind.
pub fn clip(plane: Plane, corners: &[DVec3]) -> Vec<DVec3> {
    geometry::clip(corners, plane).to_vec()
}

/// Lambert's formula: the form factor from the point `p`, with unit normal `n`, to the
/// front of a convex outline, with nothing between; 0 to its back, and to no corners.
pub fn lambert(p: DVec3, n: DVec3, corners: &[DVec3]) -> f64 {
    if corners.len() < 3 || across(corners).dot(p - corners[0]) <= 0.0 {
        return 0.0;
    }
    projected_solid_angle(p, n, corners) / PI
}

/// Where the straight line from `a` to `b` goes through a convex outline, from either
/// side; `None` where it misses it or ends before.
pub fn crossing(a: DVec3, b: DVec3, corners: &[DVec3]) -> Option<DVec3> {
    let plane = plane(corners);
    let (ha, hb) = (plane.height(a), plane.height(b));
    if ha * hb >= 0.0 {
        return None;
    }
    let at = a + (b - a) * (ha / (ha - hb));
    let next = corners.iter().cycle().skip(1);
    let mut edges = corners.iter().zip(next);
    edges.all(|(&c, &d)| (d - c).cross(at - c).dot(plane.normal) >= 0.0).then_some(at)
}

fn across(corners: &[DVec3]) -> DVec3 {
    let fan = |k: usize| (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
    (1..corners.len() - 1).map(fan).sum()
}
