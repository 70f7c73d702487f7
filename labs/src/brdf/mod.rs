//! The lab `brdf`: two lobes, their albedo, and samples that follow them.
//!
//! ```text
//! f = ρ/π                                   Lambert
//! f = (n + 2)/2π cosⁿα                      Phong, so normalised that a(0°) = 1
//! a(ωₒ) = ∫ f cosθᵢ dωᵢ ≤ 1                 directional albedo
//! ```
//!
//! The student writes the six functions of [`Work`]. Values are judged against the
//! formulas, albedos against the accuracy tables (`I1-…`, `I3-…`), samples by the moments
//! of their lobe. Directions are local: z is the normal.
//!
//! **Not here:** the closed form of the albedo; that is the library's.
//! Chapters *BRDF* (L04) and *Albedo* (L05); brief: `book/src/labs/brdf.md`.
//! Sources: Phong 1975; Lewis 1993; Lafortune & Willems 1994.

pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use radiosity::prelude::DVec3;

/// A BRDF, of `wi` and `wo`, in 1/sr.
pub type Brdf<'a> = &'a dyn Fn(DVec3, DVec3) -> f64;

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. Lambert's BRDF, in 1/sr. `wi` leads to the light and `wo` to the eye, both
    ///    away from the surface and of unit length; z is the normal. 0 below it.
    pub lambert: fn(reflectance: f64, wi: DVec3, wo: DVec3) -> f64,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. Phong's lobe, in 1/sr: `(n + 2)/2π · cosⁿα`, with `α` the angle between `wi`
    ///    and the mirror image of `wo`. 0 where `α` is a right angle or more.
    pub phong: fn(exponent: f64, wi: DVec3, wo: DVec3) -> f64,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The directional albedo of any BRDF: `∫ f(wi, wo) cosθ dω` over all `wi` above
    ///    the surface, by so many rings of equal dθ with 4 · `rings` pieces each.
    pub albedo: fn(brdf: Brdf, wo: DVec3, rings: usize) -> f64,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. A direction `wi` about the mirror image of `wo`, of two uniform random
    ///    numbers in `[0, 1)`: its density is in proportion to `cosⁿα`.
    pub sample: fn(exponent: f64, wo: DVec3, u: [f64; 2]) -> DVec3,
    /// That density, in 1/sr: over all directions it integrates to 1.
    pub pdf: fn(exponent: f64, wi: DVec3, wo: DVec3) -> f64,
    // ANCHOR_END: task4
    // ANCHOR: task5
    /// 5. Does a material with these diffuse and specular reflectances, each in three
    ///    channels, keep the conservation of energy? A sum of 1 still does.
    pub passive: fn(diffuse: [f64; 3], specular: [f64; 3]) -> bool,
    // ANCHOR_END: task5
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "brdf",
    title: "Lobes, albedo and the white furnace",
    minutes: 75,
    brief: include_str!("../../../book/src/labs/brdf.md"),
    starter: "labs/src/brdf/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "Lambert", writes: Some("lambert") },
        Task { title: "Phong", writes: Some("phong") },
        Task { title: "The albedo", writes: Some("albedo") },
        Task { title: "Samples", writes: Some("sample, pdf") },
        Task { title: "Passive or not", writes: Some("passive") },
        Task { title: "The white furnace", writes: None },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
