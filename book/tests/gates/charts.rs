//! Charts of measurements: each table is a suite's and dated, each chart shows something.
//! That a chart is what its table says is seen in `sources.rs`, with all generated files.

use radiosity::chart::{SUITES, read};
use std::path::PathBuf;
use std::{collections::BTreeSet, fs};

fn data() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("data")
}

/// A measurement without date, command and version is hearsay.
#[test]
fn every_table_says_where_it_comes_from() {
    for suite in &SUITES {
        let path = data().join(format!("{}.csv", suite.name));
        let told = "is missing; `cargo run --release --features memory -- chart -o book/data` \
                    writes it";
        let csv = fs::read_to_string(&path);
        let csv = csv.unwrap_or_else(|_| panic!("{} {told}", path.display()));
        let trials = read(&csv).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert!(trials.iter().all(|t| t.suite == suite.name), "{}", suite.name);
        for view in suite.views {
            assert!(!view.chart(&trials).lines.is_empty(), "{} is empty", view.file);
        }
        let origin = csv.lines().take_while(|line| line.starts_with('#'));
        let origin = origin.collect::<Vec<_>>().join("\n");
        for part in
            [&format!("radiosity chart {}", suite.name)[..], "version ", "on 20"]
        {
            assert!(origin.contains(part), "{} lacks {part}", path.display());
        }
    }
}

/// No chart lies about that no suite draws any more, and no page has lost one.
#[test]
fn every_chart_is_drawn_and_shown() {
    let views = SUITES.iter().flat_map(|suite| suite.views);
    let drawn: BTreeSet<String> = views.map(|v| format!("{}.svg", v.file)).collect();
    let names = fs::read_dir(data()).expect("the folder is there").flatten();
    let names = names.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let there: BTreeSet<String> = names.filter(|name| name.ends_with(".svg")).collect();
    assert_eq!(there, drawn);
    let pages = fs::read_dir(data().join("../src")).expect("the pages are there");
    let texts = pages.flatten().filter_map(|page| fs::read_to_string(page.path()).ok());
    let text: String = texts.collect();
    for chart in &drawn {
        assert!(text.contains(&format!("../data/{chart}")), "no page shows {chart}");
    }
}
