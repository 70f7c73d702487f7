//! Tasks 4 and 5: rays in a cone, and their mean.

use super::super::Work;
use super::super::bugs::*;
use super::super::given::Cap;
use super::{beside, cone};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::uniform;
use radiosity::prelude::{DVec3, Frame, dvec3};
use radiosity::random::Stream;
use std::f64::consts::{PI, TAU};

/// How rays may be drawn: of a cone and two numbers.
type Draw = fn(Cap, [f64; 2]) -> DVec3;

/// A direction about `axis`.
fn about(axis: DVec3, cosine: f64, turn: f64) -> DVec3 {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let (y, x) = turn.sin_cos();
    Frame::about(axis).world_from_local(dvec3(sine * x, sine * y, cosine))
}

fn even_cosine(cone: Cap, u: f64) -> f64 {
    1.0 - u * (1.0 - cone.half_angle.cos())
}

const WRONG: &[(Bug, Draw)] = &[
    (EVEN_ANGLES, |c, [u, v]| about(c.axis, (u * c.half_angle).cos(), TAU * v)),
    (EVEN_DISC, |c, [u, v]| about(c.axis, (u.sqrt() * c.half_angle).cos(), TAU * v)),
    (BY_COSINE, |c, [u, v]| {
        let cosine = (1.0 - u * c.half_angle.sin().powi(2)).sqrt();
        about(c.axis, cosine, TAU * v)
    }),
    (HALF_TURN, |c, [u, v]| about(c.axis, even_cosine(c, u), PI * v)),
    (ABOUT_Z, |c, [u, v]| about(DVec3::Z, even_cosine(c, u), TAU * v)),
];

/// The mean of N × N even rays, and the mean square of their cosine to the axis.
fn moments(draw: Draw, cone: Cap) -> [f64; 4] {
    const N: u32 = 128;
    let even = |k: u32| (f64::from(k) + 0.5) / f64::from(N);
    let (mut mean, mut square) = (DVec3::ZERO, 0.0);
    for k in 0..N * N {
        let ray = draw(cone, [even(k % N), even(k / N)]);
        mean += ray / f64::from(N * N);
        square += ray.dot(cone.axis).powi(2) / f64::from(N * N);
    }
    [mean.x, mean.y, mean.z, square]
}

pub(super) fn even(work: &Work, stream: &mut Stream) -> Verdict {
    let drawn: Vec<Cap> = (0..4)
        .map(|_| {
            let half_angle = uniform(stream, 1.0, 1.5);
            cone(stream, half_angle)
        })
        .collect();
    let lengths = (0..64).map(|k| {
        let u = f64::from(k) / 64.0;
        (work.ray)(drawn[0], [u, (7.0 * u).fract()]).length()
    });
    if let Some(length) = lengths.into_iter().find(|l| (l - 1.0).abs() > 1e-6) {
        let message = format!("a direction of length {length:.3} was drawn");
        return Verdict::fail(message, Some(NOT_UNIT));
    }
    let all = |f: Draw| drawn.iter().flat_map(|&cone| moments(f, cone)).collect();
    let exact = |cone: &Cap| {
        let c = cone.half_angle.cos();
        let mean = 0.5 * (1.0 + c) * cone.axis;
        [mean.x, mean.y, mean.z, (1.0 + c + c * c) / 3.0]
    };
    let expected: Vec<f64> = drawn.iter().flat_map(exact).collect();
    let suspects: Vec<Suspect> = WRONG.iter().map(|&(bug, f)| (bug, all(f))).collect();
    let place = |k: usize| {
        let what = ["mean x", "mean y", "mean z", "mean cos²"][k % 4];
        let Cap { axis, half_angle } = drawn[k / 4];
        format!("cone of {half_angle:.3} rad about {axis:.3}, {what}")
    };
    let got: Vec<f64> = all(work.ray);
    compare(&got, &expected, Within::Absolute(1e-3), &suspects, place)
}

/// Light that grows evenly in one direction: its mean is that at (1 + c)/2 of the axis.
pub(super) fn mean(work: &Work, stream: &mut Stream) -> Verdict {
    const STRATA: usize = 24;
    let mut draw = || {
        let half_angle = uniform(stream, 0.6, 1.2);
        let cone = cone(stream, half_angle);
        (cone, beside(stream, cone, 0.7))
    };
    let drawn: Vec<(Cap, DVec3)> = (0..5).map(|_| draw()).collect();
    let light = |slope: DVec3, d: DVec3| 3.0 + slope.dot(d);
    let of = |&(cone, slope): &(Cap, DVec3)| {
        (work.mean)(&|d| light(slope, d), cone, STRATA, stream)
    };
    let got: Vec<f64> = drawn.iter().map(of).collect();
    let all = |f: &dyn Fn(Cap, f64, f64) -> f64| -> Vec<f64> {
        let one = |&(cone, slope): &(Cap, DVec3)| {
            let middle = light(slope, 0.5 * (1.0 + cone.half_angle.cos()) * cone.axis);
            f(cone, middle, light(slope, cone.axis))
        };
        drawn.iter().map(one).collect()
    };
    let rays = (STRATA * STRATA) as f64;
    let wrong = [
        (SUM, all(&|_, mean, _| rays * mean)),
        (SUM, all(&|_, mean, _| STRATA as f64 * mean)),
        (INTEGRAL, all(&|c, mean, _| TAU * (1.0 - c.half_angle.cos()) * mean)),
        (ONE_RAY, all(&|_, _, axis| axis)),
    ];
    let place = |k: usize| format!("cone of {:.3} rad", drawn[k].0.half_angle);
    // One ray in each cell: about σ_cell/n = 0.4/n².
    let expected = all(&|_, mean, _| mean);
    compare(&got, &expected, Within::Relative(2e-3), &wrong, place)
}

/// A half-lit cone, many times: the variance tells how the rays fall.
pub(super) fn strata(work: &Work, stream: &mut Stream) -> Verdict {
    const STRATA: usize = 16;
    const RUNS: usize = 300;
    let cone = cone(stream, 0.5);
    let across = beside(stream, cone, PI / 2.0);
    let lit = |d: DVec3| f64::from(d.dot(across) > 0.0);
    let mut one = || (work.mean)(&lit, cone, STRATA, stream);
    let runs: Vec<f64> = (0..RUNS).map(|_| one()).collect();
    let mean = runs.iter().sum::<f64>() / RUNS as f64;
    let variance =
        runs.iter().map(|run| (run - mean).powi(2)).sum::<f64>() / RUNS as f64;
    // In units of what rays anywhere have, ¼ to a tenth of it.
    let noise = variance * (STRATA * STRATA) as f64 / 0.25;
    let place = |_| "the variance, in units of that of rays anywhere".to_string();
    if variance == 0.0 {
        let message = format!("{RUNS} runs, one result: {mean:.6}");
        return Verdict::fail(message, Some(SAME_RAYS));
    }
    let verdict = compare(&[noise], &[0.0], Within::Absolute(0.4), &[], place);
    let anywhere = (0.7..1.3).contains(&noise);
    Verdict {
        bug: (!verdict.passed() && anywhere).then_some(NOT_STRATIFIED),
        ..verdict
    }
}
