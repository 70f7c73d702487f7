//! What a lab consists of, and whose work is judged.

use crate::check::{Bug, Verdict};
use radiosity::random::Stream;
use std::fmt;

/// One lab.
pub struct Lab {
    /// Its name on the command line, in the `todo!`s of its starter, and of its page; with
    /// `_` for `-` also that of its folder.
    pub name: &'static str,
    /// Its title.
    pub title: &'static str,
    /// How long a student should need.
    pub minutes: u32,
    /// The brief: the text of the book's page.
    pub brief: &'static str,
    /// The file that the student edits, from the root of the repository.
    pub starter: &'static str,
    /// The text of that file.
    pub source: &'static str,
    /// What is to be done, in order.
    pub tasks: &'static [Task],
    /// The work and the checks.
    pub kit: &'static dyn Kit,
}

/// One task of a lab.
pub struct Task {
    /// What is to be done.
    pub title: &'static str,
    /// The function to write; `None` when the task only tries the others together.
    pub writes: Option<&'static str>,
}

/// Whose work is judged.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Who {
    /// The student's: `starter.rs` as it stands.
    Starter,
    /// The answer's.
    Answer,
    /// That of a played student, by name.
    Wrong(String),
}

impl fmt::Display for Who {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Who::Starter => write!(f, "starter"),
            Who::Answer => write!(f, "answer"),
            Who::Wrong(name) => write!(f, "wrong:{name}"),
        }
    }
}

impl Who {
    /// The inverse of `to_string`.
    pub fn parse(text: &str) -> Option<Who> {
        match text {
            "starter" => Some(Who::Starter),
            "answer" => Some(Who::Answer),
            _ => text.strip_prefix("wrong:").map(|name| Who::Wrong(name.into())),
        }
    }
}

/// What is known of a check without running it.
#[derive(Clone, Copy, Debug)]
pub struct About {
    /// Which task it belongs to, from 1.
    pub task: usize,
    /// Its name, unique within the lab.
    pub name: &'static str,
    /// What must hold: a sentence without full stop.
    pub title: &'static str,
    /// Points for passing.
    pub points: u32,
}

/// A check of some work of type `W`.
pub struct Check<W> {
    /// What it is about.
    pub about: About,
    /// Judges the work. Scenes and numbers are drawn from the cohort's stream.
    pub run: fn(&W, &mut Stream) -> Verdict,
}

/// A [`Check`] in one line.
pub const fn check<W>(
    task: usize,
    name: &'static str,
    title: &'static str,
    points: u32,
    run: fn(&W, &mut Stream) -> Verdict,
) -> Check<W> {
    Check { about: About { task, name, title, points }, run }
}

/// A played student: the answer with one mistake.
pub struct Wrong<W> {
    /// Its name on the command line.
    pub name: &'static str,
    /// What the student thought.
    pub thought: &'static str,
    /// The mistakes that the checks must name: these and no others.
    pub named: &'static [Bug],
    /// The work handed in.
    pub work: W,
}

/// A [`Wrong`] in one line.
pub const fn plays<W>(
    name: &'static str,
    thought: &'static str,
    named: &'static [Bug],
    work: W,
) -> Wrong<W> {
    Wrong { name, thought, named, work }
}

/// The work and the checks of one lab; `W` is its contract, a table of functions.
pub struct Works<W: 'static> {
    /// The student's.
    pub starter: W,
    /// The answer's.
    pub answer: W,
    /// Those of the played students, in groups.
    pub wrong: &'static [&'static [Wrong<W>]],
    /// The checks, in order of tasks.
    pub checks: &'static [Check<W>],
}

/// [`Works`] of any contract.
pub trait Kit: Sync {
    /// The checks, in order of tasks.
    fn checks(&self) -> Vec<About>;
    /// The played students: name, thought, and the mistakes to be named.
    fn wrong(&self) -> Vec<(&'static str, &'static str, &'static [Bug])>;
    /// Runs check `index` on somebody's work; `None` when there is none of either.
    fn run(&self, who: &Who, index: usize, stream: &mut Stream) -> Option<Verdict>;
}

impl<W> Works<W> {
    fn played(&self) -> impl Iterator<Item = &'static Wrong<W>> {
        self.wrong.iter().flat_map(|group| group.iter())
    }
}

impl<W: Sync> Kit for Works<W> {
    fn checks(&self) -> Vec<About> {
        self.checks.iter().map(|check| check.about).collect()
    }

    fn wrong(&self) -> Vec<(&'static str, &'static str, &'static [Bug])> {
        self.played().map(|w| (w.name, w.thought, w.named)).collect()
    }

    fn run(&self, who: &Who, index: usize, stream: &mut Stream) -> Option<Verdict> {
        let work = match who {
            Who::Starter => &self.starter,
            Who::Answer => &self.answer,
            Who::Wrong(name) => &self.played().find(|w| w.name == name)?.work,
        };
        Some((self.checks.get(index)?.run)(work, stream))
    }
}

/// Whose work an example is to run: the student's, or the answer's when the command line
/// has an argument.
pub fn chosen<'a, W>(starter: &'a W, answer: &'a W) -> &'a W {
    if std::env::args().len() > 1 { answer } else { starter }
}

impl Lab {
    /// The lab of this name.
    pub fn named(name: &str) -> Option<&'static Lab> {
        crate::LABS.iter().copied().find(|lab| lab.name == name)
    }

    /// The page of the brief, from the root of the repository.
    pub fn page(&self) -> String {
        format!("book/src/labs/{}.md", self.name)
    }

    /// The hints for `task` (from 1): the brief's `<details>` whose summary names it.
    pub fn hints(&self, task: usize) -> Vec<&'static str> {
        let head = format!("<summary>Hint for task {task}");
        let hint = |details: &'static str| {
            let (summary, rest) = details.split_once("</summary>")?;
            let (body, _) = rest.split_once("</details>")?;
            (summary.trim() == head).then(|| body.trim())
        };
        self.brief.split("<details>").skip(1).filter_map(hint).collect()
    }

    /// Does the starter still hold the `todo!` of `task`?
    pub fn untouched(&self, task: usize) -> bool {
        self.source.contains(&format!("todo!(\"{}, task {task}:", self.name))
    }
}
