//! Task 4: a method of one's own.

use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{uniform, whole_number};
use crate::race::Work;
use crate::race::bugs::*;
use crate::race::given::{Pair, gauss};
use crate::shapes::{Place, rectangle};
use radiosity::form_factor::analytic::exchange;
use radiosity::form_factor::named::{parallel_rectangles, perpendicular_rectangles};
use radiosity::prelude::{DVec3, Polygon, dvec3};
use radiosity::random::Stream;

/// Two surfaces, and their factor.
pub struct Known {
    name: String,
    from: Polygon,
    to: Polygon,
    /// The exact factor.
    pub factor: f64,
}

impl Known {
    /// A new pair, that nobody asked yet.
    pub fn pair(&self) -> Pair {
        Pair::new(self.from.clone(), self.to.clone(), vec![])
    }
}

/// Where it stands does not matter to the factor.
fn placed(place: &Place, [corner, a, b]: [DVec3; 3]) -> Polygon {
    let corners = [corner, corner + a, corner + a + b, corner + b];
    Polygon::new(place.all(&corners)).expect("a parallelogram")
}

/// Rectangles a × b straight opposite; the second one begins at any of its corners.
pub fn opposite(stream: &mut Stream, [a, b, distance]: [f64; 3]) -> Known {
    let place = Place::draw(stream);
    let [x, y] = [a * DVec3::X, b * DVec3::Y];
    let starts = [[DVec3::ZERO, y, x], [x, -x, y], [x + y, -y, -x], [y, x, -y]];
    let [corner, first, last] = starts[whole_number(stream, 0, 4)];
    Known {
        name: format!("{a:.2} × {b:.2}, {distance:.2} apart"),
        from: placed(&place, [DVec3::ZERO, x, y]),
        to: placed(&place, [corner + distance * DVec3::Z, first, last]),
        factor: parallel_rectangles(a, b, distance),
    }
}

/// Squares that share an edge, at a right angle.
fn touching(stream: &mut Stream) -> Known {
    let place = Place::draw(stream);
    Known {
        name: "squares that share an edge".into(),
        from: placed(&place, [DVec3::ZERO, DVec3::X, DVec3::Y]),
        to: placed(&place, [DVec3::ZERO, DVec3::Y, DVec3::Z]),
        factor: perpendicular_rectangles(1.0, 1.0, 1.0),
    }
}

/// One above the other and askew; by the library's formula.
fn askew(stream: &mut Stream) -> Known {
    let from = rectangle(DVec3::ZERO, 0.7 * DVec3::X, 1.3 * DVec3::Y);
    let lean = uniform(stream, 0.2, 0.6);
    let corner = dvec3(uniform(stream, 0.1, 0.6), uniform(stream, -0.4, 0.4), 1.1);
    let to =
        rectangle(corner, 1.2 * DVec3::Y, 0.8 * dvec3(lean.cos(), 0.0, lean.sin()));
    let factor = exchange(&from, &to, 1e-12) / from.area();
    Known { name: "rectangles askew".into(), from, to, factor }
}

/// The largest k with k⁴ ≤ effort.
fn places(effort: u32) -> usize {
    (1..).take_while(|k: &u32| k.pow(4) <= effort).last().unwrap_or(1) as usize
}

/// The mean of the kernel over the products of these places in each variable.
fn mean(pair: &Pair, u: &[f64], v: &[f64]) -> f64 {
    let mut sum = 0.0;
    for &a in u {
        for &b in u {
            for &c in v {
                sum += v.iter().map(|&d| pair.kernel([a, b], [c, d])).sum::<f64>();
            }
        }
    }
    sum / (u.len() * v.len()).pow(2) as f64
}

fn middles(k: usize) -> Vec<f64> {
    (0..k).map(|i| (i as f64 + 0.5) / k as f64).collect()
}

/// The midpoint rule, with no more than so many evaluations: point to point.
pub fn midpoint(pair: &Pair, effort: u32) -> f64 {
    let places = middles(places(effort));
    mean(pair, &places, &places)
}

/// Over all places where both points have the same two numbers, or swapped.
fn same_places(pair: &Pair, swapped: bool) -> f64 {
    const K: usize = 40;
    let at = |k: usize| [k % K, k / K].map(|i| (i as f64 + 0.5) / K as f64);
    let value = |u: [f64; 2]| pair.kernel(u, if swapped { [u[1], u[0]] } else { u });
    (0..K * K).map(|k| value(at(k))).sum::<f64>() / (K * K) as f64
}

/// Efforts that are fourth powers, one less, one more, and any.
pub fn allowed(work: &Work, stream: &mut Stream) -> Verdict {
    let known = opposite(stream, [1.0, 1.0, 1.0]);
    let mut efforts: Vec<u32> =
        (1..9_u32).flat_map(|k| [k.pow(4), (k + 1).pow(4) - 1]).collect();
    efforts.extend((0..8).map(|_| whole_number(stream, 1, 3000) as u32));
    for effort in efforts {
        let pair = known.pair();
        let found = (work.factor)(&pair, effort);
        let (asked, told) = (pair.asked(), format!("{effort} evaluations allowed"));
        if asked > effort {
            return Verdict::fail(format!("{told}, {asked} made"), Some(TOO_MANY));
        }
        if !found.is_finite() {
            return Verdict::fail(format!("{told}: got {found}"), None);
        }
    }
    Verdict::pass(0.0, 0.0)
}

/// With this effort even random points are good enough.
const MUCH: u32 = 10_000;

/// What a pair's factor becomes, with so many evaluations.
type Wrong = fn(&Known, f64) -> f64;

