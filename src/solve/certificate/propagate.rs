//! From residuals to errors: `ē = r̄ + K ē`, per stratum.

use super::gathering::Point;
use super::interval::Norm;
use super::strata::{NONE, Strata};
use crate::geometry::Rgb;
use crate::random::Stream;
use crate::solve::Enclosure;

/// Sweeps at the most; each leaves `ρ` or less of what was missing.
const MOST_SWEEPS: usize = 1000;

/// What is missing may be this share of what is found.
const SETTLED: f64 = 1e-3;

/// So many times the noise of `r̄` is redrawn to see what comes of it.
const REDRAWN: u64 = 8;

/// Which strata light which: `K`, as the rays of all points saw it.
pub(super) struct Exchange {
    /// Per stratum: other strata and the share of its irradiance due to each.
    rows: Vec<Vec<(u32, f64)>>,
    reflectance: Vec<Rgb>,
    area: Vec<f64>,
}

/// The mean error of each stratum, and how far to trust it.
pub(super) struct Means {
    /// `ē`, W/m².
    pub error: Vec<Rgb>,
    /// Area norm of the noise of `K ē`, W/m² times the root of an area.
    noise: Rgb,
    /// Area norm of what sweeps left over.
    rest: Rgb,
    /// `ρ_max`.
    reflectance: Rgb,
    /// Area norm of `ē`, squared.
    squared: Rgb,
}

impl Means {
    /// By how much the norm of the error, in channel `c`, may be off because of `ē`.
    pub fn doubt(&self, error: &Norm, c: usize) -> f64 {
        let within = (error.likely.powi(2) - self.squared[c]).max(0.0).sqrt();
        super::interval::QUANTILE * self.noise[c]
            + self.rest[c]
            + UNEVEN * self.reflectance[c] * within
    }
}

/// The share of the error's variation within strata that may reach others.
const UNEVEN: f64 = 0.1;

impl Exchange {
    pub fn of(strata: &Strata, enclosure: &Enclosure, points: &[Point]) -> Exchange {
        let mut row = vec![0.0; strata.len()];
        let mut rows = Vec::with_capacity(strata.len());
        for of_stratum in points.chunk_by(|a, b| a.stratum == b.stratum) {
            let sets = || of_stratum.iter().flat_map(|p| &p.met);
            let rays: usize = sets().map(Vec::len).sum();
            sets()
                .flatten()
                .filter(|&&h| h != NONE)
                .for_each(|&h| row[h as usize] += 1.0);
            let nonzero = row.iter().enumerate().filter(|(_, w)| **w > 0.0);
            rows.push(nonzero.map(|(h, w)| (h as u32, w / rays as f64)).collect());
            row.fill(0.0);
        }
        let of_stratum = |m: &std::ops::Range<usize>| {
            enclosure.reflectance[strata.pieces[m.start].element as usize]
        };
        Exchange {
            rows,
            reflectance: strata.members.iter().map(of_stratum).collect(),
            area: strata.area.clone(),
        }
    }

    /// The mean errors that the mean residuals of `points` lead to.
    pub fn errors(&self, strata: &Strata, points: &[Point], seed: u64) -> Means {
        let groups: Vec<&[Point]> =
            points.chunk_by(|a, b| a.stratum == b.stratum).collect();
        let mean = |group: &&[Point]| {
            let sum: Rgb = group.iter().map(|p| p.residual[0] + p.residual[1]).sum();
            0.5 * sum / group.len() as f64
        };
        let residual: Vec<Rgb> = groups.iter().map(mean).collect();
        // Standard error of each mean.
        let doubt = |(group, mean): (&&[Point], &Rgb)| {
            let off =
                |p: &Point| (0.5 * (p.residual[0] + p.residual[1]) - mean).powf(2.0);
            let n = group.len() as f64;
            (group.iter().map(off).sum::<Rgb>() / (n * (n - 1.0))).map(f64::sqrt)
        };
        let doubt: Vec<Rgb> = groups.iter().zip(&residual).map(doubt).collect();
        let (error, rest) = self.solve(&residual);
        let mut noise = Rgb::ZERO;
        for redrawn in 0..REDRAWN {
            let mut random = Stream::named(seed, &[u64::MAX, redrawn]);
            let mut draw = || if random.next() < 0.5 { -1.0 } else { 1.0 };
            let drawn: Vec<Rgb> = doubt.iter().map(|&d| draw() * d).collect();
            let (error, _) = self.solve(&drawn);
            let arrived = error.iter().zip(&drawn).map(|(e, d)| e - d);
            noise += self.norm_squared(arrived) / REDRAWN as f64;
        }
        let squared = self.norm_squared(error.iter().copied());
        let reflectance = self.reflectance.iter().fold(Rgb::ZERO, |m, &r| m.max(r));
        debug_assert_eq!(groups.len(), strata.len());
        Means { error, noise: noise.map(f64::sqrt), rest, reflectance, squared }
    }

    /// Gauss–Seidel: `e = r + K e`, and a bound of the norm of what is missing.
    fn solve(&self, residual: &[Rgb]) -> (Vec<Rgb>, Rgb) {
        let largest = self.reflectance.iter().fold(Rgb::ZERO, |m, &r| m.max(r));
        let mut error = residual.to_vec();
        let mut rest = Rgb::INFINITY;
        for _ in 0..MOST_SWEEPS {
            let mut change = Rgb::ZERO;
            for h in 0..error.len() {
                let sent: Rgb =
                    self.rows[h].iter().map(|&(j, w)| w * error[j as usize]).sum();
                let new = residual[h] + self.reflectance[h] * sent;
                change += self.area[h] * (new - error[h]).powf(2.0);
                error[h] = new;
            }
            rest = change.map(f64::sqrt) * largest / (Rgb::ONE - largest);
            let found = self.norm_squared(error.iter().copied()).map(f64::sqrt);
            if rest.cmple(SETTLED * found).all() {
                break;
            }
        }
        (error, rest)
    }

    fn norm_squared(&self, x: impl Iterator<Item = Rgb>) -> Rgb {
        self.area.iter().zip(x).map(|(&area, x)| area * x * x).sum()
    }
}
