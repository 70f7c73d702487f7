//! What the tests of all labs share.

use labs::Verdict;
use labs::lab::Check;
use labs::run::seed;
use radiosity::random::Stream;

/// Some cohorts: nobody must be accused wrongly in any.
pub const COHORTS: [&str; 8] = ["0", "1", "2", "3", "4", "5", "6", "7"];

/// All checks of a lab, here and not in a process of their own.
pub fn judge<W>(
    checks: &[Check<W>],
    work: &W,
    cohort: &str,
) -> Vec<(&'static str, Verdict)> {
    let mut number = 0;
    let run = |check: &Check<W>| {
        number += 1;
        let mut stream = Stream::named(seed(cohort), &[number]);
        (check.about.name, (check.run)(work, &mut stream))
    };
    checks.iter().map(run).collect()
}

/// Nobody is accused who is right in another way.
pub fn all_pass<W>(checks: &[Check<W>], works: &[(&str, &W)]) {
    for cohort in COHORTS {
        for (name, work) in works {
            for (check, verdict) in judge(checks, work, cohort) {
                assert!(verdict.passed(), "{name}, {cohort}, {check}: {verdict:?}");
            }
        }
    }
}
