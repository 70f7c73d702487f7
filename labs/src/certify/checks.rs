//! The checks of this lab.
//!
//! ```text
//! |mean of n products − 0| ≤ 5 σ²/√n           two noises of deviation σ
//! ```
//! All else is arithmetic: 1e-12 of a value is thousands of roundings.

use super::Work;
use super::bugs::*;
use super::given::{Point, Room};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::uniform;
use crate::gather::rooms::{coloured, draw, light};
use crate::lab::{Check, check};
use radiosity::random::Stream;

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "residual", "the residual at a point is right", 2, residual),
    check(2, "squared", "the norm of any residuals is right", 2, squared),
    check(2, "noise", "noise alone is no error", 2, noise),
    check(3, "bounds", "the bounds of the error are right", 2, bounds),
    check(4, "relative", "the error is relative to reflected light", 2, relative),
    check(5, "propagated", "errors of pieces follow from residuals", 3, propagated),
    check(6, "furnace", "in a furnace the largest bound is the error", 1, furnace),
    check(6, "solution", "what was stored and its error make the truth", 1, solution),
];

const WITHIN: Within = Within::Relative(1e-12);

/// The residual by gather `g`.
type At = fn(&Point, usize) -> f64;

const RIGHT: At = |p, g| p.emission + p.reflectance * p.gathered[g] - p.stored;

fn points(stream: &mut Stream) -> Vec<Point> {
    let mut point = || Point {
        area: uniform(stream, 0.1, 2.0),
        emission: uniform(stream, 0.0, 3.0),
        reflectance: uniform(stream, 0.1, 0.9),
        stored: uniform(stream, 0.5, 4.0),
        gathered: [uniform(stream, 0.5, 3.0), uniform(stream, 0.5, 3.0)],
    };
    (0..12).map(|_| point()).collect()
}

fn residual(work: &Work, stream: &mut Stream) -> Verdict {
    let points = points(stream);
    let all = |at: &dyn Fn(&Point, usize) -> f64| -> Vec<f64> {
        points.iter().flat_map(|p| [at(p, 0), at(p, 1)]).collect()
    };
    let wrong: [(Bug, At); 6] = [
        (SIGN, |p, g| -RIGHT(p, g)),
        (NO_EMISSION, |p, g| RIGHT(p, g) - p.emission),
        (NO_PAINT, |p, g| p.emission + p.gathered[g] - p.stored),
        (PAINTS_LAMPS, |p, g| p.reflectance * (p.emission + p.gathered[g]) - p.stored),
        (ONE_GATHER, |p, _| RIGHT(p, 0)),
        (BOTH_GATHERS, |p, _| 0.5 * (RIGHT(p, 0) + RIGHT(p, 1))),
    ];
    let suspects: Vec<Suspect> = wrong.map(|(bug, at)| (bug, all(&at))).to_vec();
    let place = |k: usize| format!("point {}, gather {}", k / 2, k % 2);
    let within = Within::Absolute(1e-12);
    compare(&all(&work.residual), &all(&RIGHT), within, &suspects, place)
}

fn sum(points: &[Point], of: impl Fn(&Point) -> f64) -> f64 {
    points.iter().map(of).sum()
}

/// A number from points.
type Of = fn(&[Point]) -> f64;

const NORM: Of = |p| sum(p, |p| p.area * RIGHT(p, 0) * RIGHT(p, 1));

/// Norms with a mistake.
const WRONG_NORMS: [(Bug, Of); 6] = [
    (SQUARE, |p| sum(p, |p| p.area * RIGHT(p, 0).powi(2))),
    (SQUARE, |p| sum(p, |p| p.area * RIGHT(p, 1).powi(2))),
    (SQUARE_OF_MEAN, |p| {
        sum(p, |p| p.area * (0.5 * (RIGHT(p, 0) + RIGHT(p, 1))).powi(2))
    }),
    (ABSOLUTE, |p| sum(p, |p| p.area * (RIGHT(p, 0) * RIGHT(p, 1)).abs())),
    (NO_AREAS, |p| sum(p, |p| RIGHT(p, 0) * RIGHT(p, 1)) / p.len() as f64),
    (ROOTED, |p| NORM(p).max(0.0).sqrt()),
];

/// One number of each of several lists of points.
fn of_lists(
    work: impl Fn(&[Point]) -> f64,
    right: Of,
    wrong: &[(Bug, Of)],
    stream: &mut Stream,
) -> Verdict {
    let lists: Vec<Vec<Point>> = (0..6).map(|_| points(stream)).collect();
    let all = |of: &dyn Fn(&[Point]) -> f64| -> Vec<f64> {
        lists.iter().map(|points| of(points)).collect()
    };
    let mut suspects: Vec<Suspect> =
        wrong.iter().map(|(bug, of)| (*bug, all(of))).collect();
    let no_areas = |p: &[Point]| sum(p, |p| RIGHT(p, 0) * RIGHT(p, 1));
    suspects.push((NO_AREAS, all(&no_areas)));
    let place = |k: usize| format!("list {k} of 12 points");
    let within = Within::Absolute(1e-11);
    compare(&all(&work), &all(&right), within, &suspects, place)
}

