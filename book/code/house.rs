//! The appendix *The house*: the modules in their order and who uses whom, read from the
//! source itself.
//!
//! [`Module`] is one line of `src/lib.rs`, `svg` draws all with an arc for each use, and
//! `table` says what each is and which chapter explains it.

use crate::generated::root;
use crate::source::{Entry, summary};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

/// One module of the crate.
pub struct Module {
    /// As `lib.rs` names it.
    pub name: String,
    /// Its file or folder, from the repository's root.
    pub path: String,
    /// The first sentence of its header.
    pub about: String,
    /// The chapters that the header names.
    pub chapters: Vec<String>,
    /// The modules that it uses, as places in the list.
    pub uses: BTreeSet<usize>,
}

fn source() -> PathBuf {
    root().parent().expect("the book lies in the repository").join("src")
}

/// The modules in the order of `lib.rs`.
pub fn modules() -> Vec<Module> {
    let lib = read(&source().join("lib.rs"));
    let public = |line: &str| {
        Some(line.strip_prefix("pub mod ")?.strip_suffix(';')?.to_string())
    };
    let names: Vec<String> = lib.lines().filter_map(public).collect();
    (0..names.len()).map(|k| module(k, &names)).collect()
}

fn module(k: usize, names: &[String]) -> Module {
    let name = &names[k];
    let (file, folder) = (source().join(format!("{name}.rs")), source().join(name));
    let head = if file.is_file() { file.clone() } else { folder.join("mod.rs") };
    let path = match file.is_file() {
        true => format!("src/{name}.rs"),
        false => format!("src/{name}/"),
    };
    let text = read(&head);
    let header: Vec<&str> =
        text.lines().map_while(|line| line.strip_prefix("//!")).collect();
    let mut files = vec![head];
    rust_files(&folder, &mut files);
    let mut uses: BTreeSet<usize> =
        files.iter().flat_map(|file| used(&read(file), names)).collect();
    uses.remove(&k);
    Module {
        name: name.clone(),
        path,
        about: first_sentence(&header),
        chapters: chapters(&header),
        uses,
    }
}

fn read(path: &Path) -> String {
    fs::read_to_string(path)
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All Rust files below a folder, in order; none where there is no folder.
fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|end| end == "rs")
            && !found.contains(&path)
        {
            found.push(path);
        }
    }
}

/// Which modules the code of a file names by `crate::`; comments and tests do not count.
fn used(source: &str, names: &[String]) -> Vec<usize> {
    let code = source.lines().take_while(|line| line.trim() != "#[cfg(test)]");
    let code = code.filter(|line| !line.trim_start().starts_with("//"));
    let in_line = |line: &str| -> Vec<usize> {
        let after = line.split("crate::").skip(1);
        let word = |rest: &str| {
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
            let word = &rest[..end.unwrap_or(rest.len())];
            names.iter().position(|name| name == word)
        };
        after.filter_map(word).collect()
    };
    code.flat_map(in_line).collect()
}

/// The first sentence of a header, its links made plain.
fn first_sentence(header: &[&str]) -> String {
    let lines =
        header.iter().map(|line| line.trim()).take_while(|line| !line.is_empty());
    let text =
        lines.collect::<Vec<_>>().join(" ").replace("[`", "`").replace("`]", "`");
    let end = text.find(". ").map_or(text.len(), |at| at + 1);
    text[..end].trim_end_matches('.').to_string()
}

/// The titles between stars, from the word "chapter" of a header to its sources.
fn chapters(header: &[&str]) -> Vec<String> {
    let text = header.iter().map(|line| line.trim()).collect::<Vec<_>>().join(" ");
    let Some((_, named)) = text.split_once("hapter") else { return vec![] };
    let named = named.split("Source").next().unwrap_or(named);
    named.split('*').skip(1).step_by(2).map(str::to_string).collect()
}

/// The page whose title begins with what a header calls the chapter.
pub fn page_of<'e>(entries: &'e [Entry], chapter: &str) -> Option<&'e str> {
    let found = entries.iter().find(|entry| entry.title.starts_with(chapter))?;
    found.page.as_deref()
}

