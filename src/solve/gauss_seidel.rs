//! Gauss–Seidel: the radiosity equation row by row.

use super::gather::{arriving, step};
use super::{Enclosure, Solver, Step};
use crate::form_factor::Matrix;
use crate::geometry::Rgb;

/// Gauss–Seidel: each element in turn gathers from all others' newest radiosities.
///
/// ```text
/// B_i ← E_i + ρ_i ( Σ_{j<i} F_ij B_j  +  Σ_{j≥i} F_ij B_j )
///                     new already          from last time
/// ```
/// A step is one sweep over the elements, and in a closed room does about as much as two
/// bounces of [`super::Jacobi`], for the work of one: the second sum is made when the sweep
/// is over, for the residual, and is there when the next begins.
#[derive(Debug)]
pub struct GaussSeidel<'a> {
    enclosure: &'a Enclosure,
    factors: &'a Matrix,
    radiosity: Vec<Rgb>,
    irradiance: Vec<Rgb>,
    /// `Σ_{j≥i} F_ij B_j`.
    later: Vec<Rgb>,
}

impl<'a> GaussSeidel<'a> {
    /// Starts with `B = E`.
    pub fn new(enclosure: &'a Enclosure, factors: &'a Matrix) -> GaussSeidel<'a> {
        assert_eq!(enclosure.len(), factors.rows().len(), "one row per element");
        let radiosity = enclosure.emission.clone();
        let (irradiance, later) = (Vec::new(), Vec::new());
        let mut start =
            GaussSeidel { enclosure, factors, radiosity, irradiance, later };
        start.irradiance = vec![Rgb::ZERO; enclosure.len()];
        start.later = start.gather_later();
        start
    }

    /// The factors of row `i`, those to elements before it apart from all others.
    fn halves(&self, i: usize) -> [&'a [(u32, f64)]; 2] {
        let row = self.factors.rows()[i].factors();
        let (earlier, later) = row.split_at(row.partition_point(|f| f.0 < i as u32));
        [earlier, later]
    }

    fn gather_later(&self) -> Vec<Rgb> {
        let n = self.radiosity.len();
        (0..n).map(|i| arriving(self.halves(i)[1], &self.radiosity)).collect()
    }

    /// `τ H_back` by the newest radiosities.
    fn passed(&self, i: usize) -> Rgb {
        let Some(Some(t)) = self.enclosure.through.get(i) else { return Rgb::ZERO };
        let row = self.factors.rows()[t.back].factors();
        t.transmittance * arriving(row, &self.radiosity)
    }

    // ANCHOR: sweep
    fn sweep(&mut self) {
        for i in 0..self.radiosity.len() {
            let (e, rho) = (self.enclosure.emission[i], self.enclosure.reflectance[i]);
            let earlier = arriving(self.halves(i)[0], &self.radiosity);
            let passed = self.passed(i);
            self.radiosity[i] = e + rho * (earlier + self.later[i]) + passed;
            self.irradiance[i] = earlier;
        }
        self.later = self.gather_later();
        self.irradiance.iter_mut().zip(&self.later).for_each(|(h, l)| *h += l);
    }
    // ANCHOR_END: sweep
}

impl Iterator for GaussSeidel<'_> {
    type Item = Step;

    fn next(&mut self) -> Option<Step> {
        self.sweep();
        Some(step(self.enclosure, self.factors, &self.radiosity, &self.irradiance))
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
