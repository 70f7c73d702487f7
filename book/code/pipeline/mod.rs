//! The figures and numbers of the chapter *The pipeline*.
//!
//! [`diagram`] draws the stages; [`stages`] shows what each hands to the next;
//! [`spoilt`] spoils one at a time; [`cost`] says what each takes, from measurements.

pub mod cost;
pub mod diagram;
pub mod spoilt;
pub mod stages;

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/pipeline-diagram.svg".to_string(), diagram::svg()),
        ("generated/pipeline-view.md".into(), stages::caption()),
        ("generated/pipeline-eyes.md".into(), stages::eyes_caption()),
        ("generated/pipeline-sizes.md".into(), cost::table()),
        ("generated/pipeline-cost.md".into(), cost::text()),
        ("generated/pipeline-ledger.md".into(), stages::ledger()),
    ];
    for stage in spoilt::Stage::ALL {
        let name = format!("generated/pipeline-spoilt-{}.md", stage.file());
        files.push((name, spoilt::caption(stage)));
    }
    files
}
