//! Anderson's acceleration of a fixed-point iteration.
//!
//! ```text
//! x ← x + f − Σ_j γ_j (Δx_j + Δf_j)        f = G(x) − x,  γ = argmin ‖f − Σ_j γ_j Δf_j‖
//! ```
//! Each round learns from the last few how the iteration answers to a change, and asks for
//! the combination whose remainder is least. For a linear `G` this is GMRES, in other
//! words: where plain rounds would need `1/(1 − ρ)`, it needs a dozen.
//!
//! Sources: Anderson 1965; Walker & Ni 2011.

use crate::geometry::Rgb;

/// How many rounds are remembered.
const DEPTH: usize = 6;

/// The memory of an iteration.
#[derive(Default)]
pub(super) struct Anderson {
    last: Option<(Vec<Rgb>, Vec<Rgb>)>,
    /// `(Δx, Δf)`, newest last.
    steps: Vec<(Vec<Rgb>, Vec<Rgb>)>,
}

impl Anderson {
    /// The next `x`, from this one and `G(x)`.
    pub(super) fn next(&mut self, x: &[Rgb], g: &[Rgb]) -> Vec<Rgb> {
        let f: Vec<Rgb> = g.iter().zip(x).map(|(g, x)| g - x).collect();
        if let Some((old_x, old_f)) = self.last.take() {
            let difference = |a: &[Rgb], b: &[Rgb]| -> Vec<Rgb> {
                a.iter().zip(b).map(|(a, b)| a - b).collect()
            };
            if self.steps.len() == DEPTH {
                self.steps.remove(0);
            }
            self.steps.push((difference(x, &old_x), difference(&f, &old_f)));
        }
        let mut next = g.to_vec();
        for channel in 0..3 {
            let gamma = self.combination(&f, channel);
            for ((dx, df), gamma) in self.steps.iter().zip(gamma) {
                for (k, next) in next.iter_mut().enumerate() {
                    next[channel] -= gamma * (dx[k][channel] + df[k][channel]);
                }
            }
        }
        self.last = Some((x.to_vec(), f));
        next
    }

    /// `γ` of one channel, by the normal equations.
    fn combination(&self, f: &[Rgb], channel: usize) -> Vec<f64> {
        let n = self.steps.len();
        let dot = |a: &[Rgb], b: &[Rgb]| -> f64 {
            a.iter().zip(b).map(|(a, b)| a[channel] * b[channel]).sum()
        };
        let df = |j: usize| &self.steps[j].1[..];
        let mut rows: Vec<Vec<f64>> = (0..n)
            .map(|i| {
                let left = (0..n).map(|j| dot(df(i), df(j)));
                left.chain([dot(df(i), f)]).collect()
            })
            .collect();
        eliminate(&mut rows)
    }
}

/// Solves a small symmetric system, given as rows `[A | b]`; directions in which it is
/// nearly singular are left out.
fn eliminate(rows: &mut [Vec<f64>]) -> Vec<f64> {
    let n = rows.len();
    let size: Vec<f64> = (0..n).map(|k| rows[k][k]).collect();
    // The newest step first: when two are alike, it is the older one that goes.
    for k in (0..n).rev() {
        if rows[k][k] <= 1e-12 * size[k] || rows[k][k] <= 0.0 {
            rows[k].fill(0.0);
            continue;
        }
        let pivot = rows[k].clone();
        for row in rows.iter_mut().enumerate().filter(|(i, _)| *i != k).map(|(_, r)| r)
        {
            let share = row[k] / pivot[k];
            row.iter_mut().zip(&pivot).for_each(|(a, p)| *a -= share * p);
        }
    }
    let solution =
        |k: usize| if rows[k][k] > 0.0 { rows[k][n] / rows[k][k] } else { 0.0 };
    (0..n).map(solution).collect()
}
