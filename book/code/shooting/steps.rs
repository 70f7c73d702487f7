//! Step by step: what is shown, and what is still to be shot.

use super::{Room, beside, cornell};
use crate::ledger;
use radiosity::film::RgbImage;
use radiosity::solve::{Brightest, Shoot, Step};

/// After how many shots we look.
pub const STAGES: [usize; 5] = [1, 2, 10, 100, 1000];

/// By how much the unshot light is brightened in the pictures.
pub const LIFT: f64 = 4.0;

/// The Cornell box after so many shots.
fn after(room: &Room, shots: usize) -> (Shoot<'_>, Step) {
    let mut solver = Shoot::new(&room.enclosure, &room.factors, Brightest::ByPower);
    let last = solver.by_ref().take(shots).last();
    (solver, last.unwrap_or_default())
}

/// What is shown, what is unshot, and what is shown with the ambient term.
pub fn picture(shots: usize) -> RgbImage {
    use radiosity::solve::Solver;
    let room = cornell();
    let (solver, _) = after(room, shots);
    beside(&[
        room.panel(solver.radiosity(), 1.0),
        room.panel(solver.unshot(), LIFT),
        room.panel(&solver.with_ambient(), 1.0),
    ])
}

/// What is left after so many shots, as a share of what the lamp emits.
pub fn unshot(shots: usize) -> f64 {
    let room = cornell();
    room.share(after(room, shots).0.unshot())
}

/// The caption under a strip.
pub fn caption(shots: usize) -> String {
    let shot = if shots == 1 { "shot" } else { "shots" };
    let left = 100.0 * unshot(shots);
    format!("After {shots} {shot}: {left:.0} % of the emitted light is unshot")
}

/// Where the light is after a hundred shots.
pub fn ledger() -> String {
    ledger::of(&after(cornell(), 100).1.ledger)
}
