//! Tasks 3 and 4: form factors by rays and by points, and their error bars.

use super::basics::{WRONG_DIRECTIONS, estimated, right_direction};
use super::scenes::{Known, hidden, open};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::sampling::Work;
use crate::sampling::bugs::*;
use crate::sampling::given::{Estimate, Pair, Seen};
use radiosity::prelude::{DVec3, Frame};
use radiosity::random::Stream;
use std::f64::consts::PI;

/// By what the student samples.
#[derive(Clone, Copy, PartialEq)]
pub enum Method {
    /// Rays.
    Rays,
    /// Pairs of points.
    Points,
}

/// Which pairs are looked at.
#[derive(Clone, Copy)]
pub enum Of {
    /// With nothing between.
    Open,
    /// With blockers.
    Hidden,
}

impl Of {
    fn others(self) -> Of {
        match self {
            Of::Open => Of::Hidden,
            Of::Hidden => Of::Open,
        }
    }

    fn pairs(self, stream: &mut Stream) -> Vec<Known> {
        match self {
            Of::Open => open(stream),
            Of::Hidden => hidden(stream),
        }
    }
}

impl Method {
    /// What the student finds.
    pub fn run(
        self,
        work: &Work,
        pair: &Pair,
        n: usize,
        stream: &mut Stream,
    ) -> Estimate {
        match self {
            Method::Rays => (work.by_rays)(pair, n, stream),
            Method::Points => (work.by_points)(pair, n, stream),
        }
    }
}

/// How many samples the student takes.
const SAMPLES: usize = 40_000;
/// How many of ours say what a mistake gives.
const OURS: usize = 8192;

/// What samples give: their mean, and the scatter of one.
#[derive(Clone, Copy)]
struct Stat {
    mean: f64,
    scatter: f64,
}

/// Of evenly spread samples, each from four numbers.
fn stat(sample: impl Fn([f64; 4]) -> f64) -> Stat {
    let points = Stream::named(3, &[]).points::<4>(OURS);
    let values: Vec<f64> = points.map(sample).collect();
    let [mean, error] = estimated(&values);
    Stat { mean, scatter: error * (OURS as f64).sqrt() }
}

/// A sample by a ray; `way` is what four numbers make of point and direction, `count` what
/// becomes of what is seen and of the cosine.
fn ray(
    pair: &Pair,
    numbers: [f64; 4],
    way: fn(f64, f64) -> DVec3,
    count: fn(Seen, f64) -> f64,
) -> f64 {
    let [a, b, c, d] = numbers;
    let local = way(c, d);
    let along = Frame::about(pair.from.normal()).world_from_local(local);
    count(pair.first(pair.from.point_at([a, b]), along), local.z)
}

fn target(seen: Seen, _: f64) -> f64 {
    if seen == Seen::Target { 1.0 } else { 0.0 }
}

/// What mistakes with rays give.
fn wrong_rays(pair: &Pair) -> Vec<(Bug, Stat)> {
    let right = right_direction;
    let middle = pair.from.centroid();
    let blind = Pair { blockers: vec![], ..pair.clone() };
    let (a_i, a_j) = (pair.from.area(), pair.to.area());
    let mut all = vec![
        (
            NOT_TURNED,
            stat(|[a, b, c, d]| {
                target(pair.first(pair.from.point_at([a, b]), right(c, d)), 0.0)
            }),
        ),
        (
            FROM_CENTRE,
            stat(|[_, _, c, d]| {
                let along =
                    Frame::about(pair.from.normal()).world_from_local(right(c, d));
                target(pair.first(middle, along), 0.0)
            }),
        ),
        (COSINE_TWICE, stat(|u| ray(pair, u, right, |seen, z| z * target(seen, z)))),
        (COSINE_TWICE, stat(|u| ray(pair, u, right, |s, z| 2.0 * z * target(s, z)))),
        (
            ANYTHING,
            stat(|u| {
                ray(
                    pair,
                    u,
                    right,
                    |seen, _| if seen == Seen::Nothing { 0.0 } else { 1.0 },
                )
            }),
        ),
        (NO_VISIBILITY, stat(|u| ray(&blind, u, right, target))),
        (SAME_POINTS, stat(|[a, b, ..]| ray(pair, [a, b, a, b], right, target))),
        (SAME_POINTS, stat(|[a, b, ..]| ray(pair, [a, b, b, a], right, target))),
        (SAME_NUMBER, stat(|[a, b, ..]| ray(pair, [a, a, b, b], right, target))),
        (SAME_NUMBER, stat(|[a, ..]| ray(pair, [a; 4], right, target))),
        (WRONG_AREA, stat(|u| a_i / a_j * ray(pair, u, right, target))),
    ];
    for &(bug, wrong) in WRONG_DIRECTIONS {
        all.push((bug, stat(|u| ray(pair, u, wrong, target))));
    }
    all
}

