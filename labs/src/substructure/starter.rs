//! Your work. The brief is `book/src/labs/substructure.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run substructure --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::given::{Anchor, Room, Sample};
use super::{Factor, Work};

/// Task 1: the factors from each element to each patch.
pub fn rows(patch_of: &[usize], patches: usize, factor: Factor) -> Vec<Vec<f64>> {
    todo!("substructure, task 1: who looks at whom")
}

/// Task 2: the factors between patches.
pub fn patch_factors(room: &Room) -> Vec<Vec<f64>> {
    todo!("substructure, task 2: patches from elements")
}

/// Task 3: the radiosity of the elements, W/m².
pub fn gather(room: &Room, patches: &[f64]) -> Vec<f64> {
    todo!("substructure, task 3: elements from patches")
}

/// Task 4: which elements are to be split.
pub fn marks(elements: &[Sample], share: f64, smallest: f64) -> Vec<bool> {
    todo!("substructure, task 4: where to split")
}

/// Task 5: T-vertices take the values of their edges.
pub fn anchor(values: &mut [f64], anchors: &[Anchor]) {
    todo!("substructure, task 5: T-vertices")
}

/// What is handed in.
pub const WORK: Work = Work { rows, patch_factors, gather, marks, anchor };
