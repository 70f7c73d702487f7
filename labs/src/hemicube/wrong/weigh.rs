//! Played students of tasks 1 and 2.

use crate::hemicube::Work;
use crate::hemicube::answer::{WORK, side_factor, top_factor};
use crate::hemicube::bugs::*;
use crate::hemicube::given::{Weights, table};
use crate::lab::{Wrong, plays};
use std::f64::consts::PI;

/// The answer, but with cells weighed in another way.
macro_rules! weighs {
    ($top:expr, $side:expr) => {
        Work {
            top_factor: $top,
            side_factor: $side,
            weights: |n| table(n, $top, $side),
            ..WORK
        }
    };
}

/// The same, with the tables divided by their sum.
macro_rules! normalises {
    ($top:expr, $side:expr) => {
        Work {
            top_factor: $top,
            side_factor: $side,
            weights: |n| normalised(table(n, $top, $side)),
            ..WORK
        }
    };
}

/// They weigh cells wrongly.
pub const ALL: &[Wrong<Work>] = &[
    plays("no-cosines", "light falls off as 1/r²", &[NO_COSINES], weighs!(bare, bare)),
    plays(
        "no-distance",
        "two cosines, as in the multiplier maps of old tutorials; no 1/r²",
        &[NO_COSINES],
        weighs!(bare, |y, z, e| z * bare(y, z, e)),
    ),
    plays("solid-angle", "a weight is a solid angle over π", &[ONE_COSINE], {
        weighs!(solid_angle, solid_angle)
    }),
    plays("elements-cosine-only", "the cell's tilt is forgotten", &[ONE_COSINE], {
        weighs!(solid_angle, |y, z, e| z * solid_angle(y, z, e))
    }),
    plays(
        "cosines-squared",
        "cosines go into the area, and into the formula again",
        &[COSINES_SQUARED],
        weighs!(|x, y, e| top_factor(x, y, e) / (x * x + y * y + 1.0), |y, z, e| {
            side_factor(y, z, e) * z / (y * y + z * z + 1.0)
        }),
    ),
    plays("no-area", "ΔF is the formula without ΔA", &[NO_AREA], {
        weighs!(|x, y, _| top_factor(x, y, 1.0), |y, z, _| side_factor(y, z, 1.0))
    }),
    plays("edge-for-area", "ΔA is the edge of the cell", &[EDGE_FOR_AREA], {
        weighs!(|x, y, e| top_factor(x, y, e.sqrt()), |y, z, e| {
            side_factor(y, z, e.sqrt())
        })
    }),
    plays("no-pi", "π is a constant, and cancels", &[NO_PI], {
        weighs!(|x, y, e| e * e / (x * x + y * y + 1.0).powi(2), |y, z, e| {
            z * e * e / (y * y + z * z + 1.0).powi(2)
        })
    }),
    plays("side-as-top", "all faces are alike", &[SIDE_AS_TOP], {
        weighs!(top_factor, top_factor)
    }),
    plays("side-turned", "the arguments of the side exchanged", &[SIDE_TURNED], {
        weighs!(top_factor, |y, z, e| side_factor(z, y.abs(), e))
    }),
    plays(
        "normalised-solid-angle",
        "the sum is 2, so divide by it (finds 0.128)",
        &[ONE_COSINE, NORMALISED_AWAY],
        normalises!(solid_angle, solid_angle),
    ),
    plays(
        "normalised-bare",
        "the sum is 2.44, so divide by it (finds 0.113)",
        &[NO_COSINES, NORMALISED_AWAY],
        normalises!(bare, bare),
    ),
    plays(
        "quarter-area",
        "n cells make an edge of 1/n",
        &[QUARTER_AREA],
        Work {
            weights: |n| {
                table(
                    n,
                    |x, y, e| top_factor(x, y, e / 2.0),
                    |y, z, e| side_factor(y, z, e / 2.0),
                )
            },
            ..WORK
        },
    ),
    plays(
        "cell-corners",
        "cell k lies at k times the edge",
        &[CELL_CORNERS],
        Work {
            weights: |n| {
                table(
                    n,
                    |x, y, e| top_factor(x - e / 2.0, y - e / 2.0, e),
                    |y, z, e| side_factor(y - e / 2.0, z - e / 2.0, e),
                )
            },
            ..WORK
        },
    ),
    plays(
        "side-from-above",
        "rows of a side go down",
        &[SIDE_ORDER],
        Work {
            weights: |n| table(n, top_factor, |y, z, e| side_factor(y, 1.0 - z, e)),
            ..WORK
        },
    ),
    plays(
        "full-sides",
        "a hemicube has five equal faces",
        &[FULL_SIDES],
        Work {
            weights: |n| {
                let below = |y: f64, z: f64, e| side_factor(y, z.abs(), e);
                let whole = table(n, top_factor, top_factor);
                let e = 2.0 / n as f64;
                let middle = |k: usize| (k as f64 + 0.5) * e - 1.0;
                let side = (0..n * n).map(|k| below(middle(k % n), middle(k / n), e));
                Weights { side: side.collect(), ..whole }
            },
            ..WORK
        },
    ),
];

fn bare(u: f64, v: f64, edge: f64) -> f64 {
    edge.powi(2) / (PI * (u.powi(2) + v.powi(2) + 1.0))
}

fn solid_angle(u: f64, v: f64, edge: f64) -> f64 {
    let r = (u.powi(2) + v.powi(2) + 1.0).sqrt();
    edge.powi(2) / r.powi(2) / r / PI
}

fn normalised(weights: Weights) -> Weights {
    let sum = weights.top.iter().sum::<f64>() + 4.0 * weights.side.iter().sum::<f64>();
    let over = |list: Vec<f64>| list.into_iter().map(|w| w / sum).collect();
    Weights { top: over(weights.top), side: over(weights.side) }
}
