//! The figures and numbers of the chapter *The second pass*.
//!
//! [`views`] traces scenes, [`gloss`] one floor under three lobes; [`profile`] draws the
//! lobe and the cones that stand for it; [`depth`] counts what a cut leaves out, [`cost`]
//! says what was measured.

pub mod cost;
pub mod depth;
pub mod gloss;
pub mod profile;
pub mod views;

/// Path and text of the generated files of this chapter.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/second-pass-view.md".to_string(), views::caption()),
        ("generated/second-pass-ball.md".into(), views::ball_caption()),
        ("generated/second-pass-profile.svg".into(), profile::svg()),
        ("generated/second-pass-edge.md".into(), profile::markdown()),
        ("generated/second-pass-depth.md".into(), depth::markdown()),
        ("generated/second-pass-cost.md".into(), cost::text()),
        ("generated/second-pass-by-gloss.md".into(), cost::gloss()),
        ("generated/second-pass-lobe.md".into(), cost::lobe()),
        ("generated/second-pass-ledger.md".into(), views::ledger()),
    ];
    for (k, n) in gloss::EXPONENTS.into_iter().enumerate() {
        let name = format!("generated/second-pass-gloss-{k}.md");
        files.push((name, gloss::caption(n)));
    }
    files
}
