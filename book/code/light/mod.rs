//! The figures and numbers of the chapters on light: *What radiosity assumes*,
//! *Solid angle*, *Radiometry*.
//!
//! [`panorama`] unrolls the sphere of directions; [`pieces`] shows where a small surface
//! is no longer small; [`rays`] samples; [`cost`] draws the charts.

pub mod cost;
pub mod panorama;
pub mod pieces;
pub mod rays;

/// Path and text of the generated files of these chapters.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/solid-angle-view.md".to_string(), panorama::caption()),
        ("generated/solid-angle-ledger.md".into(), panorama::ledger()),
        ("generated/solid-angle-key.md".into(), pieces::key()),
        ("generated/solid-angle-cost.svg".into(), cost::solid_angle()),
        ("generated/solid-angle-cost.md".into(), cost::solid_angle_text()),
    ];
    for (k, height) in panorama::HEIGHTS.into_iter().enumerate() {
        let name = format!("generated/solid-angle-lamp-{k}.md");
        files.push((name, panorama::lamp_caption(height)));
    }
    for cuts in pieces::CUTS {
        let name = format!("generated/solid-angle-pieces-{cuts}.md");
        files.push((name, pieces::caption(cuts)));
    }
    files
}
