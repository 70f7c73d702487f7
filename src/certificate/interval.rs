//! From products at points to norms with bounds.

use super::gathering::Point;
use super::propagate::Means;
use super::strata::Strata;
use crate::geometry::Rgb;
use crate::mesh::Mesh;

/// How sure the bounds are.
pub(super) const CONFIDENCE: f64 = 0.95;

/// So many standard errors to either side: normal numbers are above with a chance of 0.0028,
/// an eighteenth of what [`CONFIDENCE`] leaves. For whoever refines until a bound suffices
/// looks up to eighteen times, and the chance to be deceived once is at most the sum.
const QUANTILE: f64 = 2.77;

/// The share of the error's variation within strata that may reach others: as far as the
/// light from a stratum depends on where on it the error lies.
const UNEVEN: f64 = 0.05;

/// A norm, W/m² times the root of an area, and its bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Norm {
    pub likely: f64,
    pub low: f64,
    pub high: f64,
}

impl Norm {
    /// The norm whose square the products `squares`, one at each point, average to, in
    /// channel `c`; `noise` is `‖K δ‖²`.
    ///
    /// ```text
    /// ‖e‖² = Σ_h A_h mean_h(e₁ e₂) − ‖K δ‖²
    /// σ²   = Σ_h A_h² s_h²/n_h + 4 ‖e‖² ‖K δ‖² + 2 ‖K δ‖⁴
    /// ```
    /// with `δ` the noise of the mean errors that both of a pair have in common.
    pub fn of(
        strata: &Strata,
        points: &[Point],
        squares: &[Rgb],
        noise: Rgb,
        c: usize,
    ) -> Norm {
        let (mut sum, mut variance) = (0.0, 0.0);
        let mut first = 0;
        for group in points.chunk_by(|a, b| a.stratum == b.stratum) {
            let n = group.len() as f64;
            let own = &squares[first..first + group.len()];
            first += group.len();
            let mean = own.iter().map(|s| s[c]).sum::<f64>() / n;
            let off: f64 = own.iter().map(|s| (s[c] - mean).powi(2)).sum();
            let area = strata.area[group[0].stratum as usize];
            sum += area * mean;
            variance += area * area * off / ((n - 1.0) * n);
        }
        // ANCHOR: interval
        let noise = noise[c];
        sum = (sum - noise).max(0.0);
        variance += noise * (4.0 * sum + 2.0 * noise);
        let width = QUANTILE * variance.sqrt();
        let root = |x: f64| x.max(0.0).sqrt();
        Norm { likely: root(sum), low: root(sum - width), high: root(sum + width) }
        // ANCHOR_END: interval
    }

    /// By how much the bounds of this norm of an error are to be moved apart, for what the
    /// noise does not tell.
    pub fn doubt(&self, means: &Means, c: usize) -> f64 {
        let within = (self.likely.powi(2) - means.squared[c]).max(0.0).sqrt();
        means.missing[c] + UNEVEN * means.reflectance[c] * within
    }

    /// With bounds that are farther apart by `doubt` to either side.
    pub fn widened(self, doubt: f64) -> Norm {
        Norm { low: (self.low - doubt).max(0.0), high: self.high + doubt, ..self }
    }
}

/// The mean of `squares` over the strata's area.
pub(super) fn mean(strata: &Strata, points: &[Point], squares: &[Rgb]) -> Rgb {
    let share = |p: &Point| {
        let h = p.stratum as usize;
        strata.area[h] / strata.points[h] as f64
    };
    let sum: Rgb = points.iter().zip(squares).map(|(p, &s)| share(p) * s).sum();
    sum / strata.area.iter().sum::<f64>()
}

/// Per element: the root of the mean of its `squares` over `scale`, worst channel; of its
/// stratum where it has no point of its own. A mean below zero is noise and counts as the
/// same above.
pub(super) fn by_element(
    mesh: &Mesh,
    strata: &Strata,
    points: &[Point],
    squares: &[Rgb],
    scale: Rgb,
) -> Vec<f64> {
    let mut of_element = vec![(Rgb::ZERO, 0.0); mesh.elements.len()];
    let mut of_stratum = vec![(Rgb::ZERO, 0.0); strata.len()];
    for (point, &square) in points.iter().zip(squares) {
        for (sum, count) in [
            &mut of_element[point.element as usize],
            &mut of_stratum[point.stratum as usize],
        ] {
            *sum += square;
            *count += 1.0;
        }
    }
    let mut stratum = vec![None; mesh.elements.len()];
    for (piece, &h) in strata.pieces.iter().zip(&strata.of_piece) {
        stratum[piece.element as usize] = Some(h);
    }
    let value = |k: usize| {
        let (mut sum, mut count) = of_element[k];
        if count == 0.0 {
            let h = stratum[k].map_or(usize::MAX, |h| h as usize);
            (sum, count) = *of_stratum.get(h).unwrap_or(&(Rgb::ZERO, 1.0));
        }
        let mean = (sum / count).abs();
        (0..3).map(|c| super::ratio(mean[c], scale[c]).sqrt()).fold(0.0, f64::max)
    };
    (0..mesh.elements.len()).map(value).collect()
}
