//! Report question of the lab `race`: where does your method win, where does it lose,
//! and why?
//!
//! ```sh
//! cargo run --release -p labs --example race            # your functions
//! cargo run --release -p labs --example race -- answer  # the answer's
//! ```
//! Writes `out/chart/race.csv`, and the charts of its four pairs beside it.

use labs::lab::chosen;
use labs::race::report::{Clock, PAIRS, race};
use labs::race::{Work, answer, starter};
use radiosity::chart::suites::form_factors::SUITE;
use radiosity::chart::{Bench, Trial, csv, number, read};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let work = chosen(&starter::WORK, &answer::WORK);
    let clock = Clock::start();
    let bench = Bench { meter: &clock, progress: &|what, _| eprintln!("{what}") };
    let mut trials = vec![];
    for name in PAIRS {
        let of_pair = race(work, name, &bench);
        println!("\n{name}: * is the frontier");
        tell(work, &of_pair);
        trials.extend(of_pair);
    }

    let folder = Path::new("out/chart");
    std::fs::create_dir_all(folder)?;
    let table = csv("Form factors: your method beside the crate's.", &trials);
    std::fs::write(folder.join("race.csv"), &table)?;
    println!("\n{}", folder.join("race.csv").display());
    let trials = read(&table)?;
    for view in SUITE.views {
        let chart = view.chart(&trials);
        if !chart.lines.is_empty() {
            let file = folder.join(view.file.replace(SUITE.name, "race") + ".svg");
            std::fs::write(&file, chart.svg())?;
            println!("{}", file.display());
        }
    }
    Ok(())
}

/// The table of one pair; frontier and slopes are found by the student's functions.
fn tell(work: &Work, trials: &[Trial]) {
    let points: Vec<(f64, f64)> = trials.iter().map(|t| (t.seconds, t.error)).collect();
    let frontier = (work.frontier)(&points);
    let mut first = 0;
    for line in trials.chunk_by(|a, b| a.method == b.method) {
        let slope = (work.slope)(&points[first..first + line.len()]);
        println!("  {}, slope {slope:.2}", line[0].method);
        for (k, t) in line.iter().enumerate() {
            let star = if frontier.contains(&(first + k)) { "*" } else { " " };
            let setting = number(t.setting);
            println!("  {star} {setting:>9} {:10.2e} s {:9.1e}", t.seconds, t.error);
        }
        first += line.len();
    }
}
