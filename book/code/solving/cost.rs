//! What the race of the solvers says.

use crate::chart::{find, trials};
use radiosity::chart::race::contestants;
use radiosity::chart::suites::solvers::{BOUNCES, RACE};
use std::fmt::Write;

/// Steps, work and time, as a Markdown table.
pub fn table() -> String {
    let trials = trials(include_str!("../../data/solvers.csv"));
    let mut text = String::from(
        "| solver | ρ = 0.5 | 0.9 | 0.99 | 0.999 |\n|---|---|---|---|---|\n",
    );
    for contestant in contestants() {
        let _ = write!(text, "| {} ", contestant.name);
        for bounces in BOUNCES {
            let t = find(&trials, RACE, contestant.name, bounces);
            let (work, time) = (t.work.factors as f64 / 1e6, 1e3 * t.seconds);
            let _ = write!(text, "| {} · {work:.2} · {time:.2} ", t.work.steps);
        }
        text += "|\n";
    }
    text
}

/// What the table says.
pub fn text() -> String {
    let trials = trials(include_str!("../../data/solvers.csv"));
    let work = |name, bounces| find(&trials, RACE, name, bounces).work;
    let times = |name: &'static str, bounces| {
        let [own, least] =
            [name, "conjugate gradients"].map(|n| work(n, bounces).factors);
        own as f64 / least as f64
    };
    let growth = |name| work(name, 1000.0).steps as f64 / work(name, 10.0).steps as f64;
    format!(
        "From ρ = 0.9 to 0.999 light bounces a hundred times as often. Jacobi takes {:.0} \
         times as many steps, Gauss–Seidel {:.0}, conjugate gradients {:.1}. At ρ = 0.5 \
         overshooting does the least work of all, and conjugate gradients do {:.1} times as \
         much; at 0.999 sweeps do {:.0} times the work of conjugate gradients, and \
         overshooting {:.0} times. A shot costs more time than its transfers: the books are \
         drawn up after each, as they are after each sweep.\n",
        growth("Jacobi"),
        growth("Gauss-Seidel"),
        growth("conjugate gradients"),
        1.0 / times("overshooting", 2.0),
        times("Gauss-Seidel", 1000.0),
        times("overshooting", 1000.0),
    )
}
