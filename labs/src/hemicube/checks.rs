//! The checks of lab 1: tasks 1 to 5, each against values that do not come from the
//! student's other tasks. Task 6 is in [`super::whole`].
//!
//! ```text
//! |centre rule / exact − 1| ≤ max|∇²g/g| e²/24     g the density of weight, e the edge
//!                           = e²/3 on the top, 2e²/3 on a side, to leading order
//! ```
//! The tolerances are half as large again, so that cells weighed at their centre and
//! cells weighed exactly both pass.

use super::bugs::*;
use super::given::{FACES, Fragment, Item, Weights};
use super::given::{cells, exact_side, exact_top, table, through};
use super::{Work, whole};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::lab::{About, Check};
use radiosity::form_factor::Lost;
use radiosity::random::Stream;
use std::f64::consts::PI;

const fn check(
    task: usize,
    name: &'static str,
    title: &'static str,
    points: u32,
    run: fn(&Work, &mut Stream) -> Verdict,
) -> Check<Work> {
    Check { about: About { task, name, title, points }, run }
}

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "top", "a cell of the top has the right weight", 1, top),
    check(1, "side", "a cell of a side has the right weight", 1, side),
    check(2, "sum", "the weights of the five faces sum to 1", 1, sum),
    check(2, "weights", "each weight is right, in its place", 2, weights),
    check(3, "nearest", "the nearest surface is seen", 1, |w, s| buffer(w, s, NEAR)),
    check(3, "far", "a far surface is seen too", 1, |w, s| buffer(w, s, FAR)),
    check(3, "backs", "a back blocks and is black", 1, |w, s| buffer(w, s, BACKS)),
    check(3, "own", "the element does not see itself", 1, |w, s| buffer(w, s, OWN)),
    check(4, "row", "each element gets the weights of its cells", 2, |w, s| {
        row(w, s, Part::Row, 0.0)
    }),
    check(4, "lost", "the other weights are lost, and counted", 1, |w, s| {
        row(w, s, Part::Lost, 0.0)
    }),
    check(4, "cleared", "what was in the row before is gone", 1, |w, s| {
        row(w, s, Part::Row, 1.0)
    }),
    check(5, "shooting", "the factors obey reciprocity", 2, shooting),
    check(6, "known", "a unit square 1 above is seen as 0.2395", 2, whole::known),
    check(6, "elsewhere", "a rectangle elsewhere is right", 1, whole::elsewhere),
    check(6, "closed", "a closed room is seen whole", 1, whole::closed),
    check(6, "hidden", "a card hides what is behind it", 2, whole::hidden),
    check(6, "open", "what leaves an open box is counted", 1, whole::open),
];

/// A random number in `[low, high)`.
pub(super) fn uniform(stream: &mut Stream, low: f64, high: f64) -> f64 {
    low + (high - low) * stream.next()
}

/// A random whole number in `low..high`.
pub(super) fn whole_number(stream: &mut Stream, low: usize, high: usize) -> usize {
    uniform(stream, low as f64, high as f64) as usize
}

type Weigh = fn(f64, f64, f64) -> f64;

/// Wrong weights of a cell: on the top from (x, y, edge), on a side from (y, z, edge).
const WRONG_WEIGHTS: &[(Bug, Weigh, Weigh)] = &[
    (NO_COSINES, |x, y, e| e * e / PI / r2(x, y), |y, z, e| e * e / PI / r2(y, z)),
    (NO_COSINES, |x, y, e| e * e / PI / r2(x, y), |y, z, e| z * e * e / PI / r2(y, z)),
    (ONE_COSINE, once, once),
    (ONE_COSINE, once, |y, z, e| z * once(y, z, e)),
    (COSINES_SQUARED, thrice, |y, z, e| z * z * thrice(y, z, e)),
    (NO_AREA, |x, y, _| right(x, y, 1.0), |y, z, _| z * right(y, z, 1.0)),
    (EDGE_FOR_AREA, |x, y, e| right(x, y, e) / e, |y, z, e| z * right(y, z, e) / e),
    (NO_PI, |x, y, e| PI * right(x, y, e), |y, z, e| PI * z * right(y, z, e)),
    (SIDE_AS_TOP, right, right),
    (SIDE_TURNED, right, |y, z, e| y * right(y, z, e)),
    (SIDE_TURNED, right, |y, z, e| y.abs() * right(y, z, e)),
];

