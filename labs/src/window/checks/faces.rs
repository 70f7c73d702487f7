//! Tasks 1 to 3: one face, a pane, and all directions.

use super::super::Work;
use super::super::bugs::*;
use super::{Suspects, suspects};
use crate::check::{Suspect, Verdict, Within, compare};
use crate::draw::uniform;
use radiosity::random::Stream;
use std::f64::consts::{FRAC_PI_2, PI};

/// A cosine and an index.
type Asked = (f64, f64);

/// Amplitudes s and p for a cosine outside, one inside, and an index.
fn amplitudes(outside: f64, inside: f64, n: f64) -> [f64; 2] {
    [
        (outside - n * inside) / (outside + n * inside),
        (n * outside - inside) / (n * outside + inside),
    ]
}

fn inside((c, n): Asked) -> f64 {
    (1.0 - (1.0 - c * c) / (n * n)).sqrt()
}

fn right(&(c, n): &Asked) -> [f64; 2] {
    amplitudes(c, inside((c, n)), n).map(|r| r * r)
}

const WRONG_FACES: &Suspects<Asked, [f64; 2]> = &[
    (NOT_SQUARED, |&(c, n)| amplitudes(c, inside((c, n)), n)),
    (NOT_SQUARED, |&(c, n)| amplitudes(c, inside((c, n)), n).map(|r| -r)),
    (NOT_SQUARED, |asked| right(asked).map(f64::sqrt)),
    (EXCHANGED, |asked| {
        let [s, p] = right(asked);
        [p, s]
    }),
    (UPSIDE_DOWN, |&(c, n)| right(&(c, 1.0 / n))),
    (UPSIDE_DOWN, |&(c, n)| amplitudes(c, inside((c, 1.0 / n)), n).map(|r| r * r)),
    (NOT_BENT, |&(c, n)| amplitudes(c, c, n).map(|r| r * r)),
    (PASSED, |asked| right(asked).map(|r| 1.0 - r)),
];

/// What the student's face reflects, both polarisations of each, against Fresnel's law.
fn judge(work: &Work, drawn: &[Asked]) -> Verdict {
    let all =
        |f: &dyn Fn(&Asked) -> [f64; 2]| drawn.iter().flat_map(f).collect::<Vec<f64>>();
    let suspects: Vec<Suspect> =
        WRONG_FACES.iter().map(|(bug, f)| (*bug, all(f))).collect();
    let place = |k: usize| {
        let (c, n) = drawn[k / 2];
        let degrees = c.acos().to_degrees();
        format!("n = {n:.3} at {degrees:.1}°, {}", ["s", "p"][k % 2])
    };
    let got = all(&|&(c, n)| (work.fresnel)(c, n));
    compare(&got, &all(&right), Within::Absolute(1e-9), &suspects, place)
}

/// First angles at which even 1/n has a cosine inside, so that it can be named.
pub(super) fn fresnel(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |low: f64, high: f64| -> Vec<Asked> {
        let mut one = || (uniform(stream, low, high), uniform(stream, 1.3, 2.4));
        (0..20).map(|_| one()).collect()
    };
    let (steep, flat) = (draw(0.93, 1.0), draw(0.02, 0.93));
    judge(work, &steep).and(|| judge(work, &flat))
}

/// tanθ = n: p is 0, and s is ((1 − n²)/(1 + n²))².
pub(super) fn brewster(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || {
        let n = uniform(stream, 1.2, 2.5);
        (1.0 / n.hypot(1.0), n)
    };
    let drawn: Vec<Asked> = (0..5).map(|_| draw()).collect();
    judge(work, &drawn)
}

fn passes(r: f64) -> f64 {
    (1.0 - r) / (1.0 + r)
}

fn mean_of([s, p]: [f64; 2]) -> f64 {
    0.5 * (s + p)
}

/// What a pane passes.
pub(super) fn pane(asked: &Asked) -> f64 {
    mean_of(right(asked).map(passes))
}

