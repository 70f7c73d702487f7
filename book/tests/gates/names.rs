//! What the pages name is there: files by their paths, and things of the program.

use book::generated::root;
use book::source::summary;
use std::collections::HashSet;
use std::fs;
use std::path::Path;

/// Folders that a path in the text may begin with, from the repository's root.
const FOLDERS: [&str; 4] = ["src", "tests", "labs", "book"];

fn repository() -> &'static Path {
    root().parent().expect("the book lies in the repository")
}

fn pages() -> Vec<(String, String)> {
    let entries = summary(include_str!("../../src/SUMMARY.md"));
    let read = |page: String| {
        let text = fs::read_to_string(root().join("src").join(&page)).unwrap();
        (page, text)
    };
    entries.into_iter().filter_map(|entry| entry.page).map(read).collect()
}

/// The code spans of a page's prose: no fences, no formulas.
fn spans(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let prose = text.split("\n```").step_by(2);
    for part in prose {
        let mut rest = part;
        while let Some((before, after)) = rest.split_once('`') {
            let Some((span, next)) = after.split_once('`') else { break };
            if !before.ends_with('$') {
                found.push(span);
            }
            rest = next;
        }
    }
    found
}

fn words_below(folder: &Path, words: &mut HashSet<String>) {
    for entry in fs::read_dir(folder).unwrap().flatten() {
        let path = entry.path();
        if path.is_dir() {
            words_below(&path, words);
        } else if path.extension().is_some_and(|end| end == "rs") {
            let text = fs::read_to_string(&path).unwrap();
            let all = text.split(|c: char| !c.is_alphanumeric() && c != '_');
            words.extend(all.map(str::to_string));
        }
    }
}

#[test]
fn files_that_pages_name_are_there() {
    let mut count = 0;
    let mut gone = Vec::new();
    for (page, text) in pages() {
        for span in spans(&text) {
            let Some((folder, _)) = span.split_once('/') else { continue };
            if FOLDERS.contains(&folder) && !span.contains([' ', '*', '…', '{']) {
                count += 1;
                if !repository().join(span).exists() {
                    gone.push(format!("{page}: there is no {span}"));
                }
            }
        }
    }
    assert!(count > 50, "only {count} paths are found");
    assert!(gone.is_empty(), "\n{}", gone.join("\n"));
}

#[test]
fn things_that_pages_name_are_there() {
    let mut words = HashSet::new();
    for folder in ["src", "tests", "labs/src", "book/code", "book/tests"] {
        words_below(&repository().join(folder), &mut words);
    }
    let is_name = |span: &str| {
        let of_a_name = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
        span.chars().all(of_a_name) && (span.contains("::") || span.contains('_'))
    };
    let mut count = 0;
    let mut gone = Vec::new();
    for (page, text) in pages() {
        for span in spans(&text).into_iter().filter(|span| is_name(span)) {
            count += 1;
            if span.split("::").any(|word| !words.contains(word)) {
                gone.push(format!("{page}: there is no `{span}` in the program"));
            }
        }
    }
    assert!(count > 80, "only {count} names are found");
    assert!(gone.is_empty(), "\n{}", gone.join("\n"));
}

#[test]
fn spans_are_read_without_fences_and_formulas() {
    let text = "`a_b` and $`f_r`$\n```rust\nlet `x_y`;\n```\nthen `c::d`";
    assert_eq!(spans(text), ["a_b", "c::d"]);
}
