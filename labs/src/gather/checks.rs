//! The checks of this lab.
//!
//! A handful of products are summed: 1e-12 of the value is thousands of roundings. How
//! many sweeps a solution may take follows from the theory: from `B = E` on, with
//! largest values,
//!
//! ```text
//! ‖r_k‖ ≤ ρ^k ‖E‖/(1 − ρ)       so  ‖r_k‖ ≤ accuracy (1 − ρ)  after
//! k = ln(accuracy (1 − ρ)²/‖E‖) / ln ρ        bounces, and no more sweeps
//! ```

use super::Work;
use super::bugs::*;
use super::given::{Balance, Room};
use super::rooms::{coloured, draw, light, white};
use crate::check::{Bug, Suspect, Verdict, Within, compare, digits};
use crate::draw::uniform;
use crate::lab::{Check, check};
use radiosity::random::Stream;

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "ball", "what arrives in a ball is right", 2, |w, s| arriving(w, s, true)),
    check(1, "box", "what arrives in a box is right", 1, |w, s| arriving(w, s, false)),
    check(2, "bounce", "one bounce is right", 2, bounce),
    check(3, "sweep", "one sweep is right", 2, sweep),
    check(4, "residual", "the residual of any light is right", 2, residual),
    check(5, "balance", "watts are emitted, absorbed or unshot", 2, balance),
    check(6, "painted", "rooms of many paints are solved", 1, painted),
    check(6, "white", "white rooms are solved, for certain", 2, bright),
    check(6, "in-time", "a solution takes no more sweeps than it must", 1, in_time),
];

/// Some value at element `i`, of a room with radiosities `b`.
type At = fn(&Room, &[f64], usize) -> f64;

fn sum(room: &Room, term: impl Fn(usize) -> f64) -> f64 {
    (0..room.area.len()).map(term).sum()
}

/// `H_i`.
const RIGHT: At = |room, b, i| sum(room, |j| room.factors[i][j] * b[j]);

/// `E_i + ρ_i H_i`.
const ASKED: At = |r, b, i| r.emission[i] + r.reflectance[i] * RIGHT(r, b, i);

/// What arrives, with a mistake.
const WRONG_ARRIVING: [(Bug, At); 6] = [
    (TRANSPOSED, |r, b, i| sum(r, |j| r.factors[j][i] * b[j])),
    (SKIPS_SELF, |r, b, i| RIGHT(r, b, i) - r.factors[i][i] * b[i]),
    (IN_WATTS, |r, b, i| sum(r, |j| r.factors[j][i] * r.area[j] * b[j])),
    (MIXED, |r, b, i| sum(r, |j| r.factors[i][j] * r.area[j] * b[j])),
    (PAINT_TOO_EARLY, |r, b, i| r.reflectance[i] * RIGHT(r, b, i)),
    (OWN_LIGHT, |r, b, i| r.emission[i] + RIGHT(r, b, i)),
];

/// The right-hand side, with a mistake in what is made of what arrives.
const WRONG_ASKED: [(Bug, At); 5] = [
    (SENDERS_PAINT, |r, b, i| {
        r.emission[i] + sum(r, |j| r.reflectance[j] * r.factors[i][j] * b[j])
    }),
    (EMISSION_TWICE, |r, b, i| r.emission[i] + ASKED(r, b, i)),
    (ADDS_UP, |r, b, i| b[i] + r.reflectance[i] * RIGHT(r, b, i)),
    (NO_EMISSION, |r, b, i| r.reflectance[i] * RIGHT(r, b, i)),
    (PAINTS_LAMPS, |r, b, i| r.reflectance[i] * (r.emission[i] + RIGHT(r, b, i))),
];

/// The wrong right-hand sides, made of either.
type Asked = Box<dyn Fn(&Room, &[f64], usize) -> f64>;

fn wrong_asked() -> Vec<(Bug, Asked)> {
    let of_arriving = WRONG_ARRIVING.into_iter().map(|(bug, arriving)| {
        let asked = move |r: &Room, b: &[f64], i: usize| {
            r.emission[i] + r.reflectance[i] * arriving(r, b, i)
        };
        (bug, Box::new(asked) as Asked)
    });
    let others = WRONG_ASKED.into_iter().map(|(bug, at)| (bug, Box::new(at) as Asked));
    of_arriving.chain(others).collect()
}

/// A value for each element, from old values.
fn each(room: &Room, b: &[f64], at: &dyn Fn(&Room, &[f64], usize) -> f64) -> Vec<f64> {
    (0..b.len()).map(|i| at(room, b, i)).collect()
}

/// The same, in place and in this order.
fn in_order(
    room: &Room,
    b: &[f64],
    order: impl Iterator<Item = usize>,
    at: &dyn Fn(&Room, &[f64], usize) -> f64,
) -> Vec<f64> {
    let mut b = b.to_vec();
    order.for_each(|i| b[i] = at(room, &b, i));
    b
}

