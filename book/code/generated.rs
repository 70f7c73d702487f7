//! The files of the book that a program writes; `tests/book.rs` fails when one is stale.

use crate::lecture_map;
use std::path::{Path, PathBuf};

/// The folder of the package `book`.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Path and text of every generated file.
pub fn files() -> Vec<(PathBuf, String)> {
    let src = root().join("src");
    vec![(src.join("lecture-map.md"), lecture_map::page())]
}
