//! Played students of this lab: the answer with one mistake each. They are written on
//! their own: not by the formulas by which the checks suspect a mistake.

use super::Work;
use super::answer::{WORK, arriving, residual, sweep};
use super::bugs::*;
use super::given::{Balance, Room, Solved};
use crate::lab::{Wrong, plays};

/// A value at an element.
type At = fn(&Room, &[f64], usize) -> f64;

/// The answer, but with another right-hand side of the equation.
macro_rules! asks {
    ($asked:expr) => {
        Work {
            bounce: |room, b| bounce_by(room, b, $asked),
            sweep: |room, b| sweep_by(room, b, $asked),
            residual: |room, b| residual_by(room, b, $asked),
            balance: |room, b| Balance {
                unshot: power(room, &residual_by(room, b, $asked)),
                ..(WORK.balance)(room, b)
            },
            solve: |room, accuracy| solve_by(room, accuracy, $asked),
            ..WORK
        }
    };
}

/// The answer, but with light that arrives in another way.
macro_rules! gathers {
    ($arriving:expr) => {
        Work {
            arriving: $arriving,
            balance: |room, b| {
                let at: At = $arriving;
                let kept: Vec<f64> = (0..b.len())
                    .map(|i| (1.0 - room.reflectance[i]) * at(room, b, i))
                    .collect();
                let balance = asks!(|room, b, i| {
                    let at: At = $arriving;
                    room.emission[i] + room.reflectance[i] * at(room, b, i)
                });
                Balance { absorbed: power(room, &kept), ..(balance.balance)(room, b) }
            },
            ..asks!(|room, b, i| {
                let at: At = $arriving;
                room.emission[i] + room.reflectance[i] * at(room, b, i)
            })
        }
    };
}

