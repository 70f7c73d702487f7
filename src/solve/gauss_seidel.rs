//! Gathering: the radiosity equation row by row, Gauss–Seidel.

use super::ledger::LostPower;
use super::{Enclosure, Ledger, Solver, Step};
use crate::form_factor::{FormFactors, Matrix};
use crate::geometry::Rgb;

/// Gauss–Seidel: each element in turn gathers from all others' newest radiosities.
///
/// ```text
/// B_i ← E_i + ρ_i Σ_j F_ij B_j
/// ```
/// Converges as `ρ^sweeps` or better; `ρ < 1` is all it needs. A step is one sweep.
pub struct GaussSeidel<'a> {
    enclosure: &'a Enclosure,
    factors: &'a Matrix,
    radiosity: Vec<Rgb>,
    irradiance: Vec<Rgb>,
}

impl<'a> GaussSeidel<'a> {
    /// Starts with `B = E`.
    pub fn new(enclosure: &'a Enclosure, factors: &'a Matrix) -> GaussSeidel<'a> {
        assert_eq!(enclosure.len(), factors.len(), "one row of factors per element");
        let radiosity = enclosure.emission.clone();
        let irradiance = vec![Rgb::ZERO; radiosity.len()];
        GaussSeidel { enclosure, factors, radiosity, irradiance }
    }

    // ANCHOR: gather
    fn gathered(&self, i: usize) -> Rgb {
        let row = self.factors.rows()[i].factors();
        row.iter().map(|&(j, f)| f * self.radiosity[j as usize]).sum()
    }

    fn sweep(&mut self) {
        // ANCHOR: sweep
        for i in 0..self.radiosity.len() {
            let (e, rho) = (self.enclosure.emission[i], self.enclosure.reflectance[i]);
            self.radiosity[i] = e + rho * self.gathered(i);
        }
        // ANCHOR_END: sweep
    }
    // ANCHOR_END: gather
}

impl Iterator for GaussSeidel<'_> {
    type Item = Step;

    fn next(&mut self) -> Option<Step> {
        self.sweep();
        let n = self.radiosity.len();
        self.irradiance = (0..n).map(|i| self.gathered(i)).collect();
        let Enclosure { emission, reflectance, area } = self.enclosure;
        let residual: Vec<Rgb> = (0..n)
            .map(|i| {
                emission[i] + reflectance[i] * self.irradiance[i] - self.radiosity[i]
            })
            .collect();
        let mut lost = LostPower::default();
        for (i, &b) in self.radiosity.iter().enumerate() {
            lost.add(area[i] * b, self.factors.rows()[i].lost());
        }
        Some(Step {
            ledger: Ledger::draw_up(self.enclosure, &self.irradiance, &residual, lost),
            residual: self.enclosure.relative_residual(&residual, &self.radiosity),
            shot: None,
        })
    }
}

impl Solver for GaussSeidel<'_> {
    fn radiosity(&self) -> &[Rgb] {
        &self.radiosity
    }

    fn irradiance(&self) -> &[Rgb] {
        &self.irradiance
    }
}
