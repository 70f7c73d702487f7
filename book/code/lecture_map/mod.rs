//! The lecture map: which page, figure, test and lab stands for which row of the lecture.
//!
//! [`ROWS`] is the data; [`page`] writes it as the book's appendix, and
//! [`Row::faults`] holds every claim in it against the files.

mod rows;

pub use rows::ROWS;

use crate::source;
use std::fs;
use std::path::{Path, PathBuf};

/// One row of the lecture.
pub struct Row {
    /// What the lecture treats there.
    pub topic: &'static str,
    /// The chapter's title in `SUMMARY.md`.
    pub title: &'static str,
    /// Does the lecture set a lab here?
    pub lab: bool,
    /// What there is of it.
    pub state: State,
}

/// How far a row has come.
pub enum State {
    /// The chapter is yet to be written.
    Planned,
    /// Written, drawn and tested.
    Done(Written),
}

/// Where the parts of a written row are, as paths from the repository's root, the pages
/// and pictures as paths from `book/src`.
pub struct Written {
    /// The chapter.
    pub page: &'static str,
    /// The module that does what the chapter says.
    pub module: &'static str,
    /// A figure of the chapter, made by the code.
    pub figure: &'static str,
    /// A test of the method: file and function.
    pub test: (&'static str, &'static str),
    /// The lab's brief, where there is one.
    pub lab: Option<&'static str>,
}

impl Row {
    /// What a row claims and the files do not hold; `root` is the repository's.
    pub fn faults(&self, root: &Path) -> Vec<String> {
        let State::Done(written) = &self.state else { return Vec::new() };
        let src = root.join("book/src");
        let read = |path: PathBuf| fs::read_to_string(path).unwrap_or_default();
        let text = read(src.join(written.page));
        let folder = src.join(written.page);
        let mut faults = source::chapter_faults(folder.parent().unwrap_or(&src), &text);
        if !src.join(written.figure).is_file() || !text.contains(written.figure) {
            faults.push(format!("the page does not show {}", written.figure));
        }
        if !root.join(written.module).exists() {
            faults.push(format!("no module {}", written.module));
        }
        let (file, name) = written.test;
        if !read(root.join(file)).contains(&format!("fn {name}(")) {
            faults.push(format!("no test `{name}` in {file}"));
        }
        if let Some(lab) = written.lab
            && !(self.lab && src.join(lab).is_file() && text.contains(lab))
        {
            faults.push(format!("no lab {lab}, or the page does not link it"));
        }
        faults.into_iter().map(|fault| format!("{}: {fault}", self.title)).collect()
    }
}

/// The appendix, as Markdown.
pub fn page() -> String {
    let done = ROWS.iter().filter(|row| matches!(row.state, State::Done(_))).count();
    let mut text = format!(
        "# Lecture map\n\n<!-- Written by `cargo run -p book --bin generate`. -->\n\n\
         The course follows one university lecture, row by row. **{done} of {} rows** \
         are written; the others say so.\n\n\
         | row | the lecture's topic, and the chapter | code, figure, test | lab |\n\
         |---|---|---|---|\n",
        ROWS.len()
    );
    for (index, row) in ROWS.iter().enumerate() {
        text.push_str(&line(index + 1, row));
    }
    text
}

fn line(number: usize, row: &Row) -> String {
    let lab = match (&row.state, row.lab) {
        (State::Done(Written { lab: Some(page), .. }), _) => format!("[brief]({page})"),
        (_, true) => "not written".into(),
        (_, false) => "—".into(),
    };
    let start = format!("| L{number:02} | {}:<br>", row.topic);
    match &row.state {
        State::Planned => {
            format!("{start} *{}*, not written | | {lab} |\n", row.title)
        }
        State::Done(Written { page, module, figure, test: (file, name), .. }) => {
            format!(
                "{start} [{}]({page}) | `{module}`,<br>[a figure]({figure}),<br>\
                 `{name}` in<br>`{file}` | {lab} |\n",
                row.title
            )
        }
    }
}
