//! The checks of this lab.
//!
//! Some products are summed, over a few shots: 1e-12 of the largest value is thousands
//! of roundings. In a ball, where `F_ij = A_j/Σ A`, light spreads evenly, and all is
//! known:
//!
//! ```text
//! H = Σ A E / Σ A (1 − ρ)       B_i = E_i + ρ_i H       shown so after every shot
//! ```

mod shot;

use super::Work;
use super::bugs::*;
use super::given::{By, Light, Progress};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::whole_number;
use crate::gather::given::{Balance, Room};
use crate::gather::rooms::{coloured, draw, light as values, white};
use crate::lab::{Check, check};
use radiosity::random::Stream;
use shot::{ARRIVES, PAINT, after, any_light, flat, shot};

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "power", "the most powerful element is found", 1, |w, s| {
        brightest(w, s, By::Power)
    }),
    check(
        1,
        "radiosity",
        "the element of the largest radiosity is found",
        1,
        |w, s| brightest(w, s, By::Radiosity),
    ),
    check(
        1,
        "nothing",
        "nobody is found when nothing is left, and not before",
        1,
        left,
    ),
    check(2, "ball", "a shot in a ball is right", 2, |w, s| shot(w, s, true)),
    check(2, "box", "a shot in a box is right", 2, |w, s| shot(w, s, false)),
    check(3, "shown", "the ambient guess is added, by area and paint", 2, shown),
    check(4, "ledger", "watts are emitted, absorbed or unshot", 2, ledger),
    check(5, "steps", "some shots leave the right light and picture", 2, steps),
    check(5, "even", "in a ball the picture is right from the start", 1, even),
    check(5, "end", "many shots solve a room", 1, end),
];

const TIGHT: f64 = 1e-12;

/// The place of the largest value, the first of equal ones.
fn largest(values: impl Iterator<Item = f64>) -> f64 {
    let first = |best: (usize, f64), (k, x): (usize, f64)| {
        if x > best.1 { (k, x) } else { best }
    };
    values.enumerate().fold((0, f64::NEG_INFINITY), first).0 as f64
}

/// Twenty balls with any light (in boxes, walls are equally large two by two); what is
/// chosen is compared as a number, −1 being nobody.
fn brightest(work: &Work, stream: &mut Stream, by: By) -> Verdict {
    let mut rooms = Vec::new();
    for _ in 0..20 {
        let room = draw(stream, true);
        let room = coloured(room, stream);
        let unshot = values(&room, stream);
        rooms.push((room, unshot));
    }
    let all = |brightness: &dyn Fn(f64, f64) -> f64| {
        let of = |(room, unshot): &(Room, Vec<f64>)| {
            largest(room.area.iter().zip(unshot).map(|(&a, &u)| brightness(a, u)))
        };
        rooms.iter().map(of).collect::<Vec<f64>>()
    };
    let (power, radiosity) = (all(&|a, u| a * u), all(&|_, u| u));
    let (expected, other) = match by {
        By::Power => (power, (BY_RADIOSITY, radiosity)),
        By::Radiosity => (radiosity, (BY_POWER, power)),
    };
    let suspects = [
        other,
        (LARGEST, all(&|a, _| a)),
        (DIMMEST, all(&|a, u| -a * u)),
        (DIMMEST, all(&|_, u| -u)),
    ];
    let of = |(room, unshot): &(Room, Vec<f64>)| {
        (work.brightest)(room, unshot, by).map_or(-1.0, |i| i as f64)
    };
    let got: Vec<f64> = rooms.iter().map(of).collect();
    let place = |k: usize| format!("the brightest of {} elements", rooms[k].1.len());
    compare(&got, &expected, Within::Absolute(0.5), &suspects, place)
}

/// All is sent, and all but a trace.
fn left(work: &Work, stream: &mut Stream) -> Verdict {
    let room = draw(stream, true);
    let mut unshot = vec![0.0; room.area.len()];
    for by in [By::Power, By::Radiosity] {
        if let Some(i) = (work.brightest)(&room, &unshot, by) {
            let message = format!("nothing is left, and element {i} is chosen");
            return Verdict::fail(message, Some(NEVER_ENDS));
        }
    }
    let trace = whole_number(stream, 0, unshot.len());
    unshot[trace] = 1e-30;
    for by in [By::Power, By::Radiosity] {
        match (work.brightest)(&room, &unshot, by) {
            Some(i) if i == trace => {}
            None => {
                let message = "1e-30 W/m² are left, and nobody is chosen";
                return Verdict::fail(message, Some(STOPS_EARLY));
            }
            Some(i) => {
                let message =
                    format!("only element {trace} has light, and {i} is chosen");
                return Verdict::fail(message, None);
            }
        }
    }
    Verdict::pass(0.0, 0.0)
}

