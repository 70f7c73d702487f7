//! How long a file and a function may be, and how many parameters a function may have.

use super::{name, read, rust_files};
use std::path::PathBuf;

/// A file that is longer is split.
const MOST_LINES: usize = 400;

/// From the line of its `fn` to that of its last brace.
const MOST_LINES_OF_A_FUNCTION: usize = 60;

/// `self` among them; a tuple counts as the parts that it is made of.
const MOST_PARAMETERS: usize = 5;

/// A function as it is written.
#[derive(Debug, PartialEq)]
struct Function {
    name: String,
    /// Where its `fn` stands, counted from 1.
    line: usize,
    lines: usize,
    parameters: usize,
}

/// The source with comments, strings and characters blanked out, line by line as it was;
/// without the tests at its end.
fn bare(source: &str) -> String {
    let end = source.find("#[cfg(test)]").unwrap_or(source.len());
    let mut bare = String::with_capacity(end);
    let mut rest = &source[..end];
    while let Some(c) = rest.chars().next() {
        let opaque = match c {
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            '"' => quoted(rest),
            'r' if rest.starts_with("r\"") => rest[2..].find('"').unwrap() + 3,
            'r' if rest.starts_with("r#\"") => rest[3..].find("\"#").unwrap() + 5,
            // A character, not a lifetime.
            '\'' if rest[1..].starts_with('\\') => rest[3..].find('\'').unwrap() + 4,
            '\'' if rest[1..].chars().nth(1) == Some('\'') => {
                2 + rest[1..].chars().next().unwrap().len_utf8()
            }
            _ => 0,
        };
        let text = &rest[..opaque];
        bare.extend(text.chars().filter(|&c| c == '\n'));
        if opaque == 0 {
            bare.push(c);
        }
        rest = &rest[opaque.max(c.len_utf8())..];
    }
    bare
}

/// The bytes of the string that the text begins with.
fn quoted(text: &str) -> usize {
    let mut escaped = true; // the first is the opening quote
    for (at, c) in text.char_indices() {
        match (c, escaped) {
            ('"', false) => return at + 1,
            ('\\', false) => escaped = true,
            _ => escaped = false,
        }
    }
    text.len()
}

/// Where the bracket that opens at the start of `text` is closed; `->` closes nothing.
fn closing(text: &str) -> usize {
    let open = text.chars().next().unwrap();
    let close = match open {
        '(' => ')',
        '[' => ']',
        '{' => '}',
        _ => '>',
    };
    let (mut depth, mut before) = (0, ' ');
    for (at, c) in text.char_indices() {
        if c == open {
            depth += 1;
        } else if c == close && !(c == '>' && matches!(before, '-' | '=')) {
            depth -= 1;
        }
        if depth == 0 {
            return at;
        }
        before = c;
    }
    panic!("never closed: {text}")
}

