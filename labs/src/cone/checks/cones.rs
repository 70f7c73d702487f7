//! Tasks 1 to 3: cones, and round lamps in them.

use super::super::Work;
use super::super::bugs::*;
use super::super::given::Cap;
use super::{Suspects, beside, cone, suspects};
use crate::check::{Verdict, Within, compare};
use crate::draw::{decades, uniform};
use radiosity::random::Stream;
use std::f64::consts::{FRAC_PI_2, PI};

fn size(a: f64) -> f64 {
    PI * (2.0 * (a / 2.0).sin()).powi(2)
}

const WRONG_SIZES: &Suspects<f64, f64> = &[
    (WHOLE_ANGLE, |&a| size(2.0 * a)),
    (WHOLE_ANGLE, |&a| size(a / 2.0)),
    (PROJECTED, |&a| PI * a.sin().powi(2)),
    (FLAT, |&a| PI * a * a),
];

fn judge_sizes(
    work: &Work,
    drawn: &[f64],
    expected: &[f64],
    within: Within,
) -> Verdict {
    let got: Vec<f64> = drawn.iter().map(|&a| (work.solid_angle)(a)).collect();
    let place = |k: usize| format!("half angle {:.4e} rad", drawn[k]);
    compare(&got, expected, within, &suspects(WRONG_SIZES, drawn), place)
}

/// `G12-cone-5`, `-30`, `I5-cap-60` and `-90`, and others.
pub(super) fn sizes(work: &Work, stream: &mut Stream) -> Verdict {
    let mut drawn = [5.0_f64, 30.0, 60.0, 90.0].map(f64::to_radians).to_vec();
    let known = [0.023_909_417_039_326_92, 0.841_787_214_476_933, PI, 2.0 * PI];
    drawn.extend((0..10).map(|_| uniform(stream, 0.1, FRAC_PI_2)));
    let rest = drawn[4..].iter().map(|&a| size(a));
    let expected: Vec<f64> = known.into_iter().chain(rest).collect();
    judge_sizes(work, &drawn, &expected, Within::Relative(1e-9))
}

/// Down to 1e-7 rad; 1 − cos a is noise there.
pub(super) fn narrow(work: &Work, stream: &mut Stream) -> Verdict {
    let drawn: Vec<f64> = (0..10).map(|_| decades(stream, 1e-7, 1e-5)).collect();
    let expected: Vec<f64> = drawn.iter().map(|&a| size(a)).collect();
    let verdict = judge_sizes(work, &drawn, &expected, Within::Relative(1e-9));
    if verdict.passed() {
        return verdict;
    }
    // Here the flat disc, and what is projected, are right as well.
    let wide = sizes(work, stream);
    let bug = if wide.passed() { Some(CANCELS) } else { wide.bug };
    Verdict { bug, ..verdict }
}

/// A half angle and a tilt.
type Tilted = (f64, f64);

const WRONG_TILTED: &Suspects<Tilted, f64> = &[
    (SOLID, |&(a, t)| size(a) * t.cos()),
    (NO_TILT, |&(a, _)| PI * a.sin().powi(2)),
    (NOT_SQUARED, |&(a, t)| PI * a.sin() * t.cos()),
    (NO_PI, |&(a, t)| a.sin().powi(2) * t.cos()),
    (WHOLE_ANGLE, |&(a, t)| PI * (2.0 * a).sin().powi(2) * t.cos()),
    (WHOLE_ANGLE, |&(a, t)| PI * (a / 2.0).sin().powi(2) * t.cos()),
];

/// `I9-tiltcap-10-30` and `-30-45`, `G12-cone-5`, and others.
pub(super) fn tilted(work: &Work, stream: &mut Stream) -> Verdict {
    let known = [(10.0, 30.0), (30.0, 45.0), (5.0, 0.0)];
    let values = [0.082_039_114_557_863_45, 0.555_360_367_269_795_8];
    let degrees = |(a, t): (f64, f64)| (a.to_radians(), t.to_radians());
    let mut drawn: Vec<Tilted> = known.map(degrees).to_vec();
    drawn.extend((0..10).map(|_| {
        let a = uniform(stream, 0.1, 1.4);
        (a, uniform(stream, 0.0, FRAC_PI_2 - a))
    }));
    let rest = drawn[2..].iter().map(|&(a, t)| PI * a.sin().powi(2) * t.cos());
    let expected: Vec<f64> = values.into_iter().chain(rest).collect();
    let got: Vec<f64> = drawn.iter().map(|&(a, t)| (work.projected)(a, t)).collect();
    let place =
        |k: usize| format!("half angle {:.4}, tilt {:.4}", drawn[k].0, drawn[k].1);
    let suspects = suspects(WRONG_TILTED, &drawn);
    compare(&got, &expected, Within::Relative(1e-9), &suspects, place)
}

