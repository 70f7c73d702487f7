//! One right answer: Gauss's rule in all four variables.
#![deny(warnings)]

use super::Work;
use super::given::{Pair, gauss};

/// Task 1: the error first, then its square, the mean and the root.
pub fn off(answers: &[f64], exact: f64) -> f64 {
    let squares: f64 = answers.iter().map(|a| (a / exact - 1.0).powi(2)).sum();
    (squares / answers.len() as f64).sqrt()
}

/// Task 2: each against all.
pub fn frontier(trials: &[(f64, f64)]) -> Vec<usize> {
    let beats = |a: (f64, f64), b: (f64, f64)| a.0 <= b.0 && a.1 <= b.1 && a != b;
    let stands = |&k: &usize| !trials.iter().any(|&other| beats(other, trials[k]));
    (0..trials.len()).filter(stands).collect()
}

/// Task 3: the line through the middle of the logarithms.
pub fn slope(trials: &[(f64, f64)]) -> f64 {
    let counts = trials.iter().filter(|(time, error)| *time > 0.0 && *error > 0.0);
    let logs: Vec<(f64, f64)> = counts.map(|(t, e)| (t.ln(), e.ln())).collect();
    let n = logs.len() as f64;
    let x = logs.iter().map(|p| p.0).sum::<f64>() / n;
    let y = logs.iter().map(|p| p.1).sum::<f64>() / n;
    let upward: f64 = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    upward / logs.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}

/// Task 4: k places in each of four variables, as many as k⁴ evaluations allow.
pub fn factor(pair: &Pair, effort: u32) -> f64 {
    let k = (1..).take_while(|k: &u32| k.pow(4) <= effort).last().unwrap_or(1);
    let rule = gauss(k as usize);
    let mut sum = 0.0;
    for (a, wa) in &rule {
        for (b, wb) in &rule {
            for (c, wc) in &rule {
                for (d, wd) in &rule {
                    sum += wa * wb * wc * wd * pair.kernel([*a, *b], [*c, *d]);
                }
            }
        }
    }
    sum
}

/// What is handed in.
pub const WORK: Work = Work { off, frontier, slope, factor };
