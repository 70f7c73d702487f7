//! Tasks 2 and 4: form factors, of polygons wholly above the horizon and of any.

use super::cases::{ABOVE, CUT, Case};
use super::edges::{self, Edge};
use super::{View, clipping, digits_of};
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{decades, direction};
use crate::lambert::Work;
use crate::lambert::bugs::*;
use crate::shapes::Place;
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;
use std::f64::consts::{PI, TAU};

/// What may be made of the sum over the edges.
type Sum = fn(f64) -> f64;

fn right(sum: f64) -> f64 {
    (sum / TAU).max(0.0)
}

const WRONG_SUMS: &[(Bug, Sum)] = &[
    (NO_HALF, |sum| (sum / PI).max(0.0)),
    (NO_PI, |sum| (0.5 * sum).max(0.0)),
    (PI_TWICE, |sum| (sum / TAU / PI).max(0.0)),
    (FROM_BEHIND, |sum| sum / TAU),
    (FROM_BEHIND, |sum| (sum / TAU).abs()),
    (REVERSED, |sum| (-sum / TAU).max(0.0)),
    (REVERSED, |sum| -sum / TAU),
];

/// The sum over so many edges of an outline, seen from the origin.
fn over(edges: usize, n: DVec3, v: &[DVec3], edge: Edge) -> f64 {
    (0..edges).map(|k| edge(v[k], v[(k + 1) % v.len()], n)).sum()
}

fn around(n: DVec3, v: &[DVec3], edge: Edge) -> f64 {
    over(v.len(), n, v, edge)
}

/// What the form factors would be.
fn suspects(views: &[View]) -> Vec<Suspect> {
    let all = |f: &dyn Fn(&View) -> f64| views.iter().map(f).collect::<Vec<f64>>();
    let cut = |view: &View| clipping::right(view.n, &view.seen());
    let sum_of = |view: &View| around(view.n, &cut(view), edges::right);
    let open = |view: &View| {
        let v = cut(view);
        right(over(v.len().saturating_sub(1), view.n, &v, edges::right))
    };
    let at_origin = |view: &View| {
        let v = clipping::right(view.n, &view.corners);
        let seen: Vec<DVec3> = v.iter().map(|&corner| corner - view.p).collect();
        right(around(view.n, &seen, edges::right))
    };
    let not_moved = |view: &View| {
        right(around(view.n, &clipping::right(view.n, &view.corners), edges::right))
    };
    let mut suspects = vec![
        (OPEN, all(&open)),
        (HORIZON_AT_ORIGIN, all(&at_origin)),
        (NOT_MOVED, all(&not_moved)),
    ];
    for &(bug, edge) in edges::WRONG {
        suspects.push((bug, all(&|view| right(around(view.n, &cut(view), edge)))));
    }
    for &(bug, sum) in WRONG_SUMS {
        suspects.push((bug, all(&|view| sum(sum_of(view)))));
    }
    for &(bug, clip) in clipping::WRONG {
        let wrong = |view: &View| {
            right(around(view.n, &clip(view.n, &view.seen()), edges::right))
        };
        suspects.push((bug, all(&wrong)));
    }
    suspects
}

/// Compares form factors.
fn judge(
    got: &[f64],
    expected: &[f64],
    views: &[View],
    within: Within,
    place: impl Fn(usize) -> String,
) -> Verdict {
    let plain = compare(got, expected, within, &[], &place);
    if plain.passed() {
        return plain;
    }
    compare(got, expected, within, &suspects(views), place)
}

/// Compares form factors with the library's, by one of the student's functions.
fn judge_library(views: &[View], by: impl Fn(&View) -> f64) -> Verdict {
    let got: Vec<f64> = views.iter().map(by).collect();
    let expected: Vec<f64> = views.iter().map(View::factor).collect();
    judge(&got, &expected, views, Within::Absolute(1e-9), |k| {
        let View { p, n, corners } = &views[k];
        let corners: Vec<String> = corners.iter().map(|c| format!("{c:.3}")).collect();
        format!("p = {p:.3}, n = {n:.3}, corners {}", corners.join(" "))
    })
}

