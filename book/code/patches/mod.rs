//! The figures and numbers of the chapter *Patches and elements*.
//!
//! [`rounds`] splits the Cornell box a few times over; [`floor`] looks down on floors, to see
//! what tears, leaks and kinks; [`cost`] tells what was measured.

pub mod cost;
pub mod floor;
pub mod rounds;

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/patches-error.md".to_string(), cost::text()),
        ("generated/patches-rounds.md".into(), cost::table()),
        ("generated/patches-ledger.md".into(), rounds::ledger()),
        ("generated/patches-tear.md".into(), floor::tear_caption()),
        ("generated/patches-leak.md".into(), floor::leak_caption()),
        ("generated/patches-bands.md".into(), floor::bands_caption()),
    ];
    for round in 0..rounds::ROUNDS {
        let name = format!("generated/patches-round-{round}.md");
        files.push((name, rounds::caption(round)));
    }
    files
}
