//! The checks of this lab: each runs a method of the crate on what the student has made
//! for it.
//!
//! ```text
//! |foretold − measured| ≤ 20 % of measured             of a failure that was measured
//! |missed − wanted| ≤ 0.03            3 deviations of 3000 places, and they are spread evenly
//! ```

use super::Work;
use super::bugs::*;
use super::given::{Room, by_middles, jacobi, search, too_near};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{decades, uniform};
use crate::gather::rooms::cuboid;
use crate::lab::{Check, check};
use radiosity::random::Stream;

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "near", "the squares are as near as the error wants them", 2, near),
    check(1, "near-error", "the error of the middles is foretold", 2, near_error),
    check(2, "hidden", "the lamp is missed as often as it should be", 2, hidden),
    check(2, "hidden-light", "its brightness elsewhere is foretold", 2, hidden_light),
    check(3, "runaway", "the reflectance at which light grows is found", 4, runaway),
    check(4, "slow", "the solver needs as many bounces", 2, slow),
    check(4, "slow-behind", "what is missing in the end is foretold", 2, slow_behind),
    check(5, "laws", "the factors obey all laws", 2, laws),
    check(5, "wrong", "and one is wrong by as much as it should be", 2, wrong),
];

/// A prediction is right within this.
const FORETOLD: Within = Within::Relative(0.2);

/// Three times as bad at random.
fn wanted_errors(stream: &mut Stream) -> [f64; 3] {
    [0.05, 0.1, 0.2].map(|low| uniform(stream, low, 2.0 * low))
}

/// Says by how much a distance that cannot be one is wrong, if so.
fn strange(what: &str, x: f64) -> Option<Verdict> {
    let text = || format!("{what} is {x}, which is no number above 0");
    (!(x.is_finite() && x > 0.0)).then(|| Verdict::fail(text(), None))
}

fn near(work: &Work, stream: &mut Stream) -> Verdict {
    let mut verdict = Verdict::pass(0.0, 1.0);
    for wanted in wanted_errors(stream) {
        let distance = (work.near)(wanted).distance;
        if let Some(strange) = strange("the distance", distance) {
            return strange;
        }
        let got = too_near(distance.max(1e-3));
        let told = |bug| {
            let text = format!(
                "at distance {distance:.3} the middles are {:.1} % too large; wanted \
                 were {:.1} % to {:.1} %",
                100.0 * got,
                100.0 * wanted,
                200.0 * wanted
            );
            Verdict::fail(text, Some(bug))
        };
        verdict = verdict.and(|| match got / wanted {
            share if share < 1.0 => told(TOO_MILD),
            share if share > 2.0 => told(TOO_NEAR),
            share => Verdict::pass((share - 1.5).abs(), 0.5),
        });
    }
    verdict
}

fn near_error(work: &Work, stream: &mut Stream) -> Verdict {
    let mut verdict = Verdict::pass(0.0, 1.0);
    for wanted in wanted_errors(stream) {
        let near = (work.near)(wanted);
        if let Some(strange) = strange("the distance", near.distance) {
            return strange;
        }
        let got = too_near(near.distance.max(1e-3));
        let suspects: [Suspect; 4] = [
            (PER_CENT, vec![100.0 * got]),
            (ONE_OF_TWO, vec![0.5 * got]),
            (SIGN, vec![-got]),
            (RATIO, vec![1.0 + got]),
        ];
        let place = |_| format!("the error at distance {:.3}", near.distance);
        verdict =
            verdict.and(|| compare(&[near.error], &[got], FORETOLD, &suspects, place));
    }
    verdict
}

/// Cells of the hemicube, and the share of places that miss the lamp.
///
/// At less than half the lamp might cover two middles at once.
fn drawn(stream: &mut Stream) -> (u32, f64) {
    let cells = [12, 16, 20, 24, 32][(5.0 * stream.next()) as usize];
    (cells, uniform(stream, 0.55, 0.65))
}

/// The lamp is put at so many places squared.
const ROWS: usize = 55;

fn hidden(work: &Work, stream: &mut Stream) -> Verdict {
    let (cells, wanted) = drawn(stream);
    let lamp = (work.hidden)(cells, wanted);
    if let Some(strange) = strange("the lamp's side", lamp.side) {
        return strange;
    }
    let [missed, _] = search(cells, lamp.side.min(1.0), ROWS, stream);
    let seen = 1.0 - wanted;
    let suspects: [Suspect; 3] = [
        (HALF_A_CELL, vec![1.0 - 0.25 * seen]),
        (A_LINE, vec![1.0 - seen * seen]),
        (SEEN_FOR_MISSED, vec![seen]),
    ];
    let place = |_| {
        let side = lamp.side;
        format!(
            "the share of places at which {cells}² cells miss a lamp of {side:.4} m"
        )
    };
    compare(&[missed], &[wanted], Within::Absolute(0.03), &suspects, place)
}

