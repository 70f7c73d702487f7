//! The checks of this lab.
//!
//! ```text
//! |Ĥ − H| ≤ h²/4 · H     a smooth sky by rings of width h: the rule at their middle
//! |Ĥ − H| ≤ L · 2π sinα · h/2     a lamp with a rim, of half-angle α
//! ```
//! The first bound is that of the sky that shines near the horizon, the worst one here;
//! four times as much is allowed, so that other rules pass too. Of the second, a cell on
//! the rim counts wholly or not at all: half a cell's width along the rim.

use super::Work;
use super::bugs::*;
use super::given::{Sent, Spot};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{direction, uniform};
use crate::lab::{Check, check};
use radiosity::prelude::{DVec3, dvec3};
use radiosity::radiometry::projected_solid_angle_of_cap;
use radiosity::random::Stream;
use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "radiosity", "the radiosity of a lamp is right", 1, |w, s| {
        lamp(
            w.radiosity,
            s,
            |flux, area| flux / area,
            &[
                (TIMES_AREA, |flux, area| flux * area),
                (PI_TOO_EARLY, |flux, area| flux / (PI * area)),
            ],
        )
    }),
    check(1, "radiance", "the radiance of a lamp is right", 1, |w, s| {
        lamp(
            w.radiance,
            s,
            |flux, area| flux / (PI * area),
            &[
                (TIMES_AREA, |flux, area| flux * area / PI),
                (NO_PI, |flux, area| flux / area),
                (PI_UPSIDE_DOWN, |flux, area| PI * flux / area),
                (TWO_PI, |flux, area| flux / (TAU * area)),
            ],
        )
    }),
    check(2, "bulb", "a bulb lights a receiver from any side", 2, bulb),
    check(2, "surface", "a small surface lights a receiver from any side", 2, surface),
    check(3, "skies", "smooth skies give the right irradiance", 3, skies),
    check(3, "lamps", "a round lamp in the sky does too", 1, lamps),
    check(
        4,
        "reflected",
        "radiosity and radiance of a surface are right",
        2,
        reflected,
    ),
    check(5, "furnace", "in a uniform glow a surface sends the share ρ", 1, furnace),
    check(5, "chain", "from a lamp's flux to a wall's radiance", 1, chain),
];

type OfLamp = fn(f64, f64) -> f64;

/// A conversion from flux and area.
fn lamp(
    work: OfLamp,
    stream: &mut Stream,
    right: OfLamp,
    wrong: &[(Bug, OfLamp)],
) -> Verdict {
    let mut draw = || (uniform(stream, 5.0, 200.0), uniform(stream, 0.01, 0.8));
    let drawn: Vec<(f64, f64)> = (0..10).map(|_| draw()).collect();
    let all = |f: OfLamp| drawn.iter().map(|&(flux, a)| f(flux, a)).collect::<Vec<_>>();
    let suspects: Vec<Suspect> = wrong.iter().map(|&(bug, f)| (bug, all(f))).collect();
    let place = |k: usize| format!("{:.2} W from {:.3} m²", drawn[k].0, drawn[k].1);
    compare(&all(work), &all(right), Within::Relative(1e-12), &suspects, place)
}

/// Two spots a few metres apart, with their cosines towards each other and the distance.
#[derive(Clone, Copy)]
struct Pair {
    source: Spot,
    receiver: Spot,
    cosines: [f64; 2],
    r: f64,
}

/// Pairs in all attitudes: of each four, one sees front to front.
fn pairs(stream: &mut Stream) -> Vec<Pair> {
    let mut spot = |reach: f64| {
        let normal = direction(stream);
        Spot { at: direction(stream) * uniform(stream, 0.0, reach), normal }
    };
    let mut pair = || {
        let (source, mut receiver) = (spot(1.0), spot(2.0));
        receiver.at += DVec3::splat(2.0);
        let way = receiver.at - source.at;
        let r = way.length();
        let cosines = [source.normal.dot(way) / r, -receiver.normal.dot(way) / r];
        Pair { source, receiver, cosines, r }
    };
    (0..40).map(|_| pair()).collect()
}

