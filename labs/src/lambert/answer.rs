//! One right answer: Lambert's sum over the edges, clipped to the horizon.
#![deny(warnings)]

use super::Work;
use radiosity::prelude::DVec3;
use std::f64::consts::PI;

/// Task 1: |b × a| is ab sinγ and a·b is ab cosγ, so that `atan2` of them is γ.
pub fn edge(a: DVec3, b: DVec3, n: DVec3) -> f64 {
    let across = (b - a).cross(a); // b × a, with the digits of short edges
    let sine = across.length();
    if sine == 0.0 {
        return 0.0; // both corners in one direction
    }
    sine.atan2(a.dot(b)) * n.dot(across) / sine
}

/// Task 2: half the sum is the projected solid angle, and π of that is everything.
pub fn all_above(n: DVec3, corners: &[DVec3]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let sum: f64 = corners.iter().zip(next).map(|(&a, &b)| edge(a, b, n)).sum();
    (sum / (2.0 * PI)).max(0.0)
}

/// Task 3: walk round; keep what is above, and add a corner wherever the horizon is
/// crossed (Sutherland & Hodgman 1974).
pub fn clip(n: DVec3, corners: &[DVec3]) -> Vec<DVec3> {
    let mut kept = Vec::new();
    for (k, &a) in corners.iter().enumerate() {
        let b = corners[(k + 1) % corners.len()];
        let (ha, hb) = (n.dot(a), n.dot(b));
        if ha >= 0.0 {
            kept.push(a);
        }
        if ha * hb < 0.0 {
            kept.push(a + (b - a) * (ha / (ha - hb)));
        }
    }
    kept
}

/// Task 4: see it from `p`, clip, sum.
pub fn form_factor(p: DVec3, n: DVec3, corners: &[DVec3]) -> f64 {
    let seen: Vec<DVec3> = corners.iter().map(|&corner| corner - p).collect();
    all_above(n, &clip(n, &seen))
}

/// What is handed in.
pub const WORK: Work = Work { edge, all_above, clip, form_factor };
