//! The lab `lambert`: right answers that are not the answer, and the failure that its
//! report asks for.

mod common;

use common::{all_pass, judge};
use labs::lambert::report::opposed;
use labs::lambert::{Work, answer, checks};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::prelude::{DVec3, Polygon};

#[test]
fn other_right_answers_pass() {
    let answer = answer::WORK;
    // The cross product as it stands in books; clipped in another order.
    let textbook = Work {
        edge: |a, b, n| match b.cross(a).try_normalize() {
            Some(unit) => b.cross(a).length().atan2(a.dot(b)) * n.dot(unit),
            None => 0.0,
        },
        clip: |n, corners| {
            let mut turned = corners.to_vec();
            turned.rotate_left(1);
            (answer::WORK.clip)(n, &turned)
        },
        ..answer
    };
    let library = Work {
        form_factor: |p, n, corners| match Polygon::new(corners.to_vec()) {
            Ok(front) if front.plane().height(p) > 0.0 => lambert_polygon(p, n, &front),
            _ => 0.0,
        },
        ..answer::WORK
    };
    let works =
        [("answer", &answer::WORK), ("textbook", &textbook), ("library", &library)];
    all_pass(checks::ALL, &works);
}

/// What is not a number never passes.
#[test]
fn nan_fails() {
    let work = Work { form_factor: |_, _, _: &[DVec3]| f64::NAN, ..answer::WORK };
    let failing =
        judge(checks::ALL, &work, "0").into_iter().filter(|(_, v)| !v.passed());
    let names: Vec<&str> = failing.map(|(name, _)| name).collect();
    assert_eq!(names, ["tables", "any", "closed", "squares"]);
}

/// The failure that the report asks for, pinned: a patch taken at its centre (Baum et al.
/// 1989 call it the proximity assumption). Worst at half its size, ⅓ d⁻² far away.
#[test]
fn a_patch_taken_at_its_centre_is_wrong_by_a_third_close_by() {
    for (distance, percent) in [
        (0.05, 9.3),
        (0.1, 17.1),
        (0.25, 31.5),
        (0.5, 33.4),
        (1.0, 19.8),
        (2.0, 7.1),
        (3.0, 3.4),
        (5.0, 1.3),
        (10.0, 0.33),
    ] {
        let factors = opposed(&answer::WORK, distance);
        let off = 100.0 * (factors.from_centre / factors.exact - 1.0);
        assert!((off - percent).abs() < 0.06, "{distance}: {off} %");
    }
    let far = opposed(&answer::WORK, 30.0);
    let third = (far.from_centre / far.exact - 1.0) * 900.0;
    assert!((third - 1.0 / 3.0).abs() < 0.01, "{third}");
}