fn sum(room: &Room, term: impl Fn(usize) -> f64) -> f64 {
    (0..room.area.len()).map(term).sum()
}

/// What is added to element `i`.
type Guess = fn(&Room, &Light, usize) -> f64;

/// `Σ A x / Σ A (1 − ρ)`.
fn ambient(room: &Room, x: &[f64]) -> f64 {
    let kept = sum(room, |i| room.area[i] * (1.0 - room.reflectance[i]));
    sum(room, |i| room.area[i] * x[i]) / kept
}

const GUESS: Guess = |r, l, i| r.reflectance[i] * ambient(r, &l.unshot);

const WRONG_GUESSES: [(Bug, Guess); 5] = [
    (NO_BOUNCES, |r, l, i| {
        let mean = sum(r, |k| r.area[k] * l.unshot[k]) / sum(r, |k| r.area[k]);
        r.reflectance[i] * mean
    }),
    (PLAIN_MEAN, |r, l, i| {
        let kept = sum(r, |k| 1.0 - r.reflectance[k]);
        r.reflectance[i] * l.unshot.iter().sum::<f64>() / kept
    }),
    (PLAIN_MEAN, |r, l, i| {
        let n = r.area.len() as f64;
        let mean = sum(r, |k| r.area[k] * l.unshot[k]) / sum(r, |k| r.area[k]);
        r.reflectance[i] * mean / (1.0 - sum(r, |k| r.reflectance[k]) / n)
    }),
    (NOT_PAINTED, |r, l, _| ambient(r, &l.unshot)),
    (OF_ALL_LIGHT, |r, l, i| r.reflectance[i] * ambient(r, &l.radiosity)),
];

fn picture(room: &Room, light: &Light, guess: Guess) -> Vec<f64> {
    (0..room.area.len()).map(|i| light.radiosity[i] + guess(room, light, i)).collect()
}

fn shown(work: &Work, stream: &mut Stream) -> Verdict {
    let mut verdict = Verdict::pass(0.0, TIGHT);
    for curved in [true, false] {
        let room = draw(stream, curved);
        let room = coloured(room, stream);
        let light = any_light(&room, stream);
        let wrong = WRONG_GUESSES.iter();
        let suspects: Vec<Suspect> =
            wrong.map(|&(bug, guess)| (bug, picture(&room, &light, guess))).collect();
        let (got, expected) =
            ((work.shown)(&room, &light), picture(&room, &light, GUESS));
        let place = |k: usize| format!("element {k} of {}, shown", expected.len());
        let within = Within::Absolute(1e3 * TIGHT);
        verdict = verdict.and(|| compare(&got, &expected, within, &suspects, place));
    }
    verdict
}

/// Emitted, absorbed, unshot.
type Books = fn(&Room, &Light) -> [f64; 3];

const BOOKS: Books = |r, l| {
    let power = |x: &dyn Fn(usize) -> f64| sum(r, |i| r.area[i] * x(i));
    [
        power(&|i| r.emission[i]),
        power(&|i| (1.0 - r.reflectance[i]) * l.irradiance[i]),
        power(&|i| l.unshot[i]),
    ]
};

const WRONG_BOOKS: [(Bug, Books); 3] = [
    (REFLECTED, |r, l| {
        let [emitted, _, unshot] = BOOKS(r, l);
        let reflected = sum(r, |i| r.area[i] * r.reflectance[i] * l.irradiance[i]);
        [emitted, reflected, unshot]
    }),
    (ABSORBS_RADIOSITY, |r, l| {
        let [emitted, _, unshot] = BOOKS(r, l);
        let b = |i: usize| (1.0 - r.reflectance[i]) * l.radiosity[i];
        [emitted, sum(r, |i| r.area[i] * b(i)), unshot]
    }),
    (NO_AREA, |r, l| {
        let bare = Room { area: vec![1.0; r.area.len()], ..r.clone() };
        BOOKS(&bare, l)
    }),
];

