//! Gates over the book's Markdown: what mdBook accepts in silence and a reader would not.
//!
//! Each gate takes a page and returns sentences, one for each fault; none means fit.

use std::fs;
use std::path::Path;

/// The sections of a written chapter, in order.
pub const SECTIONS: [&str; 13] = [
    "The question",
    "The idea",
    "The definition",
    "The code",
    "Run it",
    "Where it fails",
    "What it costs",
    "When to use it",
    "Check yourself",
    "The lab",
    "Lecturer's notes",
    "Sources and history",
    "The energy ledger",
];

/// The longest line of code that a projector shows, in columns.
pub const COLUMNS: usize = 88;

/// The longest listing that carries one step of an argument, in lines.
pub const LISTING: usize = 12;

/// A line of `SUMMARY.md`.
#[derive(Debug, PartialEq)]
pub struct Entry {
    /// What the sidebar calls the page.
    pub title: String,
    /// Where the page is, relative to `book/src`; `None` for a draft.
    pub page: Option<String>,
}

/// The pages of `SUMMARY.md`, in order.
pub fn summary(text: &str) -> Vec<Entry> {
    let entry = |line: &str| {
        let line = line.trim().trim_start_matches("- ").strip_prefix('[')?;
        let (title, rest) = line.split_once("](")?;
        let page = Some(rest.strip_suffix(')')?.to_string()).filter(|p| !p.is_empty());
        Some(Entry { title: title.to_string(), page })
    };
    text.lines().filter_map(entry).collect()
}

/// A fenced block.
#[derive(Debug, PartialEq)]
pub struct Fence {
    /// Line of the opening fence, from 1.
    pub line: usize,
    /// What stands behind the opening backquotes.
    pub info: String,
    /// The lines between the fences.
    pub body: Vec<String>,
}

impl Fence {
    /// Is the block compiled and run by `cargo test` and `mdbook test`?
    pub fn runs(&self) -> bool {
        let mut tags = self.info.split(',').map(str::trim);
        let not_run = ["ignore", "no_run", "compile_fail"];
        tags.next() == Some("rust") && !tags.any(|tag| not_run.contains(&tag))
    }
}

/// All fenced blocks of a page.
pub fn fences(text: &str) -> Vec<Fence> {
    let mut found: Vec<Fence> = Vec::new();
    let mut open = false;
    for (index, line) in text.lines().enumerate() {
        match (open, line.trim_start().strip_prefix("```")) {
            (false, Some(info)) => {
                let info = info.trim().to_string();
                found.push(Fence { line: index + 1, info, body: Vec::new() });
                open = true;
            }
            (true, Some(_)) => open = false,
            (true, None) => found.last_mut().unwrap().body.push(line.to_string()),
            (false, None) => {}
        }
    }
    found
}

/// Every `{{#include}}` of a page, as the path and anchor between its braces.
pub fn includes(text: &str) -> Vec<&str> {
    let after = text.split("{{#include ").skip(1);
    after.filter_map(|rest| Some(rest.split_once("}}")?.0.trim())).collect()
}

/// What `{{#include target}}` shows on a page that lies in `folder`.
///
/// # Errors
/// When the file or the anchor is missing, when the selection is blank, and when lines
/// are selected by number: numbers shift, anchors stay.
pub fn included(folder: &Path, target: &str) -> Result<String, String> {
    let (file, anchor) = target.split_once(':').unwrap_or((target, ""));
    let text = fs::read_to_string(folder.join(file))
        .map_err(|error| format!("include {target}: {error}"))?;
    if anchor.starts_with(|c: char| c.is_ascii_digit() || c == ':') {
        return Err(format!("include {target}: select by anchor, not by line number"));
    }
    let marks = |line: &str, mark: &str| {
        line.split_once(mark).is_some_and(|(_, name)| name.trim() == anchor)
    };
    let lines: Vec<&str> = if anchor.is_empty() {
        text.lines().collect()
    } else {
        let start = text.lines().position(|line| marks(line, "ANCHOR:"));
        let end = text.lines().position(|line| marks(line, "ANCHOR_END:"));
        let (Some(start), Some(end)) = (start, end) else {
            return Err(format!("include {target}: no such anchor"));
        };
        let inside = text.lines().take(end).skip(start + 1);
        inside.filter(|line| !line.contains("ANCHOR")).collect()
    };
    if lines.iter().all(|line| line.trim().is_empty()) {
        return Err(format!("include {target}: selects nothing"));
    }
    Ok(lines.join("\n"))
}

