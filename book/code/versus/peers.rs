//! Other programs on the same polygons, from the record that `tests/peers/run.py` made.

use crate::chart::trials;
use radiosity::chart::{ChartView, Column, Trial};
use std::fs;
use std::path::PathBuf;

fn read(name: &str) -> String {
    let path =
        PathBuf::from(crate::generated::root()).join("../tests/peers").join(name);
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The record that the page of the comparison names.
fn record() -> Vec<Trial> {
    let page = read("README.md");
    let named = page.split('`').find(|word| word.starts_with("results-"));
    trials(&read(named.expect("the page names its record")))
}

/// The tables of that page.
pub fn tables() -> String {
    let page = read("README.md");
    let between = page.split("<!-- tables: made by run.py -->").nth(1);
    let tables = between.and_then(|rest| rest.split("<!-- end of tables -->").next());
    tables.expect("the page has its tables").trim().to_string() + "\n"
}

const SHOWN: [&str; 6] = [
    "radiosity auto",
    "radiosity hierarchy",
    "radiosity shoot+hemicube",
    "radiosity gather+analytic",
    "mitsuba radiance",
    "pyradiance paths",
];

/// Irradiance of the elements of the Cornell box: error over time.
pub fn svg() -> String {
    let view = ChartView {
        file: "",
        title: "Error of the irradiance of 226 elements against the time to find it",
        across: (Column::Seconds, "CPU seconds"),
        upward: (Column::Error, "relative error, root mean square"),
        least: 1e-4,
        shows: |t| {
            t.scene == "cornell-regular elements" && SHOWN.contains(&t.method.as_str())
        },
    };
    view.chart(&record()).svg()
}
