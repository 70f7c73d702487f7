//! The lab `cone`: gloss, by a cone about the reflected ray.
//!
//! ```text
//! Ω = 4π sin²(a/2)           Ω⊥ = π sin²a cosθ          a cone of the half angle a
//! share = |cone ∩ lamp| / |cone|                        caps of a sphere
//! L = L_own + k · mean of L over the cone               and so on, to some depth
//! ```
//!
//! The student writes the six functions of [`Work`]. Cones are judged against the
//! accuracy tables (`G12-…`, `I5-…`, `I9-…`, `G11-…`), lamps and rays against closed
//! forms.
//!
//! **Not here:** lobes with a shape (the lab `brdf` has them); polygons in a cone.
//! Chapter *The second pass: the cone* (L20); brief: `book/src/labs/cone.md`. Sources:
//! Amanatides 1984 (cones); Cook, Porter & Carpenter 1984 (stratified rays).

pub mod given;
pub mod starter;
pub mod answer;
pub mod bugs;
pub mod checks;
pub mod report;
pub mod wrong;

use crate::lab::{Lab, Task, Works};
use given::{Cap, Glance, Hit};
use radiosity::prelude::DVec3;
use radiosity::random::Stream;

/// The radiance that comes from a direction.
pub type Light<'a> = &'a dyn Fn(DVec3) -> f64;

/// What is met from a point in a direction.
pub type World<'a> = &'a dyn Fn(DVec3, DVec3) -> Hit;

/// What is to be written, task by task.
pub struct Work {
    // ANCHOR: task1
    /// 1. The solid angle of a cone, in sr; `half_angle` is from its axis to its rim,
    ///    in rad, at most π/2.
    pub solid_angle: fn(half_angle: f64) -> f64,
    // ANCHOR_END: task1
    // ANCHOR: task2
    /// 2. Its projected solid angle, `∫ cosθ dω` in sr, when the axis is tilted so far
    ///    from the normal, in rad, and all of the cone is above the horizon.
    pub projected: fn(half_angle: f64, tilt: f64) -> f64,
    // ANCHOR_END: task2
    // ANCHOR: task3
    /// 3. The share of a cone that a round lamp covers, in `[0, 1]`.
    pub share: fn(cone: Cap, lamp: Cap) -> f64,
    // ANCHOR_END: task3
    // ANCHOR: task4
    /// 4. A direction in a cone, of two uniform random numbers in `[0, 1)`: each
    ///    steradian is as likely.
    pub ray: fn(cone: Cap, u: [f64; 2]) -> DVec3,
    // ANCHOR_END: task4
    // ANCHOR: task5
    /// 5. The mean radiance over a cone by `strata` · `strata` rays: a random one in
    ///    each cell of the unit square. Each `random.next()` is a number in `[0, 1)`.
    pub mean: fn(light: Light, cone: Cap, strata: usize, random: &mut Stream) -> f64,
    // ANCHOR_END: task5
    // ANCHOR: task6
    /// 6. The radiance that a glance meets: the light of what it hits, and its gloss
    ///    times the mean over the cone about the mirrored direction. What is met there
    ///    may be glossy too, `depth` times in all; the next one shows its own light.
    pub gloss: fn(world: World, look: Glance, depth: usize, random: &mut Stream) -> f64,
    // ANCHOR_END: task6
}

/// The lab.
pub const LAB: Lab = Lab {
    name: "cone",
    title: "A cone about the reflected ray",
    minutes: 75,
    brief: include_str!("../../../book/src/labs/cone.md"),
    starter: "labs/src/cone/starter.rs",
    source: include_str!("starter.rs"),
    tasks: &[
        Task { title: "How large is a cone?", writes: Some("solid_angle") },
        Task { title: "And with the cosine?", writes: Some("projected") },
        Task { title: "A round lamp in a cone", writes: Some("share") },
        Task { title: "A ray in a cone", writes: Some("ray") },
        Task { title: "Many rays, one in each cell", writes: Some("mean") },
        Task { title: "Gloss in gloss", writes: Some("gloss") },
    ],
    kit: &Works {
        starter: starter::WORK,
        answer: answer::WORK,
        wrong: &[wrong::ALL],
        checks: checks::ALL,
    },
};