/// What mistakes give with effort [`MUCH`].
const WRONG: &[(Bug, Wrong)] = &[
    (INTERVAL, |k, _| 16.0 * k.factor),
    (NO_WEIGHTS, |k, _| {
        let rule: Vec<f64> = gauss(places(MUCH)).iter().map(|&(x, _)| x).collect();
        mean(&k.pair(), &rule, &rule)
    }),
    (NOT_DIVIDED, |k, asked| asked * k.factor),
    (PI_TWICE, |k, _| k.factor / std::f64::consts::PI),
    (AREA_TWICE, |k, _| k.factor * k.from.area()),
    (AREA_TWICE, |k, _| k.factor * k.to.area()),
    (AREA_TWICE, |k, _| k.factor / k.from.area()),
    (AREA_TWICE, |k, _| k.factor / k.to.area()),
    (AREA_TWICE, |k, _| k.factor * k.from.area() / k.to.area()),
    (SAME_PLACES, |k, _| same_places(&k.pair(), false)),
    (SAME_PLACES, |k, _| same_places(&k.pair(), true)),
    (FROM_THE_MIDDLE, |k, _| mean(&k.pair(), &[0.5], &middles(40))),
    (FROM_THE_MIDDLE, |k, _| mean(&k.pair(), &middles(40), &[0.5])),
];

/// Pairs apart, with much effort. Random points are off by a percent or
/// two: 5 % is allowed.
pub fn limit(work: &Work, stream: &mut Stream) -> Verdict {
    let mut all: Vec<Known> = (0..3)
        .map(|_| {
            let sides = [0.5, 1.2].map(|side| side * uniform(stream, 0.8, 1.2));
            opposite(stream, [sides[0], sides[1], 0.5])
        })
        .collect();
    all.push(askew(stream));
    let pairs: Vec<Pair> = all.iter().map(Known::pair).collect();
    let got: Vec<f64> = pairs.iter().map(|pair| (work.factor)(pair, MUCH)).collect();
    let of = |wrong: Wrong| {
        let each = all.iter().zip(&pairs);
        each.map(|(known, pair)| wrong(known, f64::from(pair.asked()))).collect()
    };
    let suspects: Vec<Suspect> = WRONG.iter().map(|&(bug, f)| (bug, of(f))).collect();
    let due: Vec<f64> = all.iter().map(|known| known.factor).collect();
    let place = |k: usize| format!("{}, {MUCH} evaluations allowed", all[k].name);
    let verdict = compare(&got, &due, Within::Relative(0.05), &suspects, place);
    if pairs.iter().any(Pair::was_left) {
        return Verdict::fail("the kernel was asked outside [0, 1]", Some(OUTSIDE));
    }
    let unnamed = verdict.bug.is_none() && !verdict.passed();
    let stuck = unnamed && is_stuck(work, &all[0]);
    let bug = verdict.bug.or(stuck.then_some(STUCK));
    Verdict { bug, ..verdict }
}

/// The same evaluations, and the same answer, with little effort as with much?
fn is_stuck(work: &Work, known: &Known) -> bool {
    let asked = |effort| {
        let pair = known.pair();
        let found = (work.factor)(&pair, effort);
        (pair.asked(), found.to_bits())
    };
    asked(MUCH) == asked(625)
}

/// Squares that share an edge. Gauss's rule is off by 27 % there with 10⁴ evaluations,
/// worse than the midpoint rule, 7 %: both are right in the end.
pub fn edge(work: &Work, stream: &mut Stream) -> Verdict {
    let known = touching(stream);
    let found = (work.factor)(&known.pair(), MUCH);
    let place = |_| format!("{}, {MUCH} evaluations allowed", known.name);
    let verdict = compare(&[found], &[known.factor], Within::Relative(0.4), &[], place);
    let lost = !verdict.passed() && !found.is_finite();
    Verdict { bug: lost.then_some(AT_THE_EDGE), ..verdict }
}

/// Facing squares one side apart: at most half the error of the midpoint rule with 1296
/// evaluations, at most 10⁻⁴ with 10⁴. A rule of fourth order does that.
pub fn faster(work: &Work, stream: &mut Stream) -> Verdict {
    let known = opposite(stream, [1.0, 1.0, 1.0]);
    let off = |f: f64| (f / known.factor - 1.0).abs();
    let mut verdict = Verdict::pass(0.0, 1.0);
    for effort in [1296, MUCH] {
        let got = (work.factor)(&known.pair(), effort);
        let rule = midpoint(&known.pair(), effort);
        let most = if effort == MUCH { 1e-4 } else { 0.5 * off(rule) };
        let metric = off(got) / most;
        // Not a number is not below.
        if metric <= 1.0 {
            verdict = verdict.and(|| Verdict::pass(metric, 1.0));
            continue;
        }
        let message = format!(
            "{}, {effort} evaluations allowed: off by {:.1e}, the midpoint rule by \
             {:.1e}; at most {most:.1e} is asked for",
            known.name,
            off(got),
            off(rule)
        );
        return Verdict {
            metric: if metric.is_nan() { f64::INFINITY } else { metric },
            tolerance: 1.0,
            message: Some(message),
            bug: slow(work, &known, [got, rule]),
        };
    }
    verdict
}

/// Why a method is not faster than the midpoint rule, if it is right at all.
fn slow(work: &Work, known: &Known, [got, rule]: [f64; 2]) -> Option<Bug> {
    let much = ((work.factor)(&known.pair(), MUCH) / known.factor - 1.0).abs();
    match got {
        // `limit` says what is wrong. Same places for both are 2.4 % off here.
        _ if much.is_nan() || much > 0.015 => None,
        _ if is_stuck(work, known) => Some(STUCK),
        got if (got / rule - 1.0).abs() < 1e-9 => Some(MIDPOINT),
        _ => Some(SLOW),
    }
}