fn squared(work: &Work, stream: &mut Stream) -> Verdict {
    of_lists(work.squared, NORM, &WRONG_NORMS, stream)
}

/// A field without any error, and gathers with noise.
fn noise(work: &Work, stream: &mut Stream) -> Verdict {
    const N: usize = 10_000;
    let (reflectance, sigma) = (uniform(stream, 0.3, 0.8), uniform(stream, 0.1, 0.5));
    // Uniform numbers of this half-width have the standard deviation `sigma`.
    let half = 3.0_f64.sqrt() * sigma / reflectance;
    let mut point = || Point {
        area: 1.0 / N as f64,
        emission: 0.0,
        reflectance,
        stored: reflectance,
        gathered: [0; 2].map(|_| 1.0 + uniform(stream, -half, half)),
    };
    let points: Vec<Point> = (0..N).map(|_| point()).collect();
    let suspects: Vec<Suspect> =
        WRONG_NORMS.map(|(bug, of)| (bug, vec![of(&points)])).to_vec();
    let place = |_| {
        let variance = sigma * sigma;
        format!("no error, and gathers of variance {variance:.4}")
    };
    let within = Within::Absolute(5.0 * sigma * sigma / (N as f64).sqrt());
    let mut verdict =
        compare(&[(work.squared)(&points)], &[0.0], within, &suspects, place);
    // Whatever is not far off is not far from a suspect either: name none that is right.
    verdict.bug = verdict.bug.filter(|_| verdict.message.is_some());
    verdict
}

/// Two bounds from a norm and a reflectance.
type Bounds = fn(f64, f64) -> [f64; 2];

fn bounds(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || (uniform(stream, 0.1, 3.0), uniform(stream, 0.1, 0.95));
    let drawn: Vec<(f64, f64)> = (0..8).map(|_| draw()).collect();
    let all = |of: Bounds| -> Vec<f64> {
        drawn.iter().flat_map(|&(norm, rho)| of(norm, rho)).collect()
    };
    let wrong: [(Bug, Bounds); 4] = [
        (SWAPPED, |n, rho| [n / (1.0 - rho), n / (1.0 + rho)]),
        (SWAPPED, |n, rho| [n * (1.0 - rho), n * (1.0 + rho)]),
        (NOT_PROPAGATED, |n, _| [n, n]),
        (WITHOUT_ITSELF, |n, rho| [n * rho / (1.0 + rho), n * rho / (1.0 - rho)]),
    ];
    let suspects: Vec<Suspect> = wrong.map(|(bug, of)| (bug, all(of))).to_vec();
    let place = |k: usize| {
        let (norm, rho) = drawn[k / 2];
        format!("‖r‖ = {norm:.3}, ρ = {rho:.3}: {}", ["least", "largest"][k % 2])
    };
    let right: Bounds = |n, rho| [n / (1.0 + rho), n / (1.0 - rho)];
    compare(&all(work.worst_case), &all(right), WITHIN, &suspects, place)
}

fn relative(work: &Work, stream: &mut Stream) -> Verdict {
    let of_lists_norm = uniform(stream, 0.1, 2.0);
    let lists: Vec<Vec<Point>> = (0..6).map(|_| points(stream)).collect();
    let all = |of: &dyn Fn(&[Point]) -> f64| -> Vec<f64> {
        lists.iter().map(|points| of_lists_norm / of(points)).collect()
    };
    let reflected = |p: &Point| p.stored - p.emission;
    let wrong: [(Bug, Of); 6] = [
        (LAMP_HIDES, |p| sum(p, |p| p.area * p.stored.powi(2)).sqrt()),
        (NO_AREAS, |p| sum(p, |p| (p.stored - p.emission).powi(2)).sqrt()),
        (NOT_A_NORM, |p| sum(p, |p| p.area * (p.stored - p.emission).powi(2))),
        (NOT_A_NORM, |p| sum(p, |p| p.area * (p.stored - p.emission).abs())),
        (NOT_A_NORM, |p| sum(p, |p| p.area * (p.stored - p.emission))),
        (OF_NORMS, |p| {
            let norm = |of: &dyn Fn(&Point) -> f64| sum(p, |p| p.area * of(p).powi(2));
            norm(&|p| p.stored).sqrt() - norm(&|p| p.emission).sqrt()
        }),
    ];
    let suspects: Vec<Suspect> = wrong.map(|(bug, of)| (bug, all(&of))).to_vec();
    let got: Vec<f64> =
        lists.iter().map(|points| (work.relative)(of_lists_norm, points)).collect();
    let right = |p: &[Point]| sum(p, |p| p.area * reflected(p).powi(2)).sqrt();
    let place = |k: usize| format!("list {k} of 12 points");
    compare(&got, &all(&right), WITHIN, &suspects, place)
}

