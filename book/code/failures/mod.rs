//! The gallery of failures: every row of the table with its curve or picture.
//!
//! | module       | holds                                                    |
//! |--------------|----------------------------------------------------------|
//! | [`mod@rows`] | the rows and their curves, shared with the crate's tests |
//! | [`axis`]     | where a value lies, and which values are told            |
//! | [`curve`]    | a curve as SVG                                           |
//! | [`page`]     | rows, families and the table of all of them as Markdown  |
//! | [`symptoms`] | what to suspect first                                    |
//! | [`rooms`]    | what 500 random rooms did to our own defaults            |
//! | [`ledger`]   | a ledger that shows a failure                            |

// The tests of the crate and this page call the same functions.
#[path = "../../../tests/failures/mod.rs"]
#[allow(missing_docs)]
pub mod rows;

pub mod axis;
pub mod curve;
pub mod ledger;
pub mod page;
pub mod rooms;
pub mod symptoms;

use rayon::prelude::*;
use rows::{Row, Shown, Sweep, rows};
use std::ops::RangeInclusive;

/// How many rows the table of failures has.
pub const ALL: u8 = 82;

/// Rows that fail alike.
pub struct Family {
    /// What it is called.
    pub title: &'static str,
    /// Its page, `failures-….md`.
    pub page: &'static str,
    /// Its rows.
    pub rows: RangeInclusive<u8>,
}

/// All families, in the order of their rows.
pub const FAMILIES: [Family; 7] = [
    family("Form factors", "failures-form-factors", 1..=17),
    family("Hemicube and raster", "failures-hemicube", 18..=28),
    family("Visibility", "failures-visibility", 29..=34),
    family("Meshing and what is shown of it", "failures-meshing", 35..=46),
    family("Solvers", "failures-solvers", 47..=59),
    family("Mirrors, skies and the second pass", "failures-second-pass", 60..=76),
    family("Display and files", "failures-display", 77..=82),
];

const fn family(
    title: &'static str,
    page: &'static str,
    rows: RangeInclusive<u8>,
) -> Family {
    Family { title, page, rows }
}

impl Family {
    /// What is written of them.
    pub fn written(&self) -> Vec<Row> {
        rows().into_iter().filter(|row| self.rows.contains(&row.number)).collect()
    }
}

/// All rows that have a curve, with it.
pub fn sweeps() -> Vec<(Row, Sweep)> {
    let sweep = |row: Row| match row.shown {
        Shown::Curve(sweep) => Some((row, sweep())),
        _ => None,
    };
    rows().into_par_iter().filter_map(sweep).collect()
}

/// The generated files of the gallery.
pub fn files() -> Vec<(String, String)> {
    let picture = |(row, sweep): (Row, Sweep)| {
        (format!("generated/failure-{:02}.svg", row.number), curve::svg(&row, &sweep))
    };
    let mut files: Vec<_> = sweeps().into_iter().map(picture).collect();
    for family in &FAMILIES {
        files.push((format!("generated/{}.md", family.page), page::family(family)));
    }
    let written = [
        ("table", page::table()),
        ("count", page::count()),
        ("symptoms", symptoms::table()),
        ("ledger", ledger::markdown()),
        ("rooms", rooms::table()),
    ];
    for (name, text) in written {
        files.push((format!("generated/failures-{name}.md"), text));
    }
    files
}
