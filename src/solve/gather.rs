//! Gathering: what the solvers that hold the whole matrix of form factors share.

use super::ledger::LostPower;
use super::{Enclosure, Ledger, Step};
use crate::form_factor::Matrix;
use crate::geometry::Rgb;
use rayon::prelude::*;

/// `Σ_j F_ij B_j` over some of a row, W/m².
pub fn arriving(row: &[(u32, f64)], radiosity: &[Rgb]) -> Rgb {
    row.iter().map(|&(j, f)| f * radiosity[j as usize]).sum()
}

// ANCHOR: balance
/// `F B`, W/m², per element: what arrives when all of this light is sent once.
pub fn transport(factors: &Matrix, radiosity: &[Rgb]) -> Vec<Rgb> {
    let rows = factors.rows().par_iter().with_min_len(16);
    rows.map(|row| arriving(row.factors(), radiosity)).collect()
}

/// `E + ρ H + τ H_back`, W/m², per element.
pub fn lit(enclosure: &Enclosure, irradiance: &[Rgb]) -> Vec<Rgb> {
    let Enclosure { emission: e, reflectance: rho, .. } = enclosure;
    let of = |i: usize| e[i] + rho[i] * irradiance[i] + enclosure.passed(i, irradiance);
    (0..e.len()).map(of).collect()
}
// ANCHOR_END: balance

/// The account of this light, of which `irradiance` arrives when it is sent: `H = F B`.
pub fn step(
    enclosure: &Enclosure,
    factors: &Matrix,
    radiosity: &[Rgb],
    irradiance: &[Rgb],
) -> Step {
    let mut residual = lit(enclosure, irradiance);
    residual.iter_mut().zip(radiosity).for_each(|(r, &b)| *r -= b);
    let mut lost = LostPower::default();
    for ((&b, &area), row) in radiosity.iter().zip(&enclosure.area).zip(factors.rows())
    {
        lost.add(area * b, row.lost());
    }
    Step {
        ledger: Ledger::draw_up(enclosure, irradiance, &residual, lost),
        residual: enclosure.relative_residual(&residual, radiosity),
        shot: None,
    }
}
