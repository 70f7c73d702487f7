//! Tasks 4 and 5: the row of form factors, and the factors that shooting needs.

use crate::check::{Suspect, Verdict, Within, compare};
use crate::draw::{uniform, whole_number};
use crate::hemicube::Work;
use crate::hemicube::bugs::*;
use crate::hemicube::given::{FACES, Item, Weights, cells};
use radiosity::form_factor::Lost;
use radiosity::random::Stream;

/// Which part of what `factor_row` gives is checked.
#[derive(Clone, Copy, PartialEq)]
pub enum Part {
    /// The factors.
    Row,
    /// What escapes, and what backs absorb.
    Lost,
}

/// Checks a row of `ELEMENTS` factors, or what is lost; the row holds `old` before.
pub fn row(work: &Work, stream: &mut Stream, part: Part, old: f64) -> Verdict {
    const ELEMENTS: usize = 7;
    const N: usize = 8;
    let mut draw = |_| match whole_number(stream, 0, ELEMENTS + 3) {
        k if k < ELEMENTS => Item::Front(k),
        k if k == ELEMENTS => Item::Back,
        _ => Item::Nothing,
    };
    let items: [Vec<Item>; FACES] =
        std::array::from_fn(|face| (0..cells(N, face)).map(&mut draw).collect());
    // Weights of no hemicube, which do not sum to 1: whatever they are, they count.
    let mut noise = || uniform(stream, 0.2, 1.0) / (3 * N * N) as f64;
    let mut list = |face| (0..cells(N, face)).map(|_| noise()).collect();
    let weights = Weights { top: list(0), side: list(1) };

    let sums = |weights: &Weights, faces: usize, add: fn(f64, f64) -> f64| {
        let mut sums = vec![0.0; ELEMENTS + 2];
        for (face, items) in items.iter().enumerate().take(faces) {
            let weights = if face == 0 { &weights.top } else { &weights.side };
            for (item, &weight) in items.iter().zip(weights) {
                let sum = match *item {
                    Item::Front(element) => &mut sums[element],
                    Item::Nothing => &mut sums[ELEMENTS],
                    Item::Back => &mut sums[ELEMENTS + 1],
                };
                *sum = add(*sum, weight);
            }
        }
        sums
    };
    let plus = |a: f64, b: f64| a + b;
    let expected = sums(&weights, FACES, plus);
    let even = |each: f64| {
        let (top, side) = (vec![each; cells(N, 0)], vec![each; cells(N, 1)]);
        sums(&Weights { top, side }, FACES, plus)
    };
    let (seen, lost) = expected.split_at(ELEMENTS);
    let in_all: f64 = seen.iter().sum();
    let share: Vec<f64> = seen.iter().map(|f| f / in_all).collect();
    let added: Vec<f64> = seen.iter().map(|f| f + old).collect();
    let wrong = [
        (COUNTED, even(1.0)),
        (COUNTED, even(1.0 / (3 * N * N) as f64)),
        (ONE_SIDE, sums(&weights, 2, plus)),
        (TOP_ONLY, sums(&weights, 1, plus)),
        (OVERWRITTEN, sums(&weights, FACES, |_, new| new)),
        (ROW_NORMALISED, [&share, lost].concat()),
        (NOT_CLEARED, [&added, lost].concat()),
        (ONE_MINUS, [seen, &[1.0 - in_all - lost[1], lost[1]]].concat()),
        (ONE_MINUS, [seen, &[1.0 - in_all, lost[1]]].concat()),
        (LOST_EXCHANGED, [seen, &[lost[1], lost[0]]].concat()),
    ];

    let mut got = vec![old; ELEMENTS];
    let Lost { escaped, absorbed, .. } = (work.factor_row)(&items, &weights, &mut got);
    got.extend([escaped, absorbed]);
    let range = if part == Part::Row { 0..ELEMENTS } else { ELEMENTS..ELEMENTS + 2 };
    let suspects: Vec<Suspect> = wrong
        .into_iter()
        .map(|(bug, all)| (bug, all[range.clone()].to_vec()))
        .collect();
    let place = |k: usize| match part {
        Part::Row => format!("row[{k}]"),
        Part::Lost => ["escaped", "absorbed"][k].to_string(),
    };
    let within = Within::Absolute(1e-12); // the rounding of a sum in another order
    compare(&got[range.clone()], &expected[range], within, &suspects, place)
}

/// F_ji from F_ij and the areas.
pub fn shooting(work: &Work, stream: &mut Stream) -> Verdict {
    const ELEMENTS: usize = 9;
    let from = whole_number(stream, 0, ELEMENTS);
    let areas: Vec<f64> = (0..ELEMENTS).map(|_| uniform(stream, 0.2, 5.0)).collect();
    let mut row: Vec<f64> = (0..ELEMENTS).map(|_| uniform(stream, 0.01, 0.1)).collect();
    row[from] = 0.0;
    let all = |f: &dyn Fn(f64, f64) -> f64| {
        row.iter().zip(&areas).map(|(&f_ij, &a_j)| f(f_ij, a_j)).collect::<Vec<_>>()
    };
    let a_i = areas[from];
    let suspects = [
        (TRANSPOSED, row.clone()),
        (RATIO_INVERTED, all(&|f, a_j| f * a_j / a_i)),
        (ONE_AREA, all(&|f, _| f * a_i)),
        (ONE_AREA, all(&|f, a_j| f / a_j)),
    ];
    let expected = all(&|f, a_j| f * a_i / a_j);
    let got = (work.shooting_factors)(&row, &areas, from);
    let place = |j: usize| {
        let (f, a) = (row[j], areas[j]);
        format!("F_ij = {f:.4}, A_i = {a_i:.3}, A_j = {a:.3}: F_ji")
    };
    compare(&got, &expected, Within::Absolute(1e-12), &suspects, place)
}
