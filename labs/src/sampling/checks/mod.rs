//! The checks of this lab.
//!
//! ```text
//! |F̂ − F| ≤ 5 σ/√n      σ the scatter of a single sample, √(F(1 − F)) of a ray
//! ```
//! One right answer in 1.7 million fails that. A suspect is what a mistake would give, with
//! a scatter of its own.

mod basics;
mod scenes;
mod sums;
mod whole;

use super::Work;
use crate::lab::{Check, check};
use sums::{Method, Of};

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "mean", "a mean and its error are right", 2, basics::mean),
    check(1, "equal", "equal values have a mean and no error", 1, basics::equal),
    check(
        2,
        "direction",
        "directions are as dense as their cosine",
        2,
        basics::directions,
    ),
    check(3, "rays", "rays find the factor of an open pair", 2, |w, s| {
        sums::means(w, s, Method::Rays, Of::Open)
    }),
    check(3, "rays-hidden", "rays find it behind blockers", 1, |w, s| {
        sums::means(w, s, Method::Rays, Of::Hidden)
    }),
    check(3, "rays-bars", "the error bar of the rays is right", 1, |w, s| {
        sums::bars(w, s, Method::Rays)
    }),
    check(4, "points", "points find the factor of an open pair", 2, |w, s| {
        sums::means(w, s, Method::Points, Of::Open)
    }),
    check(4, "points-hidden", "points find it behind blockers", 2, |w, s| {
        sums::means(w, s, Method::Points, Of::Hidden)
    }),
    check(4, "points-bars", "the error bar of the points is right", 1, |w, s| {
        sums::bars(w, s, Method::Points)
    }),
    check(5, "honest", "the bars hold as often as they claim", 2, whole::honest),
    check(5, "agree", "points and rays agree within their bars", 1, whole::agree),
];
