//! Tasks 1 and 2: the weights, cell by cell against closed forms.
//!
//! ```text
//! |centre rule / exact − 1| ≤ max|∇²g/g| e²/24     g the density of weight, e the edge
//!                           = e²/3 on the top, 2e²/3 on a side, to leading order
//! ```
//! The tolerances are half as large again: cells weighed at their centre and cells
//! weighed exactly both pass.

use super::sized;
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{uniform, whole_number};
use crate::hemicube::Work;
use crate::hemicube::bugs::*;
use crate::hemicube::given::{Weights, exact_side, exact_top, table, through};
use radiosity::random::Stream;
use std::f64::consts::PI;

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

/// A cell of the top.
pub fn top(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || uniform(stream, -0.95, 0.95);
    let at: Vec<(f64, f64)> = (0..40).map(|_| (draw(), draw())).collect();
    let drawn = at.into_iter().map(|(x, y)| (x, y, edge(stream))).collect();
    let place = |x, y, e| format!("cell about ({x:.3}, {y:.3}, 1) of edge {e:.4}");
    let tolerance = 0.5 * (2.0 / 32.0_f64).powi(2);
    forty(drawn, work.top_factor, exact_top, tolerance, |entry| entry.1, place)
}

/// A cell of a side.
pub fn side(work: &Work, stream: &mut Stream) -> Verdict {
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
    sized(&weights, n)?;
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

/// Every entry of both tables.
pub fn weights(work: &Work, stream: &mut Stream) -> Verdict {
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

/// The sum of the five faces.
pub fn sum(work: &Work, stream: &mut Stream) -> Verdict {
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
