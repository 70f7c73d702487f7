//! The gates over the book's sources: nothing missing, nothing stale, nothing untested.

use book::generated;
use book::lecture_map::{ROWS, State};
use book::source::{self, Entry, Fence};
use std::fs;
use std::path::PathBuf;

/// How many examples the pages run. Raise it with each new one; it never falls.
const EXAMPLES: usize = 104;

fn src(page: &str) -> PathBuf {
    generated::root().join("src").join(page)
}

fn read(page: &str) -> String {
    fs::read_to_string(src(page)).unwrap_or_else(|error| panic!("{page}: {error}"))
}

fn entries() -> Vec<Entry> {
    source::summary(&read("SUMMARY.md"))
}

fn pages() -> Vec<String> {
    let pages: Vec<String> =
        entries().into_iter().filter_map(|entry| entry.page).collect();
    assert!(!pages.is_empty(), "the summary names no page");
    pages
}

fn all_fit(faults: Vec<String>) {
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn every_page_is_fit_to_print() {
    let faults_of = |page: String| {
        let folder = src(&page).parent().unwrap().to_path_buf();
        let faults = source::faults(&folder, &read(&page));
        faults.into_iter().map(move |fault| format!("{page}: {fault}"))
    };
    all_fit(pages().into_iter().flat_map(faults_of).collect());
}

#[test]
fn every_page_is_run_by_cargo_test() {
    let lib = fs::read_to_string(generated::root().join("code/lib.rs")).unwrap();
    let missing = pages().into_iter().filter(|p| !lib.contains(&format!(": \"{p}\",")));
    all_fit(missing.map(|p| format!("{p} is not in `pages!` of lib.rs")).collect());
}

#[test]
fn no_example_is_lost() {
    let runs = |page: &String| {
        source::fences(&read(page)).iter().filter(|fence| Fence::runs(fence)).count()
    };
    let count: usize = pages().iter().map(runs).sum();
    assert!(count >= EXAMPLES, "{count} examples run, {EXAMPLES} did before");
}

#[test]
fn generated_files_are_fresh() {
    let files = generated::files();
    assert!(!files.is_empty(), "nothing is generated");
    let stale = files
        .into_iter()
        .filter(|(path, text)| fs::read_to_string(path).ok().as_ref() != Some(text));
    let say = |(path, _): (PathBuf, _)| {
        format!("{} is stale: cargo run -p book --bin generate", path.display())
    };
    all_fit(stale.map(say).collect());
}

/// What follows `mark` in `text`, each time, up to `end`.
fn after<'t>(text: &'t str, mark: &'t str, end: char) -> impl Iterator<Item = &'t str> {
    text.split(mark).skip(1).filter_map(move |rest| rest.split(end).next())
}

/// Each entry is cited by a page, each citation has its entry, and in each part years
/// ascend; what is kept on-line has none and comes last.
#[test]
fn the_bibliography_is_cited_and_in_order() {
    const FILE: &str = "bibliography.md";
    let entries = read(FILE);
    let others = pages().into_iter().filter(|page| page != FILE);
    let citing: String = others.map(|page| read(&page)).collect();
    let mut cited: Vec<&str> = after(&citing, "bibliography.md#", ')').collect();
    let mut faults = Vec::new();
    for part in entries.split("\n## ") {
        let mut before = 0;
        for key in after(part, "<a id=\"", '"') {
            let year = key.rsplit('-').next().and_then(|year| year.parse().ok());
            let year = year.unwrap_or(u32::MAX);
            if year < before {
                faults.push(format!("{key} is older than what stands before it"));
            }
            if !cited.contains(&key) {
                faults.push(format!("{key} is cited by no page"));
            }
            cited.retain(|other| *other != key);
            before = year;
        }
    }
    faults.extend(cited.iter().map(|key| format!("{key} is not in the bibliography")));
    assert!(entries.matches("<a id").count() > 60, "the entries are not found");
    all_fit(faults);
}

#[test]
fn the_summary_follows_the_lecture() {
    let entries = entries();
    let mut chapters =
        entries.iter().filter(|entry| ROWS.iter().any(|row| row.title == entry.title));
    let mut before: Option<&Entry> = None;
    for row in &ROWS {
        // Rows of one title share a page.
        let shared = before.filter(|entry| entry.title == row.title);
        let entry = shared.or_else(|| chapters.next());
        before = entry;
        let entry = entry.unwrap_or_else(|| panic!("{}: missing", row.title));
        assert_eq!(entry.title, row.title, "chapters are not in the lecture's order");
        let page = match &row.state {
            State::Planned => None,
            State::Done(written) => Some(written.page),
        };
        assert_eq!(entry.page.as_deref(), page, "{}: draft or written?", row.title);
    }
}

#[test]
fn a_row_marked_done_has_page_figure_and_test() {
    let repository = generated::root().parent().unwrap();
    all_fit(ROWS.iter().flat_map(|row| row.faults(repository)).collect());
}