fn suspects(
    of: impl Fn(&dyn Fn(&Room, &[f64], usize) -> f64) -> Vec<f64>,
) -> Vec<Suspect> {
    wrong_asked().iter().map(|(bug, asked)| (*bug, of(asked))).collect()
}

/// Compares values of elements in three rooms.
fn over_rooms(
    stream: &mut Stream,
    judge: impl Fn(&Room, &[f64], &dyn Fn(usize) -> String) -> Verdict,
) -> Verdict {
    let mut verdict = Verdict::pass(0.0, TIGHT);
    for curved in [true, false, true] {
        let room = draw(stream, curved);
        let room = coloured(room, stream);
        let b = light(&room, stream);
        let shape = if curved { "a ball" } else { "a box" };
        let place = |i: usize| format!("element {i} of {} in {shape}", b.len());
        verdict = verdict.and(|| judge(&room, &b, &place));
    }
    verdict
}

const TIGHT: f64 = 1e-12;
const WITHIN: Within = Within::Relative(TIGHT);

fn arriving(work: &Work, stream: &mut Stream, curved: bool) -> Verdict {
    let room = draw(stream, curved);
    let room = coloured(room, stream);
    let b = light(&room, stream);
    let suspects = WRONG_ARRIVING.map(|(bug, at)| (bug, each(&room, &b, &at)));
    let got = each(&room, &b, &work.arriving);
    let place = |i| format!("element {i} of {}", b.len());
    compare(&got, &each(&room, &b, &RIGHT), WITHIN, &suspects, place)
}

fn bounce(work: &Work, stream: &mut Stream) -> Verdict {
    over_rooms(stream, |room, b, place| {
        let mut suspects = suspects(|asked| each(room, b, asked));
        suspects.push((IN_PLACE, in_order(room, b, 0..b.len(), &ASKED)));
        compare(
            &(work.bounce)(room, b),
            &each(room, b, &ASKED),
            WITHIN,
            &suspects,
            place,
        )
    })
}

fn sweep(work: &Work, stream: &mut Stream) -> Verdict {
    over_rooms(stream, |room, b, place| {
        let mut suspects = suspects(|asked| in_order(room, b, 0..b.len(), asked));
        suspects.push((OLD_VALUES, each(room, b, &ASKED)));
        suspects.push((BACKWARDS, in_order(room, b, (0..b.len()).rev(), &ASKED)));
        let mut got = b.to_vec();
        (work.sweep)(room, &mut got);
        let expected = in_order(room, b, 0..b.len(), &ASKED);
        compare(&got, &expected, WITHIN, &suspects, place)
    })
}

fn residual(work: &Work, stream: &mut Stream) -> Verdict {
    over_rooms(stream, |room, b, place| {
        let less_b = |asked: Vec<f64>| -> Vec<f64> {
            asked.iter().zip(b).map(|(asked, b)| asked - b).collect()
        };
        let mut suspects = suspects(|asked| less_b(each(room, b, asked)));
        let expected = less_b(each(room, b, &ASKED));
        suspects.push((SIGN, expected.iter().map(|r| -r).collect()));
        // Differences of numbers of the size of B: their roundings are as large as B's.
        let within = Within::Absolute(10.0 * TIGHT);
        compare(&(work.residual)(room, b), &expected, within, &suspects, place)
    })
}

fn balance(work: &Work, stream: &mut Stream) -> Verdict {
    over_rooms(stream, |room, b, _| {
        let entries = |area: &[f64], absorbed: At, asked: &Asked| -> Vec<f64> {
            let power = |x: &dyn Fn(usize) -> f64| sum(room, |i| area[i] * x(i));
            vec![
                power(&|i| room.emission[i]),
                power(&|i| absorbed(room, b, i)),
                power(&|i| asked(room, b, i) - b[i]),
            ]
        };
        let kept: At = |r, b, i| (1.0 - r.reflectance[i]) * RIGHT(r, b, i);
        let right: Asked = Box::new(ASKED);
        let mut suspects: Vec<Suspect> = vec![
            (NO_AREAS, entries(&vec![1.0; b.len()], kept, &right)),
            (
                KEEPS_THE_REST,
                entries(
                    &room.area,
                    |r, b, i| r.reflectance[i] * RIGHT(r, b, i),
                    &right,
                ),
            ),
            (
                OF_WHAT_LEAVES,
                entries(&room.area, |r, b, i| (1.0 - r.reflectance[i]) * b[i], &right),
            ),
        ];
        for ((bug, asked), (_, arriving)) in
            wrong_asked().into_iter().zip(WRONG_ARRIVING)
        {
            let mut wrong = entries(&room.area, kept, &asked);
            let kept = |i: usize| (1.0 - room.reflectance[i]) * arriving(room, b, i);
            wrong[1] = sum(room, |i| room.area[i] * kept(i));
            suspects.push((bug, wrong));
        }
        for (bug, asked) in wrong_asked() {
            suspects.push((bug, entries(&room.area, kept, &asked)));
        }
        let expected = entries(&room.area, kept, &right);
        suspects.push((SIGN, vec![expected[0], expected[1], -expected[2]]));
        let Balance { emitted, absorbed, unshot } = (work.balance)(room, b);
        let place = |k: usize| ["emitted", "absorbed", "unshot"][k].to_string();
        let within = Within::Absolute(100.0 * TIGHT);
        compare(&[emitted, absorbed, unshot], &expected, within, &suspects, place)
    })
}

