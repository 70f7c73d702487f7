//! Gates over the built HTML: every link resolves, nothing is loaded from outside,
//! nothing of the source's notation is left over.
//!
//! The scanner knows tags, comments, scripts and styles, and no more of HTML.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

/// A tag or the text between two.
#[derive(Debug, PartialEq)]
pub enum Piece<'a> {
    /// `<name key="value">`; a closing tag's name starts with `/`.
    Tag(&'a str, Vec<(&'a str, &'a str)>),
    /// Text outside of scripts and styles.
    Text(&'a str),
}

/// Cuts a page into tags and texts; drops comments and the inside of scripts and styles.
pub fn pieces(html: &str) -> Vec<Piece<'_>> {
    let mut found = Vec::new();
    let mut rest = html;
    while let Some(open) = rest.find('<') {
        found.push(Piece::Text(&rest[..open]));
        rest = &rest[open..];
        if rest.starts_with("<!--") {
            rest = after(rest, "-->");
            continue;
        }
        let end = end_of_tag(rest);
        let inside = rest[1..end].trim_end_matches('/');
        let name_end = inside.find(char::is_whitespace).unwrap_or(inside.len());
        let name = &inside[..name_end];
        found.push(Piece::Tag(name, attributes(&inside[name_end..])));
        rest = rest.get(end + 1..).unwrap_or("");
        if name == "script" || name == "style" {
            let close = if name == "script" { "</script>" } else { "</style>" };
            rest = after(rest, close);
        }
    }
    found.push(Piece::Text(rest));
    found
}

fn after<'a>(text: &'a str, mark: &str) -> &'a str {
    text.split_once(mark).map_or("", |(_, rest)| rest)
}

/// Where the `>` of a tag stands; one inside quotes does not count.
fn end_of_tag(text: &str) -> usize {
    let mut quote = None;
    for (index, c) in text.char_indices() {
        match (quote, c) {
            (None, '>') => return index,
            (None, '"' | '\'') => quote = Some(c),
            (Some(q), c) if q == c => quote = None,
            _ => {}
        }
    }
    text.len()
}

fn attributes(mut text: &str) -> Vec<(&str, &str)> {
    let mut found = Vec::new();
    loop {
        text = text.trim_start();
        let end = text.find(|c: char| c == '=' || c.is_whitespace());
        let end = end.unwrap_or(text.len());
        if end == 0 {
            return found;
        }
        let key = &text[..end];
        text = &text[end..];
        let Some(value) = text.strip_prefix('=') else {
            found.push((key, ""));
            continue;
        };
        let quote = value.chars().next().filter(|c| "\"'".contains(*c));
        let value = if quote.is_some() { &value[1..] } else { value };
        let stop = value.find(|c: char| match quote {
            Some(q) => c == q,
            None => c.is_whitespace(),
        });
        let stop = stop.unwrap_or(value.len());
        found.push((key, &value[..stop]));
        text = value.get(stop + quote.map_or(0, char::len_utf8)..).unwrap_or("");
    }
}

fn attribute<'a>(attributes: &[(&str, &'a str)], key: &str) -> Option<&'a str> {
    attributes.iter().find(|(k, _)| *k == key).map(|(_, value)| *value)
}

/// The faults of all pages and style sheets under `root`, each led by its file's name.
///
/// # Errors
/// When a file cannot be read, or there is no page at all.
pub fn faults(root: &Path) -> io::Result<Vec<String>> {
    let mut files = BTreeMap::new();
    read_all(root, Path::new(""), &mut files)?;
    let ids: BTreeMap<&PathBuf, BTreeSet<&str>> =
        files.iter().map(|(path, text)| (path, ids(text))).collect();
    if !files.keys().any(|path| is(path, "html")) {
        return Err(io::Error::new(io::ErrorKind::NotFound, "no page found"));
    }
    let mut faults = Vec::new();
    for (path, text) in &files {
        let mut of_page = if is(path, "css") { Vec::new() } else { page_faults(text) };
        let links = if is(path, "css") { css_links(text) } else { links(text) };
        for link in links {
            let Some((file, anchor)) = target(path, link) else { continue };
            let found = root.join(&file).is_file();
            let anchored = anchor.is_empty()
                || ids.get(&file).is_some_and(|ids| ids.contains(anchor));
            if !found || !anchored {
                of_page.push(format!("link leads nowhere: {link}"));
            }
        }
        let name = path.display();
        faults.extend(of_page.into_iter().map(|fault| format!("{name}: {fault}")));
    }
    Ok(faults)
}

