//! The lab `solid-angle`: how large does a surface look?
//!
//! ```text
//! Ω ≈ A cosθ / r²                                                      small surfaces
//! tan(Ω/2) = −a·(b×c) / (abc + (a·b)c + (b·c)a + (c·a)b)               any triangle
//! ```
//!
//! The student writes the four functions of [`Work`]. Each is judged against closed forms:
//! the library's, and values of the accuracy tables by other programs (`I4-…`, `I6-…`).
//!
//! **Not here:** the projected solid angle; that is the lab `lambert`.
//! Chapter *Solid angle* (L02); brief: `book/src/labs/solid-angle.md`.
//! Sources: Girard 1629; Van Oosterom & Strackee 1983.

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
    /// 1. About what a small surface at `at` covers, seen from the origin: A cosθ/r².
    ///    Its front is where its unit `normal` points; from behind it covers 0.
    pub small: fn(at: DVec3, normal: DVec3, area: f64) -> f64,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. What a triangle covers, seen from the origin: positive when `a`, `b`, `c` run
    ///    counter-clockwise as seen from there, else negative.
    pub triangle: fn(a: DVec3, b: DVec3, c: DVec3) -> f64,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The same for a flat polygon, convex or not, seen from `point`.
    pub polygon: fn(point: DVec3, corners: &[DVec3]) -> f64,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. The sum over the faces of a closed surface, each with its sign.
    pub surface: fn(point: DVec3, faces: &[Vec<DVec3>]) -> f64,
    // ANCHOR_END: task4
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "solid-angle",
    title: "How large does a surface look?",
    minutes: 60,
    brief: include_str!("../../../book/src/labs/solid-angle.md"),
    starter: "labs/src/solid_angle/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "A small surface", writes: Some("small") },
        Task { title: "A triangle", writes: Some("triangle") },
        Task { title: "A polygon", writes: Some("polygon") },
        Task { title: "A closed surface", writes: Some("surface") },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