fn r2(u: f64, v: f64) -> f64 {
    1.0 + u * u + v * v
}

/// The right weight of a top cell by its centre; times z that of a side cell.
fn right(u: f64, v: f64, edge: f64) -> f64 {
    edge * edge / (PI * r2(u, v).powi(2))
}

fn once(u: f64, v: f64, edge: f64) -> f64 {
    edge * edge / (PI * r2(u, v).powf(1.5))
}

fn thrice(u: f64, v: f64, edge: f64) -> f64 {
    edge * edge / (PI * r2(u, v).powi(3))
}

/// Compares the weights of forty cells of one face.
fn forty(
    drawn: Vec<(f64, f64, f64)>,
    weigh: Weigh,
    exact: Weigh,
    tolerance: f64,
    wrong: impl Fn(&(Bug, Weigh, Weigh)) -> Weigh,
    place: impl Fn(f64, f64, f64) -> String,
) -> Verdict {
    let all = |f: Weigh| drawn.iter().map(|&(u, v, e)| f(u, v, e)).collect::<Vec<_>>();
    let suspects: Vec<Suspect> =
        WRONG_WEIGHTS.iter().map(|entry| (entry.0, all(wrong(entry)))).collect();
    let at = |k: usize| place(drawn[k].0, drawn[k].1, drawn[k].2);
    let within = Within::Relative(tolerance);
    compare(&all(weigh), &all(exact), within, &suspects, at)
}

/// The edge of a cell of a hemicube of 32 to 256 cells.
fn edge(stream: &mut Stream) -> f64 {
    2.0 / whole_number(stream, 32, 257) as f64
}

fn top(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || uniform(stream, -0.95, 0.95);
    let at: Vec<(f64, f64)> = (0..40).map(|_| (draw(), draw())).collect();
    let drawn = at.into_iter().map(|(x, y)| (x, y, edge(stream))).collect();
    let place = |x, y, e| format!("cell about ({x:.3}, {y:.3}, 1) of edge {e:.4}");
    let tolerance = 0.5 * (2.0 / 32.0_f64).powi(2);
    forty(drawn, work.top_factor, exact_top, tolerance, |entry| entry.1, place)
}

fn side(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |low| uniform(stream, low, 0.95);
    let at: Vec<(f64, f64)> = (0..40).map(|_| (draw(-0.95), draw(0.05))).collect();
    let drawn = at.into_iter().map(|(y, z)| (y, z, edge(stream))).collect();
    let place = |y, z, e| format!("cell about (1, {y:.3}, {z:.3}) of edge {e:.4}");
    let tolerance = (2.0 / 32.0_f64).powi(2);
    forty(drawn, work.side_factor, exact_side, tolerance, |entry| entry.2, place)
}

/// The student's tables for some even `n`, one after the other, or what is wrong with
/// their lengths.
fn tables(work: &Work, stream: &mut Stream) -> Result<(usize, Vec<f64>), Verdict> {
    let n = 2 * whole_number(stream, 6, 21);
    let weights = (work.weights)(n);
    whole::sized(&weights, n)?;
    Ok((n, flat(weights)))
}

fn flat(weights: Weights) -> Vec<f64> {
    [weights.top, weights.side].concat()
}

/// Σ over the top and four sides of a table from [`flat`].
fn total(n: usize, table: &[f64]) -> f64 {
    let (top, side) = table.split_at(n * n);
    top.iter().sum::<f64>() + 4.0 * side.iter().sum::<f64>()
}

