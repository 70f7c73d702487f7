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
    /// The most unshot radiosity `ΔB`: the lecture's word; small patches come too
    /// early.
    ByRadiosity,
}

/// Progressive shooting, which is Southwell's relaxation (Gortler, Cohen & Slusallek
/// 1994).
///
/// ```text
/// B_j += ρ_j F_ij A_i/A_j ΔB_i = ρ_j F_ji ΔB_i     and ΔB_j too, for all j;  ΔB_i = 0
/// ```
/// Needs one row of factors a step, that of the element that shoots. Elements without
/// light left to send are never chosen, so that it iterates over emitting elements
/// only. Ends (`None`) when no light is left at all.
///
/// A step takes the time of a row and some `n` additions, to look for the brightest and
/// to draw up the ledger. What it saves is rows: those of elements that never shine are
/// never asked for.
///
/// With factors that are not reciprocal, a hemicube's for instance, it ends at another
/// solution than gathering, as it takes `F_ij A_i/A_j` for `F_ji`: no light is made or
/// lost on the way as long as each row, with what it loses, sums to one.
#[derive(Debug)]
pub struct Shoot<'a> {
    pub(super) enclosure: &'a Enclosure,
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

    /// The power that was shot and reached no front, W.
    pub(super) fn lost(&self) -> Rgb {
        self.lost.escaped + self.lost.absorbed
    }

    /// The brightest `count` elements, brightest first; fewer when fewer have light
    /// left.
    pub fn brightest(&self, count: usize) -> Vec<ElementId> {
        // ANCHOR: brightness
        let brightness = |i: usize| match self.brightest {
            Brightest::ByPower => self.enclosure.area[i] * self.unshot[i].element_sum(),
            Brightest::ByRadiosity => self.unshot[i].element_sum(),
        };
        // ANCHOR_END: brightness
        largest(self.unshot.len(), brightness, count)
    }

    /// How bright the room would be, in W/m², were the unshot light spread evenly:
    ///
    /// ```text
    /// a = Σ A ΔB / Σ A · (1 + ρ̄ + ρ̄² + …) = Σ A ΔB / Σ A (1 − ρ)
    /// ```
    /// with `ρ̄` the area's mean reflectance (Cohen et al. 1988). A guess at the
    /// irradiance that is still to come: too large for rooms that light can leave, and
    /// blind to walls.
    pub fn ambient(&self) -> Rgb {
        // ANCHOR: ambient
        let all = 0..self.enclosure.len();
        let kept = all.map(|i| Rgb::ONE - self.enclosure.scattered(i));
        let kept = self.enclosure.power(kept);
        let unshot = self.enclosure.power(self.unshot.iter().copied());
        unshot / kept
        // ANCHOR_END: ambient
    }

    /// `B_i + ρ_i a`: the radiosity with the [ambient](Shoot::ambient) guess at the
    /// light that is still under way, **for display only**: never part of the solution.
    pub fn with_ambient(&self) -> Vec<Rgb> {
        let ambient = self.ambient();
        let lit = self.radiosity.iter().enumerate();
        lit.map(|(i, &b)| b + self.enclosure.scattered(i) * ambient).collect()
    }

    /// Element `from` shoots `amount` of radiosity, W/m², whoever is the brightest: of
    /// its unshot radiosity `ΔB − amount` is left, which is negative when that is more
    /// than it had. [`Shoot::next`] sends all there is, [`super::Overshoot`] some more.
    pub fn send(&mut self, from: ElementId, amount: Rgb) -> Step {
        let i = from.0 as usize;
        let lost = self.factors.row(from, &mut self.row);
        // ANCHOR: send
        let power = self.enclosure.area[i] * amount;
        self.unshot[i] -= amount;
        self.lost.add(power, lost);
        for (j, &factor) in self.row.iter().enumerate().filter(|(_, f)| **f != 0.0) {
            let arriving = power * factor / self.enclosure.area[j];
            let reflected = self.enclosure.reflectance[j] * arriving;
            self.irradiance[j] += arriving;
            self.radiosity[j] += reflected;
            self.unshot[j] += reflected;
        }
        // ANCHOR_END: send
        self.pass_through(power);
        let (irradiance, unshot) = (&self.irradiance, &self.unshot);
        Step {
            ledger: Ledger::draw_up(self.enclosure, irradiance, unshot, self.lost),
            residual: self.enclosure.relative_residual(unshot, &self.radiosity),
            shot: Some(from),
        }
    }
}

impl Shoot<'_> {
    /// What of this power, shot by the last row, goes through sheets to their other sides.
    fn pass_through(&mut self, power: Rgb) {
        for (j, through) in self.enclosure.through.iter().enumerate() {
            let Some(through) = through else { continue };
            let arriving = power * self.row[j] / self.enclosure.area[j];
            let (passed, back) =
                (through.transmittance * arriving, through.back.0 as usize);
            self.radiosity[back] += passed;
            self.unshot[back] += passed;
        }
    }
}

/// The `count` of `n` elements with the largest value, largest first, of those above 0.
pub(super) fn largest(
    n: usize,
    value: impl Fn(usize) -> f64,
    count: usize,
) -> Vec<ElementId> {
    // ANCHOR: largest
    let mut left: Vec<(f64, usize)> =
        (0..n).map(|i| (value(i), i)).filter(|v| v.0 > 0.0).collect();
    let order =
        |a: &(f64, usize), b: &(f64, usize)| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1));
    if left.len() > count {
        left.select_nth_unstable_by(count, order);
        left.truncate(count);
    }
    left.sort_by(order);
    // ANCHOR_END: largest
    left.into_iter().map(|(_, i)| ElementId(i as u32)).collect()
}

impl Iterator for Shoot<'_> {
    type Item = Step;

    // ANCHOR: shoot
    fn next(&mut self) -> Option<Step> {
        let from = *self.brightest(1).first()?;
        Some(self.send(from, self.unshot[from]))
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
