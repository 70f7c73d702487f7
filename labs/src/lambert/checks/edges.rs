//! Task 1: what one edge adds.

use super::digits_of;
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{decades, direction, frame, uniform};
use crate::lambert::Work;
use crate::lambert::bugs::*;
use radiosity::prelude::DVec3;
use radiosity::random::Stream;

/// How an edge may be measured.
pub type Edge = fn(DVec3, DVec3, DVec3) -> f64;

/// The right way.
pub fn right(a: DVec3, b: DVec3, n: DVec3) -> f64 {
    angle(a, b) * n.dot(unit(a, b))
}

fn angle(a: DVec3, b: DVec3) -> f64 {
    (b - a).cross(a).length().atan2(a.dot(b))
}

fn unit(a: DVec3, b: DVec3) -> DVec3 {
    (b - a).cross(a).normalize_or_zero()
}

/// Wrong ways.
pub const WRONG: &[(Bug, Edge)] = &[
    (REVERSED, |a, b, n| -right(a, b, n)),
    (NOT_A_UNIT, |a, b, n| angle(a, b) * n.dot(b.cross(a))),
    (NOT_A_UNIT, |a, b, n| angle(a, b) * n.dot(a.cross(b))),
    (SINE_LEFT, |a, b, n| angle(a, b) * n.dot(b.cross(a)) / a.length() / b.length()),
    (SINE_LEFT, |a, b, n| angle(a, b) * n.dot(a.cross(b)) / a.length() / b.length()),
    (NO_ANGLE, |a, b, n| n.dot(unit(a, b))),
    (NO_NORMAL, |a, b, _| angle(a, b)),
    (UNSIGNED, |a, b, n| right(a, b, n).abs()),
    (DEGREES, |a, b, n| right(a, b, n).to_degrees()),
    (ARCSINE, |a, b, n| {
        let sine = b.cross(a).length() / (a.length() * b.length());
        sine.clamp(-1.0, 1.0).asin() * n.dot(unit(a, b))
    }),
];

fn judge(work: &Work, drawn: &[[DVec3; 3]], within: Within) -> Verdict {
    let all = |f: Edge| drawn.iter().map(|&[a, b, n]| f(a, b, n)).collect::<Vec<_>>();
    let suspects: Vec<Suspect> =
        WRONG.iter().map(|&(bug, wrong)| (bug, all(wrong))).collect();
    let place = |k: usize| {
        let [a, b, n] = drawn[k];
        let degrees = angle(a, b).to_degrees();
        format!("a = {a:.3}, b = {b:.3}, {degrees:.3e}° apart, n = {n:.3}")
    };
    compare(&all(work.edge), &all(right), within, &suspects, place)
}

/// Edges from corner to corner, at any angle.
pub fn any(work: &Work, stream: &mut Stream) -> Verdict {
    let mut corner = || direction(stream) * uniform(stream, 0.2, 5.0);
    let drawn: Vec<[DVec3; 3]> =
        (0..40).map(|_| [corner(), corner(), corner().normalize()]).collect();
    judge(work, &drawn, Within::Absolute(1e-9))
}

/// Edges of 1e-8 to 1e-6 rad, which add as often as they take away.
pub fn short(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |k: usize| {
        let (frame, scale) = (frame(stream), uniform(stream, 0.5, 2.0));
        let b = frame.x + frame.y * decades(stream, 1e-8, 1e-6);
        let up = if k.is_multiple_of(2) { frame.z } else { -frame.z };
        let n = up + frame.x * uniform(stream, -0.5, 0.5);
        [frame.x * scale, b * scale, n.normalize()]
    };
    let drawn: Vec<[DVec3; 3]> = (0..20).map(&mut draw).collect();
    let verdict = judge(work, &drawn, Within::Relative(1e-6));
    digits_of(verdict, FLAT_COSINE, || any(work, stream))
}

/// Edges whose corners lie in one direction.
pub fn aligned(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || {
        let a = direction(stream);
        (work.edge)(a, 2.0 * a, direction(stream))
    };
    let got: Vec<f64> = (0..10).map(|_| draw()).collect();
    // Of γ alone, found from its cosine, √ε may be left.
    let within = Within::Absolute(1e-7);
    let verdict = compare(&got, &[0.0; 10], within, &[], |_| "b = 2a".to_string());
    let nan = got.iter().any(|x| x.is_nan());
    Verdict { bug: nan.then_some(ZERO_BY_ZERO), ..verdict }
}