fn wrong_tables(n: usize) -> Vec<Suspect> {
    let edge = 2.0 / n as f64;
    let by_hand = |shift: f64| {
        let s = shift * edge;
        flat(table(
            n,
            move |x, y, e| right(x + s, y + s, e),
            move |y, z, e| (z + s) * right(y + s, z + s, e),
        ))
    };
    let exact = table(n, exact_top, exact_side);
    let side = |from: &dyn Fn(usize) -> usize| {
        let side = (0..n * n / 2).map(|k| exact.side[from(k)]).collect();
        flat(Weights { top: exact.top.clone(), side })
    };
    let mut suspects = vec![
        (QUARTER_AREA, flat(exact.clone()).iter().map(|w| 0.25 * w).collect()),
        (CELL_CORNERS, by_hand(-0.5)),
        (CELL_CORNERS, by_hand(0.5)),
        (SIDE_ORDER, side(&|k| k % (n / 2) * n + k / (n / 2))),
        (SIDE_ORDER, side(&|k| (n / 2 - 1 - k / n) * n + k % n)),
    ];
    for &(bug, top, side) in WRONG_WEIGHTS {
        let wrong = flat(table(n, top, side));
        let sum = total(n, &wrong);
        suspects.push((NORMALISED_AWAY, wrong.iter().map(|w| w / sum).collect()));
        suspects.push((bug, wrong));
    }
    suspects
}

fn weights(work: &Work, stream: &mut Stream) -> Verdict {
    tables(work, stream).map_or_else(|wrong| wrong, |(n, got)| judge_table(n, &got))
}

fn judge_table(n: usize, got: &[f64]) -> Verdict {
    let expected = flat(table(n, exact_top, exact_side));
    let place = |k: usize| {
        let (face, cell) = if k < n * n { (0, k) } else { (1, k - n * n) };
        let (name, at) = (["top", "side"][face], through(n, face, cell));
        format!("n = {n}, {name}[{cell}], at ({:.3}, {:.3}, {:.3})", at.x, at.y, at.z)
    };
    let tolerance = (2.0 / n as f64).powi(2);
    compare(got, &expected, Within::Relative(tolerance), &wrong_tables(n), place)
}

fn sum(work: &Work, stream: &mut Stream) -> Verdict {
    let (n, got) = match tables(work, stream) {
        Ok(tables) => tables,
        Err(wrong) => return wrong,
    };
    let within = Within::Absolute((2.0 / n as f64).powi(2));
    let place = |_| format!("n = {n}, the sum of the top and four sides");
    let verdict = compare(&[total(n, &got)], &[1.0], within, &[], place);
    let bug = if verdict.passed() { None } else { judge_table(n, &got).bug };
    Verdict { bug, ..verdict }
}

/// What a draw of fragments holds beside fronts at depths below 1.
#[derive(Clone, Copy, Default)]
struct Draw {
    far: bool,
    backs: bool,
    own: bool,
}

const NEAR: Draw = Draw { far: false, backs: false, own: false };
const FAR: Draw = Draw { far: true, ..NEAR };
const BACKS: Draw = Draw { backs: true, ..NEAR };
const OWN: Draw = Draw { own: true, ..NEAR };

/// Does the second fragment replace the first?
type Replace = fn(&Fragment, &Fragment) -> bool;
/// What a cell stores, if the fragment is let in at all.
type Store = fn(&Fragment, own: usize) -> Option<Item>;

fn stored(fragment: &Fragment, own: usize) -> Option<Item> {
    let item = if fragment.front { Item::Front(fragment.element) } else { Item::Back };
    (fragment.element != own).then_some(item)
}

const NEARER: Replace = |old, new| new.depth < old.depth;

/// Wrong item buffers: how a fragment replaces another, and what is stored.
const WRONG_BUFFERS: &[(Bug, Replace, Store)] = &[
    (FARTHEST, |old, new| new.depth > old.depth, stored),
    (LAST_WINS, |_, _| true, stored),
    (FIRST_WINS, |_, _| false, stored),
    (FAR_PLANE, NEARER, |f, own| stored(f, own).filter(|_| f.depth < 1.0)),
    (BACKS_IGNORED, NEARER, |f, own| stored(f, own).filter(|_| f.front)),
    (BACKS_AS_FRONTS, NEARER, |f, own| stored(&Fragment { front: true, ..*f }, own)),
    (BACKS_AS_NOTHING, NEARER, |f, own| {
        stored(f, own).map(|item| if item == Item::Back { Item::Nothing } else { item })
    }),
    (SELF_SEEN, NEARER, |f, _| stored(f, usize::MAX)),
];