/// cosθ, cosθ', r and V between two points.
struct Between {
    cosines: [f64; 2],
    r: f64,
    seen: f64,
}

fn between(pair: &Pair, [a, b, c, d]: [f64; 4]) -> Between {
    let (x, y) = (pair.from.point_at([a, b]), pair.to.point_at([c, d]));
    let way = (y - x).normalize();
    Between {
        cosines: [pair.from.normal().dot(way), -pair.to.normal().dot(way)],
        r: x.distance(y),
        seen: if pair.sees(x, y) { 1.0 } else { 0.0 },
    }
}

/// The sample for a form factor, without the area and the visibility.
fn kernel(between: &Between) -> f64 {
    let [here, there] = between.cosines.map(|cosine| cosine.max(0.0));
    here * there / (PI * between.r * between.r)
}

/// What mistakes with points give.
fn wrong_points(pair: &Pair) -> Vec<(Bug, Stat)> {
    let (a_i, a_j) = (pair.from.area(), pair.to.area());
    let of = |value: fn(&Between) -> f64| {
        stat(|numbers| {
            let between = between(pair, numbers);
            a_j * between.seen * value(&between)
        })
    };
    let with = |numbers: fn([f64; 4]) -> [f64; 4]| {
        stat(|u| {
            let between = between(pair, numbers(u));
            a_j * between.seen * kernel(&between)
        })
    };
    let right = of(kernel);
    let times = |x: f64| Stat { mean: x * right.mean, scatter: x * right.scatter };
    let bare = stat(|u| a_j * kernel(&between(pair, u)));
    let seen = stat(|u| between(pair, u).seen);
    let root = seen.mean.sqrt().max(1e-3);
    vec![
        (NO_VISIBILITY, bare),
        (ONE_COSINE, of(|b| front(b) * b.cosines[0] / (PI * b.r * b.r))),
        (ONE_COSINE, of(|b| front(b) * b.cosines[1] / (PI * b.r * b.r))),
        (NO_COSINES, of(|b| front(b) / (PI * b.r * b.r))),
        (NO_COSINES, of(|b| 1.0 / (PI * b.r * b.r))),
        (NO_PI, times(PI)),
        (NO_AREA, times(1.0 / a_j)),
        (WRONG_AREA, times(a_i / a_j)),
        (DISTANCE, of(|b| kernel(b) * b.r)),
        (DISTANCE, of(|b| kernel(b) * b.r * b.r)),
        (DISTANCE, of(|b| kernel(b) / (b.r * b.r))),
        (BACKS, of(|b| b.cosines[0] * b.cosines[1] / (PI * b.r * b.r))),
        (BACKS, of(|b| (b.cosines[0] * b.cosines[1]).abs() / (PI * b.r * b.r))),
        (
            MEAN_VISIBILITY,
            Stat {
                mean: bare.mean * seen.mean,
                scatter: (bare.scatter * seen.mean).hypot(bare.mean * seen.scatter),
            },
        ),
        (
            VISIBLE_ONLY,
            Stat {
                mean: right.mean / seen.mean.max(1e-3),
                scatter: bare.scatter / root,
            },
        ),
        (SAME_POINTS, with(|[a, b, ..]| [a, b, a, b])),
        (SAME_POINTS, with(|[a, b, ..]| [a, b, b, a])),
        (SAME_NUMBER, with(|[a, b, ..]| [a, a, b, b])),
    ]
}

/// 1 where both points lie in front of each other.
fn front(between: &Between) -> f64 {
    if between.cosines.iter().all(|&cosine| cosine > 0.0) { 1.0 } else { 0.0 }
}

