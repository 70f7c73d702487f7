//! What all solvers have in common: a step, a residual, and a bound to stop by.

use super::{Enclosure, Ledger};
use crate::form_factor::{Matrix, Row};
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

    /// Steps until [`error_bound`] is below `accuracy`, or nothing but rounding is left, or
    /// `most` steps are done.
    // ANCHOR: run
    fn run(&mut self, contraction: f64, accuracy: f64, most: usize) -> Outcome {
        let mut outcome = Outcome::default();
        let done =
            |o: &Outcome| o.converged || o.steps > 0 && o.last.residual < ROUNDING;
        while outcome.steps < most && !done(&outcome) {
            let Some(last) = self.next() else { break };
            let bound = error_bound(last.residual, contraction);
            let (steps, converged) = (outcome.steps + 1, bound <= accuracy);
            outcome = Outcome { steps, last, bound, converged };
        }
        outcome
    }
    // ANCHOR_END: run
}

/// A relative residual that is no more than rounding.
const ROUNDING: f64 = 1e-15;

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
/// ‖ρF‖² = largest eigenvalue of (ρF)°ρF  ≤  max_j ((ρF)°ρF x)_j / x_j      for any x > 0
/// (ρF)°_ji = A_i ρ_i F_ij / A_j                                   the adjoint: light sent back
/// ```
/// The bound for matrices without negative entries is Collatz's (1942). With `x = 1` it is
/// at most the largest row sum of `ρF` times that of its adjoint; each further `x`, the
/// image of the one before, comes nearer to the truth. Where factors are reciprocal and
/// rows sum to one at most, no row sum of the two exceeds `ρ_max`, and neither does this.
/// Where hemicubes invent light, or rays miss a sliver, it tells how much that matters. At 1
/// or more nothing follows, and [`error_bound`] is infinite.
pub fn contraction(enclosure: &Enclosure, factors: &Matrix) -> f64 {
    let mut x = vec![Rgb::ONE; enclosure.len()];
    let mut bound = Rgb::INFINITY;
    for _ in 0..ROUNDS {
        let y = there_and_back(enclosure, factors, &x);
        let ratios =
            y.iter().zip(&x).map(|(&y, &x)| Rgb::select(y.cmpgt(Rgb::ZERO), y / x, y));
        bound = bound.min(ratios.fold(Rgb::ZERO, Rgb::max));
        x = y; // what nobody reflects stays 0, and counts for nobody
    }
    bound.max_element().sqrt()
}

/// Products that a bound is worth: each costs as much as two bounces.
const ROUNDS: usize = 4;

/// `(ρF)°ρF x`.
fn there_and_back(enclosure: &Enclosure, factors: &Matrix, x: &[Rgb]) -> Vec<Rgb> {
    let Enclosure { area, reflectance, .. } = enclosure;
    let arriving = |row: &Row| -> Rgb {
        row.factors().iter().map(|&(j, f)| f.abs() * x[j as usize]).sum()
    };
    // Reflecting and letting through is its own adjoint: done there, and done back.
    let scattered = |h: Vec<Rgb>| -> Vec<Rgb> {
        let of = |i: usize| reflectance[i] * h[i] + enclosure.passed(i, &h);
        (0..h.len()).map(of).collect()
    };
    let sent = scattered(scattered(factors.rows().iter().map(arriving).collect()));
    let mut back = vec![Rgb::ZERO; x.len()];
    for ((row, &sent), &area) in factors.rows().iter().zip(&sent).zip(area) {
        let row = row.factors();
        row.iter().for_each(|&(j, f)| back[j as usize] += f.abs() * area * sent);
    }
    back.iter().zip(area).map(|(&back, &area)| back / area).collect()
}
