//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, factor, frontier, off, slope};
use super::bugs::*;
use super::given::{Pair, gauss};
use crate::lab::{Wrong, plays};
use crate::run::PANIC;
use std::f64::consts::PI;

/// The answer, but with another error.
macro_rules! errs {
    ($off:expr) => {
        Work { off: $off, ..WORK }
    };
}

/// The answer, but with another frontier.
macro_rules! stands {
    ($frontier:expr) => {
        Work { frontier: $frontier, ..WORK }
    };
}

/// The answer, but with another slope.
macro_rules! slopes {
    ($slope:expr) => {
        Work { slope: $slope, ..WORK }
    };
}

/// The answer, but with another factor.
macro_rules! finds {
    ($factor:expr) => {
        Work { factor: $factor, ..WORK }
    };
}

/// Who reads the chart wrongly, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("absolute", "an error is a difference", &[ABSOLUTE], {
        errs!(|answers, exact| off(answers, exact) * exact)
    }),
    plays("by-the-answer", "as a share of what was found", &[BY_THE_ANSWER], {
        errs!(|answers, exact| {
            let square = |a: &f64| ((a - exact) / a).powi(2);
            (answers.iter().map(square).sum::<f64>() / answers.len() as f64).sqrt()
        })
    }),
    plays("mean-first", "seeds are for averaging", &[OF_THE_MEAN], {
        errs!(|answers, exact| off(&[mean(answers)], exact))
    }),
    plays("no-squares", "the mean error", &[NO_SQUARES], {
        errs!(|answers, exact| {
            let sizes: Vec<f64> =
                answers.iter().map(|a| (a - exact).abs() / exact).collect();
            mean(&sizes)
        })
    }),
    plays("no-root", "least squares", &[NO_ROOT], {
        errs!(|answers, exact| off(answers, exact).powi(2))
    }),
    plays("sum", "the root of the squares", &[NOT_A_MEAN], {
        errs!(|answers, exact| answers
            .iter()
            .fold(0.0, |sum: f64, a| sum.hypot(a / exact - 1.0)))
    }),
    plays("over-n", "the root, then the mean", &[OVER_N], {
        errs!(|answers, exact| off(answers, exact) / (answers.len() as f64).sqrt())
    }),
    plays("deviation", "the standard deviation is the error", &[SCATTER], {
        errs!(|answers, exact| {
            let mean = mean(answers);
            let squares: f64 = answers.iter().map(|a| (a - mean).powi(2)).sum();
            (squares / (answers.len() as f64 - 1.0)).sqrt() / exact
        })
    }),
    plays("worst", "a bound is safe", &[WORST], {
        errs!(|answers, exact| {
            let one = |a: &f64| off(&[*a], exact);
            answers.iter().map(one).max_by(f64::total_cmp).unwrap_or(0.0)
        })
    }),
    plays("itself", "≤ both ways", &[ITSELF], {
        stands!(|trials| {
            let beaten =
                |(t, e): (f64, f64)| trials.iter().any(|o| o.0 <= t && o.1 <= e);
            (0..trials.len()).filter(|&k| !beaten(trials[k])).collect()
        })
    }),
    plays("either", "faster or better", &[EITHER], {
        stands!(|trials| {
            let beaten = |(t, e): (f64, f64)| trials.iter().any(|o| o.0 < t || o.1 < e);
            (0..trials.len()).filter(|&k| !beaten(trials[k])).collect()
        })
    }),
    plays("strict", "faster and better", &[STRICT], {
        stands!(|trials| {
            let beaten = |(t, e): (f64, f64)| trials.iter().any(|o| o.0 < t && o.1 < e);
            (0..trials.len()).filter(|&k| !beaten(trials[k])).collect()
        })
    }),
    plays("staircase", "sorted, each lower than the last", &[ONE_OF_EQUALS], {
        stands!(|trials| {
            let mut order: Vec<usize> = (0..trials.len()).collect();
            order.sort_by(|&a, &b| trials[a].partial_cmp(&trials[b]).expect("numbers"));
            let mut least = f64::INFINITY;
            order.retain(|&k| {
                trials[k].1 < least && {
                    least = trials[k].1;
                    true
                }
            });
            order
        })
    }),
    plays("unsorted", "the list is in order", &[UNSORTED], {
        stands!(|trials| {
            let mut least = f64::INFINITY;
            let mut kept = vec![];
            for (k, trial) in trials.iter().enumerate() {
                if trial.1 < least {
                    least = trial.1;
                    kept.push(k);
                }
            }
            kept
        })
    }),
    plays("largest", "up and to the right", &[LARGER], {
        stands!(|trials| {
            let turned: Vec<_> = trials.iter().map(|(t, e)| (-t, -e)).collect();
            frontier(&turned)
        })
    }),
    plays("ends", "the fastest and the best", &[ENDS], {
        stands!(|trials| {
            let stand = frontier(trials);
            let by = |f: fn(&(f64, f64)) -> f64| {
                let mut sorted = stand.clone();
                sorted.sort_by(|&a, &b| f(&trials[a]).total_cmp(&f(&trials[b])));
                sorted[0]
            };
            let (fast, good) = (by(|t| t.0), by(|t| t.1));
            if fast == good { vec![fast] } else { vec![fast, good] }
        })
    }),
    plays("hull", "a frontier is convex", &[HULL], {
        stands!(|trials| {
            let mut order = frontier(trials);
            order.sort_by(|&a, &b| trials[a].0.total_cmp(&trials[b].0));
            let mut hull: Vec<usize> = vec![];
            for k in order {
                let c = trials[k];
                while let [.., i, j] = hull[..] {
                    let (a, b) = (trials[i], trials[j]);
                    let turn = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
                    if turn > 0.0 {
                        break;
                    }
                    hull.pop();
                }
                hull.push(k);
            }
            hull
        })
    }),
    plays("beaten", "which are beaten?", &[BEATEN], {
        stands!(|trials| {
            let stand = frontier(trials);
            (0..trials.len()).filter(|k| !stand.contains(k)).collect()
        })
    }),
    plays("linear", "a slope is a slope", &[LINEAR], slopes!(|trials| fit(trials))),
    plays("one-log", "errors span decades", &[ONE_LOG], {
        slopes!(|trials| {
            let counts = trials.iter().filter(|t| t.1 > 0.0);
            fit(&counts.map(|(t, e)| (*t, e.log10())).collect::<Vec<_>>())
        })
    }),
    plays("swapped", "time over error", &[SWAPPED], {
        slopes!(|trials| {
            let turned: Vec<_> = trials.iter().map(|(t, e)| (*e, *t)).collect();
            slope(&turned)
        })
    }),
    plays("order", "an order is positive", &[SIGN], slopes!(|trials| -slope(trials))),
    plays("two-points", "a line has two points", &[TWO_POINTS], {
        slopes!(|trials| {
            let counts: Vec<_> =
                trials.iter().filter(|t| t.0 > 0.0 && t.1 > 0.0).collect();
            let (a, b) = (counts[0], counts[counts.len() - 1]);
            (b.1 / a.1).ln() / (b.0 / a.0).ln()
        })
    }),
    plays("no-means", "Σxy/Σxx", &[NO_MEANS], {
        slopes!(|trials| {
            let (mut xy, mut xx) = (0.0, 0.0);
            for (t, e) in trials.iter().filter(|t| t.0 > 0.0 && t.1 > 0.0) {
                xy += t.log10() * e.log10();
                xx += t.log10().powi(2);
            }
            xy / xx
        })
    }),
    plays("zeros", "everything has a logarithm", &[NO_LOGARITHM], {
        slopes!(|trials| {
            fit(&trials.iter().map(|(t, e)| (t.ln(), e.ln())).collect::<Vec<_>>())
        })
    }),
    plays("made-up", "0 is nearly 1e-300", &[MADE_UP], {
        slopes!(|trials| {
            let up: Vec<_> =
                trials.iter().map(|(t, e)| (t.max(1e-300), e.max(1e-300))).collect();
            slope(&up)
        })
    }),
    plays("counted", "n is the length", &[COUNTED], {
        slopes!(|trials| {
            let [mut x, mut y, mut xy, mut xx] = [0.0; 4];
            for (t, e) in trials.iter().filter(|t| t.0 > 0.0 && t.1 > 0.0) {
                let (t, e) = (t.ln(), e.ln());
                x += t;
                y += e;
                xy += t * e;
                xx += t * t;
            }
            let n = trials.len() as f64;
            (xy - x * y / n) / (xx - x * x / n)
        })
    }),
];

