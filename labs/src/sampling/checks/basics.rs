//! Tasks 1 and 2: the mean and its error; directions.

use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{uniform, whole_number};
use crate::sampling::Work;
use crate::sampling::bugs::*;
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The mean of some values and the standard error of it.
pub fn estimated(values: &[f64]) -> [f64; 2] {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    [mean, (squares / (n * (n - 1.0))).sqrt()]
}

/// Means of some hundred values. Of the error a share of 1/n is allowed: dividing by n in
/// place of n − 1 is as good.
pub fn mean(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || {
        let (n, level) = (whole_number(stream, 200, 500), uniform(stream, 1.0, 10.0));
        (0..n).map(|_| level + 5.0 * stream.next().powi(3)).collect::<Vec<f64>>()
    };
    let lists: Vec<Vec<f64>> = (0..5).map(|_| draw()).collect();
    let all = |f: &dyn Fn([f64; 2], f64) -> [f64; 2]| {
        let each = |list: &Vec<f64>| f(estimated(list), list.len() as f64);
        lists.iter().flat_map(each).collect::<Vec<f64>>()
    };
    let suspects: [Suspect; 6] = [
        (SUM, all(&|[mean, error], n| [mean * n, error])),
        (SUM, all(&|[mean, error], n| [mean * n, error * n])),
        (SPREAD, all(&|[mean, error], n| [mean, error * n.sqrt()])),
        (VARIANCE, all(&|[mean, error], _| [mean, error * error])),
        (OVER_N, all(&|[mean, error], n| [mean, error / n.sqrt()])),
        (NO_SPREAD, all(&|[mean, _], n| [mean, 1.0 / n.sqrt()])),
    ];
    let found = |list: &Vec<f64>| {
        let found = (work.estimate)(list);
        [found.mean, found.error]
    };
    let got: Vec<f64> = lists.iter().flat_map(found).collect();
    let place = |k: usize| {
        format!("{} values: {}", lists[k / 2].len(), ["mean", "error"][k % 2])
    };
    let expected = all(&|right, _| right);
    compare(&got, &expected, Within::Relative(1.0 / 200.0), &suspects, place)
}

/// Values without scatter.
pub fn equal(work: &Work, stream: &mut Stream) -> Verdict {
    let values: Vec<f64> = (0..20).map(|_| uniform(stream, 0.1, 0.9)).collect();
    let found = values.iter().map(|&value| (work.estimate)(&[value; 37]));
    let got: Vec<f64> = found.flat_map(|found| [found.mean, found.error]).collect();
    let expected: Vec<f64> = values.iter().flat_map(|&value| [value, 0.0]).collect();
    let place = |k: usize| {
        format!("37 times {:.3}: {}", values[k / 2], ["mean", "error"][k % 2])
    };
    // Of a mean of squares less a square, √ε may be left.
    let verdict = compare(&got, &expected, Within::Absolute(1e-7), &[], place);
    let nan = got.iter().any(|x| x.is_nan());
    Verdict { bug: nan.then_some(ROOT_OF_NEGATIVE), ..verdict }
}

/// How a direction may come from two numbers.
pub type Direction = fn(f64, f64) -> DVec3;

fn at(sine: f64, cosine: f64, turn: f64) -> DVec3 {
    dvec3(sine * turn.cos(), sine * turn.sin(), cosine)
}

fn from_disc(radius: f64, turn: f64) -> DVec3 {
    at(radius, (1.0 - radius * radius).sqrt(), turn)
}

fn from_height(z: f64, turn: f64) -> DVec3 {
    at((1.0 - z * z).sqrt(), z, turn)
}

/// The right way.
pub fn right_direction(u: f64, v: f64) -> DVec3 {
    from_disc(u.sqrt(), TAU * v)
}

/// Wrong ways.
pub const WRONG_DIRECTIONS: &[(Bug, Direction)] = &[
    (UNIFORM, |u, v| from_height(u, TAU * v)),
    (EVEN_ANGLES, |u, v| at((FRAC_PI_2 * u).sin(), (FRAC_PI_2 * u).cos(), TAU * v)),
    (NO_ROOT, |u, v| from_disc(u, TAU * v)),
    (HALF_TURN, |u, v| from_disc(u.sqrt(), PI * v)),
    (SAME_NUMBER, |u, _| from_disc(u.sqrt(), TAU * u)),
    (SAME_NUMBER, |_, v| from_disc((1.0 - v).sqrt(), TAU * v)),
    (BELOW, |u, v| -from_disc(u.sqrt(), TAU * v)),
    (BELOW, |u, v| from_height(2.0 * u - 1.0, TAU * v)),
];

/// A moment of directions: its name, what it is of one, and its mean over all.
type Moment = (&'static str, fn(DVec3) -> f64, f64);

const MOMENTS: [Moment; 8] = [
    ("z", |d| d.z, 2.0 / 3.0),
    ("z²", |d| d.z * d.z, 0.5),
    ("z⁴", |d| d.z.powi(4), 1.0 / 3.0),
    ("x", |d| d.x, 0.0),
    ("y", |d| d.y, 0.0),
    ("x²", |d| d.x * d.x, 0.25),
    ("y²", |d| d.y * d.y, 0.25),
    ("xy", |d| d.x * d.y, 0.0),
];

/// The mean moments of directions over a grid of 100 × 100 pairs of numbers. The rule is off
/// by some N^-1.5 where a root has its end, a thousandth.
pub fn directions(work: &Work, stream: &mut Stream) -> Verdict {
    const N: usize = 100;
    let (a, b) = (uniform(stream, 0.3, 0.7), uniform(stream, 0.3, 0.7));
    let pair = |k: usize| ((k % N) as f64 + a, (k / N) as f64 + b);
    let all = |f: Direction| {
        let list = (0..N * N).map(|k| f(pair(k).0 / N as f64, pair(k).1 / N as f64));
        let list: Vec<DVec3> = list.collect();
        let mean = |moment: fn(DVec3) -> f64| {
            list.iter().map(|&d| moment(d)).sum::<f64>() / list.len() as f64
        };
        (MOMENTS.map(|(_, moment, _)| mean(moment)).to_vec(), list)
    };
    let (got, list) = all(work.direction);
    let longest = list.iter().map(|d| (d.length() - 1.0).abs()).fold(0.0, f64::max);
    if longest > 1e-9 {
        let message = format!("a length is off by {longest:.3}");
        return Verdict::fail(message, Some(NOT_A_DIRECTION));
    }
    let suspects: Vec<Suspect> =
        WRONG_DIRECTIONS.iter().map(|&(bug, wrong)| (bug, all(wrong).0)).collect();
    let expected = MOMENTS.map(|moment| moment.2);
    let place = |k: usize| format!("the mean of {}", MOMENTS[k].0);
    let verdict = compare(&got, &expected, Within::Absolute(0.01), &suspects, place);
    let below = list.iter().any(|d| d.z < -1e-9);
    let bug = verdict.bug.or((below && !verdict.passed()).then_some(BELOW));
    Verdict { bug, ..verdict }
}
