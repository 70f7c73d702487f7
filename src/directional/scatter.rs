//! A BRDF in bins: from each into each.

use super::Bins;
use crate::geometry::Rgb;
use crate::material::Brdf;
use glam::{DVec3, dvec2};
use std::f64::consts::PI;

/// What a paint makes of light that arrives in bins: an `m × m` matrix for each channel.
///
/// ```text
/// S_ba = π/m · mean of f(ωᵢ, ωₒ) over ωᵢ in a, ωₒ in b         S_ba = S_ab
/// Σ_b S_ba = mean of the directional albedo over a             in [0, 1]
/// ```
/// # Accuracy
/// The means are taken over points, 32² or more to the hemisphere; that of the albedo, which
/// has a closed form, is right to 2e-3. The matrix is then scaled from both sides until it
/// has these sums, and so neither makes nor loses light. Lambert's BRDF is exact.
#[derive(Debug)]
pub struct Scatter {
    /// `S_ba` at `b m + a`.
    shares: Vec<Rgb>,
    albedo: Vec<Rgb>,
}

/// Points along an edge of the chessboard, at least; and two along that of a bin.
const POINTS: u32 = 32;

/// From here on, relative, scaling stops when it makes the sums no better.
const ROUNDING: f64 = 1e-12;

const MOST_ROUNDS: usize = 1000;

impl Scatter {
    /// That of a BRDF.
    pub fn of(brdf: &Brdf, bins: Bins) -> Scatter {
        let m = bins.len();
        let points: Vec<Vec<DVec3>> = (0..m as u32).map(|b| points(bins, b)).collect();
        let count = points[0].len() as f64;
        // ANCHOR: scatter
        let mean = |a: usize, b: usize| {
            let pairs =
                points[a].iter().flat_map(|i| points[b].iter().map(move |o| (i, o)));
            let sum: Rgb = pairs.map(|(&i, &o)| brdf.value(i, o)).sum();
            PI / m as f64 * sum / (count * count)
        };
        let mut shares = vec![Rgb::ZERO; m * m];
        for (b, a) in (0..m).flat_map(|b| (0..=b).map(move |a| (b, a))) {
            shares[b * m + a] = mean(a, b);
            shares[a * m + b] = shares[b * m + a];
        }
        // ANCHOR_END: scatter
        let albedo = |p: &Vec<DVec3>| {
            p.iter().map(|w| brdf.albedo(w.z.min(1.0))).sum::<Rgb>() / count
        };
        let albedo: Vec<Rgb> = points.iter().map(albedo).collect();
        balance(&mut shares, &albedo);
        Scatter { shares, albedo }
    }

    /// The albedo of a bin: how much of what arrives in it leaves again.
    pub fn albedo(&self, bin: usize) -> Rgb {
        self.albedo[bin]
    }

    /// `S_ba`: the radiance that leaves in bin `to` for radiance 1 that arrives in `from`.
    pub fn share(&self, from: usize, to: usize) -> Rgb {
        self.shares[to * self.albedo.len() + from]
    }

    /// The radiance that leaves in each bin, of what arrives in each.
    pub(super) fn scattered<'a>(
        &'a self,
        incoming: &'a [Rgb],
    ) -> impl Iterator<Item = Rgb> + 'a {
        let rows = self.shares.chunks(self.albedo.len());
        rows.map(move |row| row.iter().zip(incoming).map(|(&s, &l)| s * l).sum())
    }
}

/// The middles of small squares that fill a bin.
fn points(bins: Bins, bin: u32) -> Vec<DVec3> {
    let q = POINTS.div_ceil(bins.side()).max(2);
    let along = |k: u32| (f64::from(k) + 0.5) / f64::from(q);
    (0..q * q).map(|k| bins.direction(bin, dvec2(along(k % q), along(k / q)))).collect()
}

/// Scales a symmetric matrix, `d_b S_ba d_a`, until each row has this sum.
fn balance(shares: &mut [Rgb], sums: &[Rgb]) {
    let m = sums.len();
    let mut scale = vec![Rgb::ONE; m];
    let mut last = f64::INFINITY;
    for _ in 0..MOST_ROUNDS {
        let mut worst = 0.0_f64;
        for (b, &wanted) in sums.iter().enumerate() {
            let row = shares[b * m..][..m].iter().zip(&scale);
            let sum = row.map(|(&s, &d)| s * d).sum::<Rgb>();
            for k in (0..3).filter(|&k| sum[k] > 0.0) {
                let full = wanted[k] / sum[k];
                worst = worst.max((full / scale[b][k] - 1.0).abs());
                // Half way, or it would swing to and fro.
                scale[b][k] = (scale[b][k] * full).sqrt();
            }
        }
        if worst < ROUNDING && worst >= last {
            break;
        }
        last = worst;
    }
    for (k, share) in shares.iter_mut().enumerate() {
        *share *= scale[k / m] * scale[k % m];
    }
}