/// Who finds a factor wrongly, or slowly.
pub const FACTORS: &[Wrong<Work>] = &[
    plays("rounded-up", "k is about the fourth root", &[TOO_MANY], {
        finds!(|pair, effort| {
            let k = f64::from(effort).powf(0.25).ceil();
            factor(pair, k.powi(4) as u32)
        })
    }),
    plays("once-more", "a coarse run is free", &[TOO_MANY], {
        finds!(|pair, effort| {
            let k = places(effort);
            if k < 2 {
                return product(pair, &midpoints(1));
            }
            let [fine, coarse] = [k, k / 2].map(|k| product(pair, &midpoints(k)));
            let ratio = (k as f64 / (k / 2) as f64).powi(2);
            (ratio * fine - coarse) / (ratio - 1.0)
        })
    }),
    plays("stuck", "three places are enough", &[STUCK], {
        finds!(|pair, effort| factor(pair, effort.min(81)))
    }),
    plays("table", "Gauss's places as in the table", &[OUTSIDE], {
        finds!(|pair, effort| {
            let rule: Vec<_> = gauss(places(effort))
                .iter()
                .map(|(x, w)| (2.0 * x - 1.0, *w))
                .collect();
            product(pair, &rule)
        })
    }),
    plays("weights-of-two", "the weights as in the table", &[INTERVAL], {
        finds!(|pair, effort| {
            let rule: Vec<_> =
                gauss(places(effort)).iter().map(|(x, w)| (*x, 2.0 * w)).collect();
            product(pair, &rule)
        })
    }),
    plays("no-weights", "places are all that matters", &[NO_WEIGHTS], {
        finds!(|pair, effort| {
            let k = places(effort);
            let even = |(x, _): &(f64, f64)| (*x, 1.0 / k as f64);
            product(pair, &gauss(k).iter().map(even).collect::<Vec<_>>())
        })
    }),
    plays("kernel-sum", "an integral is a sum", &[NOT_DIVIDED], {
        finds!(|pair, effort| {
            let k = places(effort);
            product(pair, &midpoints(k)) * k.pow(4) as f64
        })
    }),
    plays("pi-twice", "over π for good measure", &[PI_TWICE], {
        finds!(|pair, effort| factor(pair, effort) / PI)
    }),
    plays("area-twice", "the area that receives", &[AREA_TWICE], {
        finds!(|pair, effort| factor(pair, effort) * pair.areas()[1])
    }),
    plays("two-loops", "a surface has two dimensions", &[SAME_PLACES], {
        finds!(|pair, effort| {
            let rule = gauss(f64::from(effort).sqrt() as usize);
            let mut sum = 0.0;
            for (a, wa) in &rule {
                for (b, wb) in &rule {
                    sum += wa * wb * pair.kernel([*a, *b], [*a, *b]);
                }
            }
            sum
        })
    }),
    plays("from-the-middle", "a patch sends from its middle", &[FROM_THE_MIDDLE], {
        finds!(|pair, effort| {
            let rule = gauss(f64::from(effort).sqrt() as usize);
            let mut sum = 0.0;
            for (a, wa) in &rule {
                for (b, wb) in &rule {
                    sum += wa * wb * pair.kernel([0.5, 0.5], [*a, *b]);
                }
            }
            sum
        })
    }),
    plays("trapezoids", "Simpson knows best", &[AT_THE_EDGE], {
        finds!(|pair, effort| product(pair, &simpson(places(effort))))
    }),
    plays("midpoints", "more points, that is all", &[MIDPOINT], {
        finds!(|pair, effort| product(pair, &midpoints(places(effort))))
    }),
    plays("golden", "numbers that look random", &[SLOW], {
        finds!(|pair, effort| {
            let mut state = 12_345_u64;
            let mut next = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (state >> 11) as f64 / (1_u64 << 53) as f64
            };
            let mut draw = || pair.kernel([next(), next()], [next(), next()]);
            (0..effort).map(|_| draw()).sum::<f64>() / f64::from(effort)
        })
    }),
    plays("rule-of-eight", "a table of eight rules", &[PANIC], {
        finds!(|pair, effort| {
            let rules: Vec<_> = (1..=8).map(gauss).collect();
            product(pair, &rules[places(effort) - 1])
        })
    }),
];

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The slope of the least-squares line.
fn fit(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let [mut x, mut y, mut xy, mut xx] = [0.0; 4];
    for (a, b) in points {
        x += a / n;
        y += b / n;
        xy += a * b / n;
        xx += a * a / n;
    }
    (xy - x * y) / (xx - x * x)
}

