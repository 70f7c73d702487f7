//! Your work. The brief is `book/src/labs/window.md`. Replace each `todo!`, then:
//!
//! ```text
//! cargo lab run window --task 1
//! ```
#![allow(unused)] // until you use what is here; remove this line when you are done

use super::Work;
use super::given::{Lamp, crossing, lambert, plane};
use radiosity::prelude::DVec3;
use std::f64::consts::{FRAC_PI_2, PI};

/// Task 1: what one face reflects of s and p.
pub fn fresnel(cosine: f64, index: f64) -> [f64; 2] {
    todo!("window, task 1: one face of glass")
}

/// Task 2: what a pane passes.
pub fn pane(cosine: f64, index: f64) -> f64 {
    todo!("window, task 2: a pane")
}

/// Task 3: what a pane passes of diffuse light.
pub fn mean(index: f64, rings: usize) -> f64 {
    todo!("window, task 3: diffuse light through a pane")
}

/// Task 4: the form factor to a small lamp through a pane.
pub fn clear(p: DVec3, n: DVec3, pane: &[DVec3], index: f64, lamp: Lamp) -> f64 {
    todo!("window, task 4: a lamp behind a pane")
}

/// Task 5: the radiosities of the two faces of a sheet.
pub fn sheet(irradiance: [f64; 2], rho: f64, tau: f64) -> [f64; 2] {
    todo!("window, task 5: a translucent sheet")
}

/// Task 6: the irradiance behind a sheet.
pub fn frosted(p: DVec3, n: DVec3, pane: &[DVec3], outside: f64, tau: f64) -> f64 {
    todo!("window, task 6: a room behind paper")
}

/// What is handed in.
pub const WORK: Work = Work { fresnel, pane, mean, clear, sheet, frosted };
