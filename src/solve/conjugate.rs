//! Conjugate gradients: of all that so many bounces can be mixed to, the best.

use super::gather::{lit, step, transport};
use super::{Enclosure, Solver, Step};
use crate::form_factor::Matrix;
use crate::geometry::Rgb;

/// Conjugate gradients (Hestenes & Stiefel 1952), each channel by itself, for reciprocal
/// factors.
///
/// The method wants a symmetric system, and `B = E + ρ F B` is none. Two steps make it so.
/// The unknown is what arrives instead of what leaves, and sums weigh it as power:
///
/// ```text
/// H = F E + F ρ H                              B = E + ρ H
/// ⟨x, y⟩ = Σ_i A_i ρ_i x_i y_i
/// ⟨x, Fρ y⟩ = Σ_ij (ρ_i x_i) A_i F_ij (ρ_j y_j) = ⟨Fρ x, y⟩     as A_i F_ij = A_j F_ji
/// ```
/// Black elements weigh nothing: they take no part, and what arrives at them follows from
/// the others. Where light goes through sheets, this product need not be positive: there a
/// step is a bounce, as in [`super::Jacobi`]. In this product the eigenvalues of `1 − Fρ` lie within `1 ± ρ_max`, and the
/// error falls by `q = (1 − √(1 − ρ_max²)) / ρ_max` a step or better: at ρ = 0.99 by 0.868,
/// where a bounce leaves 0.99. Steps grow as `1/√(1 − ρ)`.
///
/// **Fails** where factors are not reciprocal: with those of element centres the residual
/// goes up and down on its way, with few rays it stalls for good - the sooner the nearer ρ
/// is to 1. It is the true residual all the same, so that a bound drawn from it holds.
#[derive(Debug)]
pub struct ConjugateGradients<'a> {
    enclosure: &'a Enclosure,
    factors: &'a Matrix,
    radiosity: Vec<Rgb>,
    /// `F B`: the unknown and its residual together.
    irradiance: Vec<Rgb>,
    /// `H`, the unknown.
    solution: Vec<Rgb>,
    residual: Vec<Rgb>,
    direction: Vec<Rgb>,
    done: bool,
}

impl<'a> ConjugateGradients<'a> {
    /// Starts with `B = E`.
    pub fn new(
        enclosure: &'a Enclosure,
        factors: &'a Matrix,
    ) -> ConjugateGradients<'a> {
        assert_eq!(enclosure.len(), factors.rows().len(), "one row per element");
        let radiosity = enclosure.emission.clone();
        let irradiance = transport(factors, &radiosity);
        ConjugateGradients {
            enclosure,
            factors,
            radiosity,
            solution: vec![Rgb::ZERO; irradiance.len()],
            residual: irradiance.clone(),
            direction: irradiance.clone(),
            irradiance,
            done: false,
        }
    }

    // ANCHOR: product
    /// `⟨x, y⟩ = Σ A ρ x y`.
    fn inner(&self, x: &[Rgb], y: &[Rgb]) -> Rgb {
        let reflected = x.iter().zip(&self.enclosure.reflectance).map(|(&x, &r)| r * x);
        self.enclosure.power(reflected.zip(y).map(|(x, &y)| x * y))
    }

    /// `(1 − Fρ) x`.
    fn applied(&self, x: &[Rgb]) -> Vec<Rgb> {
        let reflectance = &self.enclosure.reflectance;
        let reflected: Vec<Rgb> =
            reflectance.iter().zip(x).map(|(&r, &x)| r * x).collect();
        let arriving = transport(self.factors, &reflected);
        x.iter().zip(arriving).map(|(&x, h)| x - h).collect()
    }
    // ANCHOR_END: product
}

impl Iterator for ConjugateGradients<'_> {
    type Item = Step;

    fn next(&mut self) -> Option<Step> {
        if self.done {
            return None;
        }
        if self.enclosure.is_translucent() {
            self.radiosity = lit(self.enclosure, &self.irradiance);
            self.irradiance = transport(self.factors, &self.radiosity);
            let (b, h) = (&self.radiosity, &self.irradiance);
            return Some(step(self.enclosure, self.factors, b, h));
        }
        // ANCHOR: conjugate
        let change = self.applied(&self.direction);
        let before = self.inner(&self.residual, &self.residual);
        let along = ratio(before, self.inner(&self.direction, &change));
        for (i, change) in change.into_iter().enumerate() {
            self.solution[i] += along * self.direction[i];
            self.residual[i] -= along * change;
        }
        let after = self.inner(&self.residual, &self.residual);
        let keep = ratio(after, before);
        for (p, &r) in self.direction.iter_mut().zip(&self.residual) {
            *p = r + keep * *p;
        }
        // ANCHOR_END: conjugate
        self.radiosity = lit(self.enclosure, &self.solution);
        let arrives = self.solution.iter().zip(&self.residual);
        self.irradiance = arrives.map(|(&h, &r)| h + r).collect();
        self.done = along == Rgb::ZERO;
        Some(step(self.enclosure, self.factors, &self.radiosity, &self.irradiance))
    }
}

impl Solver for ConjugateGradients<'_> {
    fn radiosity(&self) -> &[Rgb] {
        &self.radiosity
    }

    fn irradiance(&self) -> &[Rgb] {
        &self.irradiance
    }
}

/// A quotient per channel; 0 where the divisor is none, for then the channel is done, or
/// factors are so far from reciprocal that this product is no measure of length.
fn ratio(over: Rgb, under: Rgb) -> Rgb {
    let of = |k: usize| if under[k] > 0.0 { over[k] / under[k] } else { 0.0 };
    Rgb::new(of(0), of(1), of(2))
}
