//! The lab `break-it`: how does your program fail, and why?
//!
//! ```text
//! F_points/F − 1 ≈ ⅔/d²                    two unit squares at distance d
//! P(missed) = 1 − area/cell                a lamp smaller than a cell of the hemicube
//! ρ λ(F) > 1                               a solver runs away
//! ρ^(k+1)                                  the share that is missing after k bounces
//! A_i F_ij = A_j F_ji, Σ_j F_ij = 1        laws that wrong factors obey, too
//! ```
//!
//! Each task asks for a scene that breaks a method, and for how badly. The checks run
//! the method of the crate on that scene. The student writes the five functions of
//! [`Work`].
//!
//! **Not here:** methods; those were written in other labs. Chapter *Where methods
//! fail*; brief: `book/src/labs/break-it.md`. Sources: Baum, Rushmeier & Winget 1989;
//! Murdoch 1981.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use given::{Hidden, Near, Room, Slow};

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. A distance at which the factor between two unit squares, by their middles,
    ///    is too large by the share `wanted` at least, and by twice that at most.
    pub near: fn(wanted: f64) -> Near,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. A square lamp, parallel to the top of a hemicube of `cells` × `cells`, and
    ///    1 m above its middle, that is missed at the share `missed` of all places.
    pub hidden: fn(cells: u32, missed: f64) -> Hidden,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The reflectance of all walls above which Jacobi's iteration runs away with
    ///    these factors: `factors[i][j]` is F_ij, by the middles of the elements.
    pub runaway: fn(factors: &[Vec<f64>]) -> f64,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. Walls of a closed room with a lamp in it, so white that Jacobi's iteration
    ///    needs `sweeps` bounces until no more than the share `missing` of all light is
    ///    missing.
    pub slow: fn(sweeps: u32, missing: f64) -> Slow,
    // ANCHOR_END: task4
    // ANCHOR: task5
    /// 5. Factors for a box with the exact ones, `room.factors`, that obey all laws,
    ///    and whose factor from the floor, 4, to the ceiling, 5, is too large by the
    ///    share `wanted`.
    pub lawful: fn(room: &Room, wanted: f64) -> Vec<Vec<f64>>,
    // ANCHOR_END: task5
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "break-it",
    title: "Break it",
    minutes: 60,
    brief: include_str!("../../../book/src/labs/break-it.md"),
    starter: "labs/src/break_it/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "Too near", writes: Some("near") },
        Task { title: "Between the cells", writes: Some("hidden") },
        Task { title: "A solver that runs away", writes: Some("runaway") },
        Task { title: "A thousand sweeps", writes: Some("slow") },
        Task { title: "Lawful, and wrong", writes: Some("lawful") },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
