//! The experiment of the report question: what is foretold, and what is found.
//!
//! `cargo run -p labs --example foretold` runs it on the student's work.

use super::Work;
use super::given::{by_middles, jacobi, search, too_near};
use radiosity::random::Stream;

/// One failure: what was turned, what the student foretold, what was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// The distance, or the lamp's side.
    pub knob: f64,
    /// By the student.
    pub foretold: f64,
    /// By the method.
    pub found: f64,
}

/// Task 1 at smaller and smaller errors, and at larger ones than its law is for.
pub fn errors(work: &Work) -> Vec<Found> {
    let of = |wanted: &f64| {
        let near = (work.near)(*wanted);
        let (knob, foretold) = (near.distance, near.error);
        Found { knob, foretold, found: too_near(knob) }
    };
    [0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0].iter().map(of).collect()
}

/// Task 2 with 32 × 32 cells: the share of places that miss the lamp.
pub fn misses(work: &Work) -> Vec<Found> {
    let of = |missed: &f64| {
        let mut stream = Stream::named(1, &[(1e3 * missed) as u64]);
        let knob = (work.hidden)(32, *missed).side;
        Found { knob, foretold: *missed, found: search(32, knob, 45, &mut stream)[0] }
    };
    [0.1, 0.3, 0.5, 0.7, 0.9].iter().map(of).collect()
}

/// Task 3 in cubes of more and more elements: how much a bounce adds with ρ = 0.9.
pub fn growth(work: &Work) -> Vec<Found> {
    let of = |k: usize| {
        let factors = by_middles([1.0; 3], k);
        let run = jacobi(&factors, 0.9, 201);
        let found = (run[200] - run[199]) / (run[199] - run[198]);
        Found { knob: k as f64, foretold: 0.9 / (work.runaway)(&factors), found }
    };
    (1..=6).map(of).collect()
}
