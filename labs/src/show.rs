//! What the student reads on the terminal.

use crate::lab::{Lab, Who};
use crate::run::Test;
use std::fmt::Write;
use std::io::IsTerminal;

/// Colours, where standard output is a terminal and `NO_COLOR` is not set.
#[derive(Clone, Copy)]
pub struct Paint(bool);

impl Paint {
    /// As the terminal and the environment wish.
    pub fn wished() -> Paint {
        Paint(std::io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none())
    }

    /// No colours.
    pub fn none() -> Paint {
        Paint(false)
    }

    fn with(self, code: &str, text: &str) -> String {
        if self.0 { format!("\u{1b}[{code}m{text}\u{1b}[0m") } else { text.into() }
    }

    fn good(self, text: &str) -> String {
        self.with("1;34", text) // blue and orange: told apart by colour-blind eyes too
    }

    fn bad(self, text: &str) -> String {
        self.with("1;33", text)
    }

    fn strong(self, text: &str) -> String {
        self.with("1", text)
    }
}

/// The labs, one a line.
pub fn labs() -> String {
    let mut out = String::new();
    for lab in crate::LABS {
        let (tasks, minutes) = (lab.tasks.len(), lab.minutes);
        let points: u32 = lab.kit.checks().iter().map(|about| about.points).sum();
        out += &format!(
            "{:<12} {} ({tasks} tasks, {minutes} min, {points} points)\n",
            lab.name, lab.title
        );
        out += &format!("             read {}   edit {}\n", lab.page(), lab.starter);
    }
    out + "\n`cargo lab list LAB` shows a lab's tasks and its played students.\n"
}

/// The tasks of a lab, its checks and its played students.
pub fn tasks(lab: &Lab) -> String {
    let mut out = format!("{}: {}\n\n", lab.name, lab.title);
    for (k, task) in lab.tasks.iter().enumerate() {
        let writes = task.writes.map(|name| format!(": `{name}`")).unwrap_or_default();
        out += &format!("task {}  {}{writes}\n", k + 1, task.title);
        for about in lab.kit.checks().iter().filter(|about| about.task == k + 1) {
            out += &format!("        {} ({})\n", about.title, points(about.points));
        }
    }
    out += "\nPlayed students, for `--wrong NAME`:\n";
    for (name, thought, _) in lab.kit.wrong() {
        out += &format!("  {name:<18} {thought}\n");
    }
    out
}

/// What became of each test, task by task, and what to do next.
pub fn report(
    lab: &Lab,
    who: &Who,
    cohort: &str,
    tests: &[Test],
    paint: Paint,
) -> String {
    let mut out = format!("{}: {}", lab.name, lab.title);
    out += &match who {
        Who::Starter => format!("   ({}, cohort {cohort})\n", lab.starter),
        _ => format!("   ({who}, cohort {cohort})\n"),
    };
    let mut named: Vec<&str> = Vec::new();
    let mut task = 0;
    for test in tests {
        if test.about.task != task {
            task = test.about.task;
            let title = format!("\ntask {task}  {}\n", lab.tasks[task - 1].title);
            out += &paint.strong(&title);
        }
        out += &line(test, &mut named, paint);
    }
    let got: u32 = tests.iter().map(Test::points).sum();
    let max: u32 = tests.iter().map(|test| test.about.points).sum();
    let _ = writeln!(out, "\n{got} of {max} points.");
    let all = tests.iter().all(|test| test.verdict.passed());
    let first = tests.iter().find(|test| !test.verdict.passed());
    match first {
        Some(test) => {
            let task = test.about.task;
            let _ = writeln!(
                out,
                "Next: task {task}. `cargo lab hint {} {task}`",
                lab.name
            );
        }
        None if all && matches!(who, Who::Starter) => {
            out += "All passed. Read the hints once more: they say why it works.\n";
            let done = |task: &usize| tests.iter().any(|t| t.about.task == *task);
            for task in (1..=lab.tasks.len()).filter(done) {
                out += &hints(lab, task);
            }
            let _ = writeln!(out, "\nThen the report question: {}", lab.page());
        }
        None => {}
    }
    out
}

fn line(test: &Test, named: &mut Vec<&'static str>, paint: Paint) -> String {
    let Test { about, verdict, .. } = test;
    let Some(message) = &verdict.message else {
        let (metric, tolerance) = (verdict.metric, verdict.tolerance);
        let margin = if tolerance > 0.0 {
            format!("   (off by {metric:.1e}, allowed {tolerance:.1e})")
        } else {
            String::new()
        };
        return format!("  {} {}{margin}\n", paint.good("pass"), about.title);
    };
    let mut out =
        format!("  {} {}\n       {message}\n", paint.bad("FAIL"), about.title);
    if verdict.metric.is_finite() {
        let _ = writeln!(
            out,
            "       off by {:.1e}, allowed {:.1e}",
            verdict.metric, verdict.tolerance
        );
    }
    match verdict.bug {
        Some(bug) if named.contains(&bug.name) => {
            let _ =
                writeln!(out, "       likely bug: the same as above ({})", bug.name);
        }
        Some(bug) => {
            named.push(bug.name);
            let says = paint.strong(bug.says);
            let _ = writeln!(out, "       likely bug: {says} [{}]", bug.name);
        }
        None => {}
    }
    out
}

/// The hints for a task, as plain text.
pub fn hints(lab: &Lab, task: usize) -> String {
    let mut out = format!("\nHints for task {task}, {}:\n", lab.tasks[task - 1].title);
    for (k, hint) in lab.hints(task).into_iter().enumerate() {
        out += if k > 0 { "\n" } else { "" };
        for line in hint.lines() {
            let _ = writeln!(out, "  {line}");
        }
    }
    out
}

fn points(n: u32) -> String {
    if n == 1 { "1 point".into() } else { format!("{n} points") }
}
