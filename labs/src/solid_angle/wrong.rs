//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, polygon, small, triangle};
use super::bugs::*;
use crate::lab::{Wrong, plays};
use radiosity::prelude::DVec3;
use std::f64::consts::PI;

/// The answer, but with triangles measured in another way.
macro_rules! measures {
    ($triangle:expr) => {
        Work {
            triangle: $triangle,
            polygon: |point, corners| fan(point, corners, $triangle),
            surface: |point, faces| {
                faces.iter().map(|f| fan(point, f, $triangle)).sum()
            },
            ..WORK
        }
    };
}

/// The answer, but with polygons measured in another way.
macro_rules! adds {
    ($polygon:expr) => {
        Work {
            polygon: $polygon,
            surface: |point, faces| {
                let polygon: fn(DVec3, &[DVec3]) -> f64 = $polygon;
                faces.iter().map(|face| polygon(point, face)).sum()
            },
            ..WORK
        }
    };
}

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays(
        "no-cosine",
        "light falls off as 1/r²",
        &[NO_COSINE],
        Work {
            small: |at, normal, area| match normal.dot(at) < 0.0 {
                true => area / at.length_squared(),
                false => 0.0,
            },
            ..WORK
        },
    ),
    plays(
        "cosine-of-long-vectors",
        "the dot product is the cosine",
        &[ONE_DISTANCE],
        Work {
            small: |at, normal, area| {
                area * (-normal.dot(at)).max(0.0) / at.length_squared()
            },
            ..WORK
        },
    ),
    plays(
        "over-pi",
        "as in the form factor",
        &[OVER_PI],
        Work { small: |at, normal, area| small(at, normal, area / PI), ..WORK },
    ),
    plays(
        "negative-behind",
        "a cosine is a cosine",
        &[FROM_BEHIND],
        Work {
            small: |at, normal, area| {
                small(at, normal, area) - small(at, -normal, area)
            },
            ..WORK
        },
    ),
    plays(
        "two-sided",
        "paper has two sides",
        &[FROM_BEHIND],
        Work {
            small: |at, normal, area| {
                small(at, normal, area).max(small(at, -normal, area))
            },
            ..WORK
        },
    ),
    plays(
        "wrong-side",
        "the normal points where `at` points",
        &[WRONG_SIDE],
        Work { small: |at, normal, area| small(at, -normal, area), ..WORK },
    ),
    plays("halved", "tan Ω", &[HALVED], measures!(|a, b, c| triangle(a, b, c) / 2.0)),
    plays("atan", "a quotient is a quotient", &[ATAN], {
        measures!(|a, b, c| (triangle(a, b, c) / 2.0).tan().atan() * 2.0)
    }),
    plays("outward", "counter-clockwise seen from outside", &[REVERSED], {
        measures!(|a, b, c| triangle(a, c, b))
    }),
    plays("unsigned", "a solid angle is never negative", &[UNSIGNED], {
        measures!(|a, b, c| triangle(a, b, c).abs())
    }),
    plays("not-unit", "the formula of the unit sphere", &[NOT_UNIT], {
        measures!(|a, b, c| {
            let below = 1.0 + a.dot(b) + b.dot(c) + c.dot(a);
            2.0 * a.dot((c - a).cross(b - a)).atan2(below)
        })
    }),
    plays("wrong-lengths", "(a·b)a", &[LENGTHS], {
        measures!(|a, b, c| {
            let (x, y, z) = (a.length(), b.length(), c.length());
            let below = x * y * z + x * a.dot(b) + y * b.dot(c) + z * c.dot(a);
            2.0 * a.dot((c - a).cross(b - a)).atan2(below)
        })
    }),
    plays("flat", "every triangle is small", &[FLAT], {
        measures!(|a, b, c| {
            let across = (b - a).cross(c - a);
            let (at, normal) = ((a + b + c) / 3.0, across.normalize());
            let area = across.length() / 2.0;
            small(at, normal, area) - small(at, -normal, area)
        })
    }),
    plays("no-excess", "the sum of the angles", &[NO_EXCESS], {
        measures!(|a, b, c| angles(a, b, c) * triangle(a, b, c).signum())
    }),
    plays(
        "half-cosine",
        "cos(Ω/2), and then acos",
        &[FLAT_COSINE],
        measures!(|a, b, c| half_cosine(a, b, c) * triangle(a, b, c).signum()),
    ),
    plays(
        "girard",
        "A + B + C − π, with angles by acos",
        &[CANCELS],
        measures!(|a, b, c| (angles(a, b, c) - PI) * triangle(a, b, c).signum()),
    ),
    plays(
        "l-huilier",
        "by the sides, each the acos of a dot product",
        &[CANCELS],
        measures!(|a, b, c| l_huilier(a, b, c) * triangle(a, b, c).signum()),
    ),
    plays(
        "textbook",
        "the formula as it stands in books, with a·(b×c)",
        &[CANCELS],
        measures!(|a, b, c| {
            let (x, y, z) = (a.length(), b.length(), c.length());
            let below = x * y * z + z * a.dot(b) + x * b.dot(c) + y * c.dot(a);
            -2.0 * a.dot(b.cross(c)).atan2(below)
        }),
    ),
    plays(
        "not-moved",
        "all eyes are at the origin",
        &[NOT_MOVED],
        adds!(|_, corners| polygon(DVec3::ZERO, corners)),
    ),
    plays(
        "fan-short",
        "n − 3 triangles",
        &[FAN_SHORT],
        adds!(|point, corners| polygon(point, &corners[..corners.len() - 1])),
    ),
    plays(
        "strip",
        "corners k, k + 1 and k + 2",
        &[STRIP],
        adds!(|point, corners| {
            let three = |k: usize| polygon(point, &corners[k..k + 3]);
            (0..corners.len() - 2).map(three).sum()
        }),
    ),
    plays(
        "fan-unsigned",
        "each triangle adds",
        &[UNSIGNED],
        adds!(|point, corners| fan(point, corners, |a, b, c| triangle(a, b, c).abs())),
    ),
    plays(
        "faces-unsigned",
        "each face adds",
        &[UNSIGNED],
        Work {
            surface: |point, faces| {
                faces.iter().map(|face| polygon(point, face).abs()).sum()
            },
            ..WORK
        },
    ),
    plays(
        "backs-skipped",
        "a back is not seen",
        &[FRONTS_ONLY],
        Work {
            surface: |point, faces| {
                faces.iter().map(|face| polygon(point, face)).filter(|f| *f > 0.0).sum()
            },
            ..WORK
        },
    ),
    plays(
        "share",
        "1 is everything",
        &[SHARE],
        Work {
            surface: |point, faces| (WORK.surface)(point, faces) / (4.0 * PI),
            ..WORK
        },
    ),
];

