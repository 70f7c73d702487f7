//! The figures and numbers of *Mirrors and windows*.
//!
//! [`unfolded`] draws the mirror world in section; [`levels`] counts what is cut;
//! [`hemicube`] looks into the virtual world from an element.

pub mod hemicube;
pub mod levels;
pub mod unfolded;

/// Name, under `book/src`, and text of every generated file of the chapter.
pub fn files() -> Vec<(String, String)> {
    [
        ("mirrors-unfolded.svg", unfolded::svg()),
        ("mirrors-unfolded.md", unfolded::caption()),
        ("mirrors-levels.svg", levels::svg()),
        ("mirrors-levels.md", levels::table()),
        ("mirrors-images.md", levels::images()),
        ("mirrors-pictures.md", hemicube::caption()),
        ("mirrors-ledger.md", hemicube::ledger()),
    ]
    .map(|(name, text)| (format!("generated/{name}"), text))
    .into()
}