fn resolve(
    cells: usize,
    own: usize,
    fragments: &[Fragment],
    replace: Replace,
    store: Store,
) -> Vec<Item> {
    let mut held: Vec<Option<(Fragment, Item)>> = vec![None; cells];
    for fragment in fragments {
        let slot = &mut held[fragment.cell];
        if let Some(item) = store(fragment, own)
            && slot.as_ref().is_none_or(|(old, _)| replace(old, fragment))
        {
            *slot = Some((*fragment, item));
        }
    }
    held.into_iter().map(|slot| slot.map_or(Item::Nothing, |(_, item)| item)).collect()
}

fn buffer(work: &Work, stream: &mut Stream, draw: Draw) -> Verdict {
    const CELLS: usize = 40;
    let own = whole_number(stream, 0, 12);
    let mut fragments = Vec::new();
    for _ in 0..3 * CELLS {
        let other = (own + whole_number(stream, 1, 12)) % 12;
        let far = if draw.far { uniform(stream, 1.0, 1000.0) } else { 1.0 };
        let itself = draw.own && stream.next() < 0.2;
        fragments.push(Fragment {
            cell: whole_number(stream, 0, CELLS - 4), // the last ones stay empty
            depth: if itself { 1e-12 } else { far * uniform(stream, 0.05, 1.0) },
            element: if itself { own } else { other },
            front: itself || !draw.backs || stream.next() < 0.5,
        });
    }
    let expected = resolve(CELLS, own, &fragments, NEARER, stored);
    let got = (work.item_buffer)(CELLS, own, &fragments);
    if got.len() != CELLS {
        let n = got.len();
        return Verdict::fail(format!("got {n} items for {CELLS} cells"), None);
    }
    let off = |k: &usize| got[*k] != expected[*k];
    let Some(cell) = (0..CELLS).find(off) else { return Verdict::pass(0.0, 0.0) };
    let suspect = |&&(_, replace, store): &&(Bug, Replace, Store)| {
        resolve(CELLS, own, &fragments, replace, store) == got
    };
    let here = fragments.iter().filter(|f| f.cell == cell);
    let told: Vec<String> = here
        .map(|f| {
            let side = if f.front { "front" } else { "back" };
            format!("{side} of {} at {:.3}", f.element, f.depth)
        })
        .collect();
    let message = format!(
        "element {own}, cell {cell} sees {:?}, expected {:?}; it was offered, in this \
         order: {}",
        got[cell],
        expected[cell],
        if told.is_empty() { "nothing".into() } else { told.join(", ") }
    );
    let share = (0..CELLS).filter(off).count() as f64 / CELLS as f64;
    let bug = WRONG_BUFFERS.iter().find(suspect).map(|entry| entry.0);
    Verdict { metric: share, tolerance: 0.0, message: Some(message), bug }
}

#[derive(Clone, Copy, PartialEq)]
enum Part {
    Row,
    Lost,
}

/// Checks a row of `ELEMENTS` factors, or what is lost; the row holds `old` before.
fn row(work: &Work, stream: &mut Stream, part: Part, old: f64) -> Verdict {
    const ELEMENTS: usize = 7;
    const N: usize = 8;
    let mut draw = |_| match whole_number(stream, 0, ELEMENTS + 3) {
        k if k < ELEMENTS => Item::Front(k),
        k if k == ELEMENTS => Item::Back,
        _ => Item::Nothing,
    };
    let items: [Vec<Item>; FACES] =
        std::array::from_fn(|face| (0..cells(N, face)).map(&mut draw).collect());
    // Weights that are no hemicube's, and do not sum to 1: whatever they are, they count.
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
    let Lost { escaped, absorbed } = (work.factor_row)(&items, &weights, &mut got);
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

fn shooting(work: &Work, stream: &mut Stream) -> Verdict {
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
