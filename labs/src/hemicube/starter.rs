//! Your work. The brief is `book/src/labs/hemicube.md`; `given.rs` holds the
//! types, and a picture of the cells. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run hemicube --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use super::given::{FACES, Fragment, Item, Weights};
use radiosity::form_factor::Lost;
use std::f64::consts::PI;

/// Task 1: the form factor to a square cell of the top face, centre (x, y, 1).
pub fn top_factor(x: f64, y: f64, edge: f64) -> f64 {
    todo!("hemicube, task 1: the weight of a cell of the top face")
}

/// Task 1: the form factor to a square cell of a side face, centre (1, y, z).
pub fn side_factor(y: f64, z: f64, edge: f64) -> f64 {
    todo!("hemicube, task 1: the weight of a cell of a side face")
}

/// Task 2: the weights of all cells of the top and of one side.
pub fn weights(n: usize) -> Weights {
    todo!("hemicube, task 2: the tables of weights")
}

/// Task 3: what each of the `cells` of a face sees first.
pub fn item_buffer(cells: usize, own: usize, fragments: &[Fragment]) -> Vec<Item> {
    todo!("hemicube, task 3: the item buffer")
}

/// Task 4: writes the form factor to element `j` to `row[j]`; returns what is lost.
pub fn factor_row(
    items: &[Vec<Item>; FACES],
    weights: &Weights,
    row: &mut [f64],
) -> Lost {
    todo!("hemicube, task 4: a row of form factors")
}

/// Task 5: from `row[j]` = F_ij, with i = `from`, the factors F_ji.
pub fn shooting_factors(row: &[f64], areas: &[f64], from: usize) -> Vec<f64> {
    todo!("hemicube, task 5: the factors that shooting needs")
}

/// What is handed in.
pub const WORK: Work = Work {
    top_factor,
    side_factor,
    weights,
    item_buffer,
    factor_row,
    shooting_factors,
};
