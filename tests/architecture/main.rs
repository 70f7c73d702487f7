//! The rules of the house: who may use whom, how long a file is, what a header says,
//! and where nothing may panic.

mod one_of_each;
mod order;
mod sizes;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All Rust files under a folder of the repository, or the file itself, in order.
///
/// # Panics
/// Where there is none: a rule that holds of nothing guards nothing.
fn rust_files(under: impl AsRef<Path>) -> Vec<PathBuf> {
    let path = root().join(under);
    let files = files_below(&path);
    assert!(!files.is_empty(), "no Rust file at {}", path.display());
    files
}

/// The same; there may be none, as in a folder of pictures.
fn files_below(path: &Path) -> Vec<PathBuf> {
    if path.is_file() {
        return path
            .extension()
            .filter(|x| *x == "rs")
            .map(|_| path.into())
            .into_iter()
            .collect();
    }
    let Ok(entries) = fs::read_dir(path) else { return vec![] };
    let mut paths: Vec<PathBuf> = entries.map(|e| e.unwrap().path()).collect();
    paths.sort();
    paths.iter().flat_map(|path| files_below(path)).collect()
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn name(path: &Path) -> String {
    path.strip_prefix(root()).unwrap_or(path).display().to_string()
}

/// The modules of the crate in the order of `lib.rs`.
fn modules() -> Vec<String> {
    let lib = read(&root().join("src/lib.rs"));
    let module =
        |line: &str| Some(line.strip_prefix("pub mod ")?.strip_suffix(';')?.into());
    lib.lines().filter_map(module).collect()
}

fn files_of(module: &str) -> Vec<PathBuf> {
    let places = [format!("src/{module}.rs"), format!("src/{module}")];
    let files: Vec<PathBuf> =
        places.iter().flat_map(|place| files_below(&root().join(place))).collect();
    assert!(!files.is_empty(), "`{module}` has no source");
    files
}

/// The file that holds a module's header.
fn head_of(module: &str) -> PathBuf {
    let file = root().join(format!("src/{module}.rs"));
    if file.is_file() { file } else { root().join(format!("src/{module}/mod.rs")) }
}

/// Lines that are code, with their numbers from 1: no comments, no tests at the end.
fn code(source: &str) -> impl Iterator<Item = (usize, &str)> {
    let lines = source.lines().enumerate().map(|(k, line)| (k + 1, line));
    let lines = lines.take_while(|(_, line)| line.trim() != "#[cfg(test)]");
    lines.filter(|(_, line)| !line.trim_start().starts_with("//"))
}

/// Where `source` names a module of `later` by way of `crate::` or `super::`.
fn upward_use(source: &str, later: &[String]) -> Option<(usize, String)> {
    for (number, line) in code(source) {
        // `use crate::{a, b}` would hide the names from a search this simple.
        if line.contains("crate::{") {
            return Some((number, line.trim().into()));
        }
        for start in ["crate::", "super::"] {
            for (at, _) in line.match_indices(start) {
                let rest = &line[at + start.len()..];
                let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
                let used = &rest[..end.unwrap_or(rest.len())];
                if later.iter().any(|module| module == used) {
                    return Some((number, line.trim().into()));
                }
            }
        }
    }
    None
}

/// A module may use only the modules listed above it in `lib.rs`: whoever reads from
/// the top never meets what has not been explained.
#[test]
fn modules_depend_downward_only() {
    let order = modules();
    assert!(order.len() >= 12, "{order:?}");
    for (k, module) in order.iter().enumerate() {
        for file in files_of(module) {
            if let Some((line, text)) = upward_use(&read(&file), &order[k + 1..]) {
                panic!("{}:{line}: `{module}` looks upward: {text}", name(&file));
            }
        }
    }
}

#[test]
fn a_planted_upward_use_is_caught() {
    let later = ["solve".to_string(), "film".to_string()];
    for planted in [
        "use crate::solve::Shoot;",
        "    let x = crate::film::byte(0.5);",
        "use super::film;",
        "use crate::{geometry, solve};",
    ] {
        assert!(upward_use(planted, &later).is_some(), "{planted}");
    }
    for sound in [
        "use crate::geometry::Rgb;",
        "/// As [`crate::solve`] does.",
        "use crate::solver_of_puzzles::x;",
        "#[cfg(test)]\nuse crate::solve::Shoot;",
    ] {
        assert!(upward_use(sound, &later).is_none(), "{sound}");
    }
}

/// What it is, a formula, the methods with their use, what is not here, the place in
/// the course, the sources.
#[test]
fn every_module_header_has_its_six_parts() {
    let mut lacking = Vec::new();
    for module in modules() {
        let file = head_of(&module);
        let source = read(&file);
        let header: Vec<&str> =
            source.lines().map_while(|line| line.strip_prefix("//!")).collect();
        let has = |part: &str| header.iter().any(|line| line.contains(part));
        let first = header.first().is_some_and(|line| line.trim().len() > 20);
        let table = header.iter().any(|line| line.starts_with(" |--"));
        let place = has("(L") && has("Chapter") || has("Beyond the lecture");
        for (part, there) in [
            ("what it is", first),
            ("a formula in a ```text fence", has("```text")),
            ("a table of what to use when", table),
            ("**Not here:**", has("**Not here:**")),
            ("its chapters with lectures, (L..), or that it is beyond", place),
            ("Sources:", has("Sources:") || has("Source:")),
        ] {
            if !there {
                lacking.push(format!("{} lacks {part}", name(&file)));
            }
        }
    }
    assert!(lacking.is_empty(), "{}", lacking.join("\n"));
}

#[test]
fn nothing_is_unsafe_ignored_or_unwritten() {
    assert!(read(&root().join("src/lib.rs")).contains("#![forbid(unsafe_code)]"));
    let banned = [
        ("src", &["unsafe {", "unsafe fn", "todo!", "unimplemented!"][..]),
        ("tests", &["#[ignore"]),
        ("src", &["#[ignore"]),
        ("book", &["#[ignore", "todo!", "unimplemented!"]),
        ("labs", &["#[ignore"]),
    ];
    for (folder, words) in banned {
        for file in rust_files(folder) {
            if file.ends_with("tests/architecture/main.rs") {
                continue; // it names them
            }
            for (line, text) in read(&file).lines().enumerate() {
                if let Some(word) = words.iter().find(|word| text.contains(**word)) {
                    panic!("{}:{}: {word}", name(&file), line + 1);
                }
            }
        }
    }
}

/// What a file or an argument can reach must not panic; each exception says why it
/// holds.
#[test]
fn input_cannot_make_it_panic() {
    let allowed = [
        ("src/scene/builtin/mod.rs", "0.5 is passive"),
        ("src/scene/builtin/mod.rs", "built-in materials are passive"),
        ("src/scene/builtin/mod.rs", "built-in scenes are sound"),
        ("src/geometry/polygon.rs", "a polygon has three or more corners"),
        ("src/geometry/polygon.rs", "vertices.len() > 1"),
        ("src/film/draw.rs", "no sheet of"), // sizes are checked by the command
    ];
    let words = [".unwrap()", ".expect(", "panic!(", "unreachable!("];
    let folders = ["obj", "geometry", "scene", "material", "film", "command"];
    let files = folders.into_iter().flat_map(files_of).chain(rust_files("src/main.rs"));
    let mut used = BTreeSet::new();
    for file in files {
        let source = read(&file);
        for (line, text) in code(&source) {
            let excuse = allowed
                .iter()
                .position(|(f, why)| name(&file) == *f && text.contains(why));
            used.extend(excuse);
            let excused = excuse.is_some();
            for word in words.iter().filter(|word| text.contains(**word)) {
                assert!(excused, "{}:{line}: {word} in {}", name(&file), text.trim());
            }
        }
    }
    assert_eq!(used.len(), allowed.len(), "an excuse that nobody needs: {used:?}");
}

/// rays asks `ways`, all others ask the material. Only files and built-in scenes name it.
#[test]
fn only_ways_reads_what_shines() {
    let may =
        ["material", "ways", "obj", "scene/builtin", "chart/suites/directional.rs"];
    let named = |file: &PathBuf| {
        let source = read(file);
        code(&source)
            .any(|(_, line)| line.replace("Shine::default", "").contains("Shine::"))
    };
    let files: Vec<String> =
        rust_files("src").iter().filter(|file| named(file)).map(|f| name(f)).collect();
    assert!(files.contains(&"src/ways/mod.rs".into()), "{files:?}");
    for file in files {
        let path = file.trim_start_matches("src/");
        assert!(may.iter().any(|m| path.starts_with(m)), "{file} reads `Shine`");
    }
}
