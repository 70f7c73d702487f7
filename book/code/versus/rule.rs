//! Who wins where: the rule that a reader may take home, from all that was measured.

use crate::chart::trials;
use radiosity::chart::suites::form_factors::{FAR, HIDDEN, NEAR, ROWS, TOUCHING};
use radiosity::chart::suites::solvers::PATCHES;
use radiosity::chart::{Column, SUITES, Trial, exponent};
use std::fmt::Write;

fn measured(suite: &str) -> Vec<Trial> {
    let path = crate::generated::root().join(format!("data/{suite}.csv"));
    let csv = std::fs::read_to_string(&path);
    trials(&csv.unwrap_or_else(|e| panic!("{}: {e}", path.display())))
}

/// Tasks: suite, scene, what the reader calls it, and the errors that are asked for.
const TASKS: [(&str, &str, &str, &[f64]); 6] = [
    ("form-factors", FAR, "a factor, far apart", &[0.01, 1e-6]),
    ("form-factors", NEAR, "a factor, close by", &[0.01, 1e-6]),
    ("form-factors", TOUCHING, "a factor, touching", &[0.01, 1e-6]),
    ("form-factors", HIDDEN, "a factor, half hidden", &[0.01, 1e-6]),
    ("form-factors", ROWS, "rows of a room (absolute)", &[0.035, 1e-3]),
    ("solvers", PATCHES, "patches of the Cornell box", &[0.06, 0.015]),
];

/// Each method's least time for an error of at most `level`, the quickest first.
pub fn quickest<'t>(
    trials: &'t [Trial],
    scene: &str,
    level: f64,
) -> Vec<(&'t str, f64)> {
    let fits = |t: &&Trial| t.scene == scene && t.error <= level;
    let mut found: Vec<(&str, f64)> = vec![];
    for t in trials.iter().filter(fits) {
        match found.iter_mut().find(|f| f.0 == t.method) {
            Some(best) => best.1 = best.1.min(t.seconds),
            None => found.push((&t.method, t.seconds)),
        }
    }
    found.sort_by(|a, b| a.1.total_cmp(&b.1));
    found
}

/// For each task and error: who is the quickest, who comes next, who does not come in.
pub fn winners() -> String {
    let mut text = String::from(
        "| task | error | quickest | next | at no setting tried |\n|---|---|---|---|---|\n",
    );
    for (suite, scene, task, levels) in TASKS {
        let mut trials = measured(suite);
        trials.retain(|t| !t.method.contains("far pairs")); // not a method of its own
        for &level in levels {
            let found = quickest(&trials, scene, level);
            let mut names: Vec<&str> = trials
                .iter()
                .filter(|t| t.scene == scene)
                .map(|t| t.method.as_str())
                .collect();
            names.dedup();
            let all = names.len();
            names.retain(|name| !found.iter().any(|f| f.0 == *name));
            let first = found.first().map_or("nobody".into(), |f| told(f.0, f.1));
            let next = found.get(1).map_or("-".into(), |f| {
                format!("{}, {:.1} times as long", f.0, f.1 / found[0].1)
            });
            let never = match names.len() {
                0 => "-".into(),
                n if n + 1 == all => "all others".into(),
                _ => names.join("; "),
            };
            let _ =
                writeln!(text, "| {task} | {level:e} | {first} | {next} | {never} |");
        }
    }
    text
}

fn told(method: &str, seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-3 => (1e6 * s, "µs"),
        s if s < 1.0 => (1e3 * s, "ms"),
        s => (s, "s"),
    };
    format!("{method}, {value:.2} {unit}")
}

/// Methods whose slope on the chart of touching squares theory knows.
const SLOPES: [(&str, &str, &str); 4] = [
    ("point to point", "first order in 1/k, k⁴ pairs", "−¼"),
    ("Lambert at the middles", "second order in 1/k, k² places", "−1"),
    ("rays", "variance over n; less, as they are spread evenly", "−½ or steeper"),
    ("random pairs", "infinite variance: k² ~ 1/r² at the edge", "less than −½"),
];

/// The slopes on a chart of error over time: fitted, and as theory has them.
pub fn slopes() -> String {
    let trials = measured("form-factors");
    let mut text = String::from(
        "| method | why | slope in theory | fitted | one more digit costs |\n\
         |---|---|---|---|---|\n",
    );
    for (method, why, theory) in SLOPES {
        let of: Vec<&Trial> = trials
            .iter()
            .filter(|t| t.scene == TOUCHING && t.method == method)
            .collect();
        // The work is known to the last digit; of times the first ones are overhead.
        let work = if method.starts_with('r') { Column::Rays } else { Column::Factors };
        let fitted = exponent(&of, work, Column::Error);
        let digit = 10_f64.powf(-1.0 / fitted);
        let _ = writeln!(
            text,
            "| {method} | {why} | {theory} | {fitted:.2} | {digit:.0} times the work |"
        );
    }
    text
}

/// What all charts of the book cost.
pub fn cost() -> String {
    let mut text =
        String::from("| suite | compares | trials | CPU s |\n|---|---|---|---|\n");
    let (mut all, mut sum) = (0, 0.0);
    for suite in &SUITES {
        let trials = measured(suite.name);
        let seconds: f64 = trials.iter().map(|t| t.seconds * t.runs as f64).sum();
        let (n, name, about) = (trials.len(), suite.name, suite.about);
        let _ = writeln!(text, "| `{name}` | {about} | {n} | {seconds:.0} |");
        (all, sum) = (all + n, sum + seconds);
    }
    let _ = writeln!(text, "| all | | {all} | {sum:.0} |");
    text
}
