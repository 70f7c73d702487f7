//! The figures and numbers of the chapter *How wrong is it?*.
//!
//! [`maps`] draws where the error is; [`cube`] is a room whose true error is known, with
//! [`bounds`] of it and what [`noise`] does to a residual; [`cost`] says what was
//! measured.

pub mod bounds;
pub mod cost;
pub mod cube;
pub mod maps;
pub mod noise;

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/how-wrong-view.md".to_string(), maps::caption()),
        ("generated/how-wrong-key.md".into(), maps::key()),
        ("generated/how-wrong-noise.md".into(), noise::table()),
        ("generated/how-wrong-bounds.svg".into(), bounds::svg()),
        ("generated/how-wrong-bounds.md".into(), bounds::table()),
        ("generated/how-wrong-cost.md".into(), cost::text()),
        ("generated/how-wrong-ledger.md".into(), maps::ledger()),
    ];
    for k in 0..maps::EDGES.len() {
        let name = format!("generated/how-wrong-map-{k}.md");
        files.push((name, maps::map_caption(k)));
    }
    for k in 0..maps::POINTS.len() {
        let name = format!("generated/how-wrong-points-{k}.md");
        files.push((name, maps::points_caption(k)));
    }
    files
}
