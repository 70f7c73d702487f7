//! Played students of tasks 4 and 5.

use crate::hemicube::Work;
use crate::hemicube::answer::WORK;
use crate::hemicube::bugs::*;
use crate::hemicube::given::{FACES, Item, Weights};
use crate::lab::{Wrong, plays};
use crate::run::{CRASH, ENDLESS, FLOOD};
use radiosity::form_factor::Lost;

/// They sum wrongly, or never come to an end.
pub const ALL: &[Wrong<Work>] = &[
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
                let Lost { escaped, absorbed, .. } =
                    (WORK.factor_row)(items, weights, row);
                Lost { escaped: absorbed, absorbed: escaped, cut: 0.0 }
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
        "flood",
        "a loop that prints and never ends",
        &[FLOOD],
        Work {
            shooting_factors: |row, areas, from| {
                while std::hint::black_box(from) < row.len() {
                    print!("{areas:?}");
                }
                (WORK.shooting_factors)(row, areas, from)
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
