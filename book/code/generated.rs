//! The files of the book that a program writes; `tests/book.rs` fails when one is stale.

use crate::hemicube::{cost, ledger, section, sheet, table, view};
use crate::{
    certificate, equation, factors, lecture_map, light, links, patches, pipeline, plan,
    shooting, surface,
};
use std::path::{Path, PathBuf};

/// The folder of the package `book`.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Path and text of every generated file.
pub fn files() -> Vec<(PathBuf, String)> {
    let mut files = vec![
        ("lecture-map.md".to_string(), lecture_map::page()),
        ("generated/hemicube-section.svg".into(), section::svg()),
        ("generated/hemicube-view.md".into(), view::caption(64)),
        ("generated/hemicube-cost.md".into(), cost::text()),
        ("generated/hemicube-ledger.md".into(), ledger::markdown()),
        ("generated/hemicube-table.md".into(), table::markdown()),
    ];
    for resolution in [16, 64, 256] {
        let name = format!("generated/hemicube-lamp-{resolution}.md");
        files.push((name, view::lamp_caption(resolution)));
    }
    for resolution in [32, 64, 256] {
        let name = format!("generated/hemicube-aliasing-{resolution}.md");
        files.push((name, sheet::caption(resolution, 0.02)));
    }
    files.extend(light::files());
    files.extend(surface::files());
    files.extend(equation::files());
    files.extend(pipeline::files());
    files.extend(certificate::files());
    files.extend(plan::files());
    files.extend(factors::files());
    files.extend(crate::solving::files());
    files.extend(patches::files());
    files.extend(shooting::files());
    files.extend(links::files());
    files.extend(crate::transport::files());
    files.extend(crate::sky::files());
    files.extend(crate::mirrors::files());
    files.extend(crate::side_by_side::files());
    files.extend(crate::second_pass::files());
    files.extend(crate::directional::files());
    files.extend(crate::display::files());
    files.extend(crate::failures::files());
    files.extend(crate::versus::files());
    files.extend(crate::chart::files());
    files.extend(crate::house::files());
    let src = root().join("src");
    files.into_iter().map(|(name, text)| (src.join(name), text)).collect()
}
