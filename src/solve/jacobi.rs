//! Jacobi's iteration: all the light makes one more bounce.

use super::gather::{lit, step, transport};
use super::{Enclosure, Solver, Step};
use crate::form_factor::Matrix;
use crate::geometry::Rgb;

/// Jacobi: every element gathers from the radiosities of the step before.
///
/// ```text
/// B ← E + ρ F B          after k steps  B = E + ρF E + … + (ρF)^k E: k bounces
/// ```
/// What is missing is the light that bounces more often: of a closed room of one
/// reflectance exactly the share `ρ^(k+1)`. The order of the elements does not matter, and
/// they can be done all at once.
#[derive(Debug)]
pub struct Jacobi<'a> {
    enclosure: &'a Enclosure,
    factors: &'a Matrix,
    radiosity: Vec<Rgb>,
    irradiance: Vec<Rgb>,
}

impl<'a> Jacobi<'a> {
    /// Starts with `B = E`.
    pub fn new(enclosure: &'a Enclosure, factors: &'a Matrix) -> Jacobi<'a> {
        assert_eq!(enclosure.len(), factors.rows().len(), "one row per element");
        let radiosity = enclosure.emission.clone();
        let irradiance = transport(factors, &radiosity);
        Jacobi { enclosure, factors, radiosity, irradiance }
    }
}

impl Iterator for Jacobi<'_> {
    type Item = Step;

    // ANCHOR: bounce
    fn next(&mut self) -> Option<Step> {
        self.radiosity = lit(self.enclosure, &self.irradiance);
        self.irradiance = transport(self.factors, &self.radiosity);
        Some(step(self.enclosure, self.factors, &self.radiosity, &self.irradiance))
    }
    // ANCHOR_END: bounce
}

impl Solver for Jacobi<'_> {
    fn radiosity(&self) -> &[Rgb] {
        &self.radiosity
    }

    fn irradiance(&self) -> &[Rgb] {
        &self.irradiance
    }
}
