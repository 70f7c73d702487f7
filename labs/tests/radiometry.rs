//! The lab `radiometry`: its tolerances, right answers that are not the answer, and the
//! failure that its report asks for.

mod common;

use common::{all_pass, judge};
use labs::radiometry::given::Sent;
use labs::radiometry::report::suns;
use labs::radiometry::{Work, answer, checks};
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// An integral by cells that lie otherwise, `at` giving (θ, weight) of a ring.
fn by_rings(
    sky: &dyn Fn(DVec3) -> f64,
    rings: usize,
    at: impl Fn(usize) -> (f64, f64),
) -> f64 {
    let mut sum = 0.0;
    for ring in 0..rings {
        let (theta, weight) = at(ring);
        for piece in 0..4 * rings {
            let phi = (piece as f64 + 0.25) / (4 * rings) as f64 * TAU;
            let (s, c) = theta.sin_cos();
            sum += sky(dvec3(s * phi.cos(), s * phi.sin(), c)) * weight;
        }
    }
    sum
}

#[test]
fn other_right_answers_pass() {
    // Rings of equal projected solid angle: the cosine and the sine are in their place.
    let even = Work {
        from_sky: |sky, rings| {
            let ring = |k: usize| ((k as f64 + 0.5) / rings as f64).sqrt().asin();
            by_rings(sky, rings, |k| (ring(k), PI / (4 * rings * rings) as f64))
        },
        ..answer::WORK
    };
    // Each ring from its upper border on.
    let borders = Work {
        from_sky: |sky, rings| {
            let h = FRAC_PI_2 / rings as f64;
            by_rings(sky, rings, |k| {
                let theta = k as f64 * h;
                (theta, theta.sin() * theta.cos() * h * h)
            })
        },
        reflected: |irradiance, reflectance| {
            let radiance = reflectance / PI * irradiance;
            Sent { radiosity: PI * radiance, radiance }
        },
        ..answer::WORK
    };
    let works = [("answer", &answer::WORK), ("even", &even), ("borders", &borders)];
    all_pass(checks::ALL, &works);
}

/// What is not a number never passes.
#[test]
fn nan_fails() {
    let work = Work { from_sky: |_, _| f64::NAN, ..answer::WORK };
    let failing =
        judge(checks::ALL, &work, "0").into_iter().filter(|(_, v)| !v.passed());
    let names: Vec<&str> = failing.map(|(name, _)| name).collect();
    assert_eq!(names, ["skies", "lamps", "furnace"]);
}

/// The failure that the report asks for, pinned: what is smaller than a cell is missed as
/// often as chance has it.
///
/// ```text
/// p = Ω / (h² sinθ)     missed: 1 − p     rms² = mean of 1/p − 1
/// ```
/// with Ω = 2π(1 − cosβ) the sun's solid angle and h = π/2n the width of a ring.
#[test]
fn a_sun_smaller_than_a_cell_is_missed_as_chance_has_it() {
    const PLACES: usize = 2000;
    let (beta, rings) = (0.27_f64.to_radians(), 32);
    let found = suns(&answer::WORK, beta, rings, PLACES);
    let h = FRAC_PI_2 / rings as f64;
    let mut stream = Stream::named(7, &[]);
    let chances: Vec<f64> = (0..100_000)
        .map(|_| {
            let z = 0.1 + 0.8 * stream.next();
            TAU * (1.0 - beta.cos()) / (h * h * (1.0 - z * z).sqrt())
        })
        .collect();
    let mean = |f: fn(f64) -> f64| {
        chances.iter().map(|&p| f(p)).sum::<f64>() / chances.len() as f64
    };
    let (missed, rms) = (mean(|p| 1.0 - p), mean(|p| 1.0 / p - 1.0).sqrt());
    assert!((0.955..0.975).contains(&missed), "{missed}: 24 of 25 are missed");
    let sigma = (missed * (1.0 - missed) / PLACES as f64).sqrt();
    assert!((found.missed - missed).abs() < 4.0 * sigma, "{} {missed}", found.missed);
    assert!((found.rms / rms - 1.0).abs() < 0.25, "{} {rms}", found.rms);
}