fn fan(
    point: DVec3,
    corners: &[DVec3],
    triangle: fn(DVec3, DVec3, DVec3) -> f64,
) -> f64 {
    let first = corners[0] - point;
    let mut sum = 0.0;
    for pair in corners[1..].windows(2) {
        sum += triangle(first, pair[0] - point, pair[1] - point);
    }
    sum
}

/// cos(Ω/2) = (1 + a·b + b·c + c·a) / √(2 (1 + a·b) (1 + b·c) (1 + c·a)), of unit vectors.
fn half_cosine(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let (a, b, c) = (a.normalize(), b.normalize(), c.normalize());
    let [ab, bc, ca] = [1.0 + a.dot(b), 1.0 + b.dot(c), 1.0 + c.dot(a)];
    2.0 * ((ab + bc + ca - 2.0) / (2.0 * ab * bc * ca).sqrt()).clamp(-1.0, 1.0).acos()
}

/// The sum of the angles between the planes that meet at a, b and c.
fn angles(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let at = |p: DVec3, q: DVec3, r: DVec3| {
        let (first, second) = (p.cross(q).normalize(), p.cross(r).normalize());
        first.dot(second).clamp(-1.0, 1.0).acos()
    };
    at(a, b, c) + at(b, c, a) + at(c, a, b)
}

/// tan²(Ω/4) = tan(s/2) tan((s−A)/2) tan((s−B)/2) tan((s−C)/2) by the sides A, B, C.
fn l_huilier(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let side =
        |p: DVec3, q: DVec3| p.normalize().dot(q.normalize()).clamp(-1.0, 1.0).acos();
    let sides = [side(b, c), side(c, a), side(a, b)];
    let s = sides.iter().sum::<f64>() / 2.0;
    let product: f64 = sides.iter().map(|x| ((s - x) / 2.0).tan()).product();
    4.0 * (product * (s / 2.0).tan()).max(0.0).sqrt().atan()
}
