//! How patches times bins grow: counts, bytes, time, and what is gained.

use crate::chart::trials;
use radiosity::chart::Trial;
use radiosity::chart::suites::directional::PATCHES;
use std::fmt::Write;

/// What `radiosity chart directional -o book/data` wrote.
const CSV: &str = include_str!("../../data/directional.csv");

/// A run by patches and bins.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Run {
    patches: f64,
    bins: f64,
    unknowns: f64,
    pairs: f64,
    bytes: f64,
    /// Until the picture is there.
    seconds: f64,
    error: f64,
}

/// All runs by patches and bins.
fn runs() -> Vec<Run> {
    let run = |t: &Trial| {
        let patches = t.method.strip_suffix(PATCHES)?.parse::<f64>().ok()?;
        Some(Run {
            patches,
            bins: t.setting,
            unknowns: patches * t.setting,
            pairs: t.work.factors as f64,
            bytes: t.work.bytes as f64,
            seconds: t.seconds,
            error: t.error,
        })
    };
    trials(CSV).iter().filter_map(run).collect()
}

/// All runs of another method.
fn others(method: &str) -> Vec<Trial> {
    trials(CSV).into_iter().filter(|t| t.method == method).collect()
}

/// Number and unit, to two digits.
fn round(value: f64, units: &[&str], step: f64) -> String {
    let (mut value, mut unit) = (value, 0);
    while value >= step && unit + 1 < units.len() {
        (value, unit) = (value / step, unit + 1);
    }
    let digits = usize::from(value < 9.95);
    format!("{value:.digits$}\u{202f}{}", units[unit])
}

fn bytes(b: f64) -> String {
    round(b, &["B", "kB", "MB", "GB", "TB", "PB"], 1e3)
}

/// A time in s, in words.
fn time(seconds: f64) -> String {
    match 1e3 * seconds {
        ms if ms < 1e3 => round(ms, &["ms"], 1e3),
        ms if ms < 1.2e5 => round(ms / 1e3, &["s"], 1e3),
        ms if ms < 7.2e6 => round(ms / 6e4, &["min"], 1e3),
        ms if ms < 1.7e8 => round(ms / 3.6e6, &["h"], 1e3),
        ms => round(ms / 8.64e7, &["days"], 1e9),
    }
}

/// A count, with a blank between thousands.
fn count(n: f64) -> String {
    let digits = format!("{n:.0}");
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// What was measured, line by line.
pub fn table() -> String {
    let mut text = String::from(
        "| patches | bins | unknowns | pairs | memory | time | error |\n\
         |---|---|---|---|---|---|---|\n",
    );
    for run in runs() {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {:.0}\u{202f}% |",
            count(run.patches),
            run.bins,
            count(run.unknowns),
            count(run.pairs),
            bytes(run.bytes),
            time(run.seconds),
            100.0 * run.error
        );
    }
    text
}

/// `a x + b y + c` through all the points, by least squares, and what it gives elsewhere.
fn plane(points: &[[f64; 3]]) -> impl Fn(f64, f64) -> f64 + use<> {
    use glam::{DMat3, DVec3};
    let (mut matrix, mut right) = (DMat3::ZERO, DVec3::ZERO);
    for &[x, y, z] in points {
        let v = DVec3::new(x, y, 1.0);
        matrix += DMat3::from_cols(v * v.x, v * v.y, v * v.z);
        right += z * v;
    }
    let found = matrix.inverse() * right;
    move |x, y| found.dot(DVec3::new(x, y, 1.0))
}

/// A power law of patches and bins through a number of each run that is not tiny.
fn law(number: fn(&Run) -> f64) -> impl Fn(f64, f64) -> f64 {
    let runs = runs().into_iter().filter(|r| r.bins > 1.0);
    let points: Vec<_> =
        runs.map(|r| [r.patches.ln(), r.bins.ln(), number(&r).ln()]).collect();
    let plane = plane(&points);
    move |patches, bins| plane(patches.ln(), bins.ln()).exp()
}