fn is(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|found| found == extension)
}

fn read_all(
    root: &Path,
    folder: &Path,
    files: &mut BTreeMap<PathBuf, String>,
) -> io::Result<()> {
    for entry in fs::read_dir(root.join(folder))? {
        let entry = entry?;
        let path = folder.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            read_all(root, &path, files)?;
        } else if is(&path, "html") || is(&path, "css") {
            files.insert(path, fs::read_to_string(entry.path())?);
        }
    }
    Ok(())
}

fn ids(html: &str) -> BTreeSet<&str> {
    let id = |piece| match piece {
        Piece::Tag(_, attributes) => attribute(&attributes, "id"),
        Piece::Text(_) => None,
    };
    pieces(html).into_iter().filter_map(id).collect()
}

fn links(html: &str) -> Vec<&str> {
    let tags = pieces(html).into_iter().filter_map(|piece| match piece {
        Piece::Tag(_, attributes) => Some(attributes),
        Piece::Text(_) => None,
    });
    let link = |(key, value)| ["href", "src"].contains(&key).then_some(value);
    tags.flatten().filter_map(link).collect()
}

fn css_links(css: &str) -> Vec<&str> {
    let urls = css.split("url(").skip(1).filter_map(|rest| rest.split_once(')'));
    urls.map(|(url, _)| url.trim_matches(|c| "\"' ".contains(c))).collect()
}

fn is_outside(link: &str) -> bool {
    link.starts_with("//") || link.starts_with("http:") || link.starts_with("https:")
}

/// The file and anchor that `link`, on the page `from`, leads to; `None` when outside.
fn target<'a>(from: &Path, link: &'a str) -> Option<(PathBuf, &'a str)> {
    if is_outside(link) || link.starts_with("mailto:") || link.starts_with("data:") {
        return None;
    }
    let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
    let path = path.split('?').next().unwrap_or("");
    if path.is_empty() {
        return Some((from.to_path_buf(), anchor));
    }
    let mut file = from.parent()?.to_path_buf();
    for part in Path::new(path).components() {
        match part {
            Component::Normal(name) => file.push(name),
            Component::ParentDir => drop(file.pop()),
            _ => {}
        }
    }
    Some((file, anchor))
}

/// The faults of one page that can be seen without the others.
pub fn page_faults(html: &str) -> Vec<String> {
    let mut faults = Vec::new();
    let mut seen = BTreeSet::new();
    let mut text = String::new(); // of the page, with `\u{1}` for each <code>
    let mut code = 0;
    let mut empty = false; // are we right behind <code>?
    for piece in pieces(html) {
        match piece {
            Piece::Text(t) if code == 0 => text.push_str(t),
            Piece::Text(t) => empty &= t.trim().is_empty(),
            Piece::Tag("code", _) => {
                code += 1;
                empty = true;
                text.push('\u{1}');
            }
            Piece::Tag("/code", _) => {
                code -= 1;
                if empty {
                    faults.push("an empty code block".to_string());
                }
            }
            Piece::Tag(name, attributes) => {
                empty = false;
                faults.extend(tag_faults(name, &attributes));
                if let Some(id) = attribute(&attributes, "id")
                    && !seen.insert(id)
                {
                    faults.push(format!("two things have the id `{id}`"));
                }
            }
        }
    }
    if html.contains("{{#") {
        faults.push("a {{# is left".into());
    }
    if let Some(at) = text.replace("$\u{1}$", "").find('$') {
        let text = text.replace("$\u{1}$", "");
        let around: String = text[at..].chars().take(30).collect();
        faults.push(format!("a stray $: {around:?}"));
    }
    faults
}

fn tag_faults(name: &str, attributes: &[(&str, &str)]) -> Vec<String> {
    let mut faults = Vec::new();
    let loads = |key: &str| match key {
        "src" | "srcset" | "data" | "poster" | "xlink:href" => true,
        "href" => ["link", "image", "use"].contains(&name),
        _ => false,
    };
    for (_, value) in attributes.iter().filter(|(key, _)| loads(key)) {
        if value.split([' ', ',']).any(is_outside) {
            faults.push(format!("<{name}> loads from outside: {value}"));
        }
    }
    if name == "img" && attribute(attributes, "alt").unwrap_or("").trim().is_empty() {
        faults.push("a picture without alt text".into());
    }
    faults
}
