//! From residuals to errors: `ē = r̄ + K ē`, per stratum.

use super::gathering::Point;
use super::strata::Strata;
use crate::geometry::Rgb;
use crate::random::Stream;

/// Sweeps at the most.
const MOST_SWEEPS: usize = 200;

/// What is missing may be this share of what is found.
const SETTLED: f64 = 1e-3;

/// So many times the noise of `r̄` is redrawn to see what comes of it.
const REDRAWN: u64 = 8;

/// Which strata light which: `K`, as the rays of all points saw it.
pub(super) struct StrataExchange {
    /// Per stratum: other strata and what `B` there counts here.
    rows: Vec<Vec<(u32, Rgb)>>,
    /// `ρ + τ`.
    reflectance: Vec<Rgb>,
    area: Vec<f64>,
}

/// The mean error of each stratum, and how far to trust it.
pub(super) struct Means {
    /// `ē`, W/m².
    pub error: Vec<Rgb>,
    /// `‖K δ‖²`, with `δ` the noise of `ē`; area norm.
    pub noise: Rgb,
    /// `‖ē‖²`, area norm.
    pub squared: Rgb,
    /// Area norm of what is missing in `ē`, at the most.
    pub missing: Rgb,
    /// `ρ_max`.
    pub reflectance: Rgb,
}

impl StrataExchange {
    /// `scattered` is `ρ + τ` per element.
    pub fn of(strata: &Strata, scattered: &[Rgb], points: &[Point]) -> StrataExchange {
        let mut row = vec![Rgb::ZERO; strata.len()];
        let mut rows = Vec::with_capacity(strata.len());
        for group in points.chunk_by(|a, b| a.stratum == b.stratum) {
            let gathers = 2.0 * group.len() as f64;
            let met = group.iter().flat_map(|p| &p.met).flatten();
            met.for_each(|&(h, share)| row[h as usize] += share / gathers);
            let lit_by = row.iter().enumerate().filter(|(_, w)| **w != Rgb::ZERO);
            rows.push(lit_by.map(|(h, &w)| (h as u32, w)).collect());
            row.fill(Rgb::ZERO);
        }
        let element = |h: usize| strata.pieces[strata.members[h].start].element;
        let reflectance = (0..strata.len()).map(|h| scattered[element(h) as usize]);
        StrataExchange {
            rows,
            reflectance: reflectance.collect(),
            area: strata.area.clone(),
        }
    }

    /// The mean errors that the mean residuals of `points` lead to.
    pub fn errors(&self, points: &[Point], seed: u64) -> Means {
        let (mut residual, mut doubt) = (Vec::new(), Vec::new());
        for group in points.chunk_by(|a, b| a.stratum == b.stratum) {
            let n = group.len() as f64;
            let both = |p: &Point| 0.5 * (p.residual[0] + p.residual[1]);
            let mean = group.iter().map(both).sum::<Rgb>() / n;
            let off: Rgb = group.iter().map(|p| (both(p) - mean).powf(2.0)).sum();
            residual.push(mean);
            doubt.push((off / (n * (n - 1.0))).map(f64::sqrt)); // its standard error
        }
        let (error, missing) = self.solve(&residual);
        let mut noise = Rgb::ZERO;
        for redrawn in 0..REDRAWN {
            let mut random = Stream::named(seed, &[u64::MAX, redrawn]);
            let mut sign = || if random.next() < 0.5 { -1.0 } else { 1.0 };
            let drawn: Vec<Rgb> = doubt.iter().map(|&d| sign() * d).collect();
            let (error, _) = self.solve(&drawn);
            let arriving = error.iter().zip(&drawn).map(|(e, d)| e - d);
            noise += self.norm_squared(arriving) / REDRAWN as f64;
        }
        let squared = self.norm_squared(error.iter().copied());
        Means { error, noise, squared, missing, reflectance: self.largest() }
    }

    /// Gauss–Seidel with an ambient term: `e = r + K e`, and a bound of the norm of what
    /// is missing in it.
    fn solve(&self, residual: &[Rgb]) -> (Vec<Rgb>, Rgb) {
        // What a light of the shape ρ everywhere loses on its way: `Σ A (ρ − K ρ)`.
        let shape = &self.reflectance;
        let lost = self.power(|h| shape[h] - self.arriving(h, shape));
        let mut error = residual.to_vec();
        let mut rest = Rgb::INFINITY;
        for _ in 0..MOST_SWEEPS {
            let missing: Vec<Rgb> = (0..error.len())
                .map(|h| residual[h] + self.arriving(h, &error) - error[h])
                .collect();
            let norm = |x: &[Rgb]| self.norm_squared(x.iter().copied()).map(f64::sqrt);
            rest = norm(&missing) / (Rgb::ONE - self.largest());
            if rest.cmple(SETTLED * norm(&error)).all() {
                break;
            }
            // ANCHOR: sweep
            let ambient = self.power(|h| missing[h]) / lost;
            let ambient = ambient.map(|a| if a.is_finite() { a } else { 0.0 });
            for h in 0..error.len() {
                error[h] += ambient * shape[h];
            }
            for h in 0..error.len() {
                error[h] = residual[h] + self.arriving(h, &error);
            }
            // ANCHOR_END: sweep
        }
        (error, rest)
    }

    /// `ρ H` on stratum `h` of what leaves all.
    fn arriving(&self, h: usize, leaving: &[Rgb]) -> Rgb {
        self.rows[h].iter().map(|&(j, w)| w * leaving[j as usize]).sum()
    }

    fn power(&self, of: impl Fn(usize) -> Rgb) -> Rgb {
        self.area.iter().enumerate().map(|(h, &area)| area * of(h)).sum()
    }

    fn norm_squared(&self, x: impl Iterator<Item = Rgb>) -> Rgb {
        self.area.iter().zip(x).map(|(&area, x)| area * x * x).sum()
    }

    fn largest(&self) -> Rgb {
        self.reflectance.iter().fold(Rgb::ZERO, |m, &r| m.max(r))
    }
}
