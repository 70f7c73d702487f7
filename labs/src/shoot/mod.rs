//! The lab `shoot`: the brightest first.
//!
//! ```text
//! i = the element with the largest A_i ΔB_i                   or ΔB_i
//! B_j += ρ_j F_ij A_i/A_j ΔB_i, ΔB_j too, for all j;  of what i had, nothing is left
//! a = Σ A ΔB / Σ A (1 − ρ)       shown: B_i + ρ_i a           the ambient term
//! Σ A E = Σ A (1 − ρ) H + Σ A ΔB                              the ledger, W
//! ```
//!
//! The student writes the five functions of [`Work`]. They are judged in the rooms of
//! the lab `gather`: balls and boxes with exact form factors and areas that differ. In
//! a ball light spreads evenly, so that the ambient guess is exact after every shot.
//!
//! **Not here:** form factors, overshooting. Chapter *Progressive refinement* (L13);
//! brief: `book/src/labs/shoot.md`. Source: Cohen et al. 1988.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::gather::given::{Balance, Room};
use crate::lab::{Lab, Task, Works};
use given::{By, Light, Progress};

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. The brightest element, or `None` when no light is left to send.
    pub brightest: fn(room: &Room, unshot: &[f64], by: By) -> Option<usize>,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. Element `from` sends all that it has left, to everybody whom it sees.
    pub shoot: fn(room: &Room, light: &mut Light, from: usize),
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The radiosity with the ambient guess, for the display.
    pub shown: fn(room: &Room, light: &Light) -> Vec<f64>,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. The ledger: where the light is, in W.
    pub ledger: fn(room: &Room, light: &Light) -> Balance,
    // ANCHOR_END: task4
    // ANCHOR: task5
    /// 5. From the start, so many shots, each by the element with the most power; fewer
    ///    when nothing is left.
    pub refine: fn(room: &Room, shots: usize) -> Progress,
    // ANCHOR_END: task5
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "shoot",
    title: "The brightest first",
    minutes: 75,
    brief: include_str!("../../../book/src/labs/shoot.md"),
    starter: "labs/src/shoot/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "The brightest", writes: Some("brightest") },
        Task { title: "A shot", writes: Some("shoot") },
        Task { title: "What is shown", writes: Some("shown") },
        Task { title: "The ledger", writes: Some("ledger") },
        Task { title: "Shot by shot", writes: Some("refine") },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
