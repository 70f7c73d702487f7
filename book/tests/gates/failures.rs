//! The gallery of failures: complete, asserted, and drawn so that it can be read.

use book::failures::curve::{self, LETTER, WIDTH};
use book::failures::rows::{Row, Shown, Sweep, rows};
use book::failures::symptoms::SYMPTOMS;
use book::failures::{ALL, FAMILIES, Family, sweeps};
use book::generated::root;
use std::collections::BTreeSet;
use std::fs;
use std::sync::LazyLock;

fn all_fit(faults: &[String]) {
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// All curves, computed once.
static SWEEPS: LazyLock<Vec<(Row, Sweep)>> = LazyLock::new(sweeps);

#[test]
fn every_row_is_there_once_in_its_family() {
    let numbers: Vec<u8> = rows().iter().map(|row| row.number).collect();
    let all: Vec<u8> = (1..=ALL).collect();
    assert_eq!(numbers, all);
    let families: Vec<u8> = FAMILIES.iter().flat_map(|f| f.rows.clone()).collect();
    assert_eq!(families, all);
    let src = root().join("src");
    let shown = |family: &Family| {
        let text = fs::read_to_string(src.join(format!("{}.md", family.page))).unwrap();
        text.contains(&format!("{{{{#include generated/{}.md}}}}", family.page))
    };
    assert!(FAMILIES.iter().all(shown));
}

#[test]
fn rows_are_asserted_or_say_why_not() {
    let asserted = rows().iter().filter(|row| !row.tests.is_empty()).count();
    assert!(asserted >= 70, "{asserted}");
    let silent = |row: &&Row| {
        row.tests.is_empty()
            && !matches!(row.shown, Shown::Nothing(why) if !why.is_empty())
    };
    let fault = |row: Row| format!("row {}: no test, and no reason", row.number);
    all_fit(
        &rows().into_iter().filter(|row| silent(&row)).map(fault).collect::<Vec<_>>(),
    );
}

#[test]
fn every_row_is_suspected_of_something() {
    let suspects: BTreeSet<u8> =
        SYMPTOMS.iter().flat_map(|s| s.rows).copied().collect();
    let all: BTreeSet<u8> = (1..=ALL).collect();
    let [missing, unknown] = [&all - &suspects, &suspects - &all];
    assert!(missing.is_empty() && unknown.is_empty(), "{missing:?} {unknown:?}");
}

#[test]
fn every_named_test_exists() {
    let tests = root().parent().unwrap().join("tests/stability");
    let fault = |row: &Row, test: &str| {
        let Some((file, name)) = test.split_once("::") else {
            return Some(format!("{}: {test} is no file::function", row.number));
        };
        let text =
            fs::read_to_string(tests.join(format!("{file}.rs"))).unwrap_or_default();
        let named = name.contains(&format!("{:02}", row.number));
        let there = text.contains(&format!("#[test]\nfn {name}("));
        (!(named && there)).then(|| format!("row {}: no test {test}", row.number))
    };
    let faults: Vec<String> = rows()
        .iter()
        .flat_map(|row| {
            row.tests.iter().filter_map(|t| fault(row, t)).collect::<Vec<_>>()
        })
        .collect();
    all_fit(&faults);
}

#[test]
fn every_picture_exists_and_rows_without_one_say_why() {
    let fault = |row: &Row| match row.shown {
        Shown::Picture(file, seen) => {
            let there = root().join("src/pictures").join(file).exists();
            (!there || seen.is_empty()).then(|| format!("{}: no {file}", row.number))
        }
        Shown::Nothing(why) => why.is_empty().then(|| format!("{}: why?", row.number)),
        Shown::Curve(_) => None,
    };
    all_fit(&rows().iter().filter_map(fault).collect::<Vec<_>>());
}

/// A curve has numbers, more than one for each method, and theory where a law is
/// stated.
#[test]
fn curves_have_numbers() {
    let mut faults = vec![];
    for (row, sweep) in SWEEPS.iter() {
        let mut fault = |what: &str| faults.push(format!("row {}: {what}", row.number));
        let points: Vec<[f64; 2]> =
            sweep.found.iter().flat_map(|f| f.points.clone()).collect();
        let all = || points.iter().chain(&sweep.theory);
        if all().flatten().any(|v| !v.is_finite()) {
            fault("a number that is none");
        }
        if !(1..=4).contains(&sweep.found.len())
            || sweep.found.iter().any(|f| f.points.len() < 2)
        {
            fault("one to four methods, each at two places or more");
        }
        for (axis, logarithmic) in sweep.logarithmic.into_iter().enumerate() {
            if logarithmic && all().any(|p| p[axis] < 0.0) {
                fault("a negative number on a logarithmic axis");
            }
        }
        if sweep.theory.is_empty() != sweep.law.is_empty() || sweep.theory.len() == 1 {
            fault("a law needs a line of theory, and theory its law");
        }
    }
    all_fit(&faults);
}

/// Start, end and baseline of a text of a drawing.
fn boxes(svg: &str) -> Vec<([f64; 3], String)> {
    let number = |line: &str, key: &str| -> Option<f64> {
        line.split_once(&format!(" {key}=\""))?.1.split_once('"')?.0.parse().ok()
    };
    let text = |line: &str| {
        let said = line.strip_suffix("</text>")?.rsplit_once('>')?.1;
        let said = said.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
        let (x, y) = (number(line, "x")?, number(line, "y")?);
        let width = LETTER * said.chars().count() as f64;
        let before = if line.contains("\"middle\"") {
            0.5
        } else if line.contains("\"end\"") {
            1.0
        } else {
            0.0
        };
        let start = x - before * width;
        Some(([start, start + width, y], said))
    };
    svg.lines().filter_map(text).collect()
}

/// No text of a curve runs over another or out of the picture. Beside it, all curves on
/// one page to look at: `failures.html` in the build's folder for temporary files.
#[test]
fn texts_of_curves_keep_apart() {
    let mut faults = vec![];
    let mut sheet = String::new();
    for (row, sweep) in SWEEPS.iter() {
        let (svg, row) = (curve::svg(row, sweep), row.number);
        let texts = boxes(&svg);
        for (k, ([start, end, y], said)) in texts.iter().enumerate() {
            if *start < -1.0 || *end > WIDTH + 8.0 {
                faults.push(format!("row {row}: {said:?} runs out of the picture"));
            }
            let over = texts[..k]
                .iter()
                .find(|([a, b, at], _)| (at - y).abs() < 11.0 && a < end && start < b);
            if let Some((_, other)) = over {
                faults.push(format!("row {row}: {said:?} runs over {other:?}"));
            }
        }
        sheet += &format!("<figure><b>{row}</b>{svg}</figure>\n");
    }
    let half = |colours: &str| format!("<div style=\"{colours}\">{sheet}</div>");
    let page = format!(
        "<meta charset=\"utf-8\"><style>body{{margin:0;font-family:sans-serif}}\
         figure{{display:inline-block;margin:8px;vertical-align:top}}b{{display:block}}\
         </style>{}{}",
        half("background:#fff;color:#000;--bg:#fff"),
        half("background:#161923;color:#bcbdd0;--bg:#161923")
            .replace("id=\"f", "id=\"n")
    );
    fs::write(concat!(env!("CARGO_TARGET_TMPDIR"), "/failures.html"), page).unwrap();
    all_fit(&faults);
}
