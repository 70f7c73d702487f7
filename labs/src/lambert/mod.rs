//! The lab `lambert`: the form factor from a point to a polygon, exactly.
//!
//! ```text
//! F = 1/(2π) Σₖ γₖ n·Γₖ      γₖ the angle between Rₖ and Rₖ₊₁, the corners seen from p
//!                            Γₖ = Rₖ₊₁ × Rₖ / |Rₖ₊₁ × Rₖ|
//! ```
//! over the outline as far as it lies above the horizon of p.
//!
//! The student writes the four functions of [`Work`]. Each is judged against closed forms:
//! the library's, and values of the accuracy tables by other programs (`A4-…`).
//!
//! **Not here:** what stands between; the lab `sampling` looks at that. Chapter *Form
//! factors* (L07); brief: `book/src/labs/lambert.md`. Sources: Lambert 1760; Sutherland &
//! Hodgman 1974; Baum, Rushmeier & Winget 1989.

pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use radiosity::prelude::DVec3;

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. What the edge from `a` to `b` adds, γ n·Γ: γ is the angle between them as
    ///    seen from the origin, Γ the unit vector along b × a. 0 where γ is 0.
    pub edge: fn(a: DVec3, b: DVec3, n: DVec3) -> f64,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. The form factor from the origin, with unit normal `n`, to the front of a
    ///    polygon wholly above the horizon; 0 to its back.
    pub all_above: fn(n: DVec3, corners: &[DVec3]) -> f64,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. What of a convex outline lies above the plane through the origin with normal
    ///    `n`, corners in the same order; none when all lies below.
    pub clip: fn(n: DVec3, corners: &[DVec3]) -> Vec<DVec3>,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. The form factor from the point `p`, with unit normal `n`, to the front of any
    ///    convex polygon.
    pub form_factor: fn(p: DVec3, n: DVec3, corners: &[DVec3]) -> f64,
    // ANCHOR_END: task4
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "lambert",
    title: "Lambert's formula",
    minutes: 75,
    brief: include_str!("../../../book/src/labs/lambert.md"),
    starter: "labs/src/lambert/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "One edge", writes: Some("edge") },
        Task { title: "A polygon above the horizon", writes: Some("all_above") },
        Task { title: "The horizon", writes: Some("clip") },
        Task { title: "Any polygon", writes: Some("form_factor") },
        Task { title: "All together", writes: None },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