/// What arrives, of the cosines of source and receiver and the distance.
type Arrives<'a> = &'a dyn Fn(f64, f64, f64) -> f64;

/// Compares what arrives; suspects are functions of the cosines and the distance.
fn arrives(
    got: &dyn Fn(&Pair) -> f64,
    right: Arrives,
    wrong: &[(Bug, Arrives)],
    stream: &mut Stream,
) -> Verdict {
    let pairs = pairs(stream);
    let all = |f: Arrives| {
        pairs.iter().map(|p| f(p.cosines[0], p.cosines[1], p.r)).collect::<Vec<_>>()
    };
    let suspects: Vec<Suspect> = wrong.iter().map(|(bug, f)| (*bug, all(f))).collect();
    let place = |k: usize| {
        let Pair { cosines: [source, receiver], r, .. } = pairs[k];
        format!("r = {r:.3}, cosines {source:.3} (source) and {receiver:.3} (receiver)")
    };
    let got: Vec<f64> = pairs.iter().map(got).collect();
    compare(&got, &all(right), Within::Absolute(1e-12), &suspects, place)
}

fn cut(cosine: f64) -> f64 {
    cosine.max(0.0)
}

/// 1 on the front, 0 on the back.
fn front(cosine: f64) -> f64 {
    if cosine > 0.0 { 1.0 } else { 0.0 }
}

fn bulb(work: &Work, stream: &mut Stream) -> Verdict {
    let flux = uniform(stream, 10.0, 100.0);
    let each = flux / (4.0 * PI);
    let got = |p: &Pair| (work.from_bulb)(flux, p.source.at, p.receiver);
    arrives(
        &got,
        &|_, c, r| each * cut(c) / r / r,
        &[
            (NO_COSINE, &|_, _, r| each / r / r),
            (NO_COSINE, &|_, c, r| each * front(c) / r / r),
            (DISTANCE, &|_, c, r| each * cut(c) / r),
            (DISTANCE, &|_, c, r| each * c / r),
            (DISTANCE, &|_, c, r| each * cut(c) / r.powi(3)),
            (NOT_ALL_ROUND, &|_, c, r| 2.0 * each * cut(c) / r / r),
            (NOT_ALL_ROUND, &|_, c, r| 4.0 * each * cut(c) / r / r),
            (NOT_ALL_ROUND, &|_, c, r| flux * cut(c) / r / r),
            (FROM_BEHIND, &|_, c, r| each * c / r / r),
            (FROM_BEHIND, &|_, c, r| each * c.abs() / r / r),
            (FROM_BEHIND, &|_, c, r| each * cut(-c) / r / r),
        ],
        stream,
    )
}

fn surface(work: &Work, stream: &mut Stream) -> Verdict {
    let (radiance, area) = (uniform(stream, 1.0, 30.0), uniform(stream, 0.01, 0.1));
    let la = radiance * area;
    let got = |p: &Pair| (work.from_surface)(radiance, area, p.source, p.receiver);
    arrives(
        &got,
        &|s, c, r| la * cut(s) * cut(c) / r / r,
        &[
            (NO_COSINE, &|s, c, r| la * cut(s) * front(c) / r / r),
            (NO_COSINE, &|s, _, r| la * cut(s) / r / r),
            (NO_SOURCE_COSINE, &|s, c, r| la * front(s) * cut(c) / r / r),
            (NO_SOURCE_COSINE, &|_, c, r| la * cut(c) / r / r),
            (NO_COSINES, &|s, c, r| la * front(s) * front(c) / r / r),
            (NO_COSINES, &|_, _, r| la / r / r),
            (DISTANCE, &|s, c, r| la * cut(s) * cut(c) / r),
            (DISTANCE, &|s, c, _| la * cut(s) * cut(c)),
            (DISTANCE, &|s, c, r| la * cut(s) * cut(c) / r.powi(4)),
            (PI_AGAIN, &|s, c, r| la * cut(s) * cut(c) / (PI * r * r)),
            (PI_AGAIN, &|s, c, r| PI * la * cut(s) * cut(c) / r / r),
            (FROM_BEHIND, &|s, c, r| la * s * c / r / r),
            (FROM_BEHIND, &|s, c, r| la * cut(s * c) / r / r),
            (FROM_BEHIND, &|s, c, r| la * (s * c).abs() / r / r),
        ],
        stream,
    )
}

