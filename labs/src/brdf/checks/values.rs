//! Values of the lobes, above the horizon and below it.

use super::super::Work;
use super::super::bugs::*;
use super::{Value, at, bare, density, mirrored, phong, power, upper};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{direction, uniform, whole_number};
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;
use std::f64::consts::{PI, TAU};

pub(super) const WRONG_LOBES: &[(Bug, Value)] = &[
    (NO_CONSTANT, bare),
    (OF_DENSITY, density),
    (COSINE_INSIDE, |n, wi, wo| phong(n, wi, wo) * wi.z),
    (COSINE_INSIDE, |n, wi, wo| phong(n, wi, wo) * wo.z),
    (COSINE_INSIDE, |n, wi, wo| density(n, wi, wo) * wi.z),
    (OVER_COSINE, |n, wi, wo| phong(n, wi, wo) / wi.z),
    (OVER_COSINE, |n, wi, wo| bare(n, wi, wo) / wi.z),
    (OVER_COSINE, |n, wi, wo| density(n, wi, wo) / wi.z),
    (RETRO, |n, wi, wo| (n + 2.0) / TAU * power(wi.dot(wo), n)),
    (RETRO, |n, wi, wo| (n + 2.0) / TAU * power(-mirrored(wo).dot(wi), n)),
    (ABOUT_NORMAL, |n, wi, _| (n + 2.0) / TAU * power(wi.z, n)),
    (ABOUT_NORMAL, |n, _, wo| (n + 2.0) / TAU * power(wo.z, n)),
    (HALFWAY, |n, wi, wo| (n + 2.0) / TAU * power((wi + wo).normalize().z, n)),
];

pub(super) const WRONG_DENSITIES: &[(Bug, Value)] = &[
    (OF_BRDF, phong),
    (NO_CONSTANT, bare),
    (COSINE_INSIDE, |n, wi, wo| phong(n, wi, wo) * wi.z),
    (COSINE_INSIDE, |n, wi, wo| density(n, wi, wo) * wi.z),
    (OVER_COSINE, |n, wi, wo| density(n, wi, wo) / wi.z),
    (RETRO, |n, wi, wo| (n + 1.0) / TAU * power(wi.dot(wo), n)),
    (ABOUT_NORMAL, |n, wi, _| (n + 1.0) / TAU * power(wi.z, n)),
];

/// What is asked: an exponent, `wi`, `wo`.
type Asked = (f64, DVec3, DVec3);

fn asked(&(n, wi, wo): &Asked) -> String {
    format!("n = {n}, wi = {wi:.3}, wo = {wo:.3}")
}

/// Compares values at these places.
fn values(
    got: &dyn Fn(f64, DVec3, DVec3) -> f64,
    right: Value,
    wrong: &[(Bug, Value)],
    drawn: &[Asked],
) -> Verdict {
    let all = |f: &dyn Fn(f64, DVec3, DVec3) -> f64| {
        drawn.iter().map(|&(n, wi, wo)| f(n, wi, wo)).collect::<Vec<f64>>()
    };
    let suspects: Vec<Suspect> = wrong.iter().map(|(bug, f)| (*bug, all(f))).collect();
    let within = Within::Absolute(1e-9);
    compare(&all(got), &all(&right), within, &suspects, |k| asked(&drawn[k]))
}

pub(super) fn lambert(work: &Work, stream: &mut Stream) -> Verdict {
    // The reflectance stands in the place of the exponent.
    let drawn: Vec<Asked> = (0..20)
        .map(|_| (uniform(stream, 0.1, 0.9), upper(stream), upper(stream)))
        .collect();
    let wrong: &[(Bug, Value)] = &[
        (NO_PI, |rho, _, _| rho),
        (OTHER_PI, |rho, _, _| rho / TAU),
        (OTHER_PI, |rho, _, _| rho * PI),
        (COSINE_INSIDE, |rho, wi, _| rho * wi.z / PI),
        (COSINE_INSIDE, |rho, wi, _| rho * wi.z),
        (COSINE_INSIDE, |rho, _, wo| rho * wo.z / PI),
    ];
    values(&work.lambert, |rho, _, _| rho / PI, wrong, &drawn)
}

/// Values of lobes, above the horizon and before the lobe's end.
pub(super) fn lobes(
    got: Value,
    right: Value,
    wrong: &[(Bug, Value)],
    s: &mut Stream,
) -> Verdict {
    let mut draw = || loop {
        let (wi, wo) = (upper(s), upper(s));
        if mirrored(wo).dot(wi) > 0.1 {
            return (whole_number(s, 2, 30) as f64, wi, wo);
        }
    };
    let drawn: Vec<Asked> = (0..40).map(|_| draw()).collect();
    values(&got, right, wrong, &drawn)
}

/// Where nothing may be: below the horizon, and with `behind` also before the surface,
/// where the lobe has ended.
pub(super) fn below(
    got: &dyn Fn(f64, DVec3, DVec3) -> f64,
    s: &mut Stream,
    behind: bool,
) -> Verdict {
    let flip = |w: DVec3| dvec3(w.x, w.y, -w.z);
    let mut drawn: Vec<Asked> = Vec::new();
    for k in 0..30 {
        let (n, wi) = (whole_number(s, 2, 6) as f64, upper(s));
        // Near the mirror image, so that the lobe has something there.
        let wo = (mirrored(wi) + 0.3 * direction(s)).normalize();
        let wo = dvec3(wo.x, wo.y, wo.z.abs().max(0.05)).normalize();
        drawn.push(match k % 3 {
            0 => (n, flip(wi), wo),
            1 => (n, wi, flip(wo)),
            _ => (n, flip(wi), flip(wo)),
        });
    }
    // One on the slope to the lamp's side of a flat eye: the lobe itself is there.
    let flat = at(85.0, s);
    drawn.push((2.0, mirrored(dvec3(flat.x, flat.y, -0.1).normalize()), flat));
    let verdict = values(got, |_, _, _| 0.0, &[], &drawn);
    if !verdict.passed() {
        return Verdict { bug: Some(THROUGH), ..verdict };
    }
    if !behind {
        return verdict;
    }
    let back = |k: u32| {
        let flat = at(70.0 + f64::from(k), s);
        (f64::from(2 + k % 5), flat, flat) // α is 140° and more
    };
    let drawn: Vec<Asked> = (0..15).map(back).collect();
    let verdict = values(got, |_, _, _| 0.0, &[], &drawn);
    match verdict.passed() {
        true => verdict,
        false => Verdict { bug: Some(LOBE_BEHIND), ..verdict },
    }
}

/// The student's own value, with lamp and eye exchanged.
pub(super) fn reciprocal(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || {
        let wi = upper(stream);
        let wo = (mirrored(wi) + 0.5 * upper(stream)).normalize();
        (whole_number(stream, 1, 12) as f64, wi, wo)
    };
    let drawn: Vec<Asked> = (0..20).map(|_| draw()).collect();
    let all = |f: &dyn Fn(&Asked) -> f64| drawn.iter().map(f).collect::<Vec<f64>>();
    let there = all(&|&(n, wi, wo)| (work.phong)(n, wi, wo));
    let back = all(&|&(n, wi, wo)| (work.phong)(n, wo, wi));
    let place = |k: usize| format!("{}, against exchanged", asked(&drawn[k]));
    let verdict = compare(&there, &back, Within::Absolute(1e-9), &[], place);
    match verdict.passed() {
        true => verdict,
        false => Verdict { bug: Some(NOT_RECIPROCAL), ..verdict },
    }
}
