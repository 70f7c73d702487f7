//! The lab `race`: right answers that are not the answer, and the slopes that its
//! report asks for.

mod common;

use common::{all_pass, judge};
use labs::race::given::{Pair, gauss};
use labs::race::report::yours;
use labs::race::{Work, answer, checks};
use radiosity::chart::suites::form_factors::{self, FAR, HIDDEN, NEAR, TOUCHING};
use radiosity::chart::{Bench, Column, Contest, Verdict, exponent};

/// A rule of places and weights in each of four variables.
fn product(pair: &Pair, rule: &[(f64, f64)]) -> f64 {
    let k = rule.len();
    let digit = |n: usize, place: u32| rule[n / k.pow(place) % k];
    let value = |n: usize| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|place| digit(n, place));
        a.1 * b.1 * c.1 * d.1 * pair.kernel([a.0, b.0], [c.0, d.0])
    };
    (0..k.pow(4)).map(value).sum()
}

/// `rule` in each of so many pieces.
fn composite(rule: &[(f64, f64)], pieces: usize) -> Vec<(f64, f64)> {
    let all = |p: usize| {
        let n = pieces as f64;
        rule.iter().map(move |(x, w)| ((p as f64 + x) / n, w / n))
    };
    (0..pieces).flat_map(all).collect()
}

/// Two midpoint rules whose errors cancel, of k and k/2 places.
fn richardson(pair: &Pair, effort: u32) -> f64 {
    let cost = |k: u32| k.pow(4) + (k / 2).pow(4);
    let k = (1..).take_while(|&k| cost(k) <= effort).last().unwrap_or(1);
    let rule = |k: u32| product(pair, &composite(&[(0.5, 1.0)], k as usize));
    if k == 1 {
        return rule(1);
    }
    let ratio = (f64::from(k) / f64::from(k / 2)).powi(2);
    (ratio * rule(k) - rule(k / 2)) / (ratio - 1.0)
}

#[test]
fn other_right_answers_pass() {
    // By sums over sums; sorted, with ties; Gauss's two places in each piece.
    let pairs = Work {
        off: |answers, exact| {
            let n = answers.len() as f64;
            let mean =
                |of: fn(f64) -> f64| answers.iter().map(|&a| of(a)).sum::<f64>() / n;
            let (first, second) =
                (mean(|a| a) / exact, mean(|a| a * a) / exact / exact);
            (second - 2.0 * first + 1.0).sqrt()
        },
        frontier: |trials| {
            let mut order: Vec<usize> = (0..trials.len()).collect();
            order.sort_by(|&a, &b| trials[b].partial_cmp(&trials[a]).unwrap());
            let beaten = |k: &usize| {
                let mut before = order.iter().rev().map(|&i| trials[i]);
                before.any(|t| {
                    t != trials[*k] && t.0 <= trials[*k].0 && t.1 <= trials[*k].1
                })
            };
            order.iter().copied().filter(|k| !beaten(k)).collect()
        },
        factor: |pair, effort| {
            let k = (1..).take_while(|k: &u32| k.pow(4) <= effort).last().unwrap_or(1);
            match k {
                1 => product(pair, &gauss(1)),
                k => product(pair, &composite(&gauss(2), k as usize / 2)),
            }
        },
        ..answer::WORK
    };
    let cancelled = Work { factor: richardson, ..answer::WORK };
    let works =
        [("answer", &answer::WORK), ("pairs", &pairs), ("cancelled", &cancelled)];
    all_pass(checks::ALL, &works);
}

/// What is not a number never passes, and only the common edge is suspected.
#[test]
fn nan_fails() {
    let work = Work {
        off: |_, _| f64::NAN,
        slope: |_| f64::NAN,
        factor: |_, _| f64::NAN,
        ..answer::WORK
    };
    let failing =
        judge(checks::ALL, &work, "0").into_iter().filter(|(_, v)| !v.passed());
    let names: Vec<&str> = failing.map(|(name, _)| name).collect();
    let all = ["off", "slope", "zeros", "allowed", "limit", "edge", "faster", "chart"];
    assert_eq!(names, all);
}

/// The failures that the report asks for, pinned: errors over evaluations.
///
/// ```text
/// smooth        k places have no order: each adds digits
/// common edge   k pairs of places lie at the same place along it, and count 1/k² each;
///               they see ∫∫ ut/(u² + t²)² du dt from 1/k² on: together ~ ln k/k
/// screen        a step in the kernel: 1/k = evaluations^(−1/4)
/// ```
#[test]
fn gauss_loses_its_order_where_the_kernel_is_not_smooth() {
    let line = |name: &str| {
        let pair = form_factors::Pair::named(name).unwrap();
        let off = |f: &f64| Verdict::of((f / pair.exact() - 1.0).abs());
        let contest = Contest::new(name, 0.0, off);
        contest.with(yours(&answer::WORK, &pair)).run("race", &Bench::SILENT)
    };
    let error = |name: &str, effort: f64| {
        let found = line(name).into_iter().find(|t| t.setting == effort);
        found.map_or(f64::NAN, |trial| trial.error)
    };
    assert!(error(FAR, 256.0) < 2e-9);
    assert!(error(NEAR, 65_536.0) < 1e-6);
    let touching = [256.0, 65_536.0].map(|effort| error(TOUCHING, effort));
    let law = (16.0_f64.ln() / 16.0) / (4.0_f64.ln() / 4.0);
    let fall = touching[1] / touching[0];
    assert!((fall - law).abs() < 0.05, "{fall}, in theory {law}");
    let hidden = line(HIDDEN);
    let some: Vec<_> = hidden.iter().filter(|t| t.setting >= 81.0).collect();
    let slope = exponent(&some, Column::Rays, Column::Error);
    assert!((slope + 0.25).abs() < 0.2, "{slope}");
}