/// The faults of one page; `folder` is where it lies, includes being relative to it.
pub fn faults(folder: &Path, text: &str) -> Vec<String> {
    let mut faults: Vec<String> = Vec::new();
    let helpers = text.matches("{{#").count();
    let targets = includes(text);
    if helpers != targets.len() {
        faults.push("a {{# that is no complete {{#include}}".into());
    }
    for target in targets {
        match included(folder, target) {
            Err(fault) => faults.push(fault),
            Ok(shown) if target.ends_with(".svg") && !shown.contains("<title") => {
                faults.push(format!("{target}: a picture without <title>"));
            }
            Ok(_) => {}
        }
    }
    faults.extend(text.lines().filter_map(|line| {
        let (alt, _) = line.split_once("![")?.1.split_once(']')?;
        alt.trim().is_empty().then(|| format!("a picture without alt text: {line}"))
    }));
    let math = |line: &&str| line.starts_with('#') && line.contains("$`");
    faults.extend(text.lines().filter(math).map(|l| format!("math in a heading: {l}")));
    faults.extend(fences(text).iter().flat_map(|fence| fence_faults(folder, fence)));
    faults
}

fn fence_faults(folder: &Path, fence: &Fence) -> Vec<String> {
    let mut faults = Vec::new();
    let at = format!("fence at line {}", fence.line);
    if fence.info.is_empty() {
        faults.push(format!("{at}: no tag, so it would be run as Rust"));
    }
    let body = fence.body.join("\n");
    let listing = includes(&body);
    if fence.info.contains("ignore") {
        if listing.len() != 1 || fence.body.len() != 1 {
            faults.push(format!("{at}: `ignore` is for listings by include alone"));
        }
        if listing.iter().any(|target| !target.contains(':')) {
            faults.push(format!("{at}: a listing names its anchor"));
        }
    }
    let linked = body.contains("# extern crate radiosity;");
    if fence.runs() && body.contains("radiosity::") && !linked {
        faults.push(format!("{at}: the example lacks `# extern crate radiosity;`"));
    }
    for shown in listing.iter().filter_map(|target| included(folder, target).ok()) {
        faults.extend(too_wide(&at, &shown));
    }
    faults.extend(too_wide(&at, &body));
    faults
}

fn too_wide(at: &str, code: &str) -> Option<String> {
    let widest = code.lines().map(|line| line.chars().count()).max()?;
    (widest > COLUMNS).then(|| format!("{at}: {widest} columns, more than {COLUMNS}"))
}

/// The faults of a page as a written chapter: sections, listings, picture, example,
/// minutes.
pub fn chapter_faults(folder: &Path, text: &str) -> Vec<String> {
    let mut faults = Vec::new();
    let headings: Vec<&str> =
        text.lines().filter_map(|line| line.strip_prefix("## ")).collect();
    if headings != SECTIONS {
        faults.push(format!("sections are {headings:?}; they must be {SECTIONS:?}"));
    }
    for fence in fences(text).iter().filter(|fence| fence.info.contains("ignore")) {
        let body = fence.body.join("\n");
        for shown in includes(&body).iter().filter_map(|t| included(folder, t).ok()) {
            let (at, lines) = (fence.line, shown.lines().count());
            if lines > LISTING {
                let fault = format!("line {at}: {lines} lines; one reads {LISTING}");
                faults.push(fault);
            }
        }
    }
    if !text.contains(".snap.png") {
        faults.push("no snapshot picture (pictures/*.snap.png)".into());
    }
    if !fences(text).iter().any(Fence::runs) {
        faults.push("no tested example".into());
    }
    let notes = text.split("## Lecturer's notes").nth(1).unwrap_or("");
    if !notes.contains("class=\"lecturer\"") || !notes.contains(" min") {
        faults.push("no lecturer's notes with minutes".into());
    }
    faults
}
