//! The statements of a text file, each with its line.

use super::ObjError;
use std::path::Path;

/// One statement or comment.
pub(super) struct Statement {
    /// The line it begins on, from 1.
    pub line: usize,
    /// Its text without white space around it; never empty.
    pub text: String,
}

impl Statement {
    /// The first word, and the rest without white space around it.
    pub fn key(&self) -> (&str, &str) {
        let (key, rest) = self.text.split_once(char::is_whitespace).unwrap_or_default();
        if key.is_empty() { (&self.text, "") } else { (key, rest.trim()) }
    }

    /// Is it a comment?
    pub fn is_comment(&self) -> bool {
        self.text.starts_with('#')
    }
}

/// Splits a file into statements; `\` at the end of a line joins the next one to it.
///
/// # Errors
/// When a statement holds what is no text. Comments may hold anything.
pub(super) fn statements(
    file: &Path,
    bytes: &[u8],
) -> Result<Vec<Statement>, ObjError> {
    let text = String::from_utf8_lossy(bytes);
    let text =
        text.trim_start_matches('\u{feff}').replace("\r\n", "\n").replace('\r', "\n");
    let mut statements: Vec<Statement> = Vec::new();
    let mut joins = false;
    for (k, line) in text.split('\n').enumerate() {
        let (line, more) = match line.trim_end().strip_suffix('\\') {
            Some(begun) if joins || !line.trim_start().starts_with('#') => {
                (begun, true)
            }
            _ => (line, false),
        };
        match statements.last_mut() {
            Some(begun) if joins => {
                begun.text.push(' ');
                begun.text.push_str(line);
            }
            _ => statements.push(Statement { line: k + 1, text: line.into() }),
        }
        joins = more;
    }
    for statement in &mut statements {
        statement.text = statement.text.trim().into();
    }
    statements.retain(|s| !s.text.is_empty());
    let strange = |c: char| (c.is_control() && c != '\t') || c == '\u{fffd}';
    match statements.iter().find(|s| !s.is_comment() && s.text.contains(strange)) {
        Some(Statement { line, .. }) => {
            let message =
                "this is not text (UTF-8); check that it is an OBJ or MTL file";
            Err(ObjError::new(file, *line, message))
        }
        None => Ok(statements),
    }
}

/// What stands before the first `#` that begins a word: names may hold others.
pub(super) fn without_comment(text: &str) -> &str {
    let begins = |&(k, _): &(usize, &str)| text[..k].ends_with(char::is_whitespace);
    let comment = text.match_indices('#').find(begins);
    text[..comment.map_or(text.len(), |(k, _)| k)].trim_end()
}

/// The words of a statement, before any `#`, as finite numbers.
///
/// # Errors
/// A sentence about the first word that is none.
pub(super) fn numbers(words: &str) -> Result<Vec<f64>, String> {
    let words = words.split('#').next().unwrap_or_default();
    let number = |word: &str| match word.parse::<f64>() {
        Ok(x) if x.is_finite() && x.abs() <= LARGEST => Ok(x),
        Ok(_) => Err(format!(
            "`{}` is not a finite number (of size {LARGEST:e} at most); correct it",
            shown(word)
        )),
        Err(_) => Err(format!("`{}` is not a number; correct it", shown(word))),
    };
    words.split_whitespace().map(number).collect()
}

/// Beyond this, products of lengths overflow.
const LARGEST: f64 = 1e50;

/// A text cut to what fits into a message.
pub(super) fn shown(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into(),
    }
}
