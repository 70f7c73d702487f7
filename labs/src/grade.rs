//! The grade: a neutral record of what passed, and its translations.
//!
//! | format     | for                                                                |
//! |------------|--------------------------------------------------------------------|
//! | `json`     | the neutral record; all others are made from the same tests        |
//! | `gradescope` | Gradescope's autograder: its `results.json`                      |
//! | `junit`    | GitLab, Jenkins and others: JUnit XML                              |
//! | `markdown` | a summary to be read: a table and the likely mistakes              |

use crate::lab::{Lab, Who};
use crate::run::{Test, number};
use serde_json::{Value, json};

/// The tests of some labs, run on somebody's work.
pub struct Grade {
    /// Whose work.
    pub who: Who,
    /// The cohort's name.
    pub cohort: String,
    /// Each lab with its tests.
    pub labs: Vec<(&'static Lab, Vec<Test>)>,
}

/// One line of a grade: the test, its lab, and its full name.
struct Line<'a> {
    lab: &'static Lab,
    test: &'a Test,
    id: String,
}

impl Grade {
    fn lines(&self) -> impl Iterator<Item = Line<'_>> {
        self.labs.iter().flat_map(|(lab, tests)| {
            tests.iter().map(move |test| {
                let id =
                    format!("{}.{}.{}", lab.name, test.about.task, test.about.name);
                Line { lab, test, id }
            })
        })
    }

    /// Points earned, and points that can be earned.
    pub fn points(&self) -> (u32, u32) {
        self.lines().fold((0, 0), |(got, max), line| {
            (got + line.test.points(), max + line.test.about.points)
        })
    }

    /// How many tests there are.
    pub fn count(&self) -> usize {
        self.lines().count()
    }

    /// Did every test pass?
    pub fn passed(&self) -> bool {
        self.lines().all(|line| line.test.verdict.passed())
    }

    /// The neutral record: `{schema, work, cohort, points, max, tests: [{id, lab, task,
    /// title, points, max, passed, message, bug, hint, metric, tolerance, seconds}]}`.
    ///
    /// `metric` is `null` where nothing was measured: a panic, a list too short.
    pub fn json(&self) -> Value {
        let (points, max) = self.points();
        let test = |line: Line| {
            let Test { about, verdict, seconds } = line.test;
            json!({
                "id": line.id,
                "lab": line.lab.name,
                "task": about.task,
                "title": about.title,
                "points": line.test.points(),
                "max": about.points,
                "passed": verdict.passed(),
                "message": verdict.message,
                "bug": verdict.bug.map(|bug| bug.name),
                "hint": verdict.bug.map(|bug| bug.says),
                "metric": number(verdict.metric),
                "tolerance": number(verdict.tolerance),
                "seconds": seconds,
            })
        };
        json!({
            "schema": 1,
            "work": self.who.to_string(),
            "cohort": self.cohort,
            "points": points,
            "max": max,
            "tests": self.lines().map(test).collect::<Vec<_>>(),
        })
    }

    /// Gradescope's `results.json`.
    pub fn gradescope(&self) -> Value {
        let test = |line: Line| {
            json!({
                "name": line.id,
                "score": line.test.points(),
                "max_score": line.test.about.points,
                "status": if line.test.verdict.passed() { "passed" } else { "failed" },
                "output": told(line.test),
            })
        };
        let seconds: f64 = self.lines().map(|line| line.test.seconds).sum();
        json!({
            "score": self.points().0,
            "execution_time": seconds,
            "tests": self.lines().map(test).collect::<Vec<_>>(),
        })
    }

    /// JUnit XML: a suite per lab.
    pub fn junit(&self) -> String {
        let mut out =
            String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n");
        for (lab, tests) in &self.labs {
            let failed = tests.iter().filter(|t| !t.verdict.passed()).count();
            out += &format!(
                "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{failed}\">\n",
                lab.name,
                tests.len()
            );
            for test in tests {
                out += &format!(
                    "    <testcase classname=\"{}.{}\" name=\"{}\" time=\"{:.3}\"",
                    lab.name, test.about.task, test.about.name, test.seconds
                );
                out += &match &test.verdict.message {
                    None => "/>\n".to_string(),
                    Some(message) => format!(
                        ">\n      <failure message=\"{}\">{}</failure>\n    \
                         </testcase>\n",
                        escaped(message),
                        escaped(&told(test))
                    ),
                };
            }
            out += "  </testsuite>\n";
        }
        out + "</testsuites>\n"
    }

    /// A summary in Markdown.
    pub fn markdown(&self) -> String {
        let (points, max) = self.points();
        let mut out = format!(
            "## {points} of {max} points\n\nWork: `{}`. Cohort: `{}`.\n\n",
            self.who, self.cohort
        );
        out += "| test | points | deviation | tolerance |\n|---|---|---|---|\n";
        for line in self.lines() {
            let Test { about, verdict, .. } = line.test;
            let measured = if verdict.metric.is_finite() {
                format!("{:.2e} | {:.2e}", verdict.metric, verdict.tolerance)
            } else {
                "- | -".to_string()
            };
            let (got, max) = (line.test.points(), about.points);
            out += &format!("| {} | {got}/{max} | {measured} |\n", line.id);
        }
        for line in self.lines().filter(|line| !line.test.verdict.passed()) {
            out += &format!("\n- **{}** {}\n", line.id, told(line.test));
        }
        out
    }
}

/// What a failed test tells the student; the title where it passed.
fn told(test: &Test) -> String {
    let mut text = test.about.title.to_string();
    if let Some(message) = &test.verdict.message {
        text += &format!(": {message}.");
    }
    if let Some(bug) = test.verdict.bug {
        text += &format!(" {}", bug.says);
    }
    text
}

fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    // XML 1.0 has no way to write most control characters.
    let text = text.replace('"', "&quot;");
    text.chars().filter(|c| !c.is_control() || *c == '\n').collect()
}