fn all_above(work: &Work, view: &View) -> f64 {
    (work.all_above)(view.n, &view.seen())
}

fn form_factor(work: &Work, view: &View) -> f64 {
    (work.form_factor)(view.p, view.n, &view.corners)
}

/// Cases of the accuracy tables: turned, enlarged, moved.
fn of_tables(
    stream: &mut Stream,
    cases: &[Case],
    by: impl Fn(&View) -> f64,
) -> Verdict {
    let mut view = |case: &Case| {
        let place = Place::draw(stream);
        let corners = case.corners.iter().map(|&corner| place.of(DVec3::from(corner)));
        View {
            p: place.of(DVec3::from(case.point)),
            n: place.direction(DVec3::from(case.normal)),
            corners: corners.collect(),
        }
    };
    let views: Vec<View> = cases.iter().map(&mut view).collect();
    let got: Vec<f64> = views.iter().map(by).collect();
    let expected: Vec<f64> = cases.iter().map(|case| case.factor).collect();
    judge(&got, &expected, &views, Within::Absolute(1e-9), |k| {
        format!("{}, turned", cases[k].name)
    })
}

/// The tables' polygons above the horizon.
pub fn known(work: &Work, stream: &mut Stream) -> Verdict {
    of_tables(stream, ABOVE, |view| all_above(work, view))
}

/// The tables' polygons on the horizon, and others that it cuts.
pub fn tables(work: &Work, stream: &mut Stream) -> Verdict {
    let others: Vec<View> = (0..60).map(|_| View::draw_cut(stream)).collect();
    // The others first: a table has too few for telling one mistake from another.
    judge_library(&others, |view| form_factor(work, view))
        .and(|| of_tables(stream, CUT, |view| form_factor(work, view)))
}

/// Polygons of all kinds: above, below and cut; fronts and backs.
pub fn any(work: &Work, stream: &mut Stream) -> Verdict {
    let views: Vec<View> = (0..60).map(|_| View::draw(stream)).collect();
    judge_library(&views, |view| form_factor(work, view))
}

/// Polygons above the horizon, fronts and backs; not all of their edges count alike.
pub fn sides(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |k: usize| loop {
        let mut view = View::draw(stream).at_origin();
        let middle = view.corners.iter().sum::<DVec3>().normalize();
        view.n = (middle + 0.7 * direction(stream)).normalize();
        if (view.factor() > 0.0) != k.is_multiple_of(2) {
            view.corners.reverse();
        }
        let sign = |edge: Edge| around(view.n, &view.corners, edge).abs();
        let unsigned = sign(|a, b, n| edges::right(a, b, n).abs());
        let above = view.heights().iter().all(|&h| h > 0.1);
        if above && unsigned > sign(edges::right) + 0.01 {
            return view;
        }
    };
    let views: Vec<View> = (0..20).map(&mut draw).collect();
    judge_library(&views, |view| all_above(work, view))
}

/// Squares of edge 1e-4 to 1e-3, seen from 1, by the closed form of a corner (Howell B-3):
///
/// ```text
/// F = s/(π√(1 + s²)) atan(s/√(1 + s²))
/// ```
pub fn small(work: &Work, stream: &mut Stream) -> Verdict {
    let (mut views, mut expected) = (Vec::new(), Vec::new());
    for _ in 0..20 {
        let s = decades(stream, 1e-4, 1e-3);
        let (root, place) = (s.hypot(1.0), Place::about_origin(stream, 1.0));
        let corners = [(0.0, 0.0), (0.0, s), (s, s), (s, 0.0)];
        let corners = corners.map(|(x, y)| place.of(dvec3(x, y, 1.0))).to_vec();
        views.push(View { p: DVec3::ZERO, n: place.direction(DVec3::Z), corners });
        expected.push(s / (PI * root) * (s / root).atan());
    }
    let got: Vec<f64> = views.iter().map(|view| all_above(work, view)).collect();
    let verdict = judge(&got, &expected, &views, Within::Relative(1e-6), |k| {
        format!("a square with a factor of {:.2e}", expected[k])
    });
    digits_of(verdict, FLAT_COSINE, || known(work, stream))
}
