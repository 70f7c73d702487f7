//! `cargo lab`: lists, runs, hints and grades the labs.
//!
//! Exit code 0 when all passed, 1 when some check failed, 2 when the command was not
//! understood or matched no test.
#![forbid(unsafe_code)]

use clap::{Args, Parser, Subcommand, ValueEnum};
use labs::grade::Grade;
use labs::lab::{Lab, Who};
use labs::run::{Runner, Test, one_task};
use labs::{LABS, proof, show};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

/// The labs of the course: exercises with checks that say what is likely wrong.
#[derive(Parser)]
#[command(name = "lab", bin_name = "cargo lab")]
struct Command {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Lists the labs, or the tasks and played students of one.
    List { lab: Option<String> },
    /// Runs the checks of a lab and says what is likely wrong.
    Run {
        lab: String,
        #[command(flatten)]
        how: How,
    },
    /// Shows the hints for a task, or for all.
    Hint { lab: String, task: Option<usize> },
    /// Grades one lab, or all, into a record for other programs.
    Grade {
        lab: Option<String>,
        #[command(flatten)]
        how: How,
        /// The neutral record as JSON; the same as `--format json`.
        #[arg(long, conflicts_with = "format")]
        json: bool,
        #[arg(long, value_enum, default_value = "markdown")]
        format: Format,
        /// Writes here instead of to standard output.
        #[arg(short, long)]
        output: Option<PathBuf>,
    },
    /// Proves that starters fail, answers pass, and played students are named.
    Ci {
        /// Lets a starter pass tasks whose `todo!` is gone: a student has been at it.
        #[arg(long)]
        worked: bool,
        /// Proves it for these cohorts.
        #[arg(long, default_values = ["0", "1"])]
        cohort: Vec<String>,
    },
    /// Runs one task here: the other half of the grader.
    #[command(hide = true)]
    OneTask {
        lab: String,
        task: usize,
        #[arg(long)]
        who: String,
        #[arg(long)]
        cohort: String,
    },
}

#[derive(Args)]
struct How {
    /// Judges the answer instead of the starter.
    #[arg(long, conflicts_with = "wrong")]
    answer: bool,
    /// Plays a wrong student: see `list LAB`.
    #[arg(long, value_name = "NAME")]
    wrong: Option<String>,
    /// Varies scenes and numbers; any text.
    #[arg(long, default_value = "0", value_name = "SEED")]
    cohort: String,
    /// Only this task.
    #[arg(long)]
    task: Option<usize>,
    /// Seconds a task may take.
    #[arg(long, default_value = "10", value_parser = seconds)]
    limit: Duration,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Json,
    Gradescope,
    Junit,
    Markdown,
}

fn seconds(text: &str) -> Result<Duration, String> {
    let limit = text.parse().ok().filter(|s| (0.01..=86_400.0).contains(s));
    limit
        .map(Duration::from_secs_f64)
        .ok_or_else(|| "give seconds from 0.01 to 86400".into())
}

fn main() -> ExitCode {
    match obey(Command::parse().verb) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(trouble) => {
            eprintln!("error: {trouble}");
            ExitCode::from(2)
        }
    }
}

/// Did all pass? An error is a command that cannot be done.
fn obey(verb: Verb) -> Result<bool, String> {
    match verb {
        Verb::List { lab: None } => print!("{}", show::labs()),
        Verb::List { lab: Some(lab) } => print!("{}", show::tasks(named(&lab)?)),
        Verb::Hint { lab, task } => {
            let lab = named(&lab)?;
            let tasks = task.map_or(1..=lab.tasks.len(), |t| t..=t);
            tasks.clone().try_for_each(|t| has_task(lab, t))?;
            tasks.for_each(|t| print!("{}", show::hints(lab, t)));
        }
        Verb::Run { lab, how } => {
            let lab = named(&lab)?;
            let (who, tests) = tests(lab, &how)?;
            let text =
                show::report(lab, &who, &how.cohort, &tests, show::Paint::wished());
            print!("{text}");
            return Ok(tests.iter().all(|test| test.verdict.passed()));
        }
        Verb::Grade { lab, how, json, format, output } => {
            let format = if json { Format::Json } else { format };
            return grade(lab, &how, format, output.as_deref());
        }
        Verb::Ci { worked, cohort } => return ci(worked, &cohort),
        Verb::OneTask { lab, task, who, cohort } => {
            let who = Who::parse(&who).ok_or("whose work?")?;
            one_task(named(&lab)?, task, &who, &cohort);
        }
    }
    Ok(true)
}

