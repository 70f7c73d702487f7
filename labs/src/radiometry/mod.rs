//! The lab `radiometry`: four quantities of light, and where their π comes from.
//!
//! ```text
//! B = Φ/A     L = B/π     H = Φ cosθ/(4π r²)     H = L A cosθ cosθ'/r²
//! H = ∫ L cosθ dω = ∫∫ L cosθ sinθ dθ dφ         B = ρ H
//! ```
//!
//! The student writes the six functions of [`Work`]. Each is judged against closed forms:
//! the library's, and values of the accuracy tables by other programs (`I3-…`, `I8-…`,
//! `I9-…`).
//!
//! **Not here:** visibility, colour. Chapter *Radiometry* (L03); brief:
//! `book/src/labs/radiometry.md`. Sources: Lambert 1760; Nicodemus et al. 1977.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use given::{Sent, Spot};
use radiosity::prelude::DVec3;

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. The radiosity, W/m², of a diffuse lamp of `area` m² that sends `flux` W.
    pub radiosity: fn(flux: f64, area: f64) -> f64,
    /// 1. Its radiance, W/(m² sr).
    pub radiance: fn(flux: f64, area: f64) -> f64,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. The irradiance, W/m², from a small bulb that sends `flux` W, alike all round.
    pub from_bulb: fn(flux: f64, bulb: DVec3, receiver: Spot) -> f64,
    /// 2. The irradiance from a small diffuse surface of this `radiance` and `area`.
    pub from_surface: fn(radiance: f64, area: f64, source: Spot, receiver: Spot) -> f64,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The irradiance from all directions above a surface, by so many rings; its
    ///    normal is z, and `sky` gives the radiance from a direction of unit length.
    pub from_sky: fn(sky: &dyn Fn(DVec3) -> f64, rings: usize) -> f64,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. What a diffuse surface of this reflectance sends back.
    pub reflected: fn(irradiance: f64, reflectance: f64) -> Sent,
    // ANCHOR_END: task4
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "radiometry",
    title: "Flux, irradiance, radiosity, radiance and π",
    minutes: 60,
    brief: include_str!("../../../book/src/labs/radiometry.md"),
    starter: "labs/src/radiometry/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "A lamp", writes: Some("radiosity, radiance") },
        Task { title: "What arrives", writes: Some("from_bulb, from_surface") },
        Task { title: "From everywhere", writes: Some("from_sky") },
        Task { title: "And back", writes: Some("reflected") },
        Task { title: "All together", writes: None },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
