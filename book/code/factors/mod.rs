//! The figures and numbers of the chapter *Form factors*.
//!
//! [`nusselt`] draws what a point sees so that areas are form factors; [`shadow`] puts
//! something between; [`errors`] maps what methods get wrong; [`answers`] asks them one
//! question; [`cost`] draws the chart, from what [`pair`] measures; [`ledger`] closes the
//! page.

pub mod answers;
pub mod cost;
pub mod errors;
pub mod ledger;
pub mod nusselt;
pub mod pair;
pub mod shadow;

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/form-factors-view.md".to_string(), nusselt::caption()),
        ("generated/form-factors-cut.md".into(), shadow::cut_caption()),
        ("generated/form-factors-shadow.md".into(), shadow::caption()),
        ("generated/form-factors-shadow-key.md".into(), shadow::key()),
        ("generated/form-factors-errors-key.md".into(), errors::key()),
        ("generated/form-factors-answers.svg".into(), answers::svg()),
        ("generated/form-factors-answers.md".into(), answers::table()),
        ("generated/form-factors-cost.md".into(), cost::text()),
        ("generated/form-factors-hidden.md".into(), cost::hidden_text()),
        ("generated/form-factors-scaling.md".into(), cost::scaling_text()),
        ("generated/form-factors-rays.md".into(), cost::rays_text()),
        ("generated/form-factors-ledger.md".into(), ledger::markdown()),
    ];
    for tilt in nusselt::TILTS {
        let name = format!("generated/form-factors-lamp-{tilt}.md");
        files.push((name, nusselt::lamp_caption(tilt)));
    }
    for method in errors::Method::ALL {
        let name = format!("generated/form-factors-errors-{}.md", method.file());
        files.push((name, errors::caption(method)));
    }
    files
}
