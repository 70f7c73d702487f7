//! The proof that a lab works: its starter fails, its answer passes, and each played
//! student is caught and named.

use crate::lab::{Lab, Who};
use crate::run::{ENDLESS, Runner, Test};
use std::collections::BTreeSet;
use std::path::Path;
use std::time::Duration;

/// Generous, for a busy machine: only endless work meets it.
const LIMIT: Duration = Duration::from_secs(60);
/// For work that is known to be endless.
const SHORT: Duration = Duration::from_secs(1);

/// Proves `lab` for each of `cohorts`; returns what was proven, and what failed.
///
/// With `worked`, a task whose `todo!` is gone from the starter need not fail: some
/// student has been at it. `program` is the grader itself.
///
/// # Errors
/// When `program` cannot be started.
pub fn prove(
    program: &Path,
    lab: &Lab,
    cohorts: &[String],
    worked: bool,
) -> std::io::Result<(Vec<String>, Vec<String>)> {
    let mut proven = Vec::new();
    let mut failed = laid_out(lab);
    for cohort in cohorts {
        let play = |who: &Who, limit: Duration| -> std::io::Result<Vec<Test>> {
            let (program, cohort) = (program.to_path_buf(), cohort.clone());
            let runner = Runner { program, cohort, limit, echo: false };
            let runs = (1..=lab.tasks.len()).map(|task| runner.task(lab, task, who));
            Ok(runs.collect::<std::io::Result<Vec<_>>>()?.concat())
        };
        let mut note = |who: &str, trouble: Result<String, String>| match trouble {
            Ok(text) => proven.push(format!("{} {who}: {text}", lab.name)),
            Err(text) => {
                failed.push(format!("{} {who}, cohort {cohort}: {text}", lab.name))
            }
        };
        note("starter", starter_fails(lab, &play(&Who::Starter, LIMIT)?, worked));
        note("answer", passes(&play(&Who::Answer, LIMIT)?));
        for (name, _, named) in lab.kit.wrong() {
            let endless = named.contains(&ENDLESS);
            let limit = if endless { SHORT } else { LIMIT };
            let tests = play(&Who::Wrong(name.into()), limit)?;
            note(name, is_named(&tests, named.iter().map(|bug| bug.name).collect()));
        }
    }
    Ok((proven, failed))
}

/// Does every task have a check and a hint, every check a task and a name of its own,
/// and does the brief tell the right time and points?
fn laid_out(lab: &Lab) -> Vec<String> {
    let mut failed = Vec::new();
    let checks = lab.kit.checks();
    for task in 1..=lab.tasks.len() {
        if !checks.iter().any(|about| about.task == task) {
            failed.push(format!("{}: task {task} has no check", lab.name));
        }
        if lab.hints(task).is_empty() {
            failed.push(format!("{}: task {task} has no hint in the brief", lab.name));
        }
    }
    let points: u32 = checks.iter().map(|about| about.points).sum();
    for told in [
        format!("**Time.** {} minutes.", lab.minutes),
        format!("**Points.** {points}."),
    ] {
        if !lab.brief.contains(&told) {
            failed.push(format!("{}: the brief does not say `{told}`", lab.name));
        }
    }
    let names: BTreeSet<&str> = checks.iter().map(|about| about.name).collect();
    let inside = checks.iter().all(|about| (1..=lab.tasks.len()).contains(&about.task));
    if names.len() != checks.len() || !inside {
        failed
            .push(format!("{}: two checks share a name, or one has no task", lab.name));
    }
    failed
}

fn starter_fails(lab: &Lab, tests: &[Test], worked: bool) -> Result<String, String> {
    let fails = |task: usize| {
        let mut of_task = tests.iter().filter(|test| test.about.task == task);
        of_task.all(|test| !test.verdict.passed())
    };
    let n = lab.tasks.len();
    // A task that writes nothing itself is untouched while all others are.
    let untouched = |task: usize| match lab.tasks[task - 1].writes {
        Some(_) => lab.untouched(task),
        None => (1..=n).all(|t| lab.tasks[t - 1].writes.is_none() || lab.untouched(t)),
    };
    let tasks: Vec<usize> = (1..=n).filter(|&t| !worked || untouched(t)).collect();
    match tasks.iter().find(|&&task| !fails(task)) {
        Some(task) => Err(format!("passes a check of task {task}; it must fail all")),
        None => Ok(format!("fails every check of {} tasks", tasks.len())),
    }
}

fn passes(tests: &[Test]) -> Result<String, String> {
    match tests.iter().find(|test| !test.verdict.passed()) {
        Some(Test { about, verdict, .. }) => Err(format!(
            "fails `{}`: {}",
            about.name,
            verdict.message.as_deref().unwrap_or_default()
        )),
        None => Ok(format!("passes all {} checks", tests.len())),
    }
}

/// Is the work caught, and are these mistakes named and no others?
fn is_named(tests: &[Test], expected: BTreeSet<&str>) -> Result<String, String> {
    let failing: Vec<&Test> = tests.iter().filter(|t| !t.verdict.passed()).collect();
    let named: BTreeSet<&str> =
        failing.iter().filter_map(|t| t.verdict.bug).map(|bug| bug.name).collect();
    if failing.is_empty() {
        return Err("is not caught".into());
    }
    if named != expected {
        return Err(format!("expected the names {expected:?}, got {named:?}"));
    }
    let checks: Vec<&str> = failing.iter().map(|t| t.about.name).collect();
    Ok(format!(
        "caught by {}, named {}",
        checks.join(", "),
        Vec::from_iter(named).join(", ")
    ))
}
