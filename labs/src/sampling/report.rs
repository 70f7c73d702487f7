//! The experiment of the report question: are the error bars to be believed?
//!
//! `cargo run -p labs --example error_bars` runs it on the student's work.

use super::Work;
use super::given::Pair;
use crate::shapes::rectangle;
use radiosity::prelude::{DVec3, Polygon};
use radiosity::random::Stream;

/// Two unit squares, and their exact form factor.
pub struct Squares {
    /// The squares.
    pub pair: Pair,
    /// The factor.
    pub factor: f64,
}

/// Straight opposite, 1 apart.
pub fn parallel() -> Squares {
    let lid = rectangle(DVec3::Z, DVec3::Y, DVec3::X);
    Squares { pair: floor_and(lid), factor: 0.199_824_895_698_387 }
}

/// At a right angle, with an edge in common.
pub fn touching() -> Squares {
    let wall = rectangle(DVec3::ZERO, DVec3::Y, DVec3::Z);
    Squares { pair: floor_and(wall), factor: 0.200_043_776_075_403 }
}

fn floor_and(to: Polygon) -> Pair {
    Pair { from: rectangle(DVec3::ZERO, DVec3::X, DVec3::Y), to, blockers: vec![] }
}

/// What many runs of one method gave.
#[derive(Clone, Copy, Debug)]
pub struct Bars {
    /// The error that half of the runs exceed, as a share of the factor.
    pub typical: f64,
    /// The largest error of all runs.
    pub worst: f64,
    /// The mean of the stated errors.
    pub stated: f64,
    /// The share of runs whose bar, twice the stated error, does not reach the factor.
    pub missed: f64,
}

/// Runs the student's method, by rays or by points, many times.
pub fn bars(
    work: &Work,
    squares: &Squares,
    rays: bool,
    samples: usize,
    runs: usize,
) -> Bars {
    let method = if rays { work.by_rays } else { work.by_points };
    let mut off = Vec::with_capacity(runs);
    let (mut stated, mut missed) = (0.0, 0);
    for run in 0..runs {
        let mut stream = Stream::named(samples as u64, &[run as u64, rays.into()]);
        let found = method(&squares.pair, samples, &mut stream);
        let error = (found.mean - squares.factor).abs();
        missed += usize::from(error > 2.0 * found.error);
        stated += found.error / squares.factor / runs as f64;
        off.push(error / squares.factor);
    }
    off.sort_by(f64::total_cmp);
    let (typical, worst) = (off[runs / 2], off[runs - 1]);
    Bars { typical, worst, stated, missed: missed as f64 / runs as f64 }
}
