//! The figures and numbers of the chapters on light: *What radiosity assumes*,
//! *Solid angle*, *Radiometry*.
//!
//! [`panorama`] unrolls the sphere of directions; [`pieces`] shows where a small surface
//! is no longer small; [`rays`] samples; [`lamp`]
//! lights a floor; [`cost`] draws the charts.

pub mod cost;
pub mod lamp;
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
    files.extend([
        ("generated/radiometry-view.md".to_string(), lamp::caption()),
        ("generated/radiometry-key.md".into(), lamp::key()),
        ("generated/radiometry-cost.svg".into(), cost::irradiance()),
        ("generated/radiometry-cost.md".into(), cost::irradiance_text()),
        ("generated/radiometry-ledger.md".into(), lamp::ledger()),
    ]);
    for (k, height) in lamp::HEIGHTS.into_iter().enumerate() {
        let name = format!("generated/radiometry-height-{k}.md");
        files.push((name, lamp::height_caption(height)));
    }
    for (k, rule) in lamp::Rule::ALL.into_iter().enumerate() {
        let name = format!("generated/radiometry-rule-{k}.md");
        files.push((name, lamp::wrong_caption(rule)));
    }
    for cuts in pieces::CUTS {
        let name = format!("generated/solid-angle-pieces-{cuts}.md");
        files.push((name, pieces::caption(cuts)));
    }
    files
}