/// `x = source + weight-sum of x`, by so many bounces.
fn settled(
    source: &[f64],
    bounces: usize,
    weight: impl Fn(usize, usize) -> f64,
) -> Vec<f64> {
    let n = source.len();
    let mut x = source.to_vec();
    for _ in 0..bounces {
        x = (0..n)
            .map(|i| source[i] + (0..n).map(|j| weight(i, j) * x[j]).sum::<f64>())
            .collect();
    }
    x
}

/// So many bounces leave nothing at reflectances below 0.9.
const ALL_BOUNCES: usize = 400;

fn propagated(work: &Work, stream: &mut Stream) -> Verdict {
    let mut verdict = Verdict::pass(0.0, 1e-9);
    for curved in [true, false, true] {
        let room = draw(stream, curved);
        let room = coloured(room, stream);
        let r: Vec<f64> =
            room.area.iter().map(|_| uniform(stream, -1.0, 1.0)).collect();
        let Room { reflectance: rho, factors: f, emission, .. } = &room;
        let right = settled(&r, ALL_BOUNCES, |i, j| rho[i] * f[i][j]);
        let less = |x: &[f64], y: &[f64]| -> Vec<f64> {
            x.iter().zip(y).map(|(x, y)| x - y).collect()
        };
        let both: Vec<f64> = r.iter().zip(emission).map(|(r, e)| r + e).collect();
        let worst = r.iter().zip(rho).map(|(r, rho)| r / (1.0 - rho));
        let suspects: Vec<Suspect> = vec![
            (ONE_BOUNCE, settled(&r, 1, |i, j| rho[i] * f[i][j])),
            (NOT_PROPAGATED, r.clone()),
            (NO_RESIDUAL, less(&right, &r)),
            (SENDERS_PAINT, settled(&r, ALL_BOUNCES, |i, j| rho[j] * f[i][j])),
            (TRANSPOSED, settled(&r, ALL_BOUNCES, |i, j| rho[i] * f[j][i])),
            (LAMP_AGAIN, settled(&both, ALL_BOUNCES, |i, j| rho[i] * f[i][j])),
            (WORST_EVERYWHERE, worst.collect()),
        ];
        let place = |i: usize| format!("piece {i} of {}", r.len());
        let within = Within::Absolute(1e-9);
        let got = (work.propagated)(&room, &r);
        verdict = verdict.and(|| compare(&got, &right, within, &suspects, place));
    }
    verdict
}

/// All walls emit 1 and reflect alike; the stored light is too dark by a share.
fn furnace(work: &Work, stream: &mut Stream) -> Verdict {
    let (rho, share) = (uniform(stream, 0.2, 0.9), uniform(stream, 0.01, 0.2));
    let stored = (1.0 - share) / (1.0 - rho);
    let point = Point {
        area: 1.0,
        emission: 1.0,
        reflectance: rho,
        stored,
        gathered: [stored; 2],
    };
    let norm = (work.squared)(&[point]).sqrt();
    let largest = (work.worst_case)(norm, rho)[1];
    let right = share / (1.0 - rho);
    let expected = [right, right / (stored - 1.0).abs()];
    let got = [largest, (work.relative)(largest, &[point])];
    let place = |k: usize| {
        let what = ["the largest error", "the relative error"][k];
        format!("ρ = {rho:.3}, {:.1} % too dark: {what}", 100.0 * share)
    };
    compare(&got, &expected, Within::Relative(1e-9), &[], place)
}

/// Any light, its residual in each piece, and the error that follows: together they are
/// the solution.
fn solution(work: &Work, stream: &mut Stream) -> Verdict {
    let room = draw(stream, true);
    let room = coloured(room, stream);
    let b = light(&room, stream);
    let Room { area, emission, reflectance, factors } = &room;
    let residual = |i: usize| {
        let h: f64 = factors[i].iter().zip(&b).map(|(f, b)| f * b).sum();
        let point = Point {
            area: area[i],
            emission: emission[i],
            reflectance: reflectance[i],
            stored: b[i],
            gathered: [h; 2],
        };
        (work.residual)(&point, 0)
    };
    let residual: Vec<f64> = (0..b.len()).map(residual).collect();
    let error = (work.propagated)(&room, &residual);
    let got: Vec<f64> = b.iter().zip(&error).map(|(b, e)| b + e).collect();
    let right = settled(emission, ALL_BOUNCES, |i, j| reflectance[i] * factors[i][j]);
    let place = |i: usize| format!("piece {i} of {}", b.len());
    compare(&got, &right, Within::Relative(1e-7), &[], place)
}
