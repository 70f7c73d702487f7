//! The lab `certify`: how wrong is a solution that somebody else has computed?
//!
//! ```text
//! r = E + ρ H − B                                 the residual at a point, W/m²
//! ‖r‖² ≈ Σ A r₁ r₂                                by two independent gathers
//! ‖r‖/(1 + ρ) ≤ ‖e‖ ≤ ‖r‖/(1 − ρ)                 the error, at the worst
//! ‖e‖/‖B − E‖                                     relative to the reflected light
//! e_i = r_i + ρ_i Σ_j F_ij e_j                    the error, propagated
//! ```
//!
//! The student writes the five functions of [`Work`].
//!
//! **Not here:** rays; strata; the interval. Chapter *How wrong is it?*; brief:
//! `book/src/labs/certify.md`. Sources: Arvo, Torrance & Smits 1994; Lischinski, Smits &
//! Greenberg 1994.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use given::{Point, Room};

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. The residual, W/m², at a point by gather 0 or 1.
    pub residual: fn(point: &Point, gather: usize) -> f64,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. `‖r‖²`, the integral of r² over the area: right in the mean, however noisy
    ///    the gathers are.
    pub squared: fn(points: &[Point]) -> f64,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The least and the largest norm that the error can have when the residual has
    ///    this norm, and no surface reflects more than `reflectance`.
    pub worst_case: fn(norm: f64, reflectance: f64) -> [f64; 2],
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. An error of this norm, relative to the light that was reflected.
    pub relative: fn(norm: f64, points: &[Point]) -> f64,
    // ANCHOR_END: task4
    // ANCHOR: task5
    /// 5. The error of each piece of a room, W/m², from the residual of each: to 1e-9.
    pub propagated: fn(room: &Room, residual: &[f64]) -> Vec<f64>,
    // ANCHOR_END: task5
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "certify",
    title: "How wrong is a solution?",
    minutes: 60,
    brief: include_str!("../../../book/src/labs/certify.md"),
    starter: "labs/src/certify/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "The residual", writes: Some("residual") },
        Task { title: "Its norm, past the noise", writes: Some("squared") },
        Task { title: "The worst case", writes: Some("worst_case") },
        Task { title: "Relative to what?", writes: Some("relative") },
        Task { title: "Propagated", writes: Some("propagated") },
        Task { title: "All together", writes: None },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
