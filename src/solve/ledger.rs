//! Where the light is: every watt that was emitted, accounted for.

use super::Enclosure;
use crate::form_factor::Lost;
use crate::geometry::Rgb;

/// The energy account of a solution, per channel, in W (scene units being metres).
///
/// ```text
/// emitted = absorbed + escaped + unshot + imbalance
/// ```
/// The first four are counted, each by itself; the imbalance is what a method's factors
/// invent (negative) or lose (positive). It is zero to rounding when the factors are
/// reciprocal and, with what is lost, sum to one in each row.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ledger {
    /// `Σ A E`.
    pub emitted: Rgb,
    /// `Σ A (1 − ρ − τ) H`, and what falls on black backs or is cut off; less what mirrors and
    /// panes send on.
    pub absorbed: Rgb,
    /// What leaves the scene, as the factors' method counts it.
    pub escaped: Rgb,
    /// What is still to be sent: `Σ A r`, signed.
    pub unshot: Rgb,
    /// `emitted − absorbed − escaped − unshot`.
    pub imbalance: Rgb,
}

impl Ledger {
    /// Draws the account up: `irradiance` has arrived, `residual` is not sent yet, and
    /// `lost` reached no front.
    pub fn draw_up(
        enclosure: &Enclosure,
        irradiance: &[Rgb],
        residual: &[Rgb],
        lost: LostPower,
    ) -> Ledger {
        // ANCHOR: draw_up
        let emitted = enclosure.power(enclosure.emission.iter().copied());
        let kept = |(i, &h): (usize, &Rgb)| (Rgb::ONE - enclosure.scattered(i)) * h;
        let absorbed = enclosure.power(irradiance.iter().enumerate().map(kept));
        let absorbed = absorbed + lost.absorbed;
        let unshot = enclosure.power(residual.iter().copied());
        let imbalance = emitted - absorbed - lost.escaped - unshot;
        Ledger { emitted, absorbed, escaped: lost.escaped, unshot, imbalance }
        // ANCHOR_END: draw_up
    }

    /// Is every entry a number?
    pub fn is_finite(&self) -> bool {
        let Ledger { emitted, absorbed, escaped, unshot, imbalance } = *self;
        (emitted + absorbed + escaped + unshot + imbalance).is_finite()
    }

    /// The largest share of the emitted power that is out of balance, over the channels.
    pub fn worst_imbalance(&self) -> f64 {
        let share = |k: usize| match self.emitted[k] {
            0.0 => self.imbalance[k].abs(),
            emitted => self.imbalance[k].abs() / emitted,
        };
        (0..3).map(share).fold(0.0, f64::max)
    }
}

/// Power that reached no front, in W.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LostPower {
    /// Left the scene.
    pub escaped: Rgb,
    /// Fell on black backs, or is cut off; less what mirrors send on.
    pub absorbed: Rgb,
}

impl LostPower {
    /// Adds the lost shares of this much power.
    pub fn add(&mut self, power: Rgb, lost: Lost) {
        self.escaped += power * lost.escaped;
        self.absorbed += power * (lost.absorbed + lost.cut);
    }

    /// Is there any?
    pub fn any(&self) -> bool {
        *self != LostPower::default()
    }
}
