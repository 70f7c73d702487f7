//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, direction, estimate};
use super::bugs::*;
use super::given::{Estimate, Pair, Seen};
use crate::lab::{Wrong, plays};
use crate::run::PANIC;
use radiosity::prelude::{DVec3, Frame, dvec3};
use radiosity::random::Stream;
use std::f64::consts::PI;

/// The answer, but with another estimate.
macro_rules! estimates {
    ($estimate:expr) => {
        Work {
            estimate: $estimate,
            by_rays: |pair, n, stream| rays(pair, n, stream, direction, $estimate),
            by_points: |pair, n, stream| points(pair, n, stream, four, area, $estimate),
            ..WORK
        }
    };
}

/// The answer, but with other directions.
macro_rules! directs {
    ($direction:expr) => {
        Work {
            direction: $direction,
            by_rays: |pair, n, stream| rays(pair, n, stream, $direction, estimate),
            ..WORK
        }
    };
}

/// The answer, but with another value for each pair of points.
macro_rules! values {
    ($value:expr) => {
        Work {
            by_points: |pair, n, stream| {
                points(pair, n, stream, four, $value, estimate)
            },
            ..WORK
        }
    };
}

/// The answer, but with other rays.
macro_rules! shoots {
    ($ray:expr) => {
        Work {
            by_rays: |pair, n, stream| {
                let ray: fn(&Pair, &mut Stream) -> f64 = $ray;
                estimate(&(0..n).map(|_| ray(pair, stream)).collect::<Vec<_>>())
            },
            ..WORK
        }
    };
}

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("standard-deviation", "an error bar is the scatter", &[SPREAD], {
        estimates!(|values| {
            let Estimate { mean, error } = estimate(values);
            Estimate { mean, error: error * (values.len() as f64).sqrt() }
        })
    }),
    plays("variance", "no root", &[VARIANCE], {
        estimates!(|values| {
            let Estimate { mean, error } = estimate(values);
            Estimate { mean, error: error.powi(2) }
        })
    }),
    plays("over-n", "as the mean, so the error", &[OVER_N], {
        estimates!(|values| {
            let Estimate { mean, error } = estimate(values);
            Estimate { mean, error: error / (values.len() as f64).sqrt() }
        })
    }),
    plays("one-over-root-n", "the error of Monte Carlo is 1/√n", &[NO_SPREAD], {
        estimates!(|values| {
            let error = (values.len() as f64).powf(-0.5);
            Estimate { error, ..estimate(values) }
        })
    }),
    plays(
        "root-of-negative",
        "mean of squares less square of mean",
        &[ROOT_OF_NEGATIVE],
        {
            estimates!(|values| {
                let n = values.len() as f64;
                let mean = values.iter().sum::<f64>() / n;
                let square = values.iter().map(|x| x * x).sum::<f64>() / n;
                Estimate { mean, error: ((square - mean * mean) / n).sqrt() }
            })
        },
    ),
    plays("sum", "a mean is a sum", &[SUM], {
        Work {
            estimate: |values| Estimate {
                mean: values.iter().sum(),
                ..estimate(values)
            },
            ..WORK
        }
    }),
    plays("even-directions", "uniform is fair", &[UNIFORM], {
        directs!(|u, v| around(1.0 - u, v))
    }),
    plays("even-angles", "θ is uniform", &[EVEN_ANGLES], {
        directs!(|u, v| around((u * PI / 2.0).cos(), v))
    }),
    plays("no-root", "the radius is uniform", &[NO_ROOT], {
        directs!(|u, v| direction(u * u, v))
    }),
    plays("half-turn", "π is a full turn", &[HALF_TURN], {
        directs!(|u, v| direction(u, v / 2.0))
    }),
    plays("one-number", "a random number is a random number", &[SAME_NUMBER], {
        directs!(|u, _| direction(u, u))
    }),
    plays("whole-sphere", "directions are all around", &[BELOW], {
        directs!(|u, v| around(1.0 - 2.0 * u, v))
    }),
    plays("cube", "a random vector", &[NOT_A_DIRECTION], {
        Work { direction: |u, v| dvec3(2.0 * u - 1.0, 2.0 * v - 1.0, 1.0), ..WORK }
    }),
    plays("world-frame", "up is z", &[NOT_TURNED], {
        shoots!(|pair, stream| {
            let start = start(pair, stream);
            hits(pair, start, direction(stream.next(), stream.next()))
        })
    }),
    plays("from-the-centre", "a patch is a point", &[FROM_CENTRE], {
        shoots!(|pair, stream| {
            let along = turned(pair, direction(stream.next(), stream.next()));
            hits(pair, pair.from.centroid(), along)
        })
    }),
    plays("cosine-twice", "the formula has a cosine", &[COSINE_TWICE], {
        shoots!(|pair, stream| {
            let local = direction(stream.next(), stream.next());
            hits(pair, start(pair, stream), turned(pair, local)) * local.z
        })
    }),
    plays("anything", "a hit is a hit", &[ANYTHING], {
        shoots!(|pair, stream| {
            let along = turned(pair, direction(stream.next(), stream.next()));
            let seen = pair.first(start(pair, stream), along);
            f64::from(u8::from(seen != Seen::Nothing))
        })
    }),
    plays("rays-blind", "the target is looked at alone", &[NO_VISIBILITY], {
        Work {
            by_rays: |pair, n, stream| {
                let alone = Pair { blockers: vec![], ..pair.clone() };
                (WORK.by_rays)(&alone, n, stream)
            },
            ..WORK
        }
    }),
    plays("two-numbers-a-ray", "random numbers are dear", &[SAME_POINTS], {
        shoots!(|pair, stream| {
            let (u, v) = (stream.next(), stream.next());
            let along = turned(pair, direction(u, v));
            hits(pair, pair.from.point_at([u, v]), along)
        })
    }),
    plays("points-blind", "what is between is the ray's affair", &[NO_VISIBILITY], {
        values!(|pair, x, y| {
            let alone = Pair { blockers: vec![], ..pair.clone() };
            area(&alone, x, y)
        })
    }),
    plays("no-receiver-cosine", "light arrives", &[ONE_COSINE], {
        values!(|pair, x, y| {
            let cosine = (y - x).normalize().dot(-pair.to.normal());
            if cosine > 0.0 { area(pair, x, y) / cosine } else { 0.0 }
        })
    }),
    plays("no-cosines", "1/πr²", &[NO_COSINES], {
        values!(|pair, x, y| {
            let seen = f64::from(u8::from(area(pair, x, y) > 0.0));
            seen * pair.to.area() / (PI * (y - x).length_squared())
        })
    }),
    plays("long-cosines", "a dot product is a cosine", &[DISTANCE], {
        values!(|pair, x, y| area(pair, x, y) * (y - x).length_squared())
    }),
    plays("no-pi", "π is in the cosine", &[NO_PI], {
        values!(|pair, x, y| area(pair, x, y) * PI)
    }),
    plays("no-area", "a mean is a mean", &[NO_AREA], {
        values!(|pair, x, y| area(pair, x, y) / pair.to.area())
    }),
    plays("senders-area", "the area that sends", &[WRONG_AREA], {
        values!(|pair, x, y| area(pair, x, y) * pair.from.area() / pair.to.area())
    }),
    plays("negative-light", "a cosine may be negative", &[BACKS], {
        values!(|pair, x, y| {
            let way = (y - x).normalize();
            let cosines = pair.from.normal().dot(way) * pair.to.normal().dot(-way);
            let value = cosines * pair.to.area() / (PI * (y - x).length_squared());
            if pair.sees(x, y) { value } else { 0.0 }
        })
    }),
    plays(
        "mean-visibility",
        "a share is visible, so multiply by it",
        &[MEAN_VISIBILITY],
        {
            Work {
                by_points: |pair, n, stream| {
                    let alone = Pair { blockers: vec![], ..pair.clone() };
                    let open = (WORK.by_points)(&alone, n, &mut stream.clone());
                    let sees = |pair: &Pair, x: DVec3, y: DVec3| {
                        f64::from(u8::from(pair.sees(x, y)))
                    };
                    let seen = points(pair, n, stream, four, sees, estimate);
                    Estimate { mean: open.mean * seen.mean, ..open }
                },
                ..WORK
            }
        },
    ),
    plays("visible-only", "what is hidden does not count", &[VISIBLE_ONLY], {
        Work {
            by_points: |pair, n, stream| {
                let mut values = Vec::new();
                for _ in 0..n {
                    let (x, y) = four(pair, stream);
                    if pair.sees(x, y) {
                        values.push(area(pair, x, y));
                    }
                }
                estimate(&values)
            },
            ..WORK
        }
    }),
    plays("two-numbers-a-pair", "one place on both", &[SAME_POINTS], {
        Work {
            by_points: |pair, n, stream| {
                let same = |pair: &Pair, stream: &mut Stream| {
                    let place = [stream.next(), stream.next()];
                    (pair.from.point_at(place), pair.to.point_at(place))
                };
                points(pair, n, stream, same, area, estimate)
            },
            ..WORK
        }
    }),
    plays("diagonal", "one number for a point", &[SAME_NUMBER], {
        Work {
            by_points: |pair, n, stream| {
                let same = |pair: &Pair, stream: &mut Stream| {
                    let (u, v) = (stream.next(), stream.next());
                    (pair.from.point_at([u, u]), pair.to.point_at([v, v]))
                };
                points(pair, n, stream, same, area, estimate)
            },
            ..WORK
        }
    }),
    plays("last-sample", "samples are numbered from 1", &[PANIC], {
        Work {
            by_points: |pair, n, stream| {
                let values: Vec<f64> = (0..n)
                    .map(|_| {
                        let (x, y) = four(pair, stream);
                        area(pair, x, y)
                    })
                    .collect();
                estimate(&values[1..=n])
            },
            ..WORK
        }
    }),
];

