//! Rows, families and the table of failures as Markdown.

use super::rows::{Row, Shown, rows};
use super::{FAMILIES, Family};
use std::collections::BTreeSet;

/// All rows of a family, one card after the other.
pub fn family(family: &Family) -> String {
    family.written().iter().map(card).collect()
}

/// A row: what fails, why, how large it is, what helps, and who asserts it.
fn card(row: &Row) -> String {
    let shown = match row.shown {
        Shown::Curve(_) => format!("{{{{#include failure-{:02}.svg}}}}", row.number),
        Shown::Picture(file, seen) => {
            let seen = super::curve::escaped(seen).replace('"', "&quot;");
            format!("<img src=\"pictures/{file}\" alt=\"{seen}\">")
        }
        Shown::Nothing(why) => {
            format!("<figcaption>\n\nNo picture: {}\n\n</figcaption>", plain(why))
        }
    };
    format!(
        "### {number}. {name} {{#row-{number:02}}}\n\n<div class=\"failure\">\n\
         <figure>\n{shown}\n</figure>\n<div>\n\n{why}\n\n**How large.** {size}\n\n\
         **What holds.** {remedy}\n\n{tests}\n\n</div>\n</div>\n\n",
        number = row.number,
        name = plain(row.name),
        why = plain(row.why),
        size = plain(row.size),
        remedy = plain(row.remedy),
        tests = tests(row)
    )
}

/// Who asserts a row: file and function.
fn tests(row: &Row) -> String {
    let test = |name: &&str| match name.split_once("::") {
        Some((file, function)) => {
            format!("`{function}` in `tests/stability/{file}.rs`")
        }
        None => format!("`{name}`"),
    };
    let tests: Vec<String> = row.tests.iter().map(test).collect();
    match tests[..] {
        [] => "Not tested.".into(),
        _ => format!("<small>Asserted by {}.</small>", tests.join(", ")),
    }
}

/// Row, test and picture of all rows; rows that are left out say why.
pub fn table() -> String {
    let mut text = String::from(
        "| | fails | asserted by (`cargo test --test stability`) | shown as |\n\
         |---|---|---|---|\n",
    );
    for row in rows() {
        let (number, name) = (row.number, plain(row.name).replace('|', "\\|"));
        let page = FAMILIES.iter().find(|f| f.rows.contains(&number));
        let page = page.map_or("", |family| family.page);
        let tests: Vec<String> =
            row.tests.iter().map(|test| format!("`{test}`")).collect();
        let shown = match row.shown {
            Shown::Curve(_) => format!("[curve]({page}.md#row-{number:02})"),
            Shown::Picture(..) => "picture".into(),
            Shown::Nothing(why) => format!("left out: {}", plain(why)),
        };
        text += &format!(
            "| {number} | [{name}]({page}.md#row-{number:02}) | {} | {shown} |\n",
            tests.join("<br>")
        );
    }
    text
}

/// How many rows there are, are asserted and are drawn, in a sentence.
pub fn count() -> String {
    let all = rows();
    let asserted = all.iter().filter(|row| !row.tests.is_empty()).count();
    let curves = all.iter().filter(|r| matches!(r.shown, Shown::Curve(_))).count();
    let pictures = all.iter().filter(|r| matches!(r.shown, Shown::Picture(..))).count();
    let tests: BTreeSet<&str> = all.iter().flat_map(|row| row.tests).copied().collect();
    let drawn = match pictures {
        0 => format!("{curves} are drawn as curves"),
        _ => format!("{curves} are drawn as curves and {pictures} as pictures"),
    };
    let files: BTreeSet<&str> =
        tests.iter().filter_map(|t| Some(t.split_once("::")?.0)).collect();
    format!(
        "Of {} rows {asserted} are asserted, by {} tests in {} files; {drawn}.\n",
        all.len(),
        tests.len(),
        files.len()
    )
}

/// A sentence as Markdown takes it: what is less than something opens no tag.
pub fn plain(text: &str) -> String {
    let part = |(k, part): (usize, &str)| match k % 2 {
        0 => part.replace('<', "&lt;").replace('*', "\\*"),
        _ => format!("`{part}`"),
    };
    text.split('`').enumerate().map(part).collect()
}
