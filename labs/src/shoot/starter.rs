//! Your work. The brief is `book/src/labs/shoot.md`; `given.rs` holds the types.
//! Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run shoot --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use super::given::{By, Light, Progress};
use crate::gather::given::{Balance, Room};

/// Task 1: the brightest element, or `None` when no light is left.
pub fn brightest(room: &Room, unshot: &[f64], by: By) -> Option<usize> {
    todo!("shoot, task 1: the brightest")
}

/// Task 2: element `from` sends all that it has left.
pub fn shoot(room: &Room, light: &mut Light, from: usize) {
    todo!("shoot, task 2: a shot")
}

/// Task 3: the radiosity with the ambient guess, W/m².
pub fn shown(room: &Room, light: &Light) -> Vec<f64> {
    todo!("shoot, task 3: what is shown")
}

/// Task 4: where the light is, W.
pub fn ledger(room: &Room, light: &Light) -> Balance {
    todo!("shoot, task 4: the ledger")
}

/// Task 5: so many shots, from the start.
pub fn refine(room: &Room, shots: usize) -> Progress {
    todo!("shoot, task 5: shot by shot")
}

/// What is handed in.
pub const WORK: Work = Work { brightest, shoot, shown, ledger, refine };
