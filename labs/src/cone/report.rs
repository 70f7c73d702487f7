//! The experiment of the report question: how many rays does the rim of a lamp need?
//!
//! `cargo run -p labs --example lamp_in_cone` runs it on the student's work.

use super::Work;
use super::given::Cap;
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;

/// Root mean squares of what is wrong with the share of a lamp in a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// By one ray in each cell.
    pub stratified: f64,
    /// By as many rays that fall anywhere.
    pub anywhere: f64,
}

/// A cone of 0.2 rad, and a lamp of 0.3 rad whose rim runs through it: `strata` ·
/// `strata` rays, so many times.
pub fn noise(work: &Work, strata: usize, runs: u64) -> Noise {
    let cone = Cap { axis: DVec3::Z, half_angle: 0.2 };
    let lamp = Cap { axis: dvec3(0.3_f64.sin(), 0.0, 0.3_f64.cos()), half_angle: 0.3 };
    let light = |d: DVec3| f64::from(d.dot(lamp.axis) > lamp.half_angle.cos());
    let exact = (work.share)(cone, lamp);
    let (mut stratified, mut anywhere) = (0.0, 0.0);
    for run in 0..runs {
        let mut random = Stream::named(run, &[strata as u64]);
        let found = (work.mean)(&light, cone, strata, &mut random);
        stratified += (found - exact).powi(2) / runs as f64;
        let rays = strata * strata;
        let mut one =
            |_| light((work.ray)(cone, [random.next(), random.next()])) / rays as f64;
        let found: f64 = (0..rays).map(&mut one).sum();
        anywhere += (found - exact).powi(2) / runs as f64;
    }
    Noise { stratified: stratified.sqrt(), anywhere: anywhere.sqrt() }
}
