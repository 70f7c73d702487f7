//! The record of public programs beside ours is whole, and says what its page claims.
#![allow(missing_docs)]

use radiosity::chart::{Trial, read};
use std::fs;

/// Whose method it is.
fn program(trial: &Trial) -> &str {
    trial.method.split(' ').next().expect("a method")
}

fn folder() -> String {
    format!("{}/tests/peers", env!("CARGO_MANIFEST_DIR"))
}

fn page() -> String {
    fs::read_to_string(format!("{}/README.md", folder())).expect("README.md")
}

/// The record that the page names, as text.
fn record() -> String {
    let page = page();
    let named = page.split('`').find(|word| word.starts_with("results-"));
    let path = format!("{}/{}", folder(), named.expect("the page names its record"));
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn rows() -> Vec<Trial> {
    read(&record()).expect("the columns of all charts")
}

#[test]
fn every_row_has_what_charts_need() {
    let rows = rows();
    assert!(rows.len() > 80, "{}", rows.len());
    for row in &rows {
        assert!(row.seconds > 0.0 && row.runs >= 1, "{row:?}");
        assert!(row.setting > 0.0, "{row:?}");
        match row.suite.as_str() {
            "peers-rays" => assert!(row.work.rays > 0),
            "peers-factors" | "peers-irradiance" => {
                assert!(row.error > 0.0 && row.uncertainty > 0.0, "{row:?}");
            }
            other => panic!("no suite is called {other}"),
        }
    }
    for name in ["radiosity", "pyviewfactor", "mitsuba", "pyradiance", "embreex"] {
        assert!(rows.iter().any(|row| program(row) == name), "{name}");
    }
}

#[test]
fn the_record_says_where_it_comes_from() {
    let record = record();
    for what in
        ["command", "versions", "machine", "date", "seconds", "start-up", "error"]
    {
        let begin = format!("# {what}");
        assert!(record.lines().any(|line| line.starts_with(&begin)), "{what}");
    }
    assert!(!record.contains("/home") && !record.contains("/root"));
}

/// CPU seconds of the cheapest setting of a program that is off by at most `error`.
fn cheapest(rows: &[Trial], suite: &str, scene: &str, name: &str, error: f64) -> f64 {
    let fits = |row: &&Trial| {
        (row.suite.as_str(), row.scene.as_str(), program(row)) == (suite, scene, name)
            && row.error <= error
    };
    rows.iter().filter(fits).map(|row| row.seconds).fold(f64::INFINITY, f64::min)
}

/// Million rays in a CPU second.
fn rate(rows: &[Trial], name: &str, query: &str) -> f64 {
    let method = format!("{name} {query}");
    let row = rows.iter().find(|row| row.method == method).expect("rays");
    row.work.rays as f64 / row.seconds / 1e6
}

/// What a cell says: a number, and beside a peer's how many times ours that is. Two digits
/// are shown.
fn holds(cell: &str, found: f64, own: f64) {
    let near = |text: &str, found: f64| {
        let told: f64 = text.parse().unwrap_or_else(|_| panic!("{text} in {cell}"));
        assert!((told / found - 1.0).abs() < 0.051, "{cell}: {found}");
    };
    if cell == "-" {
        assert_eq!(found, f64::INFINITY);
        return;
    }
    let (number, times) = cell.split_once(" (").unwrap_or((cell, ""));
    near(number, found);
    if let Some(times) = times.strip_suffix(" ×)") {
        near(times, found / own);
    }
}

#[test]
fn every_number_of_the_page_follows_from_the_record() {
    let (page, rows) = (page(), rows());
    let mut header: Vec<String> = Vec::new();
    let mut checked = 0;
    let (_, tables) = page.split_once("<!-- tables").expect("a mark before the tables");
    for line in tables.lines().filter(|line| line.starts_with('|')) {
        let cells: Vec<String> =
            line.trim_matches('|').split('|').map(|c| c.trim().to_string()).collect();
        if cells[0].starts_with("`peers-") {
            header = cells;
            continue;
        }
        if cells[0].starts_with("---") {
            continue;
        }
        let suite = header[0].trim_matches('`').to_string();
        let rays = suite == "peers-rays";
        let first = if rays { 1 } else { 2 };
        let value = |program: &str| {
            if rays {
                return rate(&rows, program, &cells[0]);
            }
            let error = cells[1].parse().expect("an error");
            cheapest(&rows, &suite, &cells[0], program, error)
        };
        let own = value("radiosity");
        for (program, cell) in header[first..].iter().zip(&cells[first..]) {
            holds(cell, value(program), own);
            checked += 1;
        }
    }
    assert!(checked >= 40, "{checked} numbers");
}
