//! Overshooting: shoot today what will come back tomorrow, but not too much of it.

use super::shoot::largest;
use super::{Brightest, Enclosure, Shoot, Solver, Step};
use crate::form_factor::FormFactors;
use crate::geometry::Rgb;
use crate::mesh::ElementId;

/// Progressive shooting that sends more than is there (Feda & Purgathofer 1992;
/// Gortler, Cohen & Slusallek 1994).
///
/// Of the light under way, element `i` will get some irradiance `a`, and will have to
/// send on `ρ_i a` of it. It sends that now, and owes it: its unshot light turns
/// negative, until what comes back has paid for it. As guess of `a`, the light is
/// spread evenly, as the [ambient](Shoot::ambient) term does, but for the share that
/// leaves the scene; shots so far have told how much.
///
/// ```text
/// k = 1 − lost/sent                  of the power shot so far, what met a front
/// a = k Σ A ΔB / (Σ A − k Σ A ρ)     k U/A · (1 + k ρ̄ + (k ρ̄)² + …)
/// δ_i = ΔB_i + ρ_i a                 what i shoots; ΔB_i − δ_i is left
/// 0 ≤ δ_i/ΔB_i ≤ 1.9                 the safe bound, per channel
/// ```
///
/// **Why it is safe.** With reciprocal factors, `M = diag(A/ρ) (1 − ρF)` is symmetric,
/// and positive definite for `ρ < 1`. Let `e` be the error of what has been sent so
/// far, and `Q = ½ eᵀ M e` its distance from the solution. A shot of `δ_i` changes that
/// by
///
/// ```text
/// Q' − Q = −(A_i/ρ_i) δ_i (ΔB_i − ½ δ_i)
/// ```
/// which is negative whenever `0 < δ_i/ΔB_i < 2`, however wrong the guess `a` is. So
/// each shot comes nearer. From 2 on, it goes away. 1.9 leaves room for factors that
/// are not quite reciprocal.
///
/// While unshot light is negative here and there, radiosities may be too large
/// elsewhere: what is shown early on is no lower bound of the solution, as it is with
/// [`Shoot`].
#[derive(Debug)]
pub struct Overshoot<'a> {
    shoot: Shoot<'a>,
}

impl<'a> Overshoot<'a> {
    /// The safe bound: the largest `δ/ΔB`.
    pub const SAFE: f64 = 1.9;

    /// Starts with `B = ΔB = E`.
    pub fn new(
        enclosure: &'a Enclosure,
        factors: &'a dyn FormFactors,
    ) -> Overshoot<'a> {
        Overshoot { shoot: Shoot::new(enclosure, factors, Brightest::ByPower) }
    }

    /// What has been shot and what is left: the unshot light has either sign.
    pub fn state(&self) -> &Shoot<'a> {
        &self.shoot
    }

    /// The `count` elements that would shoot most, most first.
    pub fn brightest(&self, count: usize) -> Vec<ElementId> {
        let expected = self.expected();
        let power = |i: usize| {
            self.shoot.enclosure.area[i] * self.amount(i, expected).abs().element_sum()
        };
        largest(self.shoot.unshot().len(), power, count)
    }

    /// The irradiance `a` that an element is to expect, W/m².
    fn expected(&self) -> Rgb {
        let enclosure = self.shoot.enclosure;
        let scattered: Vec<Rgb> =
            (0..enclosure.len()).map(|i| enclosure.scattered(i)).collect();
        let power = |x: &[Rgb]| self.shoot.enclosure.power(x.iter().copied());
        // ANCHOR: expected
        let unshot = power(self.shoot.unshot());
        let sent = (power(self.shoot.radiosity()) - unshot).element_sum();
        let lost = self.shoot.lost().element_sum();
        let kept = if sent > 0.0 { (1.0 - lost / sent).clamp(0.0, 1.0) } else { 1.0 };
        let area: f64 = enclosure.area.iter().sum();
        kept * unshot / (area - kept * power(&scattered))
        // ANCHOR_END: expected
    }

    /// Where light goes through sheets, `M` need not be positive: then nothing is sent that
    /// is not there.
    fn safe(&self) -> f64 {
        if self.shoot.enclosure.is_translucent() { 1.0 } else { Overshoot::SAFE }
    }

    // ANCHOR: amount
    /// `δ_i`, W/m².
    fn amount(&self, i: usize, expected: Rgb) -> Rgb {
        let unshot = self.shoot.unshot()[i];
        let wanted = unshot + self.shoot.enclosure.scattered(i) * expected;
        let most = self.safe() * unshot;
        wanted.clamp(most.min(Rgb::ZERO), most.max(Rgb::ZERO))
    }
    // ANCHOR_END: amount
}

impl Iterator for Overshoot<'_> {
    type Item = Step;

    // ANCHOR: overshoot
    fn next(&mut self) -> Option<Step> {
        let from = *self.brightest(1).first()?;
        let amount = self.amount(from.0 as usize, self.expected());
        Some(self.shoot.send(from, amount))
    }
    // ANCHOR_END: overshoot
}

impl Solver for Overshoot<'_> {
    /// What has been emitted and reflected so far.
    fn radiosity(&self) -> &[Rgb] {
        self.shoot.radiosity()
    }

    /// What has arrived so far.
    fn irradiance(&self) -> &[Rgb] {
        self.shoot.irradiance()
    }
}
