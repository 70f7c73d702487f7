//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, hidden, lawful, near, runaway, slow};
use super::bugs::*;
use super::given::{Hidden, Near, Room, Slow};
use crate::lab::{Wrong, plays};

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays("five-times", "far away is safe", &[TOO_MILD], {
        Work { near: |_| Near { distance: 5.0, error: 0.026 }, ..WORK }
    }),
    plays("touching", "the nearer the worse", &[TOO_NEAR], {
        // The factor is 1 there, to 2 %.
        Work { near: |_| Near { distance: 0.02, error: 795.0 }, ..WORK }
    }),
    plays("in-per-cent", "30 %", &[PER_CENT], {
        Work {
            near: |wanted| Near { error: 100.0 * near(wanted).error, ..near(wanted) },
            ..WORK
        }
    }),
    plays("one-moment", "the spread of one square", &[ONE_OF_TWO], {
        // E(x² + y²) of a unit square about its middle is 1/6; twice that, over d².
        Work {
            near: |wanted| {
                let Near { distance, .. } = near(wanted);
                Near { distance, error: 2.0 * (1.0 / 6.0) / distance.powi(2) }
            },
            ..WORK
        }
    }),
    plays("points-see-less", "a point is small", &[SIGN], {
        Work {
            near: |wanted| Near { error: -near(wanted).error, ..near(wanted) },
            ..WORK
        }
    }),
    plays("over-the-right-one", "wrong over right", &[RATIO], {
        Work {
            near: |wanted| Near { error: near(wanted).error + 1.0, ..near(wanted) },
            ..WORK
        }
    }),
    plays("a-metre-wide", "n cells to the metre", &[HALF_A_CELL], {
        Work {
            hidden: |n, m| Hidden { side: hidden(2 * n, m).side, ..hidden(n, m) },
            ..WORK
        }
    }),
    plays("side-by-side", "a share of a side", &[A_LINE], {
        Work {
            hidden: |n, m| Hidden {
                side: 2.0 / f64::from(n) * (1.0 - m),
                ..hidden(n, m)
            },
            ..WORK
        }
    }),
    plays("as-often-seen", "missed is what fits in", &[SEEN_FOR_MISSED], {
        Work {
            hidden: |n, m| Hidden { side: hidden(n, 1.0 - m).side, ..hidden(n, m) },
            ..WORK
        }
    }),
    plays("seen-is-right", "there it is", &[RIGHT_WHERE_SEEN], {
        Work { hidden: |n, m| Hidden { brightness: 1.0, ..hidden(n, m) }, ..WORK }
    }),
    plays("part-of-a-cell", "it fills a part", &[TOO_DARK], {
        Work {
            hidden: |n, m| {
                let lamp = hidden(n, m);
                Hidden { brightness: (lamp.side * f64::from(n) / 2.0).powi(2), ..lamp }
            },
            ..WORK
        }
    }),
    plays("lost-light-returns", "over what is missed", &[OVER_MISSED], {
        Work {
            hidden: |n, m| Hidden {
                brightness: hidden(n, 1.0 - m).brightness,
                ..hidden(n, m)
            },
            ..WORK
        }
    }),
    plays("below-one-is-safe", "ρ < 1 is enough", &[WHITE], {
        Work { runaway: |_| 1.0, ..WORK }
    }),
    plays("the-worst-row", "the largest row decides", &[LARGEST_ROW], {
        Work {
            runaway: |f| {
                let sum = |row: &Vec<f64>| row.iter().sum::<f64>();
                let mut sums: Vec<f64> = f.iter().map(sum).collect();
                sums.sort_by(f64::total_cmp);
                1.0 / sums[sums.len() - 1]
            },
            ..WORK
        }
    }),
    plays("one-bounce", "how much a bounce adds to 1", &[MEAN_ROW], {
        Work { runaway: |f| f.len() as f64 / f.iter().flatten().sum::<f64>(), ..WORK }
    }),
    plays("all-must-gain", "when all of them grow", &[SMALLEST_ROW], {
        Work {
            runaway: |f| {
                let limits = f.iter().map(|row| 1.0 / row.iter().sum::<f64>());
                limits.fold(0.0, f64::max)
            },
            ..WORK
        }
    }),
    plays("the-radius-itself", "λ is the answer", &[UPSIDE_DOWN], {
        Work { runaway: |f| 1.0 / runaway(f), ..WORK }
    }),
    plays("about-one-over", "1/(1 − ρ) sweeps", &[RULE_OF_THUMB], {
        Work { slow: |k, _| white(1.0 - 1.0 / f64::from(k)), ..WORK }
    }),
    plays("decimal", "so many decades", &[COMMON_LOGARITHM], {
        Work { slow: |k, m| white((m.log10() / f64::from(k)).exp()), ..WORK }
    }),
    plays("till-it-stands", "the picture stands still", &[UPDATE_STOPS], {
        Work {
            slow: |k, m| {
                // ρ^k (1 − ρ) = m, by Newton's method for 1 − ρ from above.
                let k = f64::from(k);
                let mut x = 20.0 / k;
                for _ in 0..200 {
                    x = (x.ln() - m.ln()) / k;
                    x = 1.0 - (-x).exp();
                }
                white(1.0 - x)
            },
            ..WORK
        }
    }),
    plays("as-much-again", "the update is the error", &[UPDATE_IS_ERROR], {
        Work { slow: |k, m| Slow { behind: 1.0, ..slow(k, m) }, ..WORK }
    }),
    plays("bounce-over-rest", "the last of what is left", &[TURNED_ROUND], {
        Work {
            slow: |k, m| Slow { behind: 1.0 / slow(k, m).behind, ..slow(k, m) },
            ..WORK
        }
    }),
    plays("one-entry", "one number is wrong", &[ONE_WAY], {
        Work {
            lawful: |room, wanted| {
                let mut f = room.factors.clone();
                f[4][5] *= 1.0 + wanted;
                f
            },
            ..WORK
        }
    }),
    plays("there-and-back", "reciprocal is enough", &[NOT_CLOSED], {
        Work {
            lawful: |room, wanted| {
                let mut f = room.factors.clone();
                f[4][5] *= 1.0 + wanted;
                f[5][4] *= 1.0 + wanted;
                f
            },
            ..WORK
        }
    }),
    plays("itself", "the floor sees less of itself", &[NEGATIVE], {
        Work {
            lawful: |room, wanted| {
                let mut f = room.factors.clone();
                for (i, j) in [(4, 5), (5, 4)] {
                    f[i][i] = -wanted * f[i][j];
                    f[i][j] *= 1.0 + wanted;
                }
                f
            },
            ..WORK
        }
    }),
    plays("nothing-to-break", "the exact ones obey", &[HONEST], {
        Work { lawful: |room: &Room, _| room.factors.clone(), ..WORK }
    }),
    plays("too-small", "wrong is wrong", &[OTHER_SIZE], {
        Work { lawful: |room, wanted| lawful(room, -wanted), ..WORK }
    }),
    plays("both-ways", "once there, once back", &[OTHER_SIZE], {
        Work { lawful: |room, wanted| lawful(room, 2.0 * wanted), ..WORK }
    }),
];

/// The right prediction for a reflectance that may be wrong.
fn white(reflectance: f64) -> Slow {
    Slow { reflectance, behind: reflectance / (1.0 - reflectance) }
}