/// The parts of a list that commas separate, but for those within brackets.
fn parts(list: &str) -> Vec<&str> {
    let (mut parts, mut start, mut at) = (Vec::new(), 0, 0);
    while let Some(c) = list[at..].chars().next() {
        match c {
            '(' | '[' | '{' | '<' => at += closing(&list[at..]),
            ',' => {
                parts.push(list[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
        at += list[at..].chars().next().map_or(0, char::len_utf8);
    }
    parts.push(list[start..].trim());
    parts.retain(|part| !part.is_empty());
    parts
}

/// How many parameters one is: a tuple is as many as its parts.
fn count(parameter: &str) -> usize {
    let of_tuple = |text: &str| {
        let inside = text.trim().strip_prefix('(')?.strip_suffix(')')?;
        Some(parts(inside).into_iter().map(count).sum())
    };
    // A pattern may be a tuple, a type, or nothing but a name.
    let ends =
        parameter.split(": ").next().into_iter().chain(parameter.split(": ").last());
    ends.filter_map(of_tuple).max().unwrap_or(1)
}

/// All functions of a source, those within others as well; not closures.
fn functions(source: &str) -> Vec<Function> {
    let bare = bare(source);
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut found = Vec::new();
    for (at, _) in bare.match_indices("fn ") {
        if bare[..at].ends_with(is_word) {
            continue;
        }
        let rest = &bare[at + 3..];
        let Some(named) = rest.find(|c: char| !is_word(c)).filter(|&end| end > 0)
        else {
            continue; // a function pointer
        };
        let generics = if rest[named..].starts_with('<') {
            closing(&rest[named..]) + 1
        } else {
            0
        };
        let list = &rest[named + generics..];
        let end = closing(list);
        // Of a trait, or one that has a body.
        let after = &list[end..];
        let open = after.find(['{', ';']).unwrap();
        let body = match &after[open..=open] {
            "{" => open + closing(&after[open..]),
            _ => open,
        };
        let all = at..at + 3 + named + generics + end + body;
        found.push(Function {
            name: rest[..named].into(),
            line: bare[..at].matches('\n').count() + 1,
            lines: bare[all].matches('\n').count() + 1,
            parameters: parts(&list[1..end]).into_iter().map(count).sum(),
        });
    }
    found
}

/// Every function of the library and of the command, with its file.
fn all_functions() -> Vec<(String, Function)> {
    let of_file = |path: PathBuf| {
        let functions = functions(&read(&path));
        functions.into_iter().map(move |f| (name(&path), f))
    };
    let all: Vec<_> = rust_files("src").into_iter().flat_map(of_file).collect();
    assert!(all.len() > 1500, "only {} functions found", all.len());
    all
}

#[test]
fn functions_are_found_as_they_are_written() {
    let source = "
/// fn in_a_comment(a: A) {
impl<T: Fn(&str) -> Vec<u8>> Thing {
    pub(crate) fn long<'a, F: Fn(u8, u8) -> [u8; 2]>(
        &'a self,
        (first, (second, third)): (A, (B, C)),
        call: impl Fn(A, B) -> C,
        pair: (f64, f64),
    ) -> (A, B) where A: B {
        let text = \"fn not_one() { \\\" \"; let c = '{'; let d = '\\''; let e = r#\"}\"#;
        let pointer: fn(A, B) = |a, b| { fn within() {} };
        if a < b && c > d { x }
    }
}
fn none() {}
trait T { fn of_trait(&self, a: A); }
#[cfg(test)]
mod tests { fn no() {} }
";
    let found = functions(source);
    let plain: Vec<(&str, usize, usize, usize)> =
        found.iter().map(|f| (&f.name[..], f.line, f.lines, f.parameters)).collect();
    let expected = [
        ("long", 4, 10, 7),
        ("within", 11, 1, 0),
        ("none", 15, 1, 0),
        ("of_trait", 16, 1, 2),
    ];
    assert_eq!(plain, expected);
}

/// Functions that are too long or take too much still. This list only shrinks: what is on
/// it and is no longer at fault fails the tests, too.
const LONG_STILL: [&str; 0] = [];
const MANY_STILL: [&str; 0] = [];

/// The functions at fault are those that are known to be.
fn only_known(at_fault: impl Fn(&Function) -> bool, known: &[&str]) {
    let all = all_functions().into_iter().filter(|(_, f)| at_fault(f));
    let mut found: Vec<String> =
        all.map(|(file, f)| format!("{file}: {}", f.name)).collect();
    found.sort();
    let new: Vec<&String> = found.iter().filter(|f| !known.contains(&&f[..])).collect();
    assert!(new.is_empty(), "split what is long, name what belongs together: {new:#?}");
    let mended = known.iter().filter(|k| !found.iter().any(|f| f == *k));
    let mended: Vec<_> = mended.collect();
    assert!(mended.is_empty(), "no longer at fault, strike it off: {mended:#?}");
}

#[test]
fn no_function_is_long() {
    only_known(|f| f.lines > MOST_LINES_OF_A_FUNCTION, &LONG_STILL);
}

#[test]
fn no_function_has_many_parameters() {
    only_known(|f| f.parameters > MOST_PARAMETERS, &MANY_STILL);
}

#[test]
fn no_file_is_long() {
    let folders = [
        ("src", 150),
        ("tests", 80),
        ("book/code", 80),
        ("book/tests", 10),
        ("labs/src", 150),
        ("labs/tests", 15),
    ];
    for (folder, some) in folders {
        let files = rust_files(folder);
        assert!(files.len() > some, "{folder}: only {} files", files.len());
        let lines = |path: &PathBuf| read(path).lines().count();
        let long = files.iter().filter(|path| lines(path) > MOST_LINES);
        let long: Vec<String> = long
            .map(|path| format!("{} has {} lines", name(path), lines(path)))
            .collect();
        assert!(long.is_empty(), "split what is long:\n{}", long.join("\n"));
    }
}
