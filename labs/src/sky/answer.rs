//! One right answer: texels at their middle, rows and columns picked one after the
//! other.
#![deny(warnings)]

use super::{Map, Work};
use radiosity::prelude::{DVec2, DVec3, dvec3};
use std::f64::consts::{PI, TAU};

/// Task 1: the difference of the cosines is the height of a zone of the unit sphere.
pub fn texel(width: usize, height: usize, row: usize) -> f64 {
    let cosine = |edge: usize| (PI * edge as f64 / height as f64).cos();
    TAU / width as f64 * (cosine(row) - cosine(row + 1))
}

/// Task 2: half a texel on from its corner.
pub fn direction(width: usize, height: usize, column: usize, row: usize) -> DVec3 {
    let theta = PI * (row as f64 + 0.5) / height as f64;
    let phi = TAU * ((column as f64 + 0.5) / width as f64 - 0.5);
    towards(theta.cos(), phi)
}

/// By the cosine to the zenith, and the azimuth from −z to +x.
pub fn towards(cosine: f64, phi: f64) -> DVec3 {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    dvec3(sine * phi.sin(), cosine, -sine * phi.cos())
}

/// Task 3: radiance × projected solid angle, summed.
pub fn irradiance(map: &Map, normal: DVec3) -> f64 {
    let mut sum = 0.0;
    for row in 0..map.height {
        for column in 0..map.width {
            let omega = texel(map.width, map.height, row);
            let cosine = normal.dot(direction(map.width, map.height, column, row));
            sum += map.at(column, row) * omega * cosine.max(0.0);
        }
    }
    sum
}

/// Which of `weights` holds the share `u` of their sum, and how far into it `u` is.
pub fn pick(weights: &[f64], u: f64) -> (usize, f64) {
    let mut left = u * weights.iter().sum::<f64>();
    for (k, &weight) in weights.iter().enumerate() {
        if left < weight {
            return (k, left / weight);
        }
        left -= weight;
    }
    (weights.len() - 1, 0.5) // rounding went past the end
}

/// Task 4: a row, a texel of it, a place in the texel.
pub fn sample(map: &Map, u: DVec2) -> (DVec3, f64) {
    let (width, height) = (map.width, map.height);
    let row = |k: usize| &map.radiance[k * width..][..width];
    let rows: Vec<f64> = (0..height)
        .map(|k| row(k).iter().sum::<f64>() * texel(width, height, k))
        .collect();
    let (r, down) = pick(&rows, u.x);
    let (column, along) = pick(row(r), u.y);
    let cosine = |edge: usize| (PI * edge as f64 / height as f64).cos();
    let cosine = cosine(r) + (cosine(r + 1) - cosine(r)) * down;
    let phi = TAU * ((column as f64 + along) / width as f64 - 0.5);
    (towards(cosine, phi), map.at(column, r) / rows.iter().sum::<f64>())
}

/// What is handed in.
pub const WORK: Work = Work { texel, direction, irradiance, sample };
