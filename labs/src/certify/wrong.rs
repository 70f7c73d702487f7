//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, propagated, relative, residual, squared, worst_case};
use super::bugs::*;
use super::given::{Point, Room};
use crate::lab::{Wrong, plays};

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("too-much-light", "stored less wanted", &[SIGN], {
        Work { residual: |p, g| 0.0 - residual(p, g), ..WORK }
    }),
    plays("lamps-are-off", "ρH is what leaves", &[NO_EMISSION], {
        Work { residual: |p, g| residual(&Point { emission: 0.0, ..*p }, g), ..WORK }
    }),
    plays("white-paint", "what arrives leaves", &[NO_PAINT], {
        Work { residual: |p, g| residual(&Point { reflectance: 1.0, ..*p }, g), ..WORK }
    }),
    plays("the-first-gather", "one gather is enough", &[ONE_GATHER], {
        Work { residual: |p, _| residual(p, 0), ..WORK }
    }),
    plays("the-mean-of-both", "two are better than one", &[BOTH_GATHERS], {
        Work { residual: |p, _| (residual(p, 0) + residual(p, 1)) / 2.0, ..WORK }
    }),
    plays("a-square-is-a-square", "r² is r times r", &[SQUARE], {
        Work { squared: |points| squared(&twice_the_same(points)), ..WORK }
    }),
    plays("average-then-square", "less noise first", &[SQUARE_OF_MEAN], {
        Work {
            squared: |points| {
                let mean = |p: &Point| {
                    let h = (p.gathered[0] + p.gathered[1]) / 2.0;
                    Point { gathered: [h; 2], ..*p }
                };
                squared(&points.iter().map(mean).collect::<Vec<_>>())
            },
            ..WORK
        }
    }),
    plays("never-negative", "a square is positive", &[ABSOLUTE], {
        Work {
            squared: |points| points.iter().map(|p| squared(&[*p]).abs()).sum(),
            ..WORK
        }
    }),
    plays("all-points-alike", "a mean over points", &[NO_AREAS], {
        Work {
            squared: |points| {
                let alike = |p: &Point| Point { area: 1.0 / points.len() as f64, ..*p };
                squared(&points.iter().map(alike).collect::<Vec<_>>())
            },
            ..WORK
        }
    }),
    plays("upside-down", "1 + ρ is the larger one", &[SWAPPED], {
        Work {
            worst_case: |norm, rho| {
                let [least, largest] = worst_case(norm, rho);
                [largest, least]
            },
            ..WORK
        }
    }),
    plays("solver-says-so", "the residual is the error", &[NOT_PROPAGATED], {
        Work { worst_case: |norm, _| [norm; 2], ..WORK }
    }),
    plays("of-all-light", "a share of B", &[LAMP_HIDES], {
        Work {
            relative: |norm, points| {
                let dark = |p: &Point| Point { emission: 0.0, ..*p };
                relative(norm, &points.iter().map(dark).collect::<Vec<_>>())
            },
            ..WORK
        }
    }),
    plays("norm-without-areas", "points are points", &[NO_AREAS], {
        Work {
            relative: |norm, points| {
                let alike = |p: &Point| Point { area: 1.0, ..*p };
                relative(norm, &points.iter().map(alike).collect::<Vec<_>>())
            },
            ..WORK
        }
    }),
    plays("over-the-square", "‖B − E‖² is in the formula", &[NOT_A_NORM], {
        Work {
            relative: |norm, points| {
                let one = relative(1.0, points);
                norm * one * one
            },
            ..WORK
        }
    }),
    plays("one-bounce", "r + K r", &[ONE_BOUNCE], {
        Work { propagated: |room, r| bounced(room, r, r), ..WORK }
    }),
    plays("others-only", "the error is what others do", &[NO_RESIDUAL], {
        Work {
            propagated: |room, r| {
                let all = propagated(room, r);
                all.iter().zip(r).map(|(e, r)| e - r).collect()
            },
            ..WORK
        }
    }),
    plays("senders-paint", "their error, their paint", &[SENDERS_PAINT], {
        Work {
            propagated: |room, r| {
                // ρ moves from outside of the sum to inside: solve for ρ e.
                let n = r.len();
                let rho = &room.reflectance;
                let painted: Vec<f64> = (0..n).map(|i| rho[i] * r[i]).collect();
                let all = propagated(room, &painted);
                (0..n).map(|i| all[i] / rho[i]).collect()
            },
            ..WORK
        }
    }),
    plays("columns", "light goes from j to i", &[TRANSPOSED], {
        Work {
            propagated: |room, r| {
                let n = r.len();
                let column = |i: usize| room.factors.iter().map(|row| row[i]).collect();
                let factors = (0..n).map(column).collect();
                let mut error = r.to_vec();
                let turned = Room { factors, ..room.clone() };
                for _ in 0..600 {
                    error = bounced(&turned, r, &error);
                }
                error
            },
            ..WORK
        }
    }),
    plays("lamps-err-too", "the equation has an E", &[LAMP_AGAIN], {
        Work {
            propagated: |room, r| {
                let lit = r.iter().zip(&room.emission).map(|(r, e)| r + e);
                propagated(room, &lit.collect::<Vec<_>>())
            },
            ..WORK
        }
    }),
    plays("worst-everywhere", "1/(1 − ρ) for each", &[WORST_EVERYWHERE], {
        Work {
            propagated: |room, r| {
                let largest = |(r, rho): (&f64, &f64)| {
                    let sign = if *r < 0.0 { -1.0 } else { 1.0 };
                    sign * worst_case(r.abs(), *rho)[1]
                };
                r.iter().zip(&room.reflectance).map(largest).collect()
            },
            ..WORK
        }
    }),
];

/// The points with their first gather in both places.
fn twice_the_same(points: &[Point]) -> Vec<Point> {
    points.iter().map(|p| Point { gathered: [p.gathered[0]; 2], ..*p }).collect()
}

/// `r + K x`.
fn bounced(room: &Room, r: &[f64], x: &[f64]) -> Vec<f64> {
    let arriving =
        |i: usize| -> f64 { room.factors[i].iter().zip(x).map(|(f, x)| f * x).sum() };
    (0..r.len()).map(|i| r[i] + room.reflectance[i] * arriving(i)).collect()
}
