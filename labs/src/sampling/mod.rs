//! The lab `sampling`: form factors by random points and by random rays, each with an
//! error bar.
//!
//! ```text
//! F_ij = mean over x on i, y on j of  V cosθ cosθ' A_j / (π r²)         by points
//! F_ij = share of cosine rays from i that meet j first                  by rays
//! error of a mean = s/√n,   s² = Σ (value − mean)² / (n − 1)
//! ```
//!
//! The student writes the four functions of [`Work`]. Each is judged against exact values:
//! closed forms, and partly hidden squares whose factor is known by symmetry.
//!
//! **Not here:** evenly spread samples. Chapter *Form factors* (L07); brief:
//! `book/src/labs/sampling.md`. Sources: Malley 1988; Sillion & Puech 1989.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use given::{Estimate, Pair};
use radiosity::prelude::DVec3;
use radiosity::random::Stream;

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. The mean of many values, and the error to be expected of it.
    pub estimate: fn(values: &[f64]) -> Estimate,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. A direction over a surface whose normal is z, from two numbers in [0, 1): in
    ///    proportion to the cosine, those near the normal more often.
    pub direction: fn(u: f64, v: f64) -> DVec3,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The form factor of a pair by so many rays.
    pub by_rays: fn(pair: &Pair, samples: usize, stream: &mut Stream) -> Estimate,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. The form factor of a pair by so many pairs of points.
    pub by_points: fn(pair: &Pair, samples: usize, stream: &mut Stream) -> Estimate,
    // ANCHOR_END: task4
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "sampling",
    title: "Points against rays, with error bars",
    minutes: 90,
    brief: include_str!("../../../book/src/labs/sampling.md"),
    starter: "labs/src/sampling/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "A mean and its error", writes: Some("estimate") },
        Task { title: "A direction", writes: Some("direction") },
        Task { title: "By rays", writes: Some("by_rays") },
        Task { title: "By points", writes: Some("by_points") },
        Task { title: "All together", writes: None },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
