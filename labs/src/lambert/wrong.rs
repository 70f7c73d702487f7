//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, all_above, clip, edge, form_factor};
use super::bugs::*;
use crate::lab::{Wrong, plays};
use crate::run::PANIC;
use radiosity::prelude::DVec3;
use std::f64::consts::PI;

/// The answer, but with other edges.
macro_rules! edges {
    ($edge:expr) => {
        Work {
            edge: $edge,
            all_above: |n, corners| sum(n, corners, $edge),
            form_factor: |p, n, corners| sum(n, &clip(n, &seen(p, corners)), $edge),
            ..WORK
        }
    };
}

/// The answer, but with another sum.
macro_rules! sums {
    ($sum:expr) => {
        Work {
            all_above: $sum,
            form_factor: |p, n, corners| {
                let sum: fn(DVec3, &[DVec3]) -> f64 = $sum;
                sum(n, &clip(n, &seen(p, corners)))
            },
            ..WORK
        }
    };
}

/// The answer, but clipped otherwise.
macro_rules! clips {
    ($clip:expr) => {
        Work {
            clip: $clip,
            form_factor: |p, n, corners| {
                let clip: fn(DVec3, &[DVec3]) -> Vec<DVec3> = $clip;
                all_above(n, &clip(n, &seen(p, corners)))
            },
            ..WORK
        }
    };
}

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("reversed", "a × b", &[REVERSED], edges!(|a, b, n| edge(b, a, n))),
    plays("no-unit", "a cross product is a normal", &[NOT_A_UNIT], {
        edges!(|a, b, n| {
            let across = b.cross(a);
            across.length().atan2(a.dot(b)) * across.dot(n)
        })
    }),
    plays("sine-left", "unit vectors have a unit cross product", &[SINE_LEFT], {
        edges!(|a, b, n| {
            let (u, v) = (a.normalize(), b.normalize());
            v.cross(u).dot(n) * u.angle_between(v)
        })
    }),
    plays("no-angle", "n·Γ", &[NO_ANGLE], {
        edges!(|a, b, n| b.cross(a).try_normalize().map_or(0.0, |g| g.dot(n)))
    }),
    plays("angles-alone", "the angles of the outline", &[NO_NORMAL], {
        edges!(|a, b, _| b.cross(a).length().atan2(b.dot(a)))
    }),
    plays("edges-unsigned", "each edge adds", &[UNSIGNED], {
        edges!(|a, b, n| edge(a, b, n).abs())
    }),
    plays("degrees", "angles are in degrees", &[DEGREES], {
        edges!(|a, b, n| edge(a, b, n) / PI * 180.0)
    }),
    plays("arcsine", "the sine is at hand", &[ARCSINE], {
        edges!(|a, b, n| {
            let across = b.normalize().cross(a.normalize());
            let sine = across.length();
            if sine == 0.0 { 0.0 } else { sine.min(1.0).asin() / sine * across.dot(n) }
        })
    }),
    plays("arccosine", "a·b is the cosine", &[FLAT_COSINE], {
        edges!(|a, b, n| {
            let cosine = a.normalize().dot(b.normalize()).clamp(-1.0, 1.0);
            b.cross(a).try_normalize().map_or(0.0, |g| cosine.acos() * g.dot(n))
        })
    }),
    plays("zero-by-zero", "no edge is seen end on", &[ZERO_BY_ZERO], {
        edges!(|a, b, n| {
            let across = b.cross(a);
            across.length().atan2(a.dot(b)) * across.dot(n) / across.length()
        })
    }),
    plays("no-half", "the sum over π", &[NO_HALF], {
        sums!(|n, corners| 2.0 * all_above(n, corners))
    }),
    plays("projected", "half the sum", &[NO_PI], {
        sums!(|n, corners| PI * all_above(n, corners))
    }),
    plays("pi-twice", "over π for good measure", &[PI_TWICE], {
        sums!(|n, corners| all_above(n, corners) / PI)
    }),
    plays("open", "n corners, n − 1 edges", &[OPEN], {
        sums!(|n, corners| {
            let pairs = corners.windows(2).map(|pair| edge(pair[0], pair[1], n));
            (pairs.sum::<f64>() / PI / 2.0).max(0.0)
        })
    }),
    plays("backs-negative", "a sum may be negative", &[FROM_BEHIND], {
        sums!(|n, corners| all_above(n, corners) - all_above(n, &turned(corners)))
    }),
    plays("two-sided", "a form factor is positive", &[FROM_BEHIND], {
        sums!(|n, corners| all_above(n, corners) + all_above(n, &turned(corners)))
    }),
    plays("kept-below", "above is negative", &[KEPT_BELOW], {
        clips!(|n, corners| clip(-n, corners))
    }),
    plays("dropped", "what is below goes", &[DROPPED], {
        clips!(|n, corners| {
            let mut kept = corners.to_vec();
            kept.retain(|corner| corner.dot(n) >= 0.0);
            kept
        })
    }),
    plays("lifted", "below is on the horizon", &[LIFTED], {
        clips!(|n, corners| {
            corners.iter().map(|c| *c + n * (-c.dot(n)).max(0.0)).collect()
        })
    }),
    plays("halfway", "the horizon crosses edges in their middle", &[WRONG_PLACE], {
        clips!(|n, corners| {
            let mut kept = Vec::new();
            let mut last = corners[corners.len() - 1];
            for &corner in corners {
                if (corner.dot(n) >= 0.0) != (last.dot(n) >= 0.0) {
                    kept.push(corner.midpoint(last));
                }
                if corner.dot(n) >= 0.0 {
                    kept.push(corner);
                }
                last = corner;
            }
            kept
        })
    }),
    plays("gap", "the outline is a list", &[GAP], {
        clips!(|n, corners| {
            // Through the closing edge nothing is cut: what was added there goes.
            let (first, last) = (corners[0], corners[corners.len() - 1]);
            let mut kept = clip(n, corners);
            if first.dot(n) * last.dot(n) < 0.0 {
                kept.pop();
            }
            kept
        })
    }),
    plays("not-clipped", "what is there, is there", &[NOT_CLIPPED], {
        clips!(|_, corners| corners.to_vec())
    }),
    plays("by-centre", "its centre is above", &[ALL_OR_NOTHING], {
        clips!(|n, corners| {
            let height: f64 = corners.iter().map(|corner| corner.dot(n)).sum();
            if height > 0.0 { corners.to_vec() } else { Vec::new() }
        })
    }),
    plays("first-corner", "an outline has a first corner", &[PANIC], {
        sums!(|n, corners| all_above(n, corners) + 0.0 * corners[0].length())
    }),
    plays("not-moved", "all points are the origin", &[NOT_MOVED], {
        Work { form_factor: |_, n, v| form_factor(DVec3::ZERO, n, v), ..WORK }
    }),
    plays("horizon-at-origin", "clipped first, moved later", &[HORIZON_AT_ORIGIN], {
        Work { form_factor: |p, n, v| all_above(n, &seen(p, &clip(n, v))), ..WORK }
    }),
    plays("forgot-to-clip", "the sum knows what is above", &[NOT_CLIPPED], {
        Work { form_factor: |p, n, v| all_above(n, &seen(p, v)), ..WORK }
    }),
];

fn seen(p: DVec3, corners: &[DVec3]) -> Vec<DVec3> {
    corners.iter().map(|&corner| corner - p).collect()
}

fn turned(corners: &[DVec3]) -> Vec<DVec3> {
    corners.iter().rev().copied().collect()
}

fn sum(n: DVec3, corners: &[DVec3], edge: fn(DVec3, DVec3, DVec3) -> f64) -> f64 {
    let mut sum = 0.0;
    for k in 0..corners.len() {
        sum += edge(corners[k], corners[(k + 1) % corners.len()], n);
    }
    (sum / 2.0 / PI).max(0.0)
}
