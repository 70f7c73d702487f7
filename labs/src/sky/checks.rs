//! The checks of this lab.

use super::bugs::*;
use super::{Map, Work};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{direction as any_direction, uniform, whole_number};
use crate::lab::{Check, check};
use radiosity::geometry::Rgb;
use radiosity::prelude::{DVec3, dvec2, dvec3};
use radiosity::random::Stream;
use radiosity::sky::{Panorama, Sky};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "worth", "a texel of each row has its solid angle", 3, worth),
    check(2, "middles", "texels are where they should be", 3, middles),
    check(3, "planes", "planes get the light that they should", 4, planes),
    check(4, "shares", "directions go where the light comes from", 3, shares),
    check(4, "density", "the density is that of the draw", 2, density),
];

/// The size of a panorama.
type Size = (usize, usize);

/// A solid angle, from the size of a panorama and a row.
type Texel = fn(Size, f64) -> f64;

/// Wrong solid angles.
const WRONG_TEXELS: &[(Bug, Texel)] = &[
    (NO_SINE, |(w, h), _| TAU / w as f64 * PI / h as f64),
    (UPPER_EDGE, |(w, h), row| {
        TAU / w as f64 * PI / h as f64 * (PI * row / h as f64).sin()
    }),
    (HALF_SPHERE, |(w, h), row| {
        let cosine = |edge: f64| (FRAC_PI_2 * edge / h as f64).cos();
        TAU / w as f64 * (cosine(row) - cosine(row + 1.0))
    }),
    (HALF_TURN, |(w, h), row| exact(w, h, row) / 2.0),
];

fn exact(width: usize, height: usize, row: f64) -> f64 {
    let step = PI / height as f64;
    TAU / width as f64 * 2.0 * (step * (row + 0.5)).sin() * (step / 2.0).sin()
}

fn sizes(stream: &mut Stream) -> Vec<Size> {
    (0..4).map(|_| (whole_number(stream, 5, 40), whole_number(stream, 6, 30))).collect()
}

fn worth(work: &Work, stream: &mut Stream) -> Verdict {
    let sizes = sizes(stream);
    let rows: Vec<(Size, usize)> = sizes
        .iter()
        .flat_map(|&size| (0..size.1).map(move |row| (size, row)))
        .collect();
    let of = |f: &dyn Fn(Size, usize) -> f64| -> Vec<f64> {
        rows.iter().map(|&(size, row)| f(size, row)).collect()
    };
    let suspects: Vec<Suspect> = WRONG_TEXELS
        .iter()
        .map(|&(bug, wrong)| (bug, of(&|size, row| wrong(size, row as f64))))
        .collect();
    let expected = of(&|(w, h), row| exact(w, h, row as f64));
    let got = of(&|(w, h), row| (work.texel)(w, h, row));
    let place = |k: usize| {
        let ((w, h), row) = rows[k];
        format!("row {row} of {w} × {h}")
    };
    // sinθ ΔφΔθ with the sine of the middle is right to Δθ²/24: 1.2 % of six rows.
    compare(&got, &expected, Within::Relative(0.013), &suspects, place)
}

/// By column and row, whole at the corner of a texel.
fn place_of((w, h): Size, column: f64, row: f64) -> DVec3 {
    let (sine, cosine) = (PI * row / h as f64).sin_cos();
    let (right, ahead) = (TAU * (column / w as f64 - 0.5)).sin_cos();
    dvec3(sine * right, cosine, -sine * ahead)
}

/// A direction made of another.
type Turn = fn(DVec3) -> DVec3;

/// Wrong ways with a direction that is right.
const WRONG_PLACES: &[(Bug, Turn)] = &[
    (TURNED, |d| dvec3(-d.x, d.y, -d.z)),
    (MIRRORED, |d| dvec3(-d.x, d.y, d.z)),
    (MIRRORED, |d| dvec3(d.x, d.y, -d.z)),
    (FLIPPED, |d| dvec3(d.x, -d.y, d.z)),
    (Z_UP, |d| dvec3(d.x, -d.z, d.y)),
    (Z_UP, |d| dvec3(d.x, d.z, d.y)),
    (Z_UP, |d| dvec3(-d.z, d.x, d.y)),
];

