//! The lab `sky`: light from an HDR sky.
//!
//! ```text
//! Ω = Δφ (cosθ₀ − cosθ₁)        of a texel between two parallels
//! H(n) = Σ L Ω max(0, n·ω)      of a plane, each texel taken at its middle
//! p = L / Σ L Ω                 of a direction drawn by brightness
//! ```
//!
//! The student writes the four functions of [`Work`]; they are judged against the
//! crate's own panoramas.
//!
//! **Not here:** colours; what stands in the way of the sky.
//! Chapter *Light from the sky* (L21); brief: `book/src/labs/sky.md`.
//! Sources: Blinn & Newell 1976; Debevec 1998.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

pub use given::Map;

use crate::lab::{Lab, Task, Works};
use radiosity::prelude::{DVec2, DVec3};

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. The solid angle of a texel in `row` of a panorama, in sr.
    pub texel: fn(width: usize, height: usize, row: usize) -> f64,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. The direction to the middle of a texel, of unit length. Up is +y, row 0 is
    ///    up; the middle of the picture looks along −z, and columns run to the right,
    ///    +x.
    pub direction: fn(width: usize, height: usize, column: usize, row: usize) -> DVec3,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The irradiance of a plane with this unit normal, in W/m²; each texel may be
    ///    taken at its middle.
    pub irradiance: fn(map: &Map, normal: DVec3) -> f64,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. A direction drawn by brightness, of two numbers in [0, 1), and its density,
    ///    1/sr.
    pub sample: fn(map: &Map, u: DVec2) -> (DVec3, f64),
    // ANCHOR_END: task4
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "sky",
    title: "Light from an HDR sky",
    minutes: 75,
    brief: include_str!("../../../book/src/labs/sky.md"),
    starter: "labs/src/sky/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "What a texel is worth", writes: Some("texel") },
        Task { title: "Where it is", writes: Some("direction") },
        Task { title: "What falls on a plane", writes: Some("irradiance") },
        Task { title: "Finding the sun", writes: Some("sample") },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