/// A direction with this cosine.
fn around(cosine: f64, v: f64) -> DVec3 {
    let (sine, turn) = ((1.0 - cosine * cosine).sqrt(), 2.0 * PI * v);
    dvec3(sine * turn.sin(), sine * turn.cos(), cosine)
}

fn start(pair: &Pair, stream: &mut Stream) -> DVec3 {
    pair.from.point_at([stream.next(), stream.next()])
}

fn turned(pair: &Pair, local: DVec3) -> DVec3 {
    Frame::about(pair.from.normal()).world_from_local(local)
}

fn hits(pair: &Pair, start: DVec3, along: DVec3) -> f64 {
    f64::from(u8::from(pair.first(start, along) == Seen::Target))
}

fn rays(
    pair: &Pair,
    n: usize,
    stream: &mut Stream,
    direction: fn(f64, f64) -> DVec3,
    estimate: fn(&[f64]) -> Estimate,
) -> Estimate {
    let mut values = Vec::with_capacity(n);
    for _ in 0..n {
        let along = turned(pair, direction(stream.next(), stream.next()));
        values.push(hits(pair, start(pair, stream), along));
    }
    estimate(&values)
}

/// Two points, from four numbers.
fn four(pair: &Pair, stream: &mut Stream) -> (DVec3, DVec3) {
    let x = start(pair, stream);
    (x, pair.to.point_at([stream.next(), stream.next()]))
}

/// V cosθ cosθ' A_j/(π r²).
fn area(pair: &Pair, x: DVec3, y: DVec3) -> f64 {
    let way = y - x;
    let (here, there) = (pair.from.normal().dot(way), pair.to.normal().dot(-way));
    if here <= 0.0 || there <= 0.0 || !pair.sees(x, y) {
        return 0.0;
    }
    here * there * pair.to.area() / (way.length().powi(4) * PI)
}

fn points(
    pair: &Pair,
    n: usize,
    stream: &mut Stream,
    draw: fn(&Pair, &mut Stream) -> (DVec3, DVec3),
    value: fn(&Pair, DVec3, DVec3) -> f64,
    estimate: fn(&[f64]) -> Estimate,
) -> Estimate {
    let mut values = Vec::with_capacity(n);
    for _ in 0..n {
        let (x, y) = draw(pair, stream);
        values.push(value(pair, x, y));
    }
    estimate(&values)
}