/// A cone and a lamp.
type Shared = (Cap, Cap);

fn apart(&(cone, lamp): &Shared) -> f64 {
    cone.axis.angle_between(lamp.axis)
}

/// The overlap in sr: two sectors, less the two triangles between the axes and the
/// points where the rims cross, by Gauss and Bonnet.
fn overlap(shared: &Shared) -> f64 {
    let (a, b, d) = (shared.0.half_angle, shared.1.half_angle, apart(shared));
    if d >= a + b {
        return 0.0;
    }
    if d <= (a - b).abs() {
        return size(a.min(b));
    }
    let half = |own: f64, other: f64| {
        let cosine = (other.cos() - d.cos() * own.cos()) / (d.sin() * own.sin());
        cosine.clamp(-1.0, 1.0).acos()
    };
    let corner = (d.cos() - a.cos() * b.cos()) / (a.sin() * b.sin());
    let turned = half(a, b) * a.cos() + half(b, a) * b.cos();
    2.0 * (PI - corner.clamp(-1.0, 1.0).acos() - turned)
}

/// The same for flat discs.
fn flat_overlap(shared: &Shared) -> f64 {
    let (a, b, d) = (shared.0.half_angle, shared.1.half_angle, apart(shared));
    if d >= a + b {
        return 0.0;
    }
    if d <= (a - b).abs() {
        return PI * a.min(b).powi(2);
    }
    let segment = |r: f64, other: f64| {
        let x = (d * d + r * r - other * other) / (2.0 * d);
        r * r * (x / r).acos() - x * (r * r - x * x).max(0.0).sqrt()
    };
    segment(a, b) + segment(b, a)
}

fn share(shared: &Shared) -> f64 {
    overlap(shared) / size(shared.0.half_angle)
}

const WRONG_SHARES: &Suspects<Shared, f64> = &[
    (OF_THE_LAMP, |s| overlap(s) / size(s.1.half_angle)),
    (STERADIANS, overlap),
    (ALL_OR_NOTHING, |s| f64::from(apart(s) < s.1.half_angle)),
    (FLAT_DISCS, |s| flat_overlap(s) / (PI * s.0.half_angle.powi(2))),
    (FLAT_DISCS, |s| flat_overlap(s) / size(s.0.half_angle)),
];

fn judge_shares(work: &Work, drawn: &[Shared]) -> Verdict {
    let got: Vec<f64> =
        drawn.iter().map(|&(cone, lamp)| (work.share)(cone, lamp)).collect();
    let expected: Vec<f64> = drawn.iter().map(share).collect();
    let place = |k: usize| {
        let (cone, lamp) = drawn[k];
        format!(
            "cone of {:.3} rad, lamp of {:.3}, {:.3} apart",
            cone.half_angle,
            lamp.half_angle,
            apart(&drawn[k])
        )
    };
    let suspects = suspects(WRONG_SHARES, drawn);
    let verdict = compare(&got, &expected, Within::Absolute(1e-9), &suspects, place);
    match got.iter().any(|share| share.is_nan()) {
        true => Verdict { bug: Some(NO_TRIANGLE), ..verdict },
        false => verdict,
    }
}

/// A cone and a lamp, so far apart: 0 where the one's rim begins to leave the other, 1
/// where they part.
fn pair(stream: &mut Stream, [low, high]: [f64; 2]) -> Shared {
    let (a, b) = (uniform(stream, 0.2, 1.2), uniform(stream, 0.2, 1.2));
    let (inner, outer) = ((a - b).abs(), a + b);
    let cone = cone(stream, a);
    let apart = inner + (outer - inner) * uniform(stream, low, high);
    let axis = beside(stream, cone, apart);
    (cone, Cap { axis, half_angle: b })
}

pub(super) fn cut(work: &Work, stream: &mut Stream) -> Verdict {
    let drawn: Vec<Shared> = (0..15).map(|_| pair(stream, [0.1, 0.9])).collect();
    judge_shares(work, &drawn)
}

/// Lamps beside the cone, in it, and such as fill it.
pub(super) fn clear(work: &Work, stream: &mut Stream) -> Verdict {
    let mut drawn: Vec<Shared> = (0..5).map(|_| pair(stream, [1.05, 1.2])).collect();
    for k in 0..8 {
        let (small, large) = (uniform(stream, 0.1, 0.5), uniform(stream, 0.7, 1.2));
        let (a, b) = if k % 2 == 0 { (large, small) } else { (small, large) };
        let cone = cone(stream, a);
        let apart = uniform(stream, 0.05, 0.9 * (large - small));
        drawn.push((cone, Cap { axis: beside(stream, cone, apart), half_angle: b }));
    }
    judge_shares(work, &drawn)
}