const WRONG_PANES: &Suspects<Asked, f64> = &[
    (ONE_FACE, |asked| 1.0 - mean_of(right(asked))),
    (NO_REFLECTIONS, |asked| mean_of(right(asked).map(|r| (1.0 - r) * (1.0 - r)))),
    (NO_REFLECTIONS, |asked| (1.0 - mean_of(right(asked))).powi(2)),
    (MEAN_FIRST, |asked| passes(mean_of(right(asked)))),
    (ONE_POLARISATION, |asked| passes(right(asked)[0])),
    (ONE_POLARISATION, |asked| passes(right(asked)[1])),
    (REFLECTED, |asked| 1.0 - pane(asked)),
    (SUMMED, |asked| 2.0 * pane(asked)),
    (STRAIGHT_ON, |&(_, n)| pane(&(1.0, n))),
];

fn judge_panes(work: &Work, drawn: &[Asked], expected: &[f64]) -> Verdict {
    let got: Vec<f64> = drawn.iter().map(|&(c, n)| (work.pane)(c, n)).collect();
    let place = |k: usize| {
        let (c, n) = drawn[k];
        format!("a pane of n = {n:.3} at {:.1}°", c.acos().to_degrees())
    };
    let suspects = suspects(WRONG_PANES, drawn);
    compare(&got, expected, Within::Absolute(1e-9), &suspects, place)
}

pub(super) fn panes(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || (uniform(stream, 0.02, 0.95), uniform(stream, 1.3, 2.4));
    let drawn: Vec<Asked> = (0..30).map(|_| draw()).collect();
    let expected: Vec<f64> = drawn.iter().map(pane).collect();
    judge_panes(work, &drawn, &expected)
}

/// `G4-slab-n1.5-kd0-0`, `-45` and `-60`.
pub(super) fn tables(work: &Work, _: &mut Stream) -> Verdict {
    let drawn = [0.0_f64, 45.0, 60.0].map(|degrees| (degrees.to_radians().cos(), 1.5));
    let expected =
        [0.923_076_923_076_923_1, 0.907_344_329_801_628_9, 0.848_128_409_728_8];
    judge_panes(work, &drawn, &expected)
}

/// ∫ `of`(sine, T, cosine) dθ over rings at their middle.
fn rings(n: f64, rings: usize, of: fn(f64, f64, f64) -> f64) -> f64 {
    let width = FRAC_PI_2 / rings as f64;
    let ring = |k: usize| {
        let (sine, cosine) = ((k as f64 + 0.5) * width).sin_cos();
        of(sine, pane(&(cosine, n)), cosine) * width
    };
    (0..rings).map(ring).sum()
}

const RINGS: usize = 64;

const WRONG_MEANS: &Suspects<f64, f64> = &[
    (NO_COSINE, |&n| rings(n, RINGS, |s, t, _| t * s)),
    (NO_COSINE, |&n| 2.0 * rings(n, RINGS, |s, t, _| t * s)),
    (NO_SINE, |&n| rings(n, RINGS, |_, t, c| t * c)),
    (NO_SINE, |&n| 2.0 * rings(n, RINGS, |_, t, c| t * c)),
    (STRAIGHT_ON, |&n| pane(&(1.0, n))),
    (NOT_A_MEAN, |&n| 2.0 * PI * rings(n, RINGS, |s, t, c| t * s * c)),
    (NOT_A_MEAN, |&n| rings(n, RINGS, |s, t, c| t * s * c)),
    (NOT_A_MEAN, |&n| 4.0 * rings(n, RINGS, |s, t, c| t * s * c)),
];

/// `G5-hemi-1.5` and `-1.52`, and some others by 4000 rings.
pub(super) fn mean(work: &Work, stream: &mut Stream) -> Verdict {
    let drawn = [1.5, 1.52, uniform(stream, 1.3, 1.45), uniform(stream, 1.6, 2.0)];
    let fine = |n: &f64| 2.0 * rings(*n, 4000, |s, t, c| t * s * c);
    let mut expected = drawn.each_ref().map(fine);
    expected[..2].copy_from_slice(&[0.850_938_300_895_590_5, 0.846_422_904_751_307_8]);
    let got = drawn.map(|n| (work.mean)(n, RINGS));
    let suspects = suspects(WRONG_MEANS, &drawn);
    let width = FRAC_PI_2 / RINGS as f64;
    let place = |k: usize| format!("n = {:.3}, {RINGS} rings", drawn[k]);
    compare(&got, &expected, Within::Absolute(3.0 * width * width), &suspects, place)
}