/// With the right lamp: who has hidden it badly may tell how bright it is all the same.
fn hidden_light(work: &Work, stream: &mut Stream) -> Verdict {
    let (cells, missed) = drawn(stream);
    let seen = 1.0 - missed;
    let side = 2.0 / f64::from(cells) * seen.sqrt();
    let [_, got] = search(cells, side, ROWS, stream);
    let suspects: [Suspect; 3] = [
        (RIGHT_WHERE_SEEN, vec![1.0]),
        (TOO_DARK, vec![seen]),
        (OVER_MISSED, vec![1.0 / missed]),
    ];
    let place = |_| format!("its brightness where it is seen, missed at {missed:.3}");
    let told = (work.hidden)(cells, missed).brightness;
    // Narrower than other predictions: 1/0.55 is not far from 1/0.45.
    compare(&[told], &[got], Within::Relative(0.1), &suspects, place)
}

/// A box of two elements' middles a wall edge at most.
fn draw_box(stream: &mut Stream, k: usize) -> Vec<Vec<f64>> {
    let w = uniform(stream, 0.8, 1.0);
    let d = w * uniform(stream, 1.1, 1.4);
    by_middles([w, d, d * uniform(stream, 1.1, 1.4)], k)
}

fn runaway(work: &Work, stream: &mut Stream) -> Verdict {
    let mut verdict = Verdict::pass(0.0, 1e-3);
    for k in [1, 2] {
        let factors = draw_box(stream, k);
        let got = (work.runaway)(&factors);
        let sums = || factors.iter().map(|row| row.iter().sum::<f64>());
        // What a bounce leaves in the end, by the solver that is to run away.
        let run = jacobi(&factors, 1.0, 301);
        let growth = (run[300] - run[299]) / (run[299] - run[298]);
        let n = factors.len() as f64;
        let suspects: [Suspect; 5] = [
            (WHITE, vec![1.0]),
            (LARGEST_ROW, vec![1.0 / sums().fold(0.0, f64::max)]),
            (MEAN_ROW, vec![n / sums().sum::<f64>()]),
            (SMALLEST_ROW, vec![1.0 / sums().fold(f64::INFINITY, f64::min)]),
            (UPSIDE_DOWN, vec![growth]),
        ];
        let place = |_| {
            let after = |rho: f64| {
                let run = jacobi(&factors, rho, 400);
                if run[399] > 2.0 * run[199] { "runs away" } else { "settles" }
            };
            format!(
                "a box of {n} elements, whose solver {} with 2 % less than your \
                 reflectance, and {} with 2 % more",
                after(0.98 * got),
                after(1.02 * got)
            )
        };
        let right = [1.0 / growth];
        verdict = verdict
            .and(|| compare(&[got], &right, Within::Relative(1e-3), &suspects, place));
    }
    verdict
}

/// How many bounces, and what may be missing after them.
fn bounces(stream: &mut Stream) -> (u32, f64) {
    (decades(stream, 200.0, 2000.0) as u32, decades(stream, 1e-5, 1e-3))
}

/// A cube's walls, each an element that sees all others alike: rows sum to 1.
fn any_closed_room() -> Vec<Vec<f64>> {
    let others = |i: usize| (0..6).map(|j| if i == j { 0.0 } else { 0.2 }).collect();
    (0..6).map(others).collect()
}

/// The share of all light, `1/(1 − ρ)`, that is missing after each of so many bounces.
fn missing(reflectance: f64, most: usize) -> Vec<f64> {
    let run = jacobi(&any_closed_room(), reflectance, most);
    run.iter().map(|sum| 1.0 - sum * (1.0 - reflectance)).collect()
}

/// Says so when a reflectance is none.
fn strange_paint(rho: f64) -> Option<Verdict> {
    let text = || format!("the reflectance is {rho}; it has to lie between 0 and 1");
    (!(rho > 0.0 && rho < 1.0)).then(|| Verdict::fail(text(), None))
}

fn slow(work: &Work, stream: &mut Stream) -> Verdict {
    let (wanted, share) = bounces(stream);
    let rho = (work.slow)(wanted, share).reflectance;
    if let Some(strange) = strange_paint(rho) {
        return strange;
    }
    let most = 20 * wanted as usize;
    let run = missing(rho, most);
    let got = run.iter().position(|m| *m <= share).unwrap_or(most) as f64 + 1.0;
    let wanted = f64::from(wanted);
    let log = -share.ln();
    let small = update_stops(wanted, share);
    let suspects: [Suspect; 3] = [
        (RULE_OF_THUMB, vec![wanted * log]),
        (COMMON_LOGARITHM, vec![wanted * std::f64::consts::LN_10]),
        (UPDATE_STOPS, vec![share.ln() / small.ln()]),
    ];
    let place = |_| {
        format!(
            "the bounces until {share:.2e} of the light is missing, with ρ = {rho:.6}"
        )
    };
    compare(&[got], &[wanted], Within::Relative(0.03), &suspects, place)
}

