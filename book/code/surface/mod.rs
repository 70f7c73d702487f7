//! The figures and numbers of the chapters on surfaces: *How surfaces scatter: the BRDF*,
//! *Albedo and the conservation of energy*.
//!
//! [`ball`] lights a ball, under a lamp and in a furnace; [`swap`] exchanges lamp and eye;
//! [`lobes`] draws lobes and albedos as curves; [`cost`] says what the charts say; [`ledger`]
//! closes the pages.

pub mod ball;
pub mod cost;
pub mod ledger;
pub mod lobes;
pub mod swap;

/// Path and text of the generated files of these chapters.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/brdf-view.md".to_string(), ball::caption()),
        ("generated/brdf-lobes.svg".into(), lobes::polar()),
        ("generated/brdf-swap-key.md".into(), swap::key()),
        ("generated/brdf-cost.md".into(), cost::samples_text()),
        ("generated/brdf-ledger.md".into(), ledger::of_the_ball()),
        ("generated/albedo-view.md".into(), ball::furnace_caption()),
        ("generated/albedo-curves.svg".into(), lobes::curves()),
        ("generated/albedo-cost.md".into(), cost::albedo_text()),
        ("generated/albedo-numbers.md".into(), cost::numbers()),
        ("generated/albedo-bounces.md".into(), ledger::bounces()),
        ("generated/albedo-ledger.md".into(), ledger::of_the_furnace()),
    ];
    for (k, n) in ball::EXPONENTS.into_iter().enumerate() {
        files.push((format!("generated/brdf-ball-{k}.md"), ball::lit_caption(n)));
    }
    for (k, rule) in swap::Rule::ALL.into_iter().enumerate() {
        files.push((format!("generated/brdf-swap-{k}.md"), swap::caption(rule)));
    }
    for (k, n) in ball::WIDTHS.into_iter().enumerate() {
        files.push((format!("generated/albedo-ball-{k}.md"), ball::rim_caption(n)));
    }
    for (k, n) in ball::BARE.into_iter().enumerate() {
        files.push((format!("generated/albedo-bare-{k}.md"), ball::bare_caption(n)));
    }
    files
}
