//! What each stage takes, from measurements that are kept with their date.

use crate::chart;
use radiosity::chart::suites::scaling::{STAGE, STAGES};
use radiosity::chart::{Column, Trial, exponent};
use std::fmt::Write;

/// What `radiosity chart scaling` wrote.
const CSV: &str = include_str!("../../data/scaling.csv");

/// The trials of a stage in a scene, from the fewest elements on.
fn of(scene: &str, stage: &str) -> Vec<Trial> {
    let mut trials = chart::trials(CSV);
    trials.retain(|t| t.scene == scene && t.method == stage);
    trials
}

/// A stage of the Cornell box on the finest mesh.
fn finest(stage: &str) -> Trial {
    of(STAGES[0], stage).pop().expect("it was measured")
}

/// The elements of the mesh that captions speak of: the finest.
pub fn shown() -> f64 {
    finest(STAGE[0]).setting
}

/// What is done once for a room on that mesh, in seconds.
pub fn solve_share() -> f64 {
    STAGE[..3].iter().map(|stage| finest(stage).seconds).sum()
}

/// What a picture takes on that mesh, in milliseconds.
pub fn picture_share() -> f64 {
    1e3 * finest(STAGE[3]).seconds
}

/// A time, in the unit that suits it.
fn time(seconds: f64) -> String {
    match 1e3 * seconds {
        t if t >= 1e3 => format!("{seconds:.1} s"),
        t if t >= 10.0 => format!("{t:.0} ms"),
        t if t >= 1.0 => format!("{t:.1} ms"),
        t => format!("{t:.2} ms"),
    }
}

/// Sizes and times as a Markdown table.
pub fn table() -> String {
    let mut text = String::from(
        "| elements n | pairs n² | F, non-zeros | 1 split | 2 form factors | 3 solve | \
         4 render |\n|---|---|---|---|---|---|---|\n",
    );
    let stages = STAGE.map(|stage| of(STAGES[0], stage));
    for (k, factors) in stages[1].iter().enumerate() {
        let n = factors.setting;
        let (pairs, memory) = (n * n / 1e3, factors.work.bytes as f64 / 1e6);
        let _ = write!(text, "| {n} | {pairs:.0} thousand | {memory:.1} MB |");
        for stage in &stages {
            let _ = write!(text, " {} |", time(stage[k].seconds));
        }
        text.push('\n');
    }
    text
}

/// By which powers of the number of elements the stages of a scene grow, from the second
/// mesh on.
fn exponents(scene: &str) -> [f64; 4] {
    STAGE.map(|stage| {
        let trials = of(scene, stage);
        let finer: Vec<&Trial> = trials.iter().skip(1).collect();
        exponent(&finer, Column::Setting, Column::Seconds)
    })
}

/// What the chart says.
pub fn text() -> String {
    let share = finest(STAGE[1]).seconds / solve_share();
    let [split, factors, solve, render] = exponents(STAGES[0]);
    let [_, elsewhere, sweeps, _] = exponents(STAGES[1]);
    format!(
        "**The form factors take {:.0} % of what is done once.** From the second mesh \
         on, the times grow as n to the power {split:.1} (split), {factors:.1} (form \
         factors), {solve:.1} (solve) and {render:.1} (render), fitted to all marks. In the \
         indirect room factors and solution grow by the powers {elsewhere:.1} and \
         {sweeps:.1}.\n",
        100.0 * share
    )
}