/// The exponents of patches and bins in the law of the pairs.
fn exponents() -> [f64; 2] {
    let law = law(|r| r.pairs);
    let e = std::f64::consts::E;
    [(law(e, 1.0) / law(1.0, 1.0)).ln(), (law(1.0, e) / law(1.0, 1.0)).ln()]
}

/// What the charts say.
pub fn text() -> String {
    let bins = runs();
    let last = bins.last().expect("it was measured");
    let (paths, passes) = (others("paths"), others("two passes"));
    let second = passes.first().expect("it was measured");
    let quick = paths.iter().find(|t| t.error < last.error).expect("paths get there");
    let [by_patches, by_bins] = exponents();
    format!(
        "Through all runs with more than one bin goes the law pairs ∝ patches^{by_patches:.1} \
         bins^{by_bins:.1}. The finest of them takes {}, holds {}, and shows the floor with an \
         error of {:.0} %. Path tracing shows this one view with {:.0} % after {}: {:.0} \
         times sooner. Two passes need {}, and are {:.1} % off.\n",
        time(last.seconds),
        bytes(last.bytes),
        100.0 * last.error,
        100.0 * quick.error,
        time(quick.seconds),
        last.seconds / quick.seconds,
        time(second.seconds),
        100.0 * second.error,
    )
}

/// What finer bins gain without finer patches, and with them.
pub fn steps() -> String {
    let runs = runs();
    let find = |patches: f64, bins: f64| {
        let found = runs.iter().find(|r| r.patches == patches && r.bins == bins);
        100.0 * found.expect("it was measured").error
    };
    format!(
        "On 28 patches sixteen times the bins bring the error from {:.0} % to {:.0} % only; \
         with the patches refined as well, to {:.0} %.\n",
        find(28.0, 16.0),
        find(28.0, 256.0),
        find(384.0, 256.0)
    )
}

/// What the finest run, refined on in patches and bins alike, would take to be 1 % wrong:
/// how many times as much. The error falls as a power of the unknowns; the last two runs of
/// that kind tell which.
fn to_one_per_cent() -> f64 {
    let runs = runs();
    let find = |n: f64, m: f64| {
        runs.iter().find(|r| r.patches == n && r.bins == m).expect("it was measured")
    };
    let (coarse, fine) = (find(96.0, 64.0), find(384.0, 256.0));
    let order =
        (coarse.error / fine.error).ln() / (fine.unknowns / coarse.unknowns).ln();
    (fine.error / 0.01).powf(1.0 / order)
}

/// What was measured, carried on: to an error of 1 %, and to the Cornell box.
pub fn cornell() -> String {
    let of = |number: fn(&Run) -> f64| law(number)(4000.0, 1024.0);
    let box_ = Run {
        unknowns: 4000.0 * 1024.0,
        pairs: of(|r| r.pairs),
        bytes: of(|r| r.bytes),
        seconds: of(|r| r.seconds),
        ..Run::default()
    };
    let all = runs();
    let last = all.last().expect("it was measured");
    let times = to_one_per_cent();
    let more = Run {
        unknowns: times * last.unknowns,
        pairs: times * last.pairs,
        bytes: times * last.bytes,
        seconds: times * last.seconds,
        ..*last
    };
    let mut text = String::from(
        "| what | unknowns | pairs of beams | memory | time, one thread |\n|---|---|---|---|---|\n",
    );
    for (what, run) in [
        ("the cube, as measured last", last),
        ("the cube to 1 %", &more),
        ("the Cornell box, 4000 patches, 1024 bins", &box_),
    ] {
        let _ = writeln!(
            text,
            "| {what} | {:.1e} | {:.1e} | {} | {} |",
            run.unknowns,
            run.pairs,
            bytes(run.bytes),
            time(run.seconds),
        );
    }
    text
}
