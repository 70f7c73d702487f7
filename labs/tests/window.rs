//! The lab `window`: right answers that are not the answer, and the numbers that its
//! report asks for.

mod common;

use common::{all_pass, judge};
use labs::window::report::at;
use labs::window::{Work, answer, checks};
use radiosity::material::optics;

#[test]
fn other_right_answers_pass() {
    // Fresnel's law by tangents and sines of the angles; the series summed term by
    // term; the mean over squares of the sine, of which each ring has as many.
    let other = Work {
        fresnel: |cosine, index| {
            let outside = cosine.acos();
            let inside = (outside.sin() / index).asin();
            let (less, more) = (outside - inside, outside + inside);
            if more < 1e-6 {
                return [((index - 1.0) / (index + 1.0)).powi(2); 2];
            }
            [(less.sin() / more.sin()).powi(2), (less.tan() / more.tan()).powi(2)]
        },
        pane: |cosine, index| {
            let both = (answer::WORK.fresnel)(cosine, index);
            let through = |r: f64| {
                let (mut sum, mut ray) = (0.0, 1.0 - r);
                for _ in 0..2000 {
                    sum += ray * (1.0 - r);
                    ray *= r * r;
                }
                sum
            };
            both.map(through).iter().sum::<f64>() / 2.0
        },
        mean: |index, rings| {
            let ring = |k: usize| {
                let sine_squared = (k as f64 + 0.5) / rings as f64;
                (answer::WORK.pane)((1.0 - sine_squared).sqrt(), index)
            };
            (0..rings).map(ring).sum::<f64>() / rings as f64
        },
        ..answer::WORK
    };
    let library = Work {
        fresnel: |cosine, index| {
            let both = optics::fresnel(cosine, 1.0 / index);
            [both.s, both.p]
        },
        pane: |cosine, index| optics::pane(cosine, index).1,
        ..answer::WORK
    };
    let works = [("answer", &answer::WORK), ("other", &other), ("library", &library)];
    all_pass(checks::ALL, &works);
}

/// What is not a number never passes.
#[test]
fn nan_fails() {
    let work = Work { pane: |_, _| f64::NAN, ..answer::WORK };
    let failing =
        judge(checks::ALL, &work, "0").into_iter().filter(|(_, v)| !v.passed());
    assert_eq!(failing.map(|(name, _)| name).collect::<Vec<_>>(), ["panes", "tables"]);
}

/// The numbers that the report asks for, pinned: which shortcut is off by how much.
#[test]
fn shortcuts_cost_most_at_flat_angles() {
    let off = |degrees: f64| {
        let passed = at(&answer::WORK, degrees, 1.5);
        let off = |t: f64| 100.0 * (t / passed.all - 1.0);
        [passed.one_face, passed.two_faces, passed.mean_first].map(off)
    };
    for (degrees, [one_face, two_faces, mean_first]) in [
        (0.0, [4.00, -0.16, 0.0]),
        (60.0, [7.39, -1.29, -1.40]),
        (80.0, [33.55, -13.26, -3.76]),
        (85.0, [56.81, -33.50, -2.77]),
        (89.0, [89.06, -79.43, -0.71]),
    ] {
        let found = off(degrees);
        let near = |a: f64, b: f64| (a - b).abs() < 0.006;
        assert!(near(found[0], one_face), "{degrees}: {found:?}");
        assert!(near(found[1], two_faces), "{degrees}: {found:?}");
        assert!(near(found[2], mean_first), "{degrees}: {found:?}");
    }
}
