//! Your work. The brief is `book/src/labs/break-it.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run break-it --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use super::given::{Hidden, Near, Room, Slow};

/// Task 1: two squares so near that points are not enough, and how wrong they are.
pub fn near(wanted: f64) -> Near {
    todo!("break-it, task 1: too near")
}

/// Task 2: a lamp so small that a hemicube misses it this often.
pub fn hidden(cells: u32, missed: f64) -> Hidden {
    todo!("break-it, task 2: between the cells")
}

/// Task 3: the reflectance above which a solver runs away.
pub fn runaway(factors: &[Vec<f64>]) -> f64 {
    todo!("break-it, task 3: a solver that runs away")
}

/// Task 4: a room so white that so many sweeps are needed.
pub fn slow(sweeps: u32, missing: f64) -> Slow {
    todo!("break-it, task 4: a thousand sweeps")
}

/// Task 5: wrong factors that obey all laws.
pub fn lawful(room: &Room, wanted: f64) -> Vec<Vec<f64>> {
    todo!("break-it, task 5: lawful, and wrong")
}

/// What is handed in.
pub const WORK: Work = Work { near, hidden, runaway, slow, lawful };
