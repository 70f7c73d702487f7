//! Progressive refinement: the brightest element shoots its light, then the next.

use super::ledger::LostPower;
use super::{Enclosure, Ledger, Solver, Step};
use crate::form_factor::FormFactors;
use crate::geometry::Rgb;
use crate::mesh::ElementId;

/// Which element shoots next.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Brightest {
    /// The most unshot power `A ΔB`: what lowers the residual most (Cohen et al. 1988).
    #[default]
    ByPower,
    /// The most unshot radiosity `ΔB`: the lecture's word; small patches come too early.
    ByRadiosity,
}

/// Progressive shooting, which is Southwell's relaxation.
///
/// ```text
/// ΔB_j += ρ_j F_ij A_i/A_j ΔB_i     for all j;  then ΔB_i = 0
/// ```
/// Needs one row of factors a step. Elements that have no light left to send are never
/// chosen, so that it iterates over emitting elements only. Ends (`None`) when no light is
/// left at all.
pub struct Shoot<'a> {
    enclosure: &'a Enclosure,
    factors: &'a dyn FormFactors,
    brightest: Brightest,
    irradiance: Vec<Rgb>,
    radiosity: Vec<Rgb>,
    unshot: Vec<Rgb>,
    row: Vec<f64>,
    lost: LostPower,
}

impl<'a> Shoot<'a> {
    /// Starts with `B = ΔB = E`.
    pub fn new(
        enclosure: &'a Enclosure,
        factors: &'a dyn FormFactors,
        brightest: Brightest,
    ) -> Shoot<'a> {
        assert_eq!(enclosure.len(), factors.len(), "one row of factors per element");
        let n = enclosure.len();
        Shoot {
            enclosure,
            factors,
            brightest,
            irradiance: vec![Rgb::ZERO; n],
            radiosity: enclosure.emission.clone(),
            unshot: enclosure.emission.clone(),
            row: vec![0.0; n],
            lost: LostPower::default(),
        }
    }

    /// `ΔB`, W/m², per element: what is still to be sent.
    pub fn unshot(&self) -> &[Rgb] {
        &self.unshot
    }

    /// The brightest `count` elements, brightest first; fewer when fewer have light left.
    pub fn brightest(&self, count: usize) -> Vec<ElementId> {
        let weight = |i: usize| match self.brightest {
            Brightest::ByPower => self.enclosure.area[i] * self.unshot[i].element_sum(),
            Brightest::ByRadiosity => self.unshot[i].element_sum(),
        };
        let mut left: Vec<(f64, usize)> = (0..self.unshot.len())
            .map(|i| (weight(i), i))
            .filter(|w| w.0 > 0.0)
            .collect();
        let order = |a: &(f64, usize), b: &(f64, usize)| {
            b.0.total_cmp(&a.0).then(a.1.cmp(&b.1))
        };
        if left.len() > count {
            left.select_nth_unstable_by(count, order);
            left.truncate(count);
        }
        left.sort_by(order);
        left.into_iter().map(|(_, i)| ElementId(i as u32)).collect()
    }

    /// `B` plus a guess at the light that is still under way, **for display only**.
    ///
    /// ```text
    /// ambient = Σ A ΔB / Σ A · 1/(1 − ρ̄)     B_i + ρ_i · ambient      (Cohen et al. 1988)
    /// ```
    /// with `ρ̄` the area's mean reflectance. It is wrong for rooms that do not see each
    /// other, and never part of the solution.
    pub fn with_ambient(&self) -> Vec<Rgb> {
        let area: f64 = self.enclosure.area.iter().sum();
        let reflectance = &self.enclosure.reflectance;
        let mean = self.enclosure.power(reflectance.iter().copied()) / area;
        let unshot = self.enclosure.power(self.unshot.iter().copied()) / area;
        let ambient = unshot / (Rgb::ONE - mean);
        self.radiosity
            .iter()
            .zip(reflectance)
            .map(|(&b, &rho)| b + rho * ambient)
            .collect()
    }
}

impl Iterator for Shoot<'_> {
    type Item = Step;

    // ANCHOR: shoot
    fn next(&mut self) -> Option<Step> {
        let from = *self.brightest(1).first()?;
        let i = from.0 as usize;
        let lost = self.factors.row(from, &mut self.row);
        let power = self.enclosure.area[i] * self.unshot[i];
        self.unshot[i] = Rgb::ZERO;
        self.lost.add(power, lost);
        for (j, &factor) in self.row.iter().enumerate().filter(|(_, f)| **f != 0.0) {
            let arriving = power * factor / self.enclosure.area[j];
            let reflected = self.enclosure.reflectance[j] * arriving;
            self.irradiance[j] += arriving;
            self.radiosity[j] += reflected;
            self.unshot[j] += reflected;
        }
        Some(self.step(from))
    }
    // ANCHOR_END: shoot
}

impl Solver for Shoot<'_> {
    /// What has been emitted and reflected so far.
    fn radiosity(&self) -> &[Rgb] {
        &self.radiosity
    }

    /// What has arrived so far.
    fn irradiance(&self) -> &[Rgb] {
        &self.irradiance
    }
}

impl Shoot<'_> {
    fn step(&self, from: ElementId) -> Step {
        let (irradiance, unshot) = (&self.irradiance, &self.unshot);
        Step {
            ledger: Ledger::draw_up(self.enclosure, irradiance, unshot, self.lost),
            residual: self.enclosure.relative_residual(unshot, &self.radiosity),
            shot: Some(from),
        }
    }
}