fn middles(work: &Work, stream: &mut Stream) -> Verdict {
    let mut drawn = Vec::new();
    for size in sizes(stream) {
        for _ in 0..8 {
            drawn.push((
                size,
                whole_number(stream, 0, size.0),
                whole_number(stream, 0, size.1),
            ));
        }
    }
    let numbers = |f: &dyn Fn(Size, f64, f64) -> DVec3| -> Vec<f64> {
        let one = |&(size, c, r): &(Size, usize, usize)| {
            f(size, c as f64, r as f64).to_array()
        };
        drawn.iter().flat_map(one).collect()
    };
    let right = |size: Size, c: f64, r: f64| place_of(size, c + 0.5, r + 0.5);
    let mut suspects: Vec<Suspect> = WRONG_PLACES
        .iter()
        .map(|&(bug, wrong)| (bug, numbers(&|size, c, r| wrong(right(size, c, r)))))
        .collect();
    suspects.push((CORNER, numbers(&place_of)));
    suspects.push((HALF_SPHERE, numbers(&|(w, h), c, r| right((w, 2 * h), c, r))));
    let got = numbers(&|(w, h), c, r| (work.direction)(w, h, c as usize, r as usize));
    let place = |k: usize| {
        let ((w, h), column, row) = drawn[k / 3];
        let axis = ["x", "y", "z"][k % 3];
        format!("{axis} of column {column}, row {row} of {w} × {h}")
    };
    compare(&got, &numbers(&right), Within::Absolute(1e-9), &suspects, place)
}

/// A grey sky with a bright spot of a few texels.
fn map(stream: &mut Stream, width: usize, height: usize) -> Map {
    let mut radiance: Vec<f64> =
        (0..width * height).map(|_| uniform(stream, 0.5, 1.0)).collect();
    // Off the middle, off the seam and off the horizon: no mistake hides.
    let (column, row) =
        (whole_number(stream, 1, width / 4), whole_number(stream, 2, height / 4 + 1));
    for k in 0..4 {
        radiance[(row + k / 2) * width + column + k % 2] =
            uniform(stream, 150.0, 250.0);
    }
    Map { width, height, radiance }
}

/// What each texel adds to a plane: radiance, solid angle, cosine at its middle.
fn sum(map: &Map, normal: DVec3, term: impl Fn(f64, f64, f64) -> f64) -> f64 {
    let size = (map.width, map.height);
    let texels = 0..map.width * map.height;
    let one = |k: usize| {
        let (column, row) = (k % map.width, (k / map.width) as f64);
        let cosine = normal.dot(place_of(size, column as f64 + 0.5, row + 0.5));
        term(map.radiance[k], exact(map.width, map.height, row), cosine)
    };
    texels.map(one).sum()
}

fn planes(work: &Work, stream: &mut Stream) -> Verdict {
    let map = map(stream, 64, 32);
    let texels = map.radiance.iter().map(|&l| Rgb::splat(l)).collect();
    let sky = match Panorama::new(map.width, texels) {
        Ok(panorama) => Sky::panorama(panorama, DVec3::Y),
        Err(error) => return Verdict::fail(error.to_string(), None),
    };
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let mut normals: Vec<DVec3> = axes.iter().flat_map(|&n| [n, -n]).collect();
    normals.extend((0..6).map(|_| any_direction(stream)));
    let of =
        |f: &dyn Fn(DVec3) -> f64| normals.iter().map(|&n| f(n)).collect::<Vec<f64>>();
    let flat = TAU / map.width as f64 * PI / map.height as f64;
    let right = |n: DVec3| sum(&map, n, |l, w, c| l * w * c.max(0.0));
    let mut suspects: Vec<Suspect> = vec![
        (NO_SINE, of(&|n| sum(&map, n, |l, _, c| l * flat * c.max(0.0)))),
        (COSINE_TWICE, of(&|n| sum(&map, n, |l, w, c| l * w * c.max(0.0).powi(2)))),
        (NO_COSINE, of(&|n| sum(&map, n, |l, w, c| if c > 0.0 { l * w } else { 0.0 }))),
        (NO_COSINE, of(&|n| sum(&map, n, |l, w, _| l * w))),
        (FROM_BEHIND, of(&|n| sum(&map, n, |l, w, c| l * w * c))),
        (FROM_BEHIND, of(&|n| sum(&map, n, |l, w, c| l * w * c.abs()))),
        (OVER_PI, of(&|n| right(n) / PI)),
    ];
    for &(bug, wrong) in &WRONG_PLACES[..4] {
        suspects.push((bug, of(&|n| right(wrong(n)))));
    }
    let place = |k: usize| format!("a plane with normal {:.2}", normals[k]);
    let expected = of(&|n| sky.irradiance(n).x);
    let got = of(&|n| (work.irradiance)(&map, n));
    let largest = expected.iter().copied().fold(0.0, f64::max);
    compare(&got, &expected, Within::Absolute(0.01 * largest), &suspects, place)
}