/// The reflectance with which the last of so many bounces adds this share of all light:
/// `ρ^k (1 − ρ) = share`, by halving.
fn update_stops(sweeps: f64, share: f64) -> f64 {
    let adds = |rho: f64| rho.powf(sweeps) * (1.0 - rho);
    // It rises up to here.
    let (mut low, mut high) = (0.0, sweeps / (sweeps + 1.0));
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if adds(middle) < share { low = middle } else { high = middle }
    }
    low
}

fn slow_behind(work: &Work, stream: &mut Stream) -> Verdict {
    let (wanted, share) = bounces(stream);
    let slow = (work.slow)(wanted, share);
    if let Some(strange) = strange_paint(slow.reflectance) {
        return strange;
    }
    let run = missing(slow.reflectance, 100);
    let got = run[99] / (run[98] - run[99]);
    let suspects: [Suspect; 2] =
        [(UPDATE_IS_ERROR, vec![1.0]), (TURNED_ROUND, vec![1.0 / got])];
    let place = |_| {
        let rho = slow.reflectance;
        format!("what is missing over what the last bounce added, ρ = {rho:.6}")
    };
    compare(&[slow.behind], &[got], FORETOLD, &suspects, place)
}

/// A box with its exact factors, and the share by which one is to be wrong.
fn exact_box(stream: &mut Stream) -> (Room, f64) {
    let sides = [0; 3].map(|_| uniform(stream, 0.8, 1.25));
    (cuboid(sides), uniform(stream, 0.1, 0.3))
}

fn laws(work: &Work, stream: &mut Stream) -> Verdict {
    let (room, wanted) = exact_box(stream);
    let f = (work.lawful)(&room, wanted);
    let n = room.area.len();
    if f.len() != n || f.iter().any(|row| row.len() != n) {
        return Verdict::fail(format!("the factors are no {n} × {n} numbers"), None);
    }
    let pairs = || (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    let power = |i: usize, j: usize| room.area[i] * f[i][j];
    let one_way = pairs().map(|(i, j)| (power(i, j) - power(j, i)).abs());
    let open = f.iter().map(|row| (row.iter().sum::<f64>() - 1.0).abs());
    let below = pairs().map(|(i, j)| -f[i][j]);
    let worst = |of: &mut dyn Iterator<Item = f64>| -> f64 {
        of.map(|x| if x.is_nan() { f64::INFINITY } else { x }).fold(0.0, f64::max)
    };
    let law = |name: &str, off: f64, bug: Bug| {
        let text = format!("{name} is broken, by {off:.3e}");
        let broken = off > 1e-9;
        if broken { Verdict::fail(text, Some(bug)) } else { Verdict::pass(off, 1e-9) }
    };
    law("A_i F_ij = A_j F_ji", worst(&mut one_way.into_iter()), ONE_WAY)
        .and(|| law("the sum of a row", worst(&mut open.into_iter()), NOT_CLOSED))
        .and(|| law("no factor is negative", worst(&mut below.into_iter()), NEGATIVE))
        .and(|| furnace(&f))
}

/// All walls emit 1 and reflect a half: all is 2, whatever the factors, when rows sum
/// to 1.
fn furnace(factors: &[Vec<f64>]) -> Verdict {
    let mut b = vec![1.0; factors.len()];
    for _ in 0..60 {
        let arrives =
            |row: &Vec<f64>| row.iter().zip(&b).map(|(f, b)| f * b).sum::<f64>();
        b = factors.iter().map(|row| 1.0 + 0.5 * arrives(row)).collect();
    }
    let right = vec![2.0; b.len()];
    let place = |k: usize| format!("the furnace, wall {k}");
    compare(&b, &right, Within::Absolute(1e-8), &[], place)
}

fn wrong(work: &Work, stream: &mut Stream) -> Verdict {
    let (room, wanted) = exact_box(stream);
    let f = (work.lawful)(&room, wanted);
    let Some(got) = f.get(4).and_then(|row| row.get(5)) else {
        return Verdict::fail("there is no factor from 4 to 5", None);
    };
    let exact = room.factors[4][5];
    let suspects: [Suspect; 3] = [
        (HONEST, vec![exact]),
        (OTHER_SIZE, vec![exact * (1.0 - wanted)]),
        (OTHER_SIZE, vec![exact * (1.0 + 2.0 * wanted)]),
    ];
    let place = |_| format!("floor to ceiling, {:.1} % too large", 100.0 * wanted);
    let right = [exact * (1.0 + wanted)];
    compare(&[*got], &right, Within::Relative(1e-9), &suspects, place)
}
