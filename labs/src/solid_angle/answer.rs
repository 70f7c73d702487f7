//! One right answer: a triangle by the tangent of its half (Van Oosterom & Strackee 1983).
#![deny(warnings)]

use super::Work;
use radiosity::prelude::DVec3;

/// Task 1: the front looks at the origin when its normal goes against `at`.
pub fn small(at: DVec3, normal: DVec3, area: f64) -> f64 {
    let r = at.length();
    let cosine = -normal.dot(at) / r;
    area * cosine.max(0.0) / (r * r)
}

/// Task 2: `atan2` knows the quadrant, and half of a small number is a small number.
pub fn triangle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    // The same triple product as a·(b×c), of edges: corners far away nearly agree, and
    // what is left of their product is rounding.
    let above = -a.dot((b - a).cross(c - a));
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    2.0 * above.atan2(below)
}

/// Task 3: a fan of triangles; where the outline turns inward, one is taken away again.
pub fn polygon(point: DVec3, corners: &[DVec3]) -> f64 {
    let r: Vec<DVec3> = corners.iter().map(|&corner| corner - point).collect();
    (1..r.len() - 1).map(|k| triangle(r[0], r[k], r[k + 1])).sum()
}

/// Task 4: fronts count up, backs count down.
pub fn surface(point: DVec3, faces: &[Vec<DVec3>]) -> f64 {
    faces.iter().map(|corners| polygon(point, corners)).sum()
}

/// What is handed in.
pub const WORK: Work = Work { small, triangle, polygon, surface };