/// Where bounces with this right-hand side lead; may be infinite.
fn settled(room: &Room, at: &dyn Fn(&Room, &[f64], usize) -> f64) -> Vec<f64> {
    let largest = room.reflectance.iter().copied().fold(0.0, f64::max);
    let sweeps = (1e-15_f64.ln() / largest.ln()) as usize;
    let mut b = room.emission.clone();
    for _ in 0..sweeps {
        (0..b.len()).for_each(|i| b[i] = at(room, &b, i));
    }
    b
}

/// Is the student's solution of `room` good to `accuracy`?
fn solved(work: &Work, room: &Room, accuracy: f64) -> Verdict {
    let expected = settled(room, &ASKED);
    let got = (work.solve)(room, accuracy).radiosity;
    let mut suspects = suspects(|asked| settled(room, asked));
    suspects.retain(|(_, b)| b.iter().all(|b| b.is_finite()));
    let rho = room.reflectance.iter().copied().fold(0.0, f64::max);
    let n = room.area.len();
    let place = |i: usize| {
        format!("element {i} of {n}, ρ up to {rho:.4}, accuracy {}", digits(accuracy))
    };
    // What the theory grants exactly may be exceeded by the roundings of the reference.
    let within = Within::Absolute(accuracy * (1.0 + 1e-6));
    let verdict = compare(&got, &expected, within, &suspects, place);
    if verdict.passed() || verdict.bug.is_some() || got.len() != n {
        return verdict;
    }
    let rest = (0..n).map(|i| (ASKED(room, &got, i) - got[i]).abs());
    let small = rest.fold(0.0, f64::max) <= accuracy * (1.0 + 1e-9);
    Verdict { bug: Some(if small { SMALL_CHANGE } else { TOO_EARLY }), ..verdict }
}

/// Reflectances and lights that differ from element to element.
fn painted(work: &Work, stream: &mut Stream) -> Verdict {
    let mut verdict = Verdict::pass(0.0, 1.0);
    for curved in [true, false] {
        let room = draw(stream, curved);
        let room = coloured(room, stream);
        verdict = verdict.and(|| solved(work, &room, 1e-4));
    }
    verdict
}

/// Rooms whose light dies out ever more slowly.
fn bright(work: &Work, stream: &mut Stream) -> Verdict {
    let mut verdict = Verdict::pass(0.0, 1.0);
    for (reflectance, curved) in
        [(0.5, true), (0.9, false), (0.99, true), (0.995, false)]
    {
        let room = draw(stream, curved);
        let room = white(room, reflectance, stream);
        verdict = verdict.and(|| solved(work, &room, 1e-3));
    }
    verdict
}

/// The most sweeps that a solution may take; see above.
fn most_sweeps(room: &Room, accuracy: f64) -> f64 {
    let largest = |x: &[f64]| x.iter().copied().fold(0.0, f64::max);
    let (rho, e) = (largest(&room.reflectance), largest(&room.emission));
    ((accuracy * (1.0 - rho).powi(2) / e).ln() / rho.ln()).ceil() + 1.0
}

fn in_time(work: &Work, stream: &mut Stream) -> Verdict {
    let mut verdict = Verdict::pass(0.0, 1.0);
    for reflectance in [0.3, 0.6, 0.9] {
        let room = draw(stream, false);
        let room = white(room, reflectance, stream);
        let accuracy = uniform(stream, 0.01, 0.1);
        verdict = verdict.and(|| {
            let took = (work.solve)(&room, accuracy).sweeps as f64;
            let most = most_sweeps(&room, accuracy);
            let (metric, message) = (took / most, format!(
                "ρ = {reflectance}, accuracy {}: took {took} sweeps, {most} suffice",
                digits(accuracy)
            ));
            match metric <= 1.0 {
                true => Verdict::pass(metric, 1.0),
                false => Verdict {
                    metric,
                    tolerance: 1.0,
                    message: Some(message),
                    bug: Some(TOO_LONG),
                },
            }
        });
    }
    verdict
}
