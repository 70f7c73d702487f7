//! From residuals to errors: `ē = r̄ + K ē`, per stratum.

use super::gathering::Point;
use super::strata::Strata;
use crate::geometry::Rgb;
use crate::material::Material;
use crate::random::Stream;

/// Sweeps at the most.
const MOST_SWEEPS: usize = 200;

/// What is missing may be this share of what is found.
const SETTLED: f64 = 1e-3;

/// So many times the noise of `r̄` is redrawn to see what comes of it.
const REDRAWN: u64 = 8;

/// Which strata light which: `K`, as the rays of all points saw it.
pub(super) struct StrataExchange {
    /// Per stratum, on its front and behind it: other strata, and what `B` there counts
    /// here in `H`.
    rows: [Vec<Vec<(u32, Rgb)>>; 2],
    /// `ρ`, and `τ`.
    shares: [Vec<Rgb>; 2],
    area: Vec<f64>,
}

/// The mean error of each stratum, and how far to trust it.
pub(super) struct Means {
    /// `ē`, of what leaves, W/m².
    pub error: Vec<Rgb>,
    /// `‖K δ‖²`, and the same of what arrives, with `δ` the noise of `ē`; area norm.
    pub noise: Rgb,
    pub arriving_noise: Rgb,
    /// `‖ē‖²`, area norm.
    pub squared: Rgb,
    /// Area norm of what is missing in `ē`, at the most.
    pub missing: Rgb,
    /// `ρ_max`.
    pub reflectance: Rgb,
}

impl StrataExchange {
    /// `material` is that of a stratum.
    pub fn of<'m>(
        strata: &Strata,
        material: impl Fn(usize) -> &'m Material,
        points: &[Point],
    ) -> StrataExchange {
        let mut row = vec![Rgb::ZERO; strata.len()];
        let mut rows_of = |behind: bool| {
            let mut rows = Vec::with_capacity(strata.len());
            for group in points.chunk_by(|a, b| a.stratum == b.stratum) {
                let gathers = 2.0 * group.len() as f64;
                let met = group.iter().flat_map(|p| p.met(behind));
                met.for_each(|&(h, share)| row[h as usize] += share / gathers);
                let lit_by = row.iter().enumerate().filter(|(_, w)| **w != Rgb::ZERO);
                rows.push(lit_by.map(|(h, &w)| (h as u32, w)).collect());
                row.fill(Rgb::ZERO);
            }
            rows
        };
        let share = |of: fn(&Material) -> Rgb| {
            (0..strata.len()).map(|h| of(material(h))).collect()
        };
        StrataExchange {
            rows: [rows_of(false), rows_of(true)],
            shares: [share(Material::diffuse), share(Material::translucence)],
            area: strata.area.clone(),
        }
    }

    /// The mean errors that the mean residuals of `points` lead to.
    pub fn errors(&self, points: &[Point], seed: u64) -> Means {
        let (mut residual, mut doubt) = (Vec::new(), Vec::new());
        for group in points.chunk_by(|a, b| a.stratum == b.stratum) {
            let n = group.len() as f64;
            let both = |p: &Point| 0.5 * (p.residual(0) + p.residual(1));
            let mean = group.iter().map(both).sum::<Rgb>() / n;
            let off: Rgb = group.iter().map(|p| (both(p) - mean).powf(2.0)).sum();
            residual.push(mean);
            doubt.push((off / (n * (n - 1.0))).map(f64::sqrt)); // its standard error
        }
        let (error, missing) = self.solve(&residual);
        let (mut noise, mut arriving_noise) = (Rgb::ZERO, Rgb::ZERO);
        for redrawn in 0..REDRAWN {
            let mut random = Stream::named(seed, &[u64::MAX, redrawn]);
            let mut sign = || if random.next() < 0.5 { -1.0 } else { 1.0 };
            let drawn: Vec<Rgb> = doubt.iter().map(|&d| sign() * d).collect();
            let (error, _) = self.solve(&drawn);
            let arriving = error.iter().zip(&drawn).map(|(e, d)| e - d);
            noise += self.norm_squared(arriving) / REDRAWN as f64;
            let arriving = (0..error.len()).map(|h| self.arriving(h, 0, &error));
            arriving_noise += self.norm_squared(arriving) / REDRAWN as f64;
        }
        let squared = self.norm_squared(error.iter().copied());
        let reflectance = self.largest();
        Means { error, noise, arriving_noise, squared, missing, reflectance }
    }

    /// Gauss–Seidel with an ambient term: `e = r + K e`, and a bound of the norm of what
    /// is missing in it.
    fn solve(&self, residual: &[Rgb]) -> (Vec<Rgb>, Rgb) {
        // What a light of the shape ρ everywhere loses on its way: `Σ A (ρ − K ρ)`.
        let [rho, tau] = &self.shares;
        let shape: Vec<Rgb> = rho.iter().zip(tau).map(|(r, t)| r + t).collect();
        let lost = self.power(|h| shape[h] - self.returned(h, &shape));
        let mut error = residual.to_vec();
        let mut rest = Rgb::INFINITY;
        for _ in 0..MOST_SWEEPS {
            let missing: Vec<Rgb> = (0..error.len())
                .map(|h| residual[h] + self.returned(h, &error) - error[h])
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
                error[h] = residual[h] + self.returned(h, &error);
            }
            // ANCHOR_END: sweep
        }
        (error, rest)
    }

    /// `H` on the front of stratum `h`, or behind it, of what leaves all.
    fn arriving(&self, h: usize, side: usize, leaving: &[Rgb]) -> Rgb {
        self.rows[side][h].iter().map(|&(j, w)| w * leaving[j as usize]).sum()
    }

    /// `ρ H + τ H_behind` of the same.
    fn returned(&self, h: usize, leaving: &[Rgb]) -> Rgb {
        let of = |side: usize| self.shares[side][h] * self.arriving(h, side, leaving);
        of(0) + of(1)
    }

    fn power(&self, of: impl Fn(usize) -> Rgb) -> Rgb {
        self.area.iter().enumerate().map(|(h, &area)| area * of(h)).sum()
    }

    fn norm_squared(&self, x: impl Iterator<Item = Rgb>) -> Rgb {
        self.area.iter().zip(x).map(|(&area, x)| area * x * x).sum()
    }

    fn largest(&self) -> Rgb {
        let both = self.shares[0].iter().zip(&self.shares[1]);
        both.fold(Rgb::ZERO, |most, (rho, tau)| most.max(rho + tau))
    }
}
