//! The figures and numbers of the chapter *Who carries which light?*
//!
//! [`parts`] takes a picture apart, class by class; [`cost`] says what was measured.

pub mod cost;
pub mod parts;

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    [
        ("transport-classes.md", parts::table()),
        ("transport-view.md", parts::caption()),
        ("transport-wrong.md", parts::wrong()),
        ("transport-ledger.md", parts::ledger()),
        ("transport-cost.md", cost::text()),
    ]
    .map(|(name, text)| (format!("generated/{name}"), text))
    .into()
}
