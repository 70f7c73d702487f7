//! The lab `sampling`: right answers that are not the answer, and the failure that its
//! report asks for.

mod common;

use common::{all_pass, judge};
use labs::sampling::given::Estimate;
use labs::sampling::report::{bars, parallel, touching};
use labs::sampling::{Work, answer, checks};
use radiosity::prelude::dvec2;
use radiosity::radiometry::cosine_direction;
use radiosity::random::Stream;

#[test]
fn other_right_answers_pass() {
    // The square mapped to the disc otherwise; n for n − 1.
    let other = Work {
        estimate: |values| {
            let n = values.len() as f64;
            let Estimate { mean, error } = (answer::WORK.estimate)(values);
            Estimate { mean, error: error * ((n - 1.0) / n).sqrt() }
        },
        direction: |u, v| cosine_direction(dvec2(u, v)),
        ..answer::WORK
    };
    // Each method by both halves of the samples.
    let halves = Work {
        by_rays: |pair, n, stream| {
            let mut half = || (answer::WORK.by_rays)(pair, n / 2, stream);
            mean([half(), half()])
        },
        by_points: |pair, n, stream| {
            let mut half = || (answer::WORK.by_points)(pair, n / 2, stream);
            mean([half(), half()])
        },
        ..answer::WORK
    };
    let works = [("answer", &answer::WORK), ("other", &other), ("halves", &halves)];
    all_pass(checks::ALL, &works);
}

fn mean([a, b]: [Estimate; 2]) -> Estimate {
    Estimate { mean: 0.5 * (a.mean + b.mean), error: 0.5 * a.error.hypot(b.error) }
}

/// The number that the brief tells lecturers to look out for.
#[test]
fn even_directions_find_little_more_than_half() {
    let mut played = labs::sampling::wrong::ALL.iter();
    let even = played.find(|played| played.name == "even-directions");
    let mut stream = Stream::named(1, &[]);
    let pair = parallel().pair;
    let found = even.map(|even| (even.work.by_rays)(&pair, 100_000, &mut stream));
    let mean = found.map_or(0.0, |found| found.mean);
    assert!((mean - 0.112).abs() < 0.005, "{mean}");
}

/// What is not a number never passes, and nobody is accused of it.
#[test]
fn nan_fails() {
    let work = Work {
        by_points: |_, _, _| Estimate { mean: f64::NAN, error: f64::NAN },
        ..answer::WORK
    };
    let failing =
        judge(checks::ALL, &work, "0").into_iter().filter(|(_, v)| !v.passed());
    let failing: Vec<_> = failing.map(|(name, verdict)| (name, verdict.bug)).collect();
    let names = ["points", "points-hidden", "points-bars", "honest", "agree"];
    assert_eq!(failing, names.map(|name| (name, None)));
}

/// The failure that the report asks for, pinned: points at a common edge.
///
/// ```text
/// value ~ 1/r² at a distance r from the edge      P(r < ε) ~ ε³
/// P(value > t) ~ t^(−3/2)      the variance is infinite, and the error falls as n^(−1/3)
/// ```
/// A bar of twice the stated error should miss one time in twenty; here it misses one in
/// four, whatever the number of samples. Rays have the scatter √(F(1 − F)) at every edge.
#[test]
fn bars_of_points_at_a_common_edge_do_not_hold() {
    let run = |touch: bool, rays: bool, samples: usize| {
        let squares = if touch { touching() } else { parallel() };
        bars(&answer::WORK, &squares, rays, samples, 400)
    };
    for (touch, rays) in [(false, true), (false, false), (true, true)] {
        let (few, many) = (run(touch, rays, 200), run(touch, rays, 6400));
        for bars in [few, many] {
            assert!((0.02..0.09).contains(&bars.missed), "{touch} {rays}: {bars:?}");
        }
        let fall = (few.typical / many.typical).ln() / 32.0_f64.ln();
        assert!((fall - 0.5).abs() < 0.07, "{touch} {rays}: n^-{fall}");
    }
    let (few, many) = (run(true, false, 200), run(true, false, 6400));
    for bars in [few, many] {
        assert!((0.2..0.4).contains(&bars.missed), "{bars:?}");
        assert!(bars.worst > 4.0 * bars.stated, "{bars:?}");
    }
    let fall = (few.typical / many.typical).ln() / 32.0_f64.ln();
    assert!((fall - 1.0 / 3.0).abs() < 0.07, "n^-{fall}");
}