/// How an integral over the hemisphere may go: over which θ and φ, with which weight of
/// (sinθ, cosθ), and what the sum is multiplied by, of the number of rings.
struct Rule {
    theta: f64,
    phi: f64,
    weight: fn(f64, f64) -> f64,
    /// Of the two steps and of the number of cells.
    factor: fn(f64, f64, f64) -> f64,
    /// What θ and φ are multiplied by before sin and cos.
    unit: f64,
}

const RIGHT: Rule = Rule {
    theta: FRAC_PI_2,
    phi: TAU,
    weight: |sine, cosine| sine * cosine,
    factor: |dtheta, dphi, _| dtheta * dphi,
    unit: 1.0,
};

const DEGREE: f64 = 180.0 / PI;

/// Wrong rules, with 4n pieces to each of the n rings.
const WRONG_RULES: &[(Bug, Rule)] = &[
    (INTEGRAL_NO_COSINE, Rule { weight: |sine, _| sine, ..RIGHT }),
    (NO_SINE, Rule { weight: |_, cosine| cosine, ..RIGHT }),
    (HALF_TURN, Rule { phi: PI, ..RIGHT }),
    (BELOW, Rule { theta: PI, ..RIGHT }),
    (BELOW, Rule { theta: PI, weight: |s, c| s * c.abs(), ..RIGHT }),
    (NOT_TO_HORIZON, Rule { theta: PI / 4.0, ..RIGHT }),
    (DEGREES, Rule { factor: |t, p, _| t * p * DEGREE * DEGREE, ..RIGHT }),
    (DEGREES, Rule { factor: |t, p, _| t * p * DEGREE, ..RIGHT }),
    (DEGREES, Rule { unit: DEGREE, ..RIGHT }),
    (
        DEGREES,
        Rule { unit: DEGREE, factor: |t, p, _| t * p * DEGREE * DEGREE, ..RIGHT },
    ),
    (NO_STEP, Rule { factor: |_, _, _| 1.0, ..RIGHT }),
    (NO_STEP, Rule { factor: |t, _, _| t, ..RIGHT }),
    (MEAN, Rule { factor: |_, _, cells| 1.0 / cells, ..RIGHT }),
    (MEAN, Rule { factor: |_, _, cells| PI / cells, ..RIGHT }),
    (MEAN, Rule { factor: |_, _, cells| TAU / cells, ..RIGHT }),
    (MEAN, Rule { weight: |_, c| c, factor: |_, _, n| TAU / n, ..RIGHT }),
    (MEAN, Rule { weight: |_, c| c, factor: |_, _, n| PI / n, ..RIGHT }),
    (PI_AGAIN, Rule { factor: |t, p, _| PI * t * p, ..RIGHT }),
    (PI_AGAIN, Rule { factor: |t, p, _| t * p / PI, ..RIGHT }),
];

fn integrate(rule: &Rule, sky: &dyn Fn(DVec3) -> f64, rings: usize) -> f64 {
    let (dtheta, dphi) = (rule.theta / rings as f64, rule.phi / (4 * rings) as f64);
    let mut sum = 0.0;
    for ring in 0..rings {
        let (s, c) = ((ring as f64 + 0.5) * dtheta * rule.unit).sin_cos();
        for piece in 0..4 * rings {
            let (y, x) = ((piece as f64 + 0.5) * dphi * rule.unit).sin_cos();
            sum += sky(dvec3(s * x, s * y, c)) * (rule.weight)(s, c);
        }
    }
    sum * (rule.factor)(dtheta, dphi, (4 * rings * rings) as f64)
}

/// The radiance from a direction.
type SkyView<'a> = &'a dyn Fn(DVec3) -> f64;

