//! Task 6: gloss, and gloss seen in gloss.

use super::super::Work;
use super::super::bugs::*;
use super::super::given::{Glance, Hit};
use super::{Suspects, suspects};
use crate::check::{Suspect, Verdict, Within, compare};
use crate::draw::{direction, uniform, whole_number};
use crate::shapes::Place;
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;

/// A glossy plane under light that grows evenly in one direction.
pub(super) fn mirrored(work: &Work, stream: &mut Stream) -> Verdict {
    const HALF: f64 = 0.3;
    let mut got = Vec::new();
    let (mut right, mut straight, mut upright, mut back, mut sharp) =
        (vec![], vec![], vec![], vec![], vec![]);
    for _ in 0..5 {
        let place = Place::draw(stream);
        let (turn, down) = (uniform(stream, 0.0, 6.0), uniform(stream, 0.6, 0.9));
        let across = (1.0_f64 - down * down).sqrt();
        let d = dvec3(across * turn.cos(), across * turn.sin(), -down);
        let (d, n) = (place.direction(d), place.direction(DVec3::Z));
        let (share, slope) = (uniform(stream, 0.3, 0.9), direction(stream));
        let light = |d: DVec3| 2.0 + slope.dot(d);
        // Whatever goes below meets the same light: only the axis is looked at.
        let first = std::cell::Cell::new(true);
        let world = |from: DVec3, d: DVec3| match first.replace(false) {
            true => Hit { at: from + d, normal: n, light: 0.0, gloss: share },
            false => Hit { at: from + d, normal: -d, light: light(d), gloss: 0.0 },
        };
        let look = Glance {
            from: place.of(DVec3::Z),
            direction: d,
            half_angle: HALF,
            strata: 16,
        };
        got.push((work.gloss)(&world, look, 1, stream));
        let over = |axis: DVec3| share * light(0.5 * (1.0 + HALF.cos()) * axis);
        right.push(over(d - 2.0 * d.dot(n) * n));
        straight.push(over(d));
        upright.push(over(n));
        back.push(over(-d));
        sharp.push(share * light(d - 2.0 * d.dot(n) * n));
    }
    let wrong: Vec<Suspect> = vec![
        (STRAIGHT_ON, straight),
        (ABOUT_NORMAL, upright),
        (BACK, back),
        (ONE_RAY, sharp),
    ];
    let place = |_| "a glossy floor under light from above".to_string();
    compare(&got, &right, Within::Absolute(4e-3), &wrong, place)
}

/// Own light, gloss and depth.
type Hall = (f64, f64, usize);

/// Σ_{k ≤ d} rᵏ.
fn series(r: f64, depth: usize) -> f64 {
    (0..=depth).map(|k| r.powi(k as i32)).sum()
}

const WRONG_HALLS: &Suspects<Hall, f64> = &[
    (OWN_LIGHT, |&(light, r, depth)| light * r.powi(depth as i32)),
    (NO_SHARE, |&(light, _, depth)| light * (depth + 1) as f64),
    (WRONG_DEPTH, |&(light, r, depth)| light * series(r, depth + 1)),
    (WRONG_DEPTH, |&(light, r, depth)| light * series(r, depth.saturating_sub(1))),
    (WRONG_DEPTH, |&(light, r, depth)| light * (series(r, depth) - 1.0)),
    (ONE_LEVEL, |&(light, r, depth)| light * series(r, depth.min(1))),
];

/// `G11-hall-r0.9-d5`, and others: all that a glance meets is alike.
pub(super) fn hall(work: &Work, stream: &mut Stream) -> Verdict {
    let mut drawn: Vec<Hall> = vec![(1.0, 0.9, 5)];
    drawn.extend((0..6).map(|_| {
        let light = uniform(stream, 0.5, 2.0);
        (light, uniform(stream, 0.3, 0.95), whole_number(stream, 2, 6))
    }));
    let mut of = |&(light, gloss, depth): &Hall| {
        let world =
            |from: DVec3, d: DVec3| Hit { at: from + d, normal: -d, light, gloss };
        let look = Glance {
            from: DVec3::ZERO,
            direction: direction(stream),
            half_angle: 0.2,
            strata: 2,
        };
        (work.gloss)(&world, look, depth, stream)
    };
    let got: Vec<f64> = drawn.iter().map(&mut of).collect();
    let mut expected: Vec<f64> =
        drawn.iter().map(|&(light, r, depth)| light * series(r, depth)).collect();
    expected[0] = 4.685_59;
    let place = |k: usize| {
        let (light, gloss, depth) = drawn[k];
        format!("all has light {light:.3} and gloss {gloss:.3}, depth {depth}")
    };
    let suspects = suspects(WRONG_HALLS, &drawn);
    compare(&got, &expected, Within::Relative(1e-9), &suspects, place)
}
