//! The lab `race`: a method of one's own on the chart.
//!
//! ```text
//! off = √(mean ((answer − exact)/exact)²)                       over seeds
//! beaten: another has t' ≤ t and e' ≤ e, one of them less       frontier: the others
//! slope of log e over log t, least squares                      e ~ t^slope
//! F = ∫₀¹∫₀¹∫₀¹∫₀¹ kernel(u, v)                                 four variables
//! ```
//!
//! The student writes the four functions of [`Work`]. Three read a chart, the fourth
//! finds a form factor, in as few evaluations as possible; it is judged against closed
//! forms, and then runs in the crate's own contest ([`report`]).
//!
//! **Not here:** ways that know what the kernel is, as Lambert's formula does (the lab
//! `lambert`). Chapter *Speed against accuracy*; brief: `book/src/labs/race.md`.
//! Sources: Pareto 1906.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use given::Pair;

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. How far answers are off: the root mean square, over seeds, of the error as a
    ///    share of the exact value, which is above 0.
    pub off: fn(answers: &[f64], exact: f64) -> f64,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. Which of these trials (time, error) no other one beats, by their places in
    ///    the list, in any order. To beat is to be no worse in both, better in one.
    pub frontier: fn(trials: &[(f64, f64)]) -> Vec<usize>,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The slope of a line of trials (time, error) on logarithmic axes, by least
    ///    squares. Trials without a logarithm do not count; two or more have one.
    pub slope: fn(trials: &[(f64, f64)]) -> f64,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. The form factor of a pair, from at most `effort` evaluations of its kernel,
    ///    one or more.
    pub factor: fn(pair: &Pair, effort: u32) -> f64,
    // ANCHOR_END: task4
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "race",
    title: "Put your method on the chart",
    minutes: 60,
    brief: include_str!("../../../book/src/labs/race.md"),
    starter: "labs/src/race/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "How far off", writes: Some("off") },
        Task { title: "The frontier", writes: Some("frontier") },
        Task { title: "The slope", writes: Some("slope") },
        Task { title: "A method of your own", writes: Some("factor") },
        Task { title: "All together", writes: None },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL, wrong::FACTORS],
        checks: checks::ALL,
    },
};
