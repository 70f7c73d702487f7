//! The experiment of the report question: what do the shortcuts cost?
//!
//! `cargo run -p labs --example panes` runs it on the student's work.

use super::Work;

/// What a pane passes at some angle, and what shortcuts say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passed {
    /// By the student's `pane`.
    pub all: f64,
    /// One face only: `1 − R`.
    pub one_face: f64,
    /// Two faces, nothing between: `(1 − R)²`, for s and p apart.
    pub two_faces: f64,
    /// Everything, but of the mean of s and p.
    pub mean_first: f64,
}

/// At this angle, in degrees, for glass of this index.
pub fn at(work: &Work, degrees: f64, index: f64) -> Passed {
    let cosine = degrees.to_radians().cos();
    let both = (work.fresnel)(cosine, index);
    let mean = |of: fn(f64) -> f64| both.map(of).iter().sum::<f64>() / 2.0;
    let r = mean(|r| r);
    Passed {
        all: (work.pane)(cosine, index),
        one_face: 1.0 - r,
        two_faces: mean(|r| (1.0 - r) * (1.0 - r)),
        mean_first: (1.0 - r) / (1.0 + r),
    }
}