/// The scatter of a right sample.
fn scatter(known: &Known, method: Method) -> f64 {
    let f = known.factor;
    match method {
        Method::Rays => (f * (1.0 - f)).sqrt(),
        Method::Points => {
            let value = |u| {
                let between = between(&known.pair, u);
                known.pair.to.area() * between.seen * kernel(&between)
            };
            stat(value).scatter
        }
    }
}

/// The means, in units of their due standard errors.
pub fn means(work: &Work, stream: &mut Stream, method: Method, of: Of) -> Verdict {
    let pairs = of.pairs(stream);
    let root = (SAMPLES as f64).sqrt();
    let run = |known: &Known, stream: &mut Stream| {
        method.run(work, &known.pair, SAMPLES, stream).mean
    };
    let got: Vec<f64> = pairs.iter().map(|known| run(known, stream)).collect();
    let errors: Vec<f64> =
        pairs.iter().map(|known| scatter(known, method) / root).collect();
    let units = |values: &[f64]| -> Vec<f64> {
        values.iter().zip(&errors).map(|(value, error)| value / error).collect()
    };
    let due: Vec<f64> = pairs.iter().map(|known| known.factor).collect();
    let verdict =
        compare(&units(&got), &units(&due), Within::Absolute(5.0), &[], |_| {
            String::new()
        });
    if verdict.passed() {
        return verdict;
    }
    let told: Vec<String> = pairs
        .iter()
        .zip(&got)
        .map(|(known, got)| {
            format!("{}: got {got:.5}, due {:.5}", known.name, known.factor)
        })
        .collect();
    // The others too: the more pairs, the fewer mistakes explain them all.
    let (mut pairs, mut got) = (pairs, got);
    pairs.extend(of.others().pairs(stream));
    let more: Vec<f64> = pairs[got.len()..].iter().map(|k| run(k, stream)).collect();
    got.extend(more);
    let bug = suspected(&pairs, &got, method);
    Verdict { message: Some(told.join("; ")), bug, ..verdict }
}

/// The mistake that gives these means, within five of its own standard errors; for the
/// scatter of ours 0.4 % is allowed, and half a sample.
fn suspected(pairs: &[Known], got: &[f64], method: Method) -> Option<Bug> {
    let wrong = match method {
        Method::Rays => wrong_rays,
        Method::Points => wrong_points,
    };
    let each: Vec<Vec<(Bug, Stat)>> = pairs.iter().map(|k| wrong(&k.pair)).collect();
    let off = |suspect: usize| {
        let of = |(got, all): (&f64, &Vec<(Bug, Stat)>)| {
            let Stat { mean, scatter } = all[suspect].1;
            let error = scatter / (SAMPLES as f64).sqrt()
                + 0.004 * mean.abs()
                + 0.5 / OURS as f64;
            (got - mean).abs() / error
        };
        let all = got.iter().zip(&each).map(of);
        // What is not a number is nobody's.
        all.fold(0.0, |most: f64, off| if off <= most { most } else { off })
    };
    let all = (0..each.first()?.len()).map(|k| (each[0][k].0, off(k)));
    let near = all.filter(|&(_, off)| off <= 5.0);
    near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(bug, _)| bug)
}

/// The error bars. Their own scatter is 3 % at most here; 15 % is allowed.
pub fn bars(work: &Work, stream: &mut Stream, method: Method) -> Verdict {
    const SAMPLES: usize = 10_000;
    let pairs: Vec<Known> =
        [open(stream), hidden(stream)].into_iter().flatten().collect();
    let n = SAMPLES as f64;
    let scatters: Vec<f64> = pairs.iter().map(|known| scatter(known, method)).collect();
    let all = |f: fn(f64, f64) -> f64| scatters.iter().map(|&s| f(s, n)).collect();
    let run = |known: &Known| method.run(work, &known.pair, SAMPLES, stream).error;
    let got: Vec<f64> = pairs.iter().map(run).collect();
    let suspects: [Suspect; 4] = [
        (SPREAD, all(|s, _| s)),
        (VARIANCE, all(|s, n| s * s / n)),
        (OVER_N, all(|s, n| s / n)),
        (NO_SPREAD, all(|_, n| 1.0 / n.sqrt())),
    ];
    let expected: Vec<f64> = all(|s, n| s / n.sqrt());
    let place = |k: usize| format!("{}, {SAMPLES} samples: the error", pairs[k].name);
    compare(&got, &expected, Within::Relative(0.15), &suspects, place)
}
