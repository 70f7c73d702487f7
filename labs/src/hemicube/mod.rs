//! The lab `hemicube`: hemicube weights and item buffer.
//!
//! ```text
//! ΔF_top  =   ΔA / (π (x² + y² + 1)²)      cell of the top face at (x, y, 1)
//! ΔF_side = z ΔA / (π (y² + z² + 1)²)      cell of a side face at height z
//! F_ij    = Σ ΔF over the cells in which j is what element i sees first
//! ```
//!
//! The student writes the five functions of [`Work`]; [`StudentHemicube`] puts them
//! together and is a [`FormFactors`](radiosity::form_factor::FormFactors).
//!
//! **Not here:** the raster. Cells find what they see by a ray through their centre
//! ([`given`]). Chapter *The hemicube* (L10); brief: `book/src/labs/hemicube.md`.
//! Sources: Cohen & Greenberg 1985.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use given::{FACES, Fragment, Item, Weights};
use radiosity::form_factor::Lost;

pub use given::StudentHemicube;

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. The form factor to one square cell of the top face, centre (x, y, 1).
    pub top_factor: fn(x: f64, y: f64, edge: f64) -> f64,
    /// 1. The same for a side face: centre (1, y, z), `z` above the base.
    pub side_factor: fn(y: f64, z: f64, edge: f64) -> f64,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. All cells of the top, and of one side; `n` cells span an edge of the top.
    pub weights: fn(n: usize) -> Weights,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. What each of the `cells` of one face sees first; `own` is the element itself.
    pub item_buffer: fn(cells: usize, own: usize, fragments: &[Fragment]) -> Vec<Item>,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. The form factor to every element, and the shares that reach no front.
    pub factor_row: fn(&[Vec<Item>; FACES], &Weights, row: &mut [f64]) -> Lost,
    // ANCHOR_END: task4
    // ANCHOR: task5
    /// 5. From `row[j]` = F_ij, with i = `from`: the factors F_ji that shooting needs.
    pub shooting_factors: fn(row: &[f64], areas: &[f64], from: usize) -> Vec<f64>,
    // ANCHOR_END: task5
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "hemicube",
    title: "Hemicube weights and item buffer",
    minutes: 90,
    brief: include_str!("../../../book/src/labs/hemicube.md"),
    starter: "labs/src/hemicube/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "Weigh one cell", writes: Some("top_factor, side_factor") },
        Task { title: "Weigh them all", writes: Some("weights") },
        Task { title: "The item buffer", writes: Some("item_buffer") },
        Task { title: "A row of form factors", writes: Some("factor_row") },
        Task { title: "The other way round", writes: Some("shooting_factors") },
        Task { title: "All together", writes: None },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: wrong::ALL,
        checks: checks::ALL,
    },
};
