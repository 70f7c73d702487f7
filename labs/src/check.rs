//! Judging numbers: how far off, within which tolerance, and by which likely mistake.
//!
//! ```text
//! deviation = max_k |got_k − expected_k| / scale_k        pass: deviation ≤ tolerance
//! ```
//!
//! A **suspect** is what the numbers would be if one known mistake had been made. When
//! the student's numbers are a suspect's, the mistake is named; when all of them are
//! the same multiple of the right ones, the multiple is.

use std::fmt::Write;

/// A mistake that a check can recognise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bug {
    /// A short name, unique within its lab.
    pub name: &'static str,
    /// What to look for: a question to the student.
    pub says: &'static str,
}

/// Declares each mistake as a constant.
macro_rules! bugs {
    ($($(#[$doc:meta])* $id:ident $name:literal $says:literal;)*) => {
        $(
            $(#[$doc])*
            pub const $id: $crate::check::Bug =
                $crate::check::Bug { name: $name, says: $says };
        )*
    };
}
pub(crate) use bugs;

/// What one check found.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The largest deviation; see the check's message for its unit. Not a number fails.
    pub metric: f64,
    /// The largest deviation that passes.
    pub tolerance: f64,
    /// What is wrong, the value got and the value expected; `None` when all is well.
    pub message: Option<String>,
    /// The mistake that explains it.
    pub bug: Option<Bug>,
}

impl Verdict {
    /// All is well.
    pub fn pass(metric: f64, tolerance: f64) -> Verdict {
        Verdict { metric, tolerance, message: None, bug: None }
    }

    /// Something is wrong that no number measures, such as a list of the wrong length.
    pub fn fail(message: impl Into<String>, bug: Option<Bug>) -> Verdict {
        let message = Some(message.into());
        Verdict { metric: f64::INFINITY, tolerance: 0.0, message, bug }
    }

    /// Is all well?
    pub fn passed(&self) -> bool {
        self.message.is_none()
    }

    /// This verdict when it fails, else the `next` one; of two passes, the tighter.
    pub fn and(self, next: impl FnOnce() -> Verdict) -> Verdict {
        if !self.passed() {
            return self;
        }
        let next = next();
        let tighter = self.metric * next.tolerance > next.metric * self.tolerance;
        if next.passed() && tighter { self } else { next }
    }
}

/// What a deviation is relative to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Within {
    /// Each expected value; none may be 0.
    Relative(f64),
    /// One: the deviation has the unit of the values.
    Absolute(f64),
}

/// What the numbers would be if this mistake had been made.
pub type Suspect = (Bug, Vec<f64>);

/// Compares a student's numbers with the right ones.
///
/// `place` names the `k`-th number in messages. A value that is not finite fails.
pub fn compare(
    got: &[f64],
    expected: &[f64],
    within: Within,
    suspects: &[Suspect],
    place: impl Fn(usize) -> String,
) -> Verdict {
    if got.len() != expected.len() {
        let (n, m) = (got.len(), expected.len());
        return Verdict::fail(format!("got {n} numbers, expected {m}"), None);
    }
    let (Within::Relative(tolerance) | Within::Absolute(tolerance)) = within;
    let (worst, metric) = deviation(got, expected, within);
    if metric <= tolerance {
        return Verdict::pass(metric, tolerance);
    }
    let mut message = format!(
        "{}: got {}, expected {}",
        place(worst),
        digits(got[worst]),
        digits(expected[worst])
    );
    let named = suspects
        .iter()
        .map(|(bug, values)| (*bug, deviation(got, values, within).1))
        .filter(|&(_, off)| off <= tolerance)
        .min_by(|a, b| a.1.total_cmp(&b.1));
    let bug = named.map(|(bug, _)| bug);
    if bug.is_none() {
        message += &same_multiple(got, expected).unwrap_or_default();
    }
    Verdict { metric, tolerance, message: Some(message), bug }
}

/// The place and size of the largest deviation; infinite where a value is not finite.
fn deviation(got: &[f64], expected: &[f64], within: Within) -> (usize, f64) {
    let off = |k: usize| {
        let scale = match within {
            Within::Relative(_) => expected[k].abs(),
            Within::Absolute(_) => 1.0,
        };
        if got[k] == expected[k] {
            return 0.0; // both may be 0, or a suspect's infinity
        }
        let off = (got[k] - expected[k]).abs() / scale;
        if off.is_nan() { f64::INFINITY } else { off }
    };
    if got.len() != expected.len() {
        return (0, f64::INFINITY);
    }
    let all = (0..got.len()).map(|k| (k, off(k)));
    all.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, 0.0))
}

/// Says so when all values are one multiple of the right ones, within 0.1 %.
fn same_multiple(got: &[f64], expected: &[f64]) -> Option<String> {
    let ratios =
        got.iter().zip(expected).filter(|&(_, &e)| e != 0.0).map(|(g, e)| g / e);
    let (low, high) = ratios
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), r| (lo.min(r), hi.max(r)));
    let one = low > 0.0 && high.is_finite() && high - low < 1e-3 * high;
    (one && got.len() > 1)
        .then(|| format!("; every value is {} times the right one", digits(low)))
}

/// Six digits, in the shorter of the two notations.
pub fn digits(x: f64) -> String {
    let x = x + 0.0; // -0 is 0
    let mut text = String::new();
    let plain = x == 0.0 || !x.is_finite() || (1e-4..1e6).contains(&x.abs());
    // Writing to a String cannot fail.
    let _ = if plain { write!(text, "{x:.6}") } else { write!(text, "{x:.5e}") };
    text
}
