//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::answer::{WORK, direction, irradiance, pick, sample, texel, towards};
use super::bugs::*;
use super::{Map, Work};
use crate::lab::{Wrong, plays};
use radiosity::prelude::{DVec2, DVec3, dvec2, dvec3};
use std::f64::consts::{PI, TAU};

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays(
        "a-rectangle",
        "Δφ times Δθ, the picture is a rectangle",
        &[NO_SINE],
        Work { texel: |w, h, _| 2.0 * PI * PI / (w * h) as f64, ..WORK },
    ),
    plays(
        "first-edge",
        "the row begins at its edge",
        &[UPPER_EDGE],
        Work {
            texel: |w, h, row| {
                2.0 * PI * PI / (w * h) as f64 * (row as f64 * PI / h as f64).sin()
            },
            ..WORK
        },
    ),
    plays(
        "sky-only",
        "a sky ends at the horizon",
        &[HALF_SPHERE],
        Work {
            texel: |w, h, row| texel(w, 2 * h, row),
            direction: |w, h, column, row| direction(w, 2 * h, column, row),
            ..WORK
        },
    ),
    plays(
        "half-around",
        "both angles run to π",
        &[HALF_TURN],
        Work { texel: |w, h, row| texel(2 * w, h, row), ..WORK },
    ),
    plays(
        "from-the-seam",
        "column 0 looks along −z",
        &[TURNED],
        Work {
            direction: |w, h, column, row| {
                let d = direction(w, h, column, row);
                dvec3(-d.x, d.y, -d.z)
            },
            ..WORK
        },
    ),
    plays(
        "seen-from-outside",
        "a globe",
        &[MIRRORED],
        Work { direction: |w, h, c, r| direction(w, h, w - 1 - c, r), ..WORK },
    ),
    plays(
        "row-zero-below",
        "pictures begin at the bottom",
        &[FLIPPED],
        Work { direction: |w, h, c, r| direction(w, h, c, h - 1 - r), ..WORK },
    ),
    plays(
        "corners",
        "column over width",
        &[CORNER],
        Work {
            direction: |w, h, column, row| {
                let phi = TAU * (column as f64 / w as f64 - 0.5);
                towards((PI * row as f64 / h as f64).cos(), phi)
            },
            ..WORK
        },
    ),
    plays(
        "mathematician",
        "z is the polar axis",
        &[Z_UP],
        Work {
            direction: |w, h, column, row| {
                let d = direction(w, h, column, row);
                dvec3(d.x, -d.z, d.y)
            },
            ..WORK
        },
    ),
    plays(
        "sum-of-a-rectangle",
        "the mean of the texels, times 2π²",
        &[NO_SINE],
        Work {
            irradiance: |map, normal| {
                let texel = 2.0 * PI * PI / (map.width * map.height) as f64;
                add(map, |l, d, _| l * normal.dot(d).max(0.0) * texel)
            },
            ..WORK
        },
    ),
    plays(
        "doubly-cosined",
        "one cosine for the plane, one for the texel",
        &[COSINE_TWICE],
        Work {
            irradiance: |map, normal| {
                let seen = |d: DVec3| normal.dot(d).max(0.0);
                add(map, |l, d, omega| l * seen(d) * seen(d) * omega)
            },
            ..WORK
        },
    ),
    plays(
        "no-cosine",
        "all light that is before the plane",
        &[NO_COSINE],
        Work {
            irradiance: |map, normal| {
                add(
                    map,
                    |l, d, omega| if normal.dot(d) > 0.0 { l * omega } else { 0.0 },
                )
            },
            ..WORK
        },
    ),
    plays(
        "behind-counts",
        "a cosine is a cosine",
        &[FROM_BEHIND],
        Work {
            irradiance: |map, normal| {
                irradiance(map, normal) - irradiance(map, -normal)
            },
            ..WORK
        },
    ),
    plays(
        "over-pi",
        "radiance is B/π",
        &[OVER_PI],
        Work { irradiance: |map, normal| irradiance(map, normal) / PI, ..WORK },
    ),
    plays(
        "upside-down",
        "row 0 is the ground",
        &[FLIPPED],
        Work { irradiance: |map, n| irradiance(map, dvec3(n.x, -n.y, n.z)), ..WORK },
    ),
    plays(
        "half-a-turn",
        "the seam is ahead",
        &[TURNED],
        Work { irradiance: |map, n| irradiance(map, dvec3(-n.x, n.y, -n.z)), ..WORK },
    ),
    plays(
        "rows-as-they-are",
        "the brightest rows first, whatever their size",
        &[NO_SINE],
        Work { sample: |map, u| (by_rows(map, u), sample(map, u).1), ..WORK },
    ),
    plays(
        "turned-draw",
        "φ from 0",
        &[TURNED],
        Work {
            sample: |map, u| {
                let d = sample(map, u).0;
                let turned = dvec3(-d.x, d.y, -d.z);
                (turned, told(map, turned))
            },
            ..WORK
        },
    ),
    plays(
        "evenly",
        "over the sphere, as ever",
        &[NOT_BRIGHT],
        Work {
            sample: |map, u| {
                let d = towards(1.0 - 2.0 * u.x, TAU * (u.y - 0.5));
                (d, told(map, d))
            },
            ..WORK
        },
    ),
    plays(
        "probability",
        "a probability is a probability",
        &[PER_TEXEL],
        Work {
            sample: |map, u| {
                let (d, pdf) = sample(map, u);
                let row = d.y.acos() / PI * map.height as f64;
                (d, pdf * texel(map.width, map.height, row as usize))
            },
            ..WORK
        },
    ),
    plays(
        "one-over-4-pi",
        "the sphere has 4π",
        &[EVEN],
        Work { sample: |map, u| (sample(map, u).0, 0.25 / PI), ..WORK },
    ),
];

/// The sum over texels of radiance, direction and solid angle.
fn add(map: &Map, term: impl Fn(f64, DVec3, f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for (k, &radiance) in map.radiance.iter().enumerate() {
        let (column, row) = (k % map.width, k / map.width);
        let d = direction(map.width, map.height, column, row);
        sum += term(radiance, d, texel(map.width, map.height, row));
    }
    sum
}

/// The density of a direction.
fn told(map: &Map, d: DVec3) -> f64 {
    let row = (d.y.acos() / PI * map.height as f64) as usize;
    let column = (d.x.atan2(-d.z) / TAU + 0.5) * map.width as f64;
    map.at((column as usize).min(map.width - 1), row.min(map.height - 1))
        / add(map, |l, _, omega| l * omega)
}

/// A row by its sum, a texel of it, and its middle.
fn by_rows(map: &Map, u: DVec2) -> DVec3 {
    let row = |k: usize| &map.radiance[k * map.width..][..map.width];
    let sums: Vec<f64> = (0..map.height).map(|k| row(k).iter().sum()).collect();
    let (r, down) = pick(&sums, u.x);
    let (column, along) = pick(row(r), u.y);
    let at = dvec2(column as f64 + along, r as f64 + down);
    let phi = TAU * (at.x / map.width as f64 - 0.5);
    towards((PI * at.y / map.height as f64).cos(), phi)
}