/// Draws along each edge of the unit square.
const DRAWS: usize = 150;

/// Shares of the draws by row, then by column, of a coarse map.
fn shares(work: &Work, stream: &mut Stream) -> Verdict {
    let map = map(stream, 16, 8);
    let (w, h) = (map.width, map.height);
    let by = |weight: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
        let mut shares = vec![0.0; h + w];
        let all: f64 = (0..w * h).map(|k| weight(k % w, k / w)).sum();
        for k in 0..w * h {
            shares[k / w] += weight(k % w, k / w) / all;
            shares[h + k % w] += weight(k % w, k / w) / all;
        }
        shares
    };
    let mut got = vec![0.0; h + w];
    for k in 0..DRAWS * DRAWS {
        let at = |k: usize| (k as f64 + 0.5) / DRAWS as f64;
        let (d, _) = (work.sample)(&map, dvec2(at(k % DRAWS), at(k / DRAWS)));
        if !(d.length() - 1.0).abs().is_finite() || (d.length() - 1.0).abs() > 1e-6 {
            return Verdict::fail(format!("{d} has not length 1"), None);
        }
        let row = d.y.clamp(-1.0, 1.0).acos() / PI * h as f64;
        let column = (d.x.atan2(-d.z) / TAU + 0.5) * w as f64;
        got[(row as usize).min(h - 1)] += 1.0 / (DRAWS * DRAWS) as f64;
        got[h + (column as usize).min(w - 1)] += 1.0 / (DRAWS * DRAWS) as f64;
    }
    let omega = |row: usize| exact(w, h, row as f64);
    let light = |column: usize, row: usize| map.at(column, row) * omega(row);
    let suspects = [
        (NO_SINE, by(&|c, r| map.at(c, r))),
        (TURNED, by(&|c, r| light((c + w / 2) % w, r))),
        (MIRRORED, by(&|c, r| light(w - 1 - c, r))),
        (FLIPPED, by(&|c, r| light(c, h - 1 - r))),
        (NOT_BRIGHT, by(&|_, r| omega(r))),
        (NOT_BRIGHT, by(&|_, _| 1.0)),
    ];
    let place = |k: usize| match k.checked_sub(h) {
        None => format!("the share of row {k}"),
        Some(column) => format!("the share of column {column}"),
    };
    compare(&got, &by(&light), Within::Absolute(0.015), &suspects, place)
}

/// The density that is told with each direction.
fn density(work: &Work, stream: &mut Stream) -> Verdict {
    let map = map(stream, 16, 8);
    let (w, h) = (map.width, map.height);
    let drawn: Vec<(usize, f64)> = (0..200)
        .map(|_| {
            let u = dvec2(uniform(stream, 0.0, 1.0), uniform(stream, 0.0, 1.0));
            let (d, pdf) = (work.sample)(&map, u);
            let row = d.y.clamp(-1.0, 1.0).acos() / PI * h as f64;
            let column = (d.x.atan2(-d.z) / TAU + 0.5) * w as f64;
            let (row, column) =
                ((row as usize).min(h - 1), (column as usize).min(w - 1));
            (row * w + column, pdf)
        })
        .collect();
    let omega = |k: usize| exact(w, h, (k / w) as f64);
    let total: f64 = (0..w * h).map(|k| map.radiance[k] * omega(k)).sum();
    let sum: f64 = map.radiance.iter().sum();
    let flat = TAU / w as f64 * PI / h as f64;
    let of = |f: &dyn Fn(usize) -> f64| {
        drawn.iter().map(|&(k, _)| f(k)).collect::<Vec<f64>>()
    };
    let suspects = [
        (PER_TEXEL, of(&|k| map.radiance[k] * omega(k) / total)),
        (PER_TEXEL, of(&|k| map.radiance[k] / sum)),
        (EVEN, of(&|_| 1.0 / (4.0 * PI))),
        (NO_SINE, of(&|k| map.radiance[k] / (sum * omega(k)))),
        (NO_SINE, of(&|k| map.radiance[k] / (sum * flat))),
    ];
    let got: Vec<f64> = drawn.iter().map(|draw| draw.1).collect();
    let place = |k: usize| {
        let texel = drawn[k].0;
        format!("a direction in column {}, row {}", texel % w, texel / w)
    };
    let expected = of(&|k| map.radiance[k] / total);
    compare(&got, &expected, Within::Relative(0.01), &suspects, place)
}
