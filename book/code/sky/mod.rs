//! The figures and numbers of the chapter *Light from the sky*.
//!
//! [`skies`] paints what shines; [`court`] is the scene under it; [`shadow`] looks for
//! a sun by chance, in three ways; [`tables`] writes what falls on planes and what a
//! texel is worth; [`cost`] says what was measured.

pub mod cost;
pub mod court;
pub mod shadow;
pub mod skies;
pub mod tables;

/// Path and text of the generated files of this chapter.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/sky-view.md".to_string(), court::caption()),
        ("generated/sky-tilts.md".into(), tables::tilts()),
        ("generated/sky-texels.md".into(), tables::texels()),
        ("generated/sky-sun.md".into(), shadow::of_the_sun()),
        ("generated/sky-cost.md".into(), cost::text()),
        ("generated/sky-clouds.md".into(), cost::clouds()),
        ("generated/sky-ledger.md".into(), court::ledger()),
    ];
    for (k, draw) in shadow::Draw::ALL.into_iter().enumerate() {
        files.push((format!("generated/sky-shadow-{k}.md"), shadow::caption(draw)));
    }
    files
}