/// For each module all that it uses by way of any others.
fn closure(modules: &[Module]) -> Vec<BTreeSet<usize>> {
    let mut all: Vec<BTreeSet<usize>> = Vec::new();
    for module in modules {
        let before = module.uses.iter().filter_map(|&k| all.get(k)).flatten();
        let reached = before.chain(&module.uses).copied().collect();
        all.push(reached);
    }
    all
}

/// The uses of each module that do not follow from its others.
fn direct(modules: &[Module]) -> Vec<BTreeSet<usize>> {
    let all = closure(modules);
    let of = |module: &Module| {
        let follows =
            |to: &usize| module.uses.iter().any(|&other| all[other].contains(to));
        module.uses.iter().filter(|to| !follows(to)).copied().collect()
    };
    modules.iter().map(of).collect()
}

/// From one module down to the next, and where their names end, in pixels.
const STEP: usize = 26;
const NAMES: usize = 150;
const WIDTH: usize = 640;

/// The list with an arc from each module up to each that it uses.
fn svg() -> String {
    let modules = modules();
    let height = STEP * modules.len() + 20;
    let arrows: usize = modules.iter().map(|module| module.uses.len()).sum();
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" \
         width=\"{WIDTH}\" height=\"{height}\" role=\"img\" fill=\"none\" \
         stroke=\"currentColor\" font-size=\"14\">\n\
         <title>{} modules from {} down to {}, and {arrows} arcs on their right, each from a \
         module up to one that it uses; none leads down</title>\n",
        modules.len(),
        modules[0].name,
        modules[modules.len() - 1].name
    );
    let strong = direct(&modules);
    let y = |k: usize| STEP * k + STEP / 2 + 10;
    for (from, module) in modules.iter().enumerate() {
        let _ = writeln!(
            svg,
            "<text x=\"{NAMES}\" y=\"{}\" text-anchor=\"end\" fill=\"currentColor\" \
             stroke=\"none\">{}</text>",
            y(from) + 5,
            module.name
        );
        for &to in &module.uses {
            let opacity = if strong[from].contains(&to) { 0.9 } else { 0.15 };
            let (left, out) =
                (NAMES + 10, NAMES + 30 + reach(from.abs_diff(to), modules.len()));
            let _ = writeln!(
                svg,
                "<path d=\"M{left} {0}C{out} {0} {out} {1} {left} {1}\" \
                 stroke-opacity=\"{opacity}\"><title>{2} uses {3}</title></path>",
                y(from) - 3,
                y(to) + 3,
                module.name,
                modules[to].name
            );
        }
    }
    svg.push_str("</svg>\n");
    svg
}

/// How far an arc over so many lines leans out.
fn reach(lines: usize, all: usize) -> usize {
    (WIDTH - NAMES) * 5 / 4 * lines / all
}

/// What each module is, where, and which chapters explain it.
fn table() -> String {
    let entries = summary(&read(&root().join("src/SUMMARY.md")));
    let link = |chapter: &String| match page_of(&entries, chapter) {
        Some(page) => format!("[{chapter}]({page})"),
        None => chapter.clone(),
    };
    let mut text = String::from("| module | is | chapters |\n|---|---|---|\n");
    for module in modules() {
        let chapters: Vec<String> = module.chapters.iter().map(link).collect();
        let _ = writeln!(
            text,
            "| <a id=\"house-{}\"></a>`{}` | {} | {} |",
            module.name,
            module.path,
            module.about.replace('|', "\\|"),
            chapters.join(", ")
        );
    }
    text
}

/// What the picture counts.
fn caption() -> String {
    let modules = modules();
    let arrows: usize = modules.iter().map(|module| module.uses.len()).sum();
    let direct: usize = direct(&modules).iter().map(BTreeSet::len).sum();
    format!(
        "The {} modules in the order of `src/lib.rs`, and {arrows} arcs, one from each module up to \
         each that its code names by `crate::`. The {direct} strong ones make all others follow: the \
         faint ones lead to where a chain of strong ones leads, too.",
        modules.len()
    )
}

/// Path and text of the generated files of the page.
pub fn files() -> Vec<(String, String)> {
    vec![
        ("generated/house-modules.svg".to_string(), svg()),
        ("generated/house-modules.md".into(), caption()),
        ("generated/house-table.md".into(), table()),
    ]
}
