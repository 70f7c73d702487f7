//! The figures and numbers of *Speed against accuracy*.
//!
//! [`views`] draws what the same time buys; [`itself`] is a chart that lies; [`peers`] holds
//! other programs beside ours; [`rule`] says who wins where, from all that was measured.

pub mod itself;
pub mod peers;
pub mod rule;
pub mod views;

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/versus-itself.svg".to_string(), itself::svg()),
        ("generated/versus-itself.md".into(), itself::text()),
        ("generated/versus-peers.svg".into(), peers::svg()),
        ("generated/versus-peers.md".into(), peers::tables()),
        ("generated/versus-slopes.md".into(), rule::slopes()),
        ("generated/versus-winners.md".into(), rule::winners()),
        ("generated/versus-cost.md".into(), rule::cost()),
        ("generated/versus-ledger.md".into(), views::ledger()),
    ];
    for k in 0..views::VIEWS.len() {
        files.push((format!("generated/versus-view-{k}.md"), views::caption(k)));
    }
    files
}
