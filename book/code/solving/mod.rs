//! The figures and numbers of the chapter *Solving it*.
//!
//! [`stages`] looks at solvers after equal work; [`stall`] takes reciprocity away; [`cost`]
//! shows the race that was measured.

pub mod cost;
pub mod stages;
pub mod stall;

/// Path and text of the generated files of the chapter.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/solving-view.md".to_string(), stages::view()),
        ("generated/solving-curves.svg".into(), stages::svg()),
        ("generated/solving-curves.md".into(), stages::text()),
        ("generated/solving-ledger.md".into(), stages::ledger()),
        ("generated/solving-stall.svg".into(), stall::svg()),
        ("generated/solving-stall.md".into(), stall::text()),
        ("generated/solving-race.md".into(), cost::table()),
        ("generated/solving-cost.md".into(), cost::text()),
    ];
    for (name, short) in stages::SHOWN {
        let file = format!("generated/solving-{short}.md");
        files.push((file, stages::caption(name)));
    }
    files
}
