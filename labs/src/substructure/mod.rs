//! The lab `substructure`: patches send, elements receive.
//!
//! ```text
//! F_pq = Σ_e A_e F_eq / A_p                  the patch is the mean of its elements
//! B_e  = E_p + ρ_p Σ_q F_eq B_q              elements gather from patches
//! A_e Δ²/12 > share, A_e > A_min             which are split
//! B_t  = (1 − t) B_a + t B_b                 a T-vertex lies on an edge
//! ```
//!
//! The student writes the five functions of [`Work`].
//!
//! **Not here:** the factors themselves; that is the lab `hemicube`.
//! Chapter *Patches and elements* (L11, L12); brief: `book/src/labs/substructure.md`.
//! Sources: Cohen, Greenberg, Immel & Brock 1986.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use given::{Anchor, Room, Sample};

/// Answers with the factor from element `e` to patch `q`.
pub type Factor<'a> = &'a dyn Fn(usize, usize) -> f64;

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. The rows of all elements: `rows[e][q]` is the factor from element `e` to
    ///    patch `q`. `patch_of[e]` is the patch of element `e`; there are `patches`
    ///    patches. Ask `factor(e, q)` for each pair that can see each other, once, and
    ///    for no other.
    pub rows: fn(patch_of: &[usize], patches: usize, factor: Factor) -> Vec<Vec<f64>>,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. What patches see of each other, `m` rows of `m`: the means of their
    ///    elements' rows.
    pub patch_factors: fn(room: &Room) -> Vec<Vec<f64>>,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The radiosity of each element, W/m², when the patches have these.
    pub gather: fn(room: &Room, patches: &[f64]) -> Vec<f64>,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. Which elements are to be split: those with more than `share` of the squared
    ///    error (W²/m²) that are larger than `smallest` (m²).
    pub marks: fn(elements: &[Sample], share: f64, smallest: f64) -> Vec<bool>,
    // ANCHOR_END: task4
    // ANCHOR: task5
    /// 5. Gives T-vertices the values of the edges that they lie on, in the order of
    ///    the list: the end of an edge may be a T-vertex that comes before.
    pub anchor: fn(values: &mut [f64], anchors: &[Anchor]),
    // ANCHOR_END: task5
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "substructure",
    title: "Patches and elements",
    minutes: 75,
    brief: include_str!("../../../book/src/labs/substructure.md"),
    starter: "labs/src/substructure/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "Who looks at whom", writes: Some("rows") },
        Task { title: "Patches from elements", writes: Some("patch_factors") },
        Task { title: "Elements from patches", writes: Some("gather") },
        Task { title: "Where to split", writes: Some("marks") },
        Task { title: "T-vertices", writes: Some("anchor") },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