fn named(name: &str) -> Result<&'static Lab, String> {
    Lab::named(name).ok_or_else(|| {
        let all: Vec<&str> = LABS.iter().map(|lab| lab.name).collect();
        format!("there is no lab `{name}`; there are: {}", all.join(", "))
    })
}

fn has_task(lab: &Lab, task: usize) -> Result<(), String> {
    let n = lab.tasks.len();
    let inside = (1..=n).contains(&task);
    inside
        .then_some(())
        .ok_or_else(|| format!("lab `{}` has tasks 1 to {n}, not {task}", lab.name))
}

/// Runs the tests asked for; there is at least one.
fn tests(lab: &Lab, how: &How) -> Result<(Who, Vec<Test>), String> {
    let who = match (&how.wrong, how.answer) {
        (Some(name), _) => Who::Wrong(name.clone()),
        (None, true) => Who::Answer,
        (None, false) => Who::Starter,
    };
    if let Who::Wrong(name) = &who
        && !lab.kit.wrong().iter().any(|(known, ..)| known == name)
    {
        let lab = lab.name;
        return Err(format!("no played student `{name}`; see `cargo lab list {lab}`"));
    }
    if let Some(task) = how.task {
        has_task(lab, task)?;
    }
    let (program, cohort, limit) = (program()?, how.cohort.clone(), how.limit);
    let runner = Runner { program, cohort, limit, echo: true };
    let mut tests = Vec::new();
    for task in how.task.map_or(1..=lab.tasks.len(), |t| t..=t) {
        let run = runner.task(lab, task, &who);
        tests.extend(run.map_err(|e| format!("cannot start the grader again: {e}"))?);
    }
    if tests.is_empty() {
        return Err(format!("lab `{}`: no test matched", lab.name));
    }
    Ok((who, tests))
}

fn program() -> Result<PathBuf, String> {
    std::env::current_exe().map_err(|e| format!("cannot find this program: {e}"))
}

fn grade(
    lab: Option<String>,
    how: &How,
    format: Format,
    output: Option<&Path>,
) -> Result<bool, String> {
    let labs =
        lab.map_or_else(|| Ok(LABS.to_vec()), |lab| named(&lab).map(|l| vec![l]))?;
    let mut grade =
        Grade { who: Who::Starter, cohort: how.cohort.clone(), labs: Vec::new() };
    for lab in labs {
        let (who, tests) = tests(lab, how)?;
        grade.who = who;
        grade.labs.push((lab, tests));
    }
    let text = match format {
        Format::Json => format!("{:#}\n", grade.json()),
        Format::Gradescope => format!("{:#}\n", grade.gradescope()),
        Format::Junit => grade.junit(),
        Format::Markdown => grade.markdown(),
    };
    match output {
        None => print!("{text}"),
        Some(path) => std::fs::write(path, text)
            .map_err(|e| format!("cannot write {}: {e}", path.display()))?,
    }
    Ok(grade.passed())
}

fn ci(worked: bool, cohorts: &[String]) -> Result<bool, String> {
    let program = program()?;
    let mut good = true;
    for lab in LABS {
        let (proven, failed) = proof::prove(&program, lab, cohorts, worked)
            .map_err(|e| format!("cannot start the grader again: {e}"))?;
        proven.iter().for_each(|text| println!("proven  {text}"));
        failed.iter().for_each(|text| println!("FAILED  {text}"));
        good &= failed.is_empty() && !proven.is_empty();
    }
    Ok(good)
}
