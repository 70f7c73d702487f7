//! Task 6: the row of images between two mirrors.

use super::super::Work;
use super::super::bugs::*;
use super::Suspects;
use crate::check::{Suspect, Verdict, Within, compare};
use crate::draw::uniform;
use radiosity::random::Stream;
use std::f64::consts::PI;

/// The factor to image `k`, of rectangles with a corner on the axis:
///
/// ```text
/// F = 1/2π (a/√(1 + a²) atan(b/√(1 + a²)) + b/√(1 + b²) atan(a/√(1 + b²)))
/// ```
/// for sides a and b at the distance 1, one corner straight above.
fn image(k: usize) -> f64 {
    let corner = |a: f64| {
        let (b, ra): (f64, f64) = (0.5, a.hypot(1.0));
        let rb = b.hypot(1.0);
        (a / ra * (b / ra).atan() + b / rb * (a / rb).atan()) / (2.0 * PI)
    };
    let k = k as f64;
    2.0 * (corner(k + 0.5) - corner(k - 0.5))
}

/// What was asked: a reflectance, and so many levels.
type Asked = (f64, usize);

/// Images on `sides` sides, each weighted with what `share` makes of ρ and k.
fn row(sides: f64, share: fn(f64, i32) -> f64, &(rho, levels): &Asked) -> f64 {
    let beside = |k: usize| sides * share(rho, k as i32) * image(k);
    image(0) + (1..=levels).map(beside).sum::<f64>()
}

fn right(asked: &Asked) -> f64 {
    row(2.0, f64::powi, asked)
}

const WRONG: &Suspects<Asked, f64> = &[
    (ONE_SIDE, |asked| row(1.0, f64::powi, asked)),
    (ONCE_DIMMED, |asked| row(2.0, |rho, _| rho, asked)),
    (NOT_DIMMED, |asked| row(2.0, |_, _| 1.0, asked)),
    (OFF_BY_ONE, |&(rho, levels)| right(&(rho, levels + 1))),
    (OFF_BY_ONE, |&(rho, levels)| right(&(rho, levels.saturating_sub(1)))),
    (LAMP_TWICE, |asked| image(0) + right(asked)),
    (DOUBLED, |asked| row(1.0, |rho, k| (2.0 * rho).powi(k), asked)),
    (DOUBLED, |asked| row(2.0, |rho, k| (2.0 * rho).powi(k), asked)),
];

fn judge(work: &Work, drawn: &[Asked], expected: &[f64], within: Within) -> Verdict {
    let all = |f: &dyn Fn(&Asked) -> f64| drawn.iter().map(f).collect::<Vec<f64>>();
    let suspects: Vec<Suspect> = WRONG.iter().map(|(bug, f)| (*bug, all(f))).collect();
    let got = all(&|&(rho, levels)| (work.corridor)(rho, levels));
    let place = |k: usize| {
        let (rho, levels) = drawn[k];
        format!("ρ = {rho:.3}, {levels} levels")
    };
    compare(&got, expected, within, &suspects, place)
}

pub(super) fn levels(work: &Work, stream: &mut Stream) -> Verdict {
    let mut drawn: Vec<Asked> =
        (0..8).map(|levels| (uniform(stream, 0.3, 0.95), levels)).collect();
    drawn.push((1.0, 1));
    let expected: Vec<f64> = drawn.iter().map(right).collect();
    judge(work, &drawn, &expected, Within::Absolute(1e-9))
}

/// Perfect mirrors: the images make a strip without end, |y| ≤ ½ at the height 1; of
/// that ½/√(½² + 1²) = 1/√5 is seen. What lies beyond L is 2/(3π L³): 3e-8 for 200.
pub(super) fn limit(work: &Work, _: &mut Stream) -> Verdict {
    let drawn = [(1.0, 200), (0.9, 200), (0.5, 200)];
    let expected = [1.0 / 5.0_f64.sqrt(), 0.421_364_518_2, 0.331_796_634_8];
    judge(work, &drawn, &expected, Within::Absolute(1e-7))
}
