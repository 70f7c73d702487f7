//! Albedos, samples, and what they are together.

use super::super::Work;
use super::super::bugs::*;
use super::{at, mirrored, phong};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{uniform, whole_number};
use radiosity::material::Lobe;
use radiosity::prelude::{DVec3, Frame, dvec3};
use radiosity::random::Stream;
use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Albedos of the accuracy tables: name, exponent (0 for Lambert's ½), degrees, albedo.
const ALBEDOS: [(&str, f64, f64, f64); 6] = [
    ("I3-lambert-0.5", 0.0, 40.0, 0.5),
    ("I1-phong-n5-th0", 5.0, 0.0, 1.0),
    ("I1-phong-n1-th60", 1.0, 60.0, 0.608_997_781_044_229_3),
    ("I1-phong-n5-th45", 5.0, 45.0, 0.710_393_349_121_331_9),
    ("I1-phong-n20-th60", 20.0, 60.0, 0.500_509_497_987_877_7),
    ("I1-phong-n10-th75", 10.0, 75.0, 0.291_901_015_166_934_84),
];

/// How an integral may go: how far round, with which weight of sinθ, the cosine of `wi`
/// and that of `wo`, and times what.
struct Rule {
    turn: f64,
    weight: fn(f64, f64, f64) -> f64,
    factor: f64,
}

const RULE: Rule = Rule { turn: TAU, weight: |s, c, _| s * c, factor: 1.0 };

const WRONG_RULES: &[(Bug, Rule)] = &[
    (NO_COSINE, Rule { weight: |s, _, _| s, ..RULE }),
    (COSINE_TWICE, Rule { weight: |s, c, _| s * c * c, ..RULE }),
    (COSINE_TWICE, Rule { weight: |s, c, o| s * c * o, ..RULE }),
    (OTHER_COSINE, Rule { weight: |s, _, o| s * o, ..RULE }),
    (NO_SINE, Rule { weight: |_, c, _| c, ..RULE }),
    (HALF_TURN, Rule { turn: PI, ..RULE }),
    (PI_AGAIN, Rule { factor: PI, ..RULE }),
    (PI_AGAIN, Rule { factor: 1.0 / PI, ..RULE }),
];

/// As [`phong`], but with exponent 0 for a Lambert surface of reflectance ½.
fn brdf(n: f64, wi: DVec3, wo: DVec3) -> f64 {
    match n > 0.0 {
        true => phong(n, wi, wo),
        false if wi.z > 0.0 && wo.z > 0.0 => 0.5 / PI,
        false => 0.0,
    }
}

fn by_rule(rule: &Rule, n: f64, wo: DVec3, rings: usize) -> f64 {
    let (dtheta, dphi) = (FRAC_PI_2 / rings as f64, rule.turn / (4 * rings) as f64);
    let mut sum = 0.0;
    for ring in 0..rings {
        let (s, c) = ((ring as f64 + 0.5) * dtheta).sin_cos();
        for piece in 0..4 * rings {
            let (y, x) = ((piece as f64 + 0.5) * dphi).sin_cos();
            let f = brdf(n, dvec3(s * x, s * y, c), wo);
            sum += f * (rule.weight)(s, c, wo.z);
        }
    }
    sum * rule.factor * dtheta * dphi
}

pub(super) fn albedo(work: &Work, stream: &mut Stream) -> Verdict {
    const RINGS: usize = 48;
    let eyes = ALBEDOS.map(|(_, _, degrees, _)| at(degrees, stream));
    let longest = Cell::new(1.0_f64);
    let of = |k: usize| {
        let n = ALBEDOS[k].1;
        let look = |wi: DVec3, wo: DVec3| {
            let off = wi.length().max(1.0 / wi.length());
            longest.set(longest.get().max(off));
            brdf(n, wi, wo)
        };
        (work.albedo)(&look, eyes[k], RINGS)
    };
    let got: Vec<f64> = (0..ALBEDOS.len()).map(of).collect();
    if longest.get() > 1.0 + 1e-9 {
        let message = format!("a direction off unit length by ×{:.3}", longest.get());
        return Verdict::fail(message, Some(NOT_UNIT));
    }
    let expected = ALBEDOS.map(|case| case.3);
    let all = |rule: &Rule| {
        let one = |k: usize| by_rule(rule, ALBEDOS[k].1, eyes[k], RINGS);
        (0..ALBEDOS.len()).map(one).collect::<Vec<f64>>()
    };
    let suspects: Vec<Suspect> =
        WRONG_RULES.iter().map(|(bug, rule)| (*bug, all(rule))).collect();
    let h = FRAC_PI_2 / RINGS as f64;
    let place = |k: usize| format!("{}, turned", ALBEDOS[k].0);
    compare(&got, &expected, Within::Relative(3.0 * h * h), &suspects, place)
}

/// How samples may be drawn: of an exponent, `wo` and two numbers.
type Draw = fn(f64, DVec3, [f64; 2]) -> DVec3;

/// A direction about `axis` whose cosine to it is given.
fn about(axis: DVec3, cosine: f64, turn: f64) -> DVec3 {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let (y, x) = (TAU * turn).sin_cos();
    Frame::about(axis).world_from_local(dvec3(sine * x, sine * y, cosine))
}

const WRONG_DRAWS: &[(Bug, Draw)] = &[
    (ROOT, |n, wo, u| about(mirrored(wo), u[0].powf(1.0 / n), u[1])),
    (ROOT, |n, wo, u| about(mirrored(wo), u[0].powf(1.0 / (n + 2.0)), u[1])),
    (ROOT, |n, wo, u| about(mirrored(wo), u[0].powf(0.5 / (n + 1.0)), u[1])),
    (ROOT, |n, wo, u| about(mirrored(wo), u[0].powf(n), u[1])),
    (ROOT, |n, wo, u| about(mirrored(wo), u[0].powf(n + 1.0), u[1])),
    (UNIFORM, |_, wo, u| about(mirrored(wo), u[0], u[1])),
    (UNIFORM, |_, _, u| about(DVec3::Z, u[0], u[1])),
    (ABOUT_NORMAL, |n, _, u| about(DVec3::Z, u[0].powf(1.0 / (n + 1.0)), u[1])),
    (RETRO, |n, wo, u| about(wo, u[0].powf(1.0 / (n + 1.0)), u[1])),
    (RETRO, |n, wo, u| about(-mirrored(wo), u[0].powf(1.0 / (n + 1.0)), u[1])),
];

/// The mean of N × N even samples, and the mean square of their cosine to the lobe's axis.
fn moments(draw: Draw, n: f64, wo: DVec3) -> [f64; 4] {
    const N: u32 = 128;
    let even = |k: u32| (f64::from(k) + 0.5) / f64::from(N);
    let (mut mean, mut square) = (DVec3::ZERO, 0.0);
    for k in 0..N * N {
        let w = draw(n, wo, [even(k % N), even(k / N)]);
        mean += w / f64::from(N * N);
        square += mirrored(wo).dot(w).powi(2) / f64::from(N * N);
    }
    [mean.x, mean.y, mean.z, square]
}

/// Samples by their moments, which are known:
///
/// ```text
/// E ω = (n + 1)/(n + 2) · axis        E cos²α = (n + 1)/(n + 3)
/// ```
pub(super) fn sample(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |n: f64| (n, at(uniform(stream, 25.0, 40.0), stream));
    let drawn = [2.0, 3.0, 5.0, 8.0].map(&mut draw);
    let (n, wo) = drawn[0];
    let lengths = (0..64).map(|k| {
        let u = f64::from(k) / 64.0;
        (work.sample)(n, wo, [u, (7.0 * u).fract()]).length()
    });
    if let Some(length) = lengths.into_iter().find(|l| (l - 1.0).abs() > 1e-6) {
        let message = format!("a direction of length {length:.3} was drawn");
        return Verdict::fail(message, Some(NOT_UNIT));
    }
    let all = |f: Draw| drawn.iter().flat_map(|&(n, wo)| moments(f, n, wo)).collect();
    let exact = |&(n, wo): &(f64, DVec3)| {
        let mean = (n + 1.0) / (n + 2.0) * mirrored(wo);
        [mean.x, mean.y, mean.z, (n + 1.0) / (n + 3.0)]
    };
    let expected: Vec<f64> = drawn.iter().flat_map(exact).collect();
    let suspects: Vec<Suspect> =
        WRONG_DRAWS.iter().map(|&(bug, f)| (bug, all(f))).collect();
    let place = |k: usize| {
        let what = ["mean x", "mean y", "mean z", "mean cos²α"][k % 4];
        let (n, wo) = drawn[k / 4];
        format!("n = {n}, wo = {wo:.3}, {what}")
    };
    let got: Vec<f64> = all(work.sample);
    compare(&got, &expected, Within::Absolute(4e-3), &suspects, place)
}

pub(super) fn passive(work: &Work, stream: &mut Stream) -> Verdict {
    type Passive = fn([f64; 3], [f64; 3]) -> bool;
    let all_channels =
        |d: [f64; 3], s: [f64; 3]| d.iter().zip(s).all(|(d, s)| d + s <= 1.0);
    // Exact in binary: a sum of 1 is 1.
    let mut drawn = vec![
        ([0.5, 0.25, 0.75], [0.5, 0.5, 0.25]),
        ([0.0; 3], [1.0; 3]),
        ([0.5, 0.25, 0.25], [0.625, 0.25, 0.25]),
        ([0.75; 3], [0.75; 3]),
    ];
    for _ in 0..30 {
        let mut three = |most: f64| [0; 3].map(|_| uniform(stream, 0.0, most));
        drawn.push((three(0.7), three(0.6)));
    }
    let wrong: &[(Bug, Passive)] = &[
        (EACH_ALONE, |d, s| d.iter().chain(&s).all(|&k| k <= 1.0)),
        (EACH_ALONE, |d, s| d.iter().chain(&s).all(|&k| k < 1.0)),
        (MEAN_OF_CHANNELS, |d, s| d.iter().chain(&s).sum::<f64>() <= 3.0),
        (MEAN_OF_CHANNELS, |d, s| d.iter().chain(&s).sum::<f64>() <= 1.0),
        (STRICT, |d, s| d.iter().zip(s).all(|(d, s)| d + s < 1.0)),
    ];
    let all = |f: Passive| {
        drawn.iter().map(|&(d, s)| f64::from(f(d, s))).collect::<Vec<f64>>()
    };
    let suspects: Vec<Suspect> = wrong.iter().map(|&(bug, f)| (bug, all(f))).collect();
    let place = |k: usize| {
        let (d, s) = drawn[k];
        format!("kd = {d:.3?}, ks = {s:.3?} (1 is passive, 0 not)")
    };
    let expected = all(all_channels);
    compare(&all(work.passive), &expected, Within::Absolute(0.0), &suspects, place)
}

/// The student's albedo of the student's BRDFs: ρ, and 1 straight above a lobe.
pub(super) fn furnace(work: &Work, stream: &mut Stream) -> Verdict {
    const RINGS: usize = 48;
    let rho = uniform(stream, 0.2, 1.0);
    let n = whole_number(stream, 1, 10) as f64;
    let white = |wi: DVec3, wo: DVec3| (work.lambert)(rho, wi, wo);
    let gloss = |wi: DVec3, wo: DVec3| (work.phong)(n, wi, wo);
    let got = [
        (work.albedo)(&white, at(60.0, stream), RINGS),
        (work.albedo)(&gloss, DVec3::Z, RINGS),
    ];
    let place = |k: usize| match k {
        0 => format!("Lambert, ρ = {rho:.3}, at 60°"),
        _ => format!("Phong, n = {n}, at 0°"),
    };
    compare(&got, &[rho, 1.0], Within::Relative(5e-3), &[], place)
}

/// The mean of `f cosθ / pdf` over the student's samples, which is the albedo.
pub(super) fn weights(work: &Work, stream: &mut Stream) -> Verdict {
    const N: u32 = 128;
    let even = |k: u32| (f64::from(k) + 0.5) / f64::from(N);
    let cases = [3.0, 12.0, 50.0].map(|n| (n, at(uniform(stream, 20.0, 70.0), stream)));
    let mean = |&(n, wo): &(f64, DVec3)| {
        let one = |k: u32| {
            let wi = (work.sample)(n, wo, [even(k % N), even(k / N)]);
            let reflected = (work.phong)(n, wi, wo) * wi.z;
            if wi.z > 0.0 { reflected / (work.pdf)(n, wi, wo) } else { 0.0 }
        };
        (0..N * N).map(one).sum::<f64>() / f64::from(N * N)
    };
    let exact = |&(n, wo): &(f64, DVec3)| {
        Lobe::Phong { exponent: n }.albedo(wo.z.clamp(0.0, 1.0))
    };
    let got: Vec<f64> = cases.iter().map(mean).collect();
    let expected: Vec<f64> = cases.iter().map(exact).collect();
    let place = |k: usize| format!("n = {}, wo = {:.3}", cases[k].0, cases[k].1);
    compare(&got, &expected, Within::Absolute(1e-2), &[], place)
}
