//! Charts of measurements: each is what its table says, each table is a suite's and dated.

use radiosity::chart::{SUITES, read};
use std::fs;
use std::path::PathBuf;

fn data(file: &str) -> (PathBuf, String) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("data").join(file);
    let text = fs::read_to_string(&path);
    let told = "is missing; `cargo run --release -- chart -o book/data` writes it";
    let text = text.unwrap_or_else(|_| panic!("{} {told}", path.display()));
    (path, text)
}

/// A chart that no longer shows its table, or shows it otherwise than the program draws it
/// today, is stale.
#[test]
fn every_chart_shows_its_table() {
    for suite in &SUITES {
        let (path, csv) = data(&format!("{}.csv", suite.name));
        let trials = read(&csv).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert!(trials.iter().all(|t| t.suite == suite.name), "{}", suite.name);
        for view in suite.views {
            let (path, svg) = data(&format!("{}.svg", view.file));
            let chart = view.chart(&trials);
            assert!(!chart.lines.is_empty(), "{} shows nothing", view.file);
            assert!(
                svg == chart.svg(),
                "{} is not what its table says",
                path.display()
            );
        }
    }
}

/// A measurement without date, command and version is hearsay.
#[test]
fn every_table_says_where_it_comes_from() {
    for suite in &SUITES {
        let (path, csv) = data(&format!("{}.csv", suite.name));
        let origin: Vec<&str> =
            csv.lines().take_while(|line| line.starts_with('#')).collect();
        let origin = origin.join("\n");
        for part in [&format!("radiosity chart {}", suite.name)[..], "version ", "202"]
        {
            assert!(origin.contains(part), "{} lacks {part}", path.display());
        }
    }
}
