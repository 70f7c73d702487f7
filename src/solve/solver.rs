//! What all solvers have in common: a step, a residual, and a bound to stop by.

use super::{Enclosure, Ledger};
use crate::form_factor::Matrix;
use crate::geometry::Rgb;
use crate::mesh::ElementId;

/// What a solver says after a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Step {
    /// Where the light is now.
    pub ledger: Ledger,
    /// `‖r‖ / ‖B − E‖`, area norm, worst channel: algebraic, of the discrete system.
    pub residual: f64,
    /// Which element was shot; `None` for a sweep.
    pub shot: Option<ElementId>,
}

/// A way to solve the radiosity equation step by step.
///
/// It is an iterator: each step leaves a state that can be looked at and says where the
/// light is and what is left to do. `None`: nothing is left, or nothing more can be done.
pub trait Solver: Iterator<Item = Step> {
    /// `B`, W/m², per element.
    fn radiosity(&self) -> &[Rgb];

    /// `H`, W/m², per element: what arrives at the front.
    fn irradiance(&self) -> &[Rgb];

    /// Steps until [`error_bound`] is below `accuracy`, or `most` steps are done.
    // ANCHOR: run
    fn run(&mut self, contraction: f64, accuracy: f64, most: usize) -> Outcome {
        let mut outcome = Outcome::default();
        while outcome.steps < most && !outcome.converged {
            let Some(last) = self.next() else { break };
            let bound = error_bound(last.residual, contraction);
            let (steps, converged) = (outcome.steps + 1, bound <= accuracy);
            outcome = Outcome { steps, last, bound, converged };
        }
        outcome
    }
    // ANCHOR_END: run
}

/// How a run of a solver ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// How many steps were made.
    pub steps: usize,
    /// The last of them.
    pub last: Step,
    /// The error is at most this; see [`error_bound`].
    pub bound: f64,
    /// Is that as accurate as was asked for?
    pub converged: bool,
}

impl Default for Outcome {
    /// No step is made and nothing known.
    fn default() -> Outcome {
        let last = Step::default();
        Outcome { steps: 0, last, bound: f64::INFINITY, converged: false }
    }
}

/// An upper bound of the error of the discrete solution, relative to the reflected light,
/// from the relative residual of a [`Step`]; infinite when none can be given.
///
/// ```text
/// ‖B − B*‖ ≤ ‖r‖ / (1 − c)        r = E + ρ F B − B,   c ≥ ‖ρF‖ the contraction
/// ```
/// For `(1 − ρF)(B* − B) = r`, and so `‖B* − B‖ ≤ ‖r‖ + c ‖B* − B‖`. For reciprocal
/// factors whose rows sum to one at most, `c` is the largest reflectance; for any others
/// [`contraction`] finds one. The size of the last *update* bounds nothing: where light dies
/// out slowly each update is small, and there are many more to come.
pub fn error_bound(residual: f64, contraction: f64) -> f64 {
    if contraction < 1.0 { residual / (1.0 - contraction) } else { f64::INFINITY }
}

/// A bound of `‖ρF‖` in the area norm, worst channel, for any factors, `≥ 0`: what one
/// bounce leaves of a field of light at most.
///
/// ```text
/// c = √( max_i ρ_i Σ_j F_ij  ·  max_j Σ_i A_i ρ_i F_ij / A_j )
/// ```
/// The first is what an element can reflect when all it sees is bright, the second what
/// becomes of the light of one element. Either bounds a norm of its own (the largest value;
/// the power), and the area norm lies between them (Schur's test, 1911). Where factors are
/// reciprocal and rows sum to one at most, neither is above `ρ_max`; where hemicubes invent
/// light the second says so. At 1 or more nothing follows, and [`error_bound`] is infinite.
pub fn contraction(enclosure: &Enclosure, factors: &Matrix) -> f64 {
    let Enclosure { area, reflectance, .. } = enclosure;
    let mut gathered = Rgb::ZERO;
    let mut sent = vec![Rgb::ZERO; area.len()];
    for (i, row) in factors.rows().iter().enumerate() {
        let sum: f64 = row.factors().iter().map(|&(_, f)| f.abs()).sum();
        gathered = gathered.max(reflectance[i] * sum);
        for &(j, f) in row.factors() {
            sent[j as usize] += reflectance[i] * (area[i] * f.abs());
        }
    }
    let share = |(&sent, &area): (&Rgb, &f64)| sent / area;
    let sent = sent.iter().zip(area).map(share).fold(Rgb::ZERO, Rgb::max);
    (gathered * sent).max_element().sqrt()
}
