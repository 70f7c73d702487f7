//! The lab `mirror-world`: a flat mirror is a window into a second world.
//!
//! ```text
//! x' = x − 2 h(x) n                    the image of a point; h its height
//! F_mirror = F(p → image of the lamp)   as far as the mirror's outline shows it
//! F_L = Σ_{|k| ≤ L} ρᵏ F(p → image k)  two mirrors face to face, up to L reflections
//! ```
//!
//! The student writes the six functions of [`Work`]. Factors are judged against the
//! accuracy tables (`G7-…`) and closed forms, and against a virtual *eye*: its image
//! looks out of the mirror at the lamp itself.
//!
//! **Not here:** mirrors in mirrors of any position. Chapter *Mirrors* (L18); brief:
//! `book/src/labs/mirror-world.md`. Sources: Wallace, Cohen & Greenberg 1987;
//! Rushmeier & Torrance 1990.

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use radiosity::prelude::{DVec3, Plane};

/// Outlines that let nothing through.
pub type Cards<'a> = &'a [Vec<DVec3>];

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. The image of the point `x` in the plane of a mirror.
    pub image: fn(mirror: Plane, x: DVec3) -> DVec3,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. The image of what of a convex outline lies in front of the mirror; no corners
    ///    when all lies behind. The image of a front is a front.
    pub image_of: fn(mirror: Plane, corners: &[DVec3]) -> Vec<DVec3>,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. What of a convex outline `eye` sees through a convex window: beyond the
    ///    window's plane, and within its outline. No corners when `eye` is behind it.
    pub through: fn(eye: DVec3, window: &[DVec3], corners: &[DVec3]) -> Vec<DVec3>,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. The form factor from the point `p`, with unit normal `n`, to the front of a
    ///    lamp by way of a perfect mirror, and on no other way.
    pub by_mirror: fn(p: DVec3, n: DVec3, mirror: &[DVec3], lamp: &[DVec3]) -> f64,
    // ANCHOR_END: task4
    // ANCHOR: task5
    /// 5. Does light from the point `x` reach the point `p` by way of the mirror, past
    ///    these cards, which let nothing through?
    pub reaches: fn(x: DVec3, p: DVec3, mirror: &[DVec3], cards: Cards) -> bool,
    // ANCHOR_END: task5
    // ANCHOR: task6
    /// 6. The form factor from the origin, normal z, to the lamp |x| ≤ ½, |y| ≤ ½,
    ///    z = 1, which faces down, between the mirrors x = ½ and x = −½ of unlimited
    ///    extent: straight, and by up to so many reflections, each of which keeps the
    ///    share `reflectance`.
    pub corridor: fn(reflectance: f64, levels: usize) -> f64,
    // ANCHOR_END: task6
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "mirror-world",
    title: "A mirror is a window into a second world",
    minutes: 90,
    brief: include_str!("../../../book/src/labs/mirror-world.md"),
    starter: "labs/src/mirror_world/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "The image of a point", writes: Some("image") },
        Task { title: "The image of an outline", writes: Some("image_of") },
        Task { title: "Through a window", writes: Some("through") },
        Task { title: "The form factor by a mirror", writes: Some("by_mirror") },
        Task { title: "What stands in the way", writes: Some("reaches") },
        Task { title: "Mirrors in mirrors", writes: Some("corridor") },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
