//! The figures and numbers of the chapters on light: *What radiosity assumes*,
//! *Solid angle*, *Radiometry*.
//!
//! [`panorama`] unrolls the sphere of directions; [`pieces`] shows where a small surface
//! is no longer small; [`lamp`] lights a floor; [`assumptions`] shows one number for each
//! element; [`cost`] says what the charts say.

pub mod assumptions;
pub mod cost;
pub mod lamp;
pub mod panorama;
pub mod pieces;

/// Path and text of the generated files of these chapters.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/solid-angle-view.md".to_string(), panorama::caption()),
        ("generated/solid-angle-ledger.md".into(), panorama::ledger()),
        ("generated/solid-angle-key.md".into(), pieces::key()),
        ("generated/solid-angle-cost.md".into(), cost::solid_angle_text()),
    ];
    for (k, height) in panorama::HEIGHTS.into_iter().enumerate() {
        let name = format!("generated/solid-angle-lamp-{k}.md");
        files.push((name, panorama::lamp_caption(height)));
    }
    files.extend([
        ("generated/radiometry-view.md".to_string(), lamp::caption()),
        ("generated/radiometry-key.md".into(), lamp::key()),
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
    files.extend([
        ("generated/assumptions-key.md".to_string(), assumptions::key()),
        ("generated/assumptions-order.md".into(), assumptions::order()),
        ("generated/assumptions-cost.md".into(), assumptions::cost()),
        ("generated/assumptions-ledger.md".into(), assumptions::ledger()),
    ]);
    for (k, edge) in
        assumptions::COARSE.into_iter().chain([assumptions::FINE]).enumerate()
    {
        let name = format!("generated/assumptions-edge-{k}.md");
        files.push((name, assumptions::edge_caption(edge)));
    }
    for cuts in assumptions::CUTS {
        let name = format!("generated/assumptions-error-{cuts}.md");
        files.push((name, assumptions::error_caption(cuts)));
    }
    for cuts in pieces::CUTS {
        let name = format!("generated/solid-angle-pieces-{cuts}.md");
        files.push((name, pieces::caption(cuts)));
    }
    files
}