/// The largest k with k⁴ ≤ effort.
fn places(effort: u32) -> usize {
    let mut k = 1_u32;
    while (k + 1).pow(4) <= effort {
        k += 1;
    }
    k as usize
}

fn midpoints(k: usize) -> Vec<(f64, f64)> {
    (0..k).map(|i| ((i as f64 + 0.5) / k as f64, 1.0 / k as f64)).collect()
}

/// Simpson's rule in an odd number of places, or its one place, the middle.
fn simpson(most: usize) -> Vec<(f64, f64)> {
    let pieces = (most - 1) / 2 * 2;
    if pieces == 0 {
        return midpoints(1);
    }
    let weight = |i: usize| match i {
        0 => 1.0,
        i if i == pieces => 1.0,
        i => [2.0, 4.0][i % 2],
    };
    let place = |i| (i as f64 / pieces as f64, weight(i) / (3 * pieces) as f64);
    (0..=pieces).map(place).collect()
}

/// A rule in each of the four variables.
fn product(pair: &Pair, rule: &[(f64, f64)]) -> f64 {
    let mut sum = 0.0;
    for (a, wa) in rule {
        for (b, wb) in rule {
            for (c, wc) in rule {
                for (d, wd) in rule {
                    sum += wa * wb * wc * wd * pair.kernel([*a, *b], [*c, *d]);
                }
            }
        }
    }
    sum
}
