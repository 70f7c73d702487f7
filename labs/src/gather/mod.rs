//! The lab `gather`: the radiosity equation as code.
//!
//! ```text
//! H_i = Σ_j F_ij B_j                          what arrives, W/m²
//! B_i = E_i + ρ_i H_i                         the equation
//! r_i = E_i + ρ_i H_i − B_i                   the residual: what has not settled
//! Σ A E = Σ A (1 − ρ) H + Σ A r               the balance of a closed room, W
//! ‖B − B*‖ ≤ ‖r‖/(1 − ρ_max)                  the bound, of largest values
//! ```
//!
//! The student writes the six functions of [`Work`]. Each is judged in balls and boxes
//! whose form factors are exact, with areas that differ: where all are alike, slips do
//! not show.
//!
//! **Not here:** form factors; shooting. Chapter *The radiosity equation* (L06); brief:
//! `book/src/labs/gather.md`. Sources: Goral et al. 1984; Cohen & Greenberg 1985.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod rooms;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use given::{Balance, Room, Solved};

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. What arrives at element `i`, in W/m², when the elements have radiosities `b`.
    pub arriving: fn(room: &Room, b: &[f64], i: usize) -> f64,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. One bounce (Jacobi): new radiosities of all elements, from old ones alone.
    pub bounce: fn(room: &Room, b: &[f64]) -> Vec<f64>,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. One sweep (Gauss–Seidel): element 0 first, each from the newest values there
    ///    are.
    pub sweep: fn(room: &Room, b: &mut [f64]),
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. By how much each element's radiosity falls short of what the equation asks.
    pub residual: fn(room: &Room, b: &[f64]) -> Vec<f64>,
    // ANCHOR_END: task4
    // ANCHOR: task5
    /// 5. Where the light is, in W.
    pub balance: fn(room: &Room, b: &[f64]) -> Balance,
    // ANCHOR_END: task5
    // ANCHOR: task6
    /// 6. Radiosities of which none is off by more than `accuracy`, in W/m²: for
    ///    certain, and with no more sweeps than that takes.
    pub solve: fn(room: &Room, accuracy: f64) -> Solved,
    // ANCHOR_END: task6
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "gather",
    title: "The radiosity equation as code",
    minutes: 75,
    brief: include_str!("../../../book/src/labs/gather.md"),
    starter: "labs/src/gather/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "What arrives", writes: Some("arriving") },
        Task { title: "A bounce", writes: Some("bounce") },
        Task { title: "A sweep", writes: Some("sweep") },
        Task { title: "The residual", writes: Some("residual") },
        Task { title: "The balance", writes: Some("balance") },
        Task { title: "A solution, for certain", writes: Some("solve") },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
