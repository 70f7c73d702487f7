//! The gallery of failures: every row of the table with its curve or picture.
//!
//! | module    | holds                                                  |
//! |-----------|--------------------------------------------------------|
//! | [`sweeps`] | the rows and their curves, shared with the crate's tests |
//! | [`axis`]  | where a value lies, and which values are told           |
//! | [`curve`] | a curve as SVG                                          |
//! | [`page`]  | rows, families and the table of all of them as Markdown |

// The tests of the crate and this page call the same functions.
#[path = "../../../tests/failures/mod.rs"]
#[allow(missing_docs)]
pub mod sweeps;

pub mod axis;
pub mod curve;
pub mod page;

use rayon::prelude::*;
use std::ops::RangeInclusive;
use sweeps::{Row, Shown, rows};

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

/// Number and drawing of every row that is shown by a curve.
pub fn curves() -> Vec<(u8, String)> {
    let draw = |row: Row| match row.shown {
        Shown::Curve(sweep) => {
            Some((row.number, curve::svg(row.number, row.name, &sweep())))
        }
        _ => None,
    };
    rows().into_par_iter().filter_map(draw).collect()
}

/// The generated files of the gallery.
pub fn files() -> Vec<(String, String)> {
    let picture = |(n, svg)| (format!("generated/failure-{n:02}.svg"), svg);
    let mut files: Vec<_> = curves().into_iter().map(picture).collect();
    for family in &FAMILIES {
        files.push((format!("generated/{}.md", family.page), page::family(family)));
    }
    files.push(("generated/failures-table.md".into(), page::table()));
    files
}