fn ledger(work: &Work, stream: &mut Stream) -> Verdict {
    let room = draw(stream, true);
    let room = coloured(room, stream);
    let light = any_light(&room, stream);
    let Balance { emitted, absorbed, unshot } = (work.ledger)(&room, &light);
    let suspects: Vec<Suspect> = WRONG_BOOKS
        .iter()
        .map(|(bug, books)| (*bug, books(&room, &light).into()))
        .collect();
    let place = |k: usize| ["emitted", "absorbed", "unshot"][k].into();
    let within = Within::Relative(10.0 * TIGHT);
    let (got, expected) = ([emitted, absorbed, unshot], BOOKS(&room, &light));
    compare(&got, &expected, within, &suspects, place)
}

/// So many shots from the start, or as many as there are to make.
fn played(room: &Room, shots: usize, by: By) -> Light {
    let mut light = Light {
        irradiance: vec![0.0; room.area.len()],
        radiosity: room.emission.clone(),
        unshot: room.emission.clone(),
    };
    for _ in 0..shots {
        let brightness = |i: usize| match by {
            By::Power => room.area[i] * light.unshot[i],
            By::Radiosity => light.unshot[i],
        };
        let from = largest((0..room.area.len()).map(brightness)) as usize;
        light = after(room, &light, from, ARRIVES, PAINT);
    }
    light
}

/// Light and picture as one list.
fn listed(light: &Light, picture: &[f64]) -> Vec<f64> {
    let mut all = flat(light);
    all.extend(picture);
    all
}

fn steps(work: &Work, stream: &mut Stream) -> Verdict {
    let room = draw(stream, true);
    let room = coloured(room, stream);
    let (n, shots) = (room.area.len(), whole_number(stream, 3, 9));
    let all = |light: &Light| listed(light, &picture(&room, light, GUESS));
    let right = played(&room, shots, By::Power);
    let shifted = |times: f64| {
        let mut light = right.clone();
        let shift = light.radiosity.iter_mut().zip(&room.emission);
        shift.for_each(|(b, e)| *b += times * e);
        light
    };
    let guessed = Light { radiosity: picture(&room, &right, GUESS), ..right.clone() };
    let suspects = [
        (OFF_BY_ONE, all(&played(&room, shots - 1, By::Power))),
        (OFF_BY_ONE, all(&played(&room, shots + 1, By::Power))),
        (BY_RADIOSITY, all(&played(&room, shots, By::Radiosity))),
        (NO_EMISSION, all(&shifted(-1.0))),
        (EMISSION_TWICE, all(&shifted(1.0))),
        (AMBIENT_IN_RESULT, listed(&guessed, &guessed.radiosity)),
        (AMBIENT_IN_RESULT, all(&guessed)),
    ];
    let Progress { light, picture } = (work.refine)(&room, shots);
    let place = |k: usize| {
        let what = ["H", "B", "ΔB", "picture"][(k / n).min(3)];
        format!("{what} of element {}, after {shots} shots", k % n)
    };
    let within = Within::Absolute(1e3 * TIGHT);
    compare(&listed(&light, &picture), &all(&right), within, &suspects, place)
}

/// `B = E + ρ H` in a ball.
fn settled(room: &Room) -> Vec<f64> {
    let arrives = ambient(room, &room.emission);
    let lit = room.emission.iter().zip(&room.reflectance);
    lit.map(|(e, rho)| e + rho * arrives).collect()
}

fn even(work: &Work, stream: &mut Stream) -> Verdict {
    let room = draw(stream, true);
    let room = coloured(room, stream);
    let expected = settled(&room);
    let mut verdict = Verdict::pass(0.0, TIGHT);
    for shots in [0, 1, 5] {
        let got = (work.refine)(&room, shots).picture;
        let place = |k: usize| format!("element {k}, shown after {shots} shots");
        let within = Within::Absolute(1e3 * TIGHT);
        verdict = verdict.and(|| compare(&got, &expected, within, &[], place));
    }
    verdict
}

fn end(work: &Work, stream: &mut Stream) -> Verdict {
    let room = draw(stream, true);
    let room = white(room, 0.5, stream);
    let got = (work.refine)(&room, 5_000).light.radiosity;
    let place = |k: usize| format!("element {k}, after 5000 shots");
    let within = Within::Relative(1e3 * TIGHT);
    compare(&got, &settled(&room), within, &[], place)
}
