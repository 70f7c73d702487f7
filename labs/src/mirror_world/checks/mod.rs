//! The checks of this lab.
//!
//! Outlines are told apart by two moments, Σ vₖ × vₖ₊₁ and Σ (vₖ × vₖ₊₁) u·(vₖ + vₖ₊₁).
//! They do not change with the first corner, nor when a corner is added on an edge, and
//! both change sign with the order. Everything is exact, so that tolerances are those
//! of rounding: 1e-9 of coordinates of a few metres, 1e-7 of form factors near 0.01.

mod cards;
mod factors;
mod images;
mod rows;
mod windows;

use super::Work;
use crate::check::Bug;
use crate::draw::{frame, uniform};
use crate::lab::{Check, check};
use crate::shapes::convex;
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "point", "the image of a point is as far behind", 1, images::point),
    check(2, "front", "the image of a front is a front", 2, images::front),
    check(2, "behind", "what is behind has no image", 1, images::behind),
    check(3, "seen", "a window cuts what lies beyond it", 2, windows::seen),
    check(3, "before", "what stands before it is not seen through it", 1, |w, s| {
        windows::before(w, s)
    }),
    check(3, "back", "from behind nothing is seen", 1, windows::back),
    check(4, "known", "known form factors by mirrors are right", 2, factors::known),
    check(4, "any", "any lamp by any mirror is right", 1, factors::any),
    check(4, "one-side", "a mirror has one side", 1, factors::one_side),
    check(5, "cards", "a card on either leg is in the way", 2, cards::cards),
    check(5, "outline", "a mirror has an end, and a back", 1, cards::rim_and_back),
    check(6, "levels", "each level adds its two images", 2, rows::levels),
    check(6, "limit", "many levels come to the known limits", 1, rows::limit),
];

/// What one mistake each makes of a scene.
type Suspects<S, T> = [(Bug, fn(&S) -> T)];

/// A convex outline about `centre`, turned at random.
fn outline(stream: &mut Stream, centre: DVec3, size: f64) -> Vec<DVec3> {
    let turn = frame(stream);
    let corners = convex(stream);
    corners.iter().map(|&c| centre + turn.world_from_local(c * size)).collect()
}

/// A point with these heights, within a metre and a half of the axis.
fn above(stream: &mut Stream, low: f64, high: f64) -> DVec3 {
    let mut across = || uniform(stream, -1.5, 1.5);
    let (x, y) = (across(), across());
    dvec3(x, y, uniform(stream, low, high))
}

fn moments(v: &[DVec3]) -> [f64; 6] {
    let u = dvec3(1.0, 0.7, -0.4);
    let (mut first, mut second) = (DVec3::ZERO, DVec3::ZERO);
    for (k, &a) in v.iter().enumerate() {
        let b = v[(k + 1) % v.len()];
        first += a.cross(b);
        second += a.cross(b) * u.dot(a + b);
    }
    [first.x, first.y, first.z, second.x, second.y, second.z]
}
