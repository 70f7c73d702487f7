//! The figures and numbers of the chapter *The radiosity equation*.
//!
//! [`system`] holds the equation of a room, and one bounce; [`bounces`] draws the light
//! bounce by bounce; [`matrix`] draws who sees whom; [`wrong`] solves with slips in the
//! indices; [`cost`] counts bounces; [`elements`] cuts finer.

pub mod bounces;
pub mod cost;
pub mod elements;
pub mod matrix;
pub mod system;
pub mod wrong;

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/equation-view.md".to_string(), bounces::caption()),
        ("generated/equation-ledger.md".into(), bounces::ledger()),
        ("generated/equation-matrix.md".into(), matrix::caption()),
        ("generated/equation-matrix-key.md".into(), matrix::key()),
        ("generated/equation-cost.svg".into(), cost::svg()),
        ("generated/equation-cost.md".into(), cost::text()),
        ("generated/equation-elements.md".into(), elements::table()),
    ];
    for bounces in bounces::SHOWN {
        let name = format!("generated/equation-alone-{bounces}.md");
        files.push((name, bounces::alone_caption(bounces)));
    }
    for slip in wrong::Slip::ALL {
        let name = format!("generated/equation-wrong-{}.md", slip.file());
        files.push((name, wrong::caption(slip)));
    }
    files
}
