//! The experiment of the report question: how wrong is one estimate, by directions
//! drawn evenly and by brightness, as the sun gets smaller?
//!
//! `cargo run -p labs --example sun_by_chance` runs it on the student's work.

use super::{Map, Work};
use radiosity::prelude::{DVec3, dvec2, dvec3};
use radiosity::random::Stream;
use std::f64::consts::{PI, TAU};

/// The root mean square of the relative error.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// Directions drawn evenly over the sphere.
    pub even: f64,
    /// Directions of `sample`.
    pub bright: f64,
}

/// A grey sky above grey ground, and a sun of one texel that sends nine times as much
/// to a level plane.
pub fn sunny(work: &Work, width: usize) -> Map {
    let height = width / 2;
    let mut map = Map { width, height, radiance: vec![1.0; width * height] };
    let (column, row) = (width / 3, height / 4);
    let cosine = (work.direction)(width, height, column, row).y;
    map.radiance[row * width + column] +=
        9.0 * PI / ((work.texel)(width, height, row) * cosine);
    map
}

/// Looks at a level plane under [`sunny`], `runs` times with so many `rays`.
pub fn errors(work: &Work, width: usize, rays: usize, runs: usize) -> Errors {
    let map = sunny(work, width);
    let exact = (work.irradiance)(&map, DVec3::Y);
    let at = |d: DVec3| {
        let row = (d.y.acos() / PI * map.height as f64) as usize;
        let column = ((d.x.atan2(-d.z) / TAU + 0.5) * map.width as f64) as usize;
        map.at(column.min(map.width - 1), row.min(map.height - 1))
    };
    let mut sums = [0.0; 2];
    for run in 0..runs {
        let mut stream = Stream::named(run as u64, &[width as u64]);
        let mut means = [0.0; 2];
        for [u, v] in stream.points(rays) {
            let ((x, z), y) = ((TAU * v).sin_cos(), 1.0 - 2.0 * u);
            let flat = (1.0 - y * y).sqrt();
            let even = dvec3(flat * x, y, flat * z);
            let (drawn, pdf) = (work.sample)(&map, dvec2(u, v));
            for (mean, (d, pdf)) in
                means.iter_mut().zip([(even, 0.25 / PI), (drawn, pdf)])
            {
                *mean += at(d) * d.y.max(0.0) / pdf / rays as f64;
            }
        }
        for (sum, mean) in sums.iter_mut().zip(means) {
            *sum += (mean / exact - 1.0).powi(2);
        }
    }
    let [even, bright] = sums.map(|sum: f64| (sum / runs as f64).sqrt());
    Errors { even, bright }
}