/// A sky, by its zenith's radiance: its shape, its name, and its irradiance.
type Sky = (fn(DVec3) -> f64, &'static str, f64);

const SKIES: [Sky; 5] = [
    (|_| 1.0, "uniform, H = π L (I8-cospow-1)", PI),
    (|d| d.z, "L cosθ, H = 2π/3 L (I8-cospow-2)", 2.094_395_102_393_195_7),
    (|d| (1.0 + 2.0 * d.z) / 3.0, "overcast (Moon & Spencer)", 7.0 * PI / 9.0),
    (|d| 1.0 - d.z, "bright at the horizon", PI / 3.0),
    (|d| 1.0 + d.x + d.y, "bright to one side", PI),
];

/// The skies, each times the radiance of its zenith; suspects by the same rule.
fn skies(work: &Work, stream: &mut Stream) -> Verdict {
    const RINGS: usize = 48;
    let zenith = SKIES.map(|_| uniform(stream, 0.5, 20.0));
    let (longest, lowest) = (Cell::new(1.0_f64), Cell::new(0.0_f64));
    let look = |k: usize, d: DVec3| {
        longest.set(longest.get().max(d.length()).max(1.0 / d.length()));
        lowest.set(lowest.get().min(d.z));
        zenith[k] * (SKIES[k].0)(d)
    };
    let all = |f: &dyn Fn(SkyView) -> f64| {
        (0..SKIES.len()).map(|k| f(&|d| look(k, d))).collect::<Vec<f64>>()
    };
    let got = all(&|sky| (work.from_sky)(sky, RINGS));
    let (longest, lowest) = (longest.get(), lowest.get());
    let expected: Vec<f64> = (0..SKIES.len()).map(|k| zenith[k] * SKIES[k].2).collect();
    let h = FRAC_PI_2 / RINGS as f64;
    let within = Within::Relative(h * h);
    let place = |k: usize| format!("sky {}, zenith {:.3}", SKIES[k].1, zenith[k]);
    let mut verdict = compare(&got, &expected, within, &[], place);
    if !verdict.passed() {
        let suspects: Vec<Suspect> = WRONG_RULES
            .iter()
            .map(|(bug, rule)| (*bug, all(&|sky| integrate(rule, sky, RINGS))))
            .collect();
        verdict = compare(&got, &expected, within, &suspects, place);
    }
    if longest > 1.0 + 1e-9 {
        let message = format!("a direction of length {longest:.3} was looked in");
        return Verdict::fail(message, Some(NOT_A_DIRECTION));
    }
    if !verdict.passed() && verdict.bug.is_none() && lowest < -1e-9 {
        return Verdict { bug: Some(BELOW), ..verdict };
    }
    verdict
}

/// Round lamps of the accuracy tables, and one that the horizon cuts: name, half-angle
/// and tilt in degrees, irradiance for a radiance of 1.
const LAMPS: [(&str, f64, f64, f64); 3] = [
    ("I9-tiltcap-30-45", 30.0, 45.0, 0.555_360_367_269_795_8),
    ("I9-tiltcap-10-30", 10.0, 30.0, 0.082_039_114_557_863_45),
    ("a lamp cut by the horizon", 30.0, 80.0, 0.0),
];

fn lamps(work: &Work, stream: &mut Stream) -> Verdict {
    const RINGS: usize = 150;
    let (mut got, mut expected, mut allowed) = (vec![], vec![], 0.0_f64);
    for (_, half_angle, tilt, known) in LAMPS {
        let (radiance, turn) = (uniform(stream, 1.0, 20.0), uniform(stream, 0.0, TAU));
        let (beta, tilt) = (f64::to_radians(half_angle), f64::to_radians(tilt));
        let (across, up) = tilt.sin_cos();
        let axis = dvec3(across * turn.cos(), across * turn.sin(), up);
        let cosine = beta.cos();
        let sky = |d: DVec3| if d.dot(axis) > cosine { radiance } else { 0.0 };
        let cut = projected_solid_angle_of_cap(beta, tilt);
        got.push((work.from_sky)(&sky, RINGS) / radiance);
        expected.push(if known > 0.0 { known } else { cut });
        allowed = allowed.max(PI * beta.sin() * FRAC_PI_2 / RINGS as f64);
    }
    let place = |k: usize| format!("{}, radiance 1, turned", LAMPS[k].0);
    compare(&got, &expected, Within::Absolute(allowed), &[], place)
}

/// What a surface sends, as (radiosity, radiance) from H and ρ.
type Reflects = fn(f64, f64) -> [f64; 2];

const WRONG_REFLECTIONS: &[(Bug, Reflects)] = &[
    (NO_PI, |h, rho| [rho * h, rho * h]),
    (PI_UPSIDE_DOWN, |h, rho| [rho * h, PI * rho * h]),
    (PI_UPSIDE_DOWN, |h, rho| [PI * rho * h, rho * h]),
    (TWO_PI, |h, rho| [rho * h, rho * h / TAU]),
    (PI_TOO_EARLY, |h, rho| [rho * h / PI, rho * h / PI]),
    (PI_TOO_EARLY, |h, rho| [rho * h / PI, rho * h / (PI * PI)]),
    (ABSORBED, |h, rho| [(1.0 - rho) * h, (1.0 - rho) * h / PI]),
    (NO_REFLECTANCE, |h, _| [h, h / PI]),
];

fn reflected(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || (uniform(stream, 1.0, 500.0), uniform(stream, 0.05, 0.95));
    let drawn: Vec<(f64, f64)> = (0..10).map(|_| draw()).collect();
    let all = |f: &dyn Fn(f64, f64) -> [f64; 2]| {
        drawn.iter().flat_map(|&(h, rho)| f(h, rho)).collect::<Vec<f64>>()
    };
    let suspects: Vec<Suspect> =
        WRONG_REFLECTIONS.iter().map(|(bug, f)| (*bug, all(f))).collect();
    let got = all(&|h, rho| {
        let Sent { radiosity, radiance } = (work.reflected)(h, rho);
        [radiosity, radiance]
    });
    let place = |k: usize| {
        let (h, rho) = drawn[k / 2];
        format!("H = {h:.2}, ρ = {rho:.3}: {}", ["radiosity", "radiance"][k % 2])
    };
    let expected = all(&|h, rho| [rho * h, rho * h / PI]);
    compare(&got, &expected, Within::Relative(1e-12), &suspects, place)
}

/// A surface in a glow of radiance 1 from everywhere sends the radiance ρ (I3-lambert-0.5).
fn furnace(work: &Work, stream: &mut Stream) -> Verdict {
    const RINGS: usize = 48;
    let reflectances = [0.5, uniform(stream, 0.1, 0.9)];
    let irradiance = (work.from_sky)(&|_| 1.0, RINGS);
    let got = reflectances.map(|rho| (work.reflected)(irradiance, rho).radiance);
    let place = |k: usize| format!("ρ = {:.3}, L = 1 from everywhere", reflectances[k]);
    let h = FRAC_PI_2 / RINGS as f64;
    compare(&got, &reflectances, Within::Relative(h * h), &[], place)
}

/// A small lamp, a wall, an eye; and a bulb of the same flux in the lamp's place.
fn chain(work: &Work, stream: &mut Stream) -> Verdict {
    let (flux, area) = (uniform(stream, 10.0, 100.0), uniform(stream, 0.01, 0.05));
    let (r, rho) = (uniform(stream, 2.0, 4.0), uniform(stream, 0.2, 0.8));
    let lamp = Spot { at: DVec3::Z * r, normal: -DVec3::Z };
    let wall = Spot { at: DVec3::ZERO, normal: DVec3::Z };
    let radiance = (work.radiance)(flux, area);
    let near = (work.from_surface)(radiance, area, lamp, wall);
    let bulb = (work.from_bulb)(flux, lamp.at, wall);
    let sent = (work.reflected)(near, rho);
    // Straight below, a flat lamp lights four times as much as a bulb of its flux.
    let place = |k: usize| {
        let what = ["the wall's radiance", "the lamp's light over a bulb's"][k];
        format!("{flux:.1} W, {area:.3} m², r = {r:.3}, ρ = {rho:.3}: {what}")
    };
    let expected = [rho * flux / (PI * PI * r * r), 4.0];
    let within = Within::Relative(1e-12);
    compare(&[sent.radiance, near / bulb], &expected, within, &[], place)
}