/// All played students, task by task.
pub const ALL: &[Wrong<Work>] = &[
    plays(
        "transposed",
        "light goes from j to i, so F_ji",
        &[TRANSPOSED],
        gathers!(|room, b, i| {
            let column = room.factors.iter().map(|row| row[i]);
            column.zip(b).map(|(f, b)| f * b).sum()
        }),
    ),
    plays(
        "nobody-sees-himself",
        "the diagonal is zero",
        &[SKIPS_SELF],
        gathers!(|room, b, i| {
            let mut sum = 0.0;
            for (j, b) in b.iter().enumerate() {
                if j != i {
                    sum += room.factors[i][j] * b;
                }
            }
            sum
        }),
    ),
    plays(
        "in-watts",
        "the lecture's sum is what arrives",
        &[IN_WATTS],
        Work { arriving: |room, b, i| room.area[i] * arriving(room, b, i), ..WORK },
    ),
    plays(
        "mixed",
        "large walls send more",
        &[MIXED],
        Work {
            arriving: |room, b, i| {
                let power: Vec<f64> =
                    b.iter().zip(&room.area).map(|(b, a)| b * a).collect();
                arriving(room, &power, i)
            },
            ..WORK
        },
    ),
    plays(
        "paint-in-the-sum",
        "a black wall gets no light",
        &[PAINT_TOO_EARLY],
        Work {
            arriving: |room, b, i| arriving(room, b, i) * room.reflectance[i],
            ..WORK
        },
    ),
    plays(
        "own-light",
        "a lamp is lit by itself",
        &[OWN_LIGHT],
        Work { arriving: |room, b, i| arriving(room, b, i) + room.emission[i], ..WORK },
    ),
    plays(
        "senders-paint",
        "red walls send red light",
        &[SENDERS_PAINT],
        asks!(|room, b, i| {
            let mut new = room.emission[i];
            for (j, b) in b.iter().enumerate() {
                new += room.reflectance[j] * room.factors[i][j] * b;
            }
            new
        }),
    ),
    plays(
        "emission-twice",
        "what is emitted is added to what was there",
        &[EMISSION_TWICE],
        asks!(|room, b, i| {
            2.0 * room.emission[i] + room.reflectance[i] * arriving(room, b, i)
        }),
    ),
    plays(
        "emission-arrives",
        "all light at i is E and what comes; the paint reflects it",
        &[OWN_LIGHT],
        asks!(|room, b, i| {
            let all = room.emission[i] + arriving(room, b, i);
            room.emission[i] + room.reflectance[i] * all
        }),
    ),
    plays(
        "adds-up",
        "each bounce adds light",
        &[ADDS_UP],
        Work {
            bounce: |room, b| {
                let more = |i| room.reflectance[i] * arriving(room, b, i);
                (0..b.len()).map(|i| b[i] + more(i)).collect()
            },
            ..WORK
        },
    ),
    plays(
        "no-emission",
        "E is only there at the start",
        &[NO_EMISSION],
        asks!(|room, b, i| room.reflectance[i] * arriving(room, b, i)),
    ),
    plays(
        "paints-lamps",
        "paint takes its share of all light",
        &[PAINTS_LAMPS],
        asks!(|room, b, i| {
            room.reflectance[i] * (room.emission[i] + arriving(room, b, i))
        }),
    ),
    plays(
        "one-list",
        "a list is updated as one goes",
        &[IN_PLACE],
        Work {
            bounce: |room, b| {
                let mut b = b.to_vec();
                sweep(room, &mut b);
                b
            },
            ..WORK
        },
    ),
    plays(
        "two-lists",
        "first all new values, then copy",
        &[OLD_VALUES],
        Work { sweep: |room, b| b.copy_from_slice(&(WORK.bounce)(room, b)), ..WORK },
    ),
    plays(
        "backwards",
        "the order does not matter",
        &[BACKWARDS],
        Work {
            sweep: |room, b| {
                for i in (0..b.len()).rev() {
                    b[i] =
                        room.emission[i] + room.reflectance[i] * arriving(room, b, i);
                }
            },
            ..WORK
        },
    ),
    plays(
        "other-sign",
        "the residual is what is too much",
        &[SIGN],
        Work {
            residual: |room, b| residual(room, b).into_iter().map(|r| -r).collect(),
            balance: |room, b| {
                let balance = (WORK.balance)(room, b);
                Balance { unshot: -balance.unshot, ..balance }
            },
            ..WORK
        },
    ),
    plays(
        "no-areas",
        "light is light",
        &[NO_AREAS],
        Work {
            balance: |room, b| {
                let even = Room { area: vec![1.0; b.len()], ..room.clone() };
                (WORK.balance)(&even, b)
            },
            ..WORK
        },
    ),
    plays(
        "absorbs-what-it-reflects",
        "ρ is how much a surface takes",
        &[KEEPS_THE_REST],
        Work {
            balance: |room, b| {
                let kept = |i: usize| room.reflectance[i] * arriving(room, b, i);
                let kept: Vec<f64> = (0..b.len()).map(kept).collect();
                Balance { absorbed: power(room, &kept), ..(WORK.balance)(room, b) }
            },
            ..WORK
        },
    ),
    plays(
        "absorbs-what-leaves",
        "Σ A B (1 − ρ), says the book",
        &[OF_WHAT_LEAVES],
        Work {
            balance: |room, b| {
                let kept =
                    b.iter().zip(&room.reflectance).map(|(b, rho)| b * (1.0 - rho));
                let kept: Vec<f64> = kept.collect();
                Balance { absorbed: power(room, &kept), ..(WORK.balance)(room, b) }
            },
            ..WORK
        },
    ),
    plays(
        "stops-by-update",
        "when nothing changes any more it is right",
        &[SMALL_CHANGE],
        Work {
            solve: |room, accuracy| {
                let (mut b, mut sweeps) = (room.emission.clone(), 0);
                loop {
                    let old = b.clone();
                    sweep(room, &mut b);
                    sweeps += 1;
                    let change = b.iter().zip(&old).map(|(new, old)| (new - old).abs());
                    if change.fold(0.0, f64::max) <= accuracy {
                        return Solved { radiosity: b, sweeps };
                    }
                }
            },
            ..WORK
        },
    ),
    plays(
        "stops-by-residual",
        "the residual is the error",
        &[SMALL_CHANGE],
        Work {
            solve: |room, accuracy| {
                let (mut b, mut sweeps) = (room.emission.clone(), 0);
                while residual(room, &b).iter().any(|r| r.abs() > accuracy) {
                    sweep(room, &mut b);
                    sweeps += 1;
                }
                Solved { radiosity: b, sweeps }
            },
            ..WORK
        },
    ),
    plays(
        "four-sweeps",
        "light is gone after some bounces",
        &[TOO_EARLY],
        Work {
            solve: |room, _| {
                let mut radiosity = room.emission.clone();
                (0..4).for_each(|_| sweep(room, &mut radiosity));
                Solved { radiosity, sweeps: 4 }
            },
            ..WORK
        },
    ),
    plays(
        "to-the-last-digit",
        "exact is exact",
        &[TOO_LONG],
        Work { solve: |room, _| (WORK.solve)(room, 1e-12), ..WORK },
    ),
];

fn bounce_by(room: &Room, b: &[f64], asked: At) -> Vec<f64> {
    let mut new = vec![0.0; b.len()];
    for (i, new) in new.iter_mut().enumerate() {
        *new = asked(room, b, i);
    }
    new
}

fn sweep_by(room: &Room, b: &mut [f64], asked: At) {
    for i in 0..b.len() {
        b[i] = asked(room, b, i);
    }
}

fn residual_by(room: &Room, b: &[f64], asked: At) -> Vec<f64> {
    bounce_by(room, b, asked).iter().zip(b).map(|(new, old)| new - old).collect()
}

/// Stops as the answer does; or gives up, for light with a mistake may grow.
fn solve_by(room: &Room, accuracy: f64, asked: At) -> Solved {
    let least =
        room.reflectance.iter().fold(1.0_f64, |least, rho| least.min(1.0 - rho));
    let mut radiosity = room.emission.clone();
    for sweeps in 0..100_000 {
        let rest = residual_by(room, &radiosity, asked);
        if rest.iter().all(|r| r.abs() <= accuracy * least) {
            return Solved { radiosity, sweeps };
        }
        sweep_by(room, &mut radiosity, asked);
    }
    Solved { radiosity, sweeps: 100_000 }
}

fn power(room: &Room, x: &[f64]) -> f64 {
    room.area.iter().zip(x).map(|(area, x)| area * x).sum()
}
