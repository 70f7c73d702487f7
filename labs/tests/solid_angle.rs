//! The lab `solid-angle`: its tolerances, right answers that are not the answer, and the
//! failure that its report asks for.

mod common;

use common::{all_pass, judge};
use labs::solid_angle::report::errors;
use labs::solid_angle::{Work, answer, checks};
use radiosity::prelude::{DVec3, Polygon};
use radiosity::radiometry::{solid_angle, solid_angle_triangle};

#[test]
fn other_right_answers_pass() {
    let answer = answer::WORK;
    let library = Work {
        triangle: solid_angle_triangle,
        polygon: |point, corners| match Polygon::new(corners.to_vec()) {
            Ok(convex) if convex.plane().height(point) > 0.0 => {
                solid_angle(point, &convex)
            }
            Ok(convex) => -solid_angle(point, &convex),
            Err(_) => (answer::WORK.polygon)(point, corners),
        },
        ..answer::WORK
    };
    let complex =
        Work { triangle: by_unit_vectors, polygon: about_the_middle, ..answer::WORK };
    let works = [("answer", &answer), ("library", &library), ("complex", &complex)];
    all_pass(checks::ALL, &works);
}

/// The same tangent, of unit vectors.
fn by_unit_vectors(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let above = a.dot((c - a).cross(b - a)) / (a.length() * b.length() * c.length());
    let [a, b, c] = [a.normalize(), b.normalize(), c.normalize()];
    2.0 * above.atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}

/// A fan about the mean of the corners, which may lie outside the outline.
fn about_the_middle(point: DVec3, corners: &[DVec3]) -> f64 {
    let n = corners.len();
    let middle = corners.iter().sum::<DVec3>() / n as f64 - point;
    let r = |k: usize| corners[k % n] - point;
    (0..n).map(|k| by_unit_vectors(middle, r(k), r(k + 1))).sum()
}

/// The formula of the books passes all checks but one.
#[test]
fn the_textbook_formula_loses_one_point() {
    let textbook = Work {
        triangle: |a, b, c| {
            let (x, y, z) = (a.length(), b.length(), c.length());
            let below = x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y;
            -2.0 * a.dot(b.cross(c)).atan2(below)
        },
        ..answer::WORK
    };
    for cohort in common::COHORTS {
        let failing = judge(checks::ALL, &textbook, cohort);
        let failing = failing.into_iter().filter(|(_, verdict)| !verdict.passed());
        let names: Vec<&str> = failing.map(|(name, _)| name).collect();
        assert_eq!(names, ["tinier"], "{cohort}");
    }
}

/// What is not a number never passes.
#[test]
fn nan_fails() {
    let work = Work { surface: |_, _| f64::NAN, ..answer::WORK };
    let failing =
        judge(checks::ALL, &work, "0").into_iter().filter(|(_, v)| !v.passed());
    assert_eq!(
        failing.map(|(name, _)| name).collect::<Vec<_>>(),
        ["inside", "outside"]
    );
}

/// The slopes that the report asks for, pinned.
///
/// ```text
/// A cosθ/r² at the centre      s²/6, since cosθ/r² = 1 − 3ρ²/2 at a distance ρ off the
///                              axis, and the triangle's variance of ρ² is s²/9
/// the triangle, of edges       a few ε/s: the rounding of its corners
/// by cos(Ω/2)                  nothing is left where Ω²/8 = s⁴/32 < ε: below s = 3e-4
/// ```
#[test]
fn errors_follow_the_slopes_of_the_report() {
    for size in [0.1, 0.01, 1e-3, 1e-4] {
        let small = errors(&answer::WORK, size, 50).small / (size * size / 6.0);
        assert!((0.97..1.03).contains(&small), "{size}: {small}");
    }
    for size in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        let of_rounding =
            errors(&answer::WORK, size, 50).triangle * size / f64::EPSILON;
        assert!((0.05..1.0).contains(&of_rounding), "{size}: {of_rounding}");
    }
    let by_cosine = |size| errors(&answer::WORK, size, 50).by_cosine;
    assert!(by_cosine(0.1) < 1e-10, "{}", by_cosine(0.1));
    assert!(by_cosine(1e-4) > 0.5, "{}", by_cosine(1e-4));
}
