//! The experiment of the report question: how narrow may a lobe be?
//!
//! `cargo run -p labs --example narrow_lobe` runs it on the student's work.

use super::Work;
use radiosity::material::Lobe;
use radiosity::prelude::DVec3;
use radiosity::random::Stream;

/// Root mean squares of â/a − 1 over some places.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// By rings.
    pub grid: f64,
    /// By as many samples of the lobe.
    pub samples: f64,
}

/// The albedo of a lobe of this exponent from `places` random directions, 20° to 45° off
/// the normal: by so many rings, and by as many directions drawn from the lobe.
pub fn errors(work: &Work, exponent: f64, rings: usize, places: u64) -> Errors {
    let mut sums = [0.0; 2];
    for place in 0..places {
        let mut stream = Stream::named(place, &[rings as u64]);
        let (across, up) = (20.0 + 25.0 * stream.next()).to_radians().sin_cos();
        let (y, x) = (std::f64::consts::TAU * stream.next()).sin_cos();
        let wo = DVec3::new(across * x, across * y, up);
        let grid = (work.albedo)(&|wi, wo| (work.phong)(exponent, wi, wo), wo, rings);
        let count = 4 * rings * rings;
        let mut one = || {
            let wi = (work.sample)(exponent, wo, [stream.next(), stream.next()]);
            match wi.z > 0.0 {
                true => {
                    (work.phong)(exponent, wi, wo) * wi.z / (work.pdf)(exponent, wi, wo)
                }
                false => 0.0,
            }
        };
        let samples = (0..count).map(|_| one()).sum::<f64>() / count as f64;
        let exact = Lobe::Phong { exponent }.albedo(up);
        for (sum, found) in sums.iter_mut().zip([grid, samples]) {
            *sum += (found / exact - 1.0).powi(2) / places as f64;
        }
    }
    let [grid, samples] = sums.map(f64::sqrt);
    Errors { grid, samples }
}
