//! The experiment of the report question: how much light comes from a small sun?
//!
//! `cargo run -p labs --example small_sun` runs it on the student's work.

use super::Work;
use radiosity::prelude::dvec3;
use radiosity::random::Stream;
use std::f64::consts::{PI, TAU};

/// What became of many suns.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// The share of places at which no cell saw the sun.
    pub missed: f64,
    /// The root mean square of Ĥ/H − 1 over all places.
    pub rms: f64,
}

/// Puts a round sun of half-angle `beta` (radians) at `places` random places of the sky,
/// and compares the irradiance by `rings` rings with the exact one, π L sin²β cosθ.
///
/// Directions are uniform, from 26° to 84° off the zenith.
pub fn suns(work: &Work, beta: f64, rings: usize, places: usize) -> Found {
    let mut stream = Stream::named(rings as u64, &[]);
    let (mut missed, mut off) = (0, 0.0);
    for _ in 0..places {
        let z = 0.1 + 0.8 * stream.next();
        let (turn, across) = (TAU * stream.next(), (1.0 - z * z).sqrt());
        let sun = dvec3(across * turn.cos(), across * turn.sin(), z);
        let rim = beta.cos();
        let found =
            (work.from_sky)(&|d| if d.dot(sun) > rim { 1.0 } else { 0.0 }, rings);
        missed += usize::from(found == 0.0);
        off += (found / (PI * beta.sin().powi(2) * z) - 1.0).powi(2);
    }
    let places = places as f64;
    Found { missed: missed as f64 / places, rms: (off / places).sqrt() }
}
