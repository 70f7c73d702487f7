//! The proof that a lab works: its starter fails, its answer passes, and each played
//! student is caught and named.

use crate::lab::{Lab, Who};
use crate::run::{ENDLESS, Runner, Test};
use std::collections::BTreeSet;
use std::num::NonZero;
use std::path::Path;
use std::thread;
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
        let wrong = lab.kit.wrong();
        let played = side_by_side(&wrong, |(name, _, named)| {
            let endless = named.contains(&ENDLESS);
            play(&Who::Wrong(name.to_string()), if endless { SHORT } else { LIMIT })
        });
        for ((name, _, named), tests) in wrong.iter().zip(played) {
            note(name, is_named(&tests?, named.iter().map(|bug| bug.name).collect()));
        }
    }
    Ok((proven, failed))
}

/// `f` of each item, in order, on as many threads as there are cores.
fn side_by_side<T: Sync, R: Send>(items: &[T], f: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    let share = |first: usize| {
        let mine = (first..items.len()).step_by(threads);
        mine.map(|k| (k, f(&items[k]))).collect::<Vec<_>>()
    };
    let mut done: Vec<(usize, R)> = thread::scope(|scope| {
        let spawn = |first| scope.spawn(move || share(first));
        let shares: Vec<_> = (0..threads).map(spawn).collect();
        // A share panics only where `f` does; then so does this.
        shares.into_iter().flat_map(|s| s.join().expect("no panic")).collect()
    });
    done.sort_by_key(|&(k, _)| k);
    done.into_iter().map(|(_, result)| result).collect()
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
