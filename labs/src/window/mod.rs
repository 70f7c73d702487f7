//! The lab `window`: clear panes and translucent sheets in form factors.
//!
//! ```text
//! s = ((cosᵢ − n cosₜ)/(cosᵢ + n cosₜ))²      p = ((n cosᵢ − cosₜ)/(n cosᵢ + cosₜ))²
//! T = ½ Σ_{R = s, p} (1 − R)/(1 + R)         a pane: all reflections between its faces
//! F = T(θ_w) cosθ cosθ' A/(π r²)              a small lamp through a clear pane
//! B₀ = ρ H₀ + τ H₁    B₁ = ρ H₁ + τ H₀        the two faces of a translucent sheet
//! ```
//!
//! The student writes the six functions of [`Work`]. Faces, panes and their means are
//! judged against the accuracy tables (`G1-…`, `G4-…`, `G5-…`), the rest against
//! formulas.
//!
//! **Not here:** glass that absorbs; the shift of what is seen through thick glass.
//! Chapter *Windows* (L17); brief: `book/src/labs/window.md`. Sources: Fresnel 1823;
//! Stokes 1862 (piles of plates); Rushmeier & Torrance 1990.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use given::Lamp;
use radiosity::prelude::DVec3;

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. What one face of glass of this index reflects of light from the air, in
    ///    `[0, 1]`: of light that swings across the plane of incidence (s), and in it
    ///    (p). `cosine` is that of the angle to the normal, in `(0, 1]`.
    pub fresnel: fn(cosine: f64, index: f64) -> [f64; 2],
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. What a clear pane passes of unpolarised light: by two faces, with all
    ///    reflections between them.
    pub pane: fn(cosine: f64, index: f64) -> f64,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. What a pane passes of diffuse light, the same from all directions on one
    ///    side: a mean over them by their cosine, in so many rings of equal dθ.
    pub mean: fn(index: f64, rings: usize) -> f64,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. The form factor from the point `p`, with unit normal `n`, to the front of a
    ///    small lamp through a thin pane. A wall without end holds it: what misses its
    ///    outline misses the lamp. Light goes through it either way.
    pub clear: fn(p: DVec3, n: DVec3, pane: &[DVec3], index: f64, lamp: Lamp) -> f64,
    // ANCHOR_END: task4
    // ANCHOR: task5
    /// 5. The radiosities of the two faces of a translucent sheet, of what falls on
    ///    both. Each face reflects ρ and passes τ of what falls on it, diffusely.
    pub sheet: fn(irradiance: [f64; 2], rho: f64, tau: f64) -> [f64; 2],
    // ANCHOR_END: task5
    // ANCHOR: task6
    /// 6. The irradiance at the point `p`, with unit normal `n`, by a translucent sheet
    ///    in the place of the pane. Its front looks into the room; on its back falls
    ///    `outside`, W/m², from whatever direction, and on its front nothing.
    pub frosted: fn(p: DVec3, n: DVec3, pane: &[DVec3], outside: f64, tau: f64) -> f64,
    // ANCHOR_END: task6
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "window",
    title: "A window's form factor",
    minutes: 75,
    brief: include_str!("../../../book/src/labs/window.md"),
    starter: "labs/src/window/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "One face of glass", writes: Some("fresnel") },
        Task { title: "A pane", writes: Some("pane") },
        Task { title: "Diffuse light through a pane", writes: Some("mean") },
        Task { title: "A lamp behind a pane", writes: Some("clear") },
        Task { title: "A translucent sheet", writes: Some("sheet") },
        Task { title: "A room behind paper", writes: Some("frosted") },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
