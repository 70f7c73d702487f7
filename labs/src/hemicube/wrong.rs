//! Played students of lab 1: the answer with one mistake each. `cargo lab ci` proves that
//! every one is caught and named; `cargo lab run hemicube --wrong NAME` shows what the
//! student would read.

use super::Work;
use super::answer::{WORK, side_factor, top_factor};
use super::bugs::*;
use super::given::{FACES, Fragment, Item, Weights, table};
use crate::check::Bug;
use crate::lab::Wrong;
use crate::run::{CRASH, ENDLESS, PANIC};
use radiosity::form_factor::Lost;
use std::f64::consts::PI;

const fn plays(
    name: &'static str,
    thought: &'static str,
    named: &'static [Bug],
    work: Work,
) -> Wrong<Work> {
    Wrong { name, thought, named, work }
}

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

/// All played students.
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
    plays(
        "farthest",
        "depth is compared the wrong way round",
        &[FARTHEST],
        Work {
            item_buffer: |cells, own, fragments| {
                painted(cells, own, fragments, |f| -f.depth, item)
            },
            ..WORK
        },
    ),
    plays(
        "last-wins",
        "a later fragment covers an earlier one",
        &[LAST_WINS],
        Work {
            item_buffer: |cells, own, fragments| {
                let mut items = vec![Item::Nothing; cells];
                for f in fragments.iter().filter(|f| f.element != own) {
                    items[f.cell] = item(f);
                }
                items
            },
            ..WORK
        },
    ),
    plays(
        "first-wins",
        "a full cell is full",
        &[FIRST_WINS],
        Work {
            item_buffer: |cells, own, fragments| {
                let mut items = vec![Item::Nothing; cells];
                for f in fragments.iter().filter(|f| f.element != own).rev() {
                    items[f.cell] = item(f);
                }
                items
            },
            ..WORK
        },
    ),
    plays(
        "far-plane",
        "the depth buffer is cleared to 1, as in OpenGL",
        &[FAR_PLANE],
        Work {
            item_buffer: |cells, own, fragments| {
                let near: Vec<Fragment> =
                    fragments.iter().copied().filter(|f| f.depth < 1.0).collect();
                painted(cells, own, &near, |f| f.depth, item)
            },
            ..WORK
        },
    ),
    plays(
        "backs-culled",
        "backs are culled, as in OpenGL",
        &[BACKS_IGNORED],
        Work {
            item_buffer: |cells, own, fragments| {
                let fronts: Vec<Fragment> =
                    fragments.iter().copied().filter(|f| f.front).collect();
                painted(cells, own, &fronts, |f| f.depth, item)
            },
            ..WORK
        },
    ),
    plays(
        "backs-as-fronts",
        "a surface is a surface",
        &[BACKS_AS_FRONTS],
        Work {
            item_buffer: |cells, own, fragments| {
                painted(cells, own, fragments, |f| f.depth, |f| Item::Front(f.element))
            },
            ..WORK
        },
    ),
    plays(
        "backs-as-nothing",
        "a black back is as good as nothing",
        &[BACKS_AS_NOTHING],
        {
            Work {
                item_buffer: |cells, own, fragments| {
                    painted(
                        cells,
                        own,
                        fragments,
                        |f| f.depth,
                        |f| match f.front {
                            true => Item::Front(f.element),
                            false => Item::Nothing,
                        },
                    )
                },
                ..WORK
            }
        },
    ),
    plays(
        "self-seen",
        "`own` is not needed",
        &[SELF_SEEN],
        Work {
            item_buffer: |cells, _, fragments| {
                painted(cells, usize::MAX, fragments, |f| f.depth, item)
            },
            ..WORK
        },
    ),
    plays(
        "counted",
        "a factor is a share of the cells",
        &[COUNTED],
        Work {
            factor_row: |items, weights, row| {
                let all: usize = items.iter().map(Vec::len).sum();
                let even = |list: &[f64]| vec![1.0 / all as f64; list.len()];
                let weights =
                    Weights { top: even(&weights.top), side: even(&weights.side) };
                (WORK.factor_row)(items, &weights, row)
            },
            ..WORK
        },
    ),
    plays(
        "one-side",
        "a top and a side",
        &[ONE_SIDE],
        Work {
            factor_row: |items, weights, row| {
                let two =
                    std::array::from_fn(
                        |k| if k < 2 { items[k].clone() } else { vec![] },
                    );
                (WORK.factor_row)(&two, weights, row)
            },
            ..WORK
        },
    ),
    plays(
        "top-only",
        "the hemicube is what is above",
        &[TOP_ONLY],
        Work {
            factor_row: |items, weights, row| {
                let top =
                    std::array::from_fn(
                        |k| if k < 1 { items[k].clone() } else { vec![] },
                    );
                (WORK.factor_row)(&top, weights, row)
            },
            ..WORK
        },
    ),
    plays(
        "overwritten",
        "`=` for `+=`",
        &[OVERWRITTEN],
        Work { factor_row: overwritten, ..WORK },
    ),
    plays(
        "not-cleared",
        "the row comes empty",
        &[NOT_CLEARED],
        Work {
            factor_row: |items, weights, row| {
                let old = row.to_vec();
                let lost = (WORK.factor_row)(items, weights, row);
                row.iter_mut().zip(old).for_each(|(f, old)| *f += old);
                lost
            },
            ..WORK
        },
    ),
    plays(
        "one-minus",
        "what is not seen has escaped",
        &[ONE_MINUS],
        Work {
            factor_row: |items, weights, row| {
                let lost = (WORK.factor_row)(items, weights, row);
                let seen: f64 = row.iter().sum();
                Lost { escaped: 1.0 - seen - lost.absorbed, ..lost }
            },
            ..WORK
        },
    ),
    plays(
        "row-normalised",
        "rows of F sum to 1",
        &[ROW_NORMALISED],
        Work {
            factor_row: |items, weights, row| {
                let lost = (WORK.factor_row)(items, weights, row);
                let seen: f64 = row.iter().sum();
                row.iter_mut().for_each(|f| *f /= seen);
                lost
            },
            ..WORK
        },
    ),
    plays(
        "lost-exchanged",
        "escaped for absorbed",
        &[LOST_EXCHANGED],
        Work {
            factor_row: |items, weights, row| {
                let Lost { escaped, absorbed } = (WORK.factor_row)(items, weights, row);
                Lost { escaped: absorbed, absorbed: escaped }
            },
            ..WORK
        },
    ),
    plays(
        "transposed",
        "F_ij is F_ji",
        &[TRANSPOSED],
        Work { shooting_factors: |row, _, _| row.to_vec(), ..WORK },
    ),
    plays(
        "ratio-inverted",
        "i for j",
        &[RATIO_INVERTED],
        Work {
            shooting_factors: |row, areas, from| {
                row.iter().zip(areas).map(|(f, a)| f * a / areas[from]).collect()
            },
            ..WORK
        },
    ),
    plays(
        "one-area",
        "divide by the receiver's area",
        &[ONE_AREA],
        Work {
            shooting_factors: |row, areas, _| {
                row.iter().zip(areas).map(|(f, a)| f / a).collect()
            },
            ..WORK
        },
    ),
    plays(
        "panics",
        "a buffer too short",
        &[PANIC],
        Work {
            item_buffer: |cells, own, fragments| {
                (WORK.item_buffer)(cells / 2, own, fragments)
            },
            ..WORK
        },
    ),
    plays(
        "endless",
        "a loop that never ends",
        &[ENDLESS],
        Work {
            shooting_factors: |row, areas, from| {
                while std::hint::black_box(from) < row.len() {
                    std::hint::spin_loop();
                }
                (WORK.shooting_factors)(row, areas, from)
            },
            ..WORK
        },
    ),
    plays(
        "bottomless",
        "a recursion that never ends",
        &[CRASH],
        Work { shooting_factors: |row, areas, _| bottomless(row, areas, 0), ..WORK },
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

fn item(fragment: &Fragment) -> Item {
    if fragment.front { Item::Front(fragment.element) } else { Item::Back }
}

/// Sorts by `key`, and paints from the largest to the smallest.
fn painted(
    cells: usize,
    own: usize,
    fragments: &[Fragment],
    key: fn(&Fragment) -> f64,
    store: fn(&Fragment) -> Item,
) -> Vec<Item> {
    let mut sorted: Vec<&Fragment> =
        fragments.iter().filter(|f| f.element != own).collect();
    sorted.sort_by(|a, b| key(b).total_cmp(&key(a)));
    let mut items = vec![Item::Nothing; cells];
    sorted.into_iter().for_each(|f| items[f.cell] = store(f));
    items
}

fn overwritten(items: &[Vec<Item>; FACES], weights: &Weights, row: &mut [f64]) -> Lost {
    let mut lost = Lost::default();
    row.fill(0.0);
    for (item, &weight) in items[0].iter().zip(&weights.top) {
        *slot(item, row, &mut lost) = weight;
    }
    for (item, &weight) in
        items[1..].iter().flat_map(|side| side.iter().zip(&weights.side))
    {
        *slot(item, row, &mut lost) = weight;
    }
    lost
}

fn slot<'a>(item: &Item, row: &'a mut [f64], lost: &'a mut Lost) -> &'a mut f64 {
    match *item {
        Item::Front(element) => &mut row[element],
        Item::Nothing => &mut lost.escaped,
        Item::Back => &mut lost.absorbed,
    }
}

fn bottomless(row: &[f64], areas: &[f64], depth: usize) -> Vec<f64> {
    if std::hint::black_box(depth) == usize::MAX {
        return row.iter().zip(areas).map(|(f, a)| f / a).collect();
    }
    let mut deeper = bottomless(row, areas, depth + 1);
    deeper.reverse();
    deeper
}
