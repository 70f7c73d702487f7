//! The experiment of the report question: how much is missing when a change is small?
//!
//! `cargo run -p labs --example last_change` runs it on the student's work.

use super::Work;
use super::given::Room;
use super::rooms::cuboid;

/// A room of 3 × 2 × 1, one of its small walls a lamp, all of one reflectance.
pub fn room(reflectance: f64) -> Room {
    let mut room = cuboid([3.0, 2.0, 1.0]);
    room.reflectance.fill(reflectance);
    room.emission[0] = 10.0;
    room
}

/// What was found when the last change came to be small.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// After so many bounces or sweeps.
    pub steps: usize,
    /// The last change, the largest over the elements, W/m².
    pub change: f64,
    /// The error, the largest over the elements, W/m².
    pub error: f64,
}

/// Bounces, or sweeps when `newest`, until none of the elements changes by more than
/// `change`.
pub fn until_small(work: &Work, reflectance: f64, change: f64, newest: bool) -> Stop {
    let room = room(reflectance);
    let apart = |a: &[f64], b: &[f64]| {
        a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    let step = |b: &[f64]| {
        if newest {
            let mut b = b.to_vec();
            (work.sweep)(&room, &mut b);
            b
        } else {
            (work.bounce)(&room, b)
        }
    };
    let (mut b, mut steps) = (room.emission.clone(), 0);
    // A step that never settles must not hang: light with a mistake may grow.
    let last = loop {
        let new = step(&b);
        let last = apart(&new, &b);
        (b, steps) = (new, steps + 1);
        if last <= change || steps == 1_000_000 {
            break last;
        }
    };
    let mut exact = b.clone();
    for _ in 0..(1e-14_f64.ln() / reflectance.ln()) as usize {
        exact = step(&exact);
    }
    Stop { steps, change: last, error: apart(&b, &exact) }
}
