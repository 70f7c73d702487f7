//! The race of the solvers, from measurements that are kept with their date.

use radiosity::chart::race::{self, Finish, contestants};
use std::fmt::Write;

/// What `radiosity chart solvers` wrote.
const CSV: &str = include_str!("../../data/solvers-2026-11-22.csv");

/// All runs; a line that does not fit is a mistake of the file.
pub fn finishes() -> Vec<Finish> {
    let names = contestants().map(|c| c.name);
    let finish = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let [solver, reflectance, steps, transfers, seconds, bound, converged] =
            cells[..]
        else {
            return None;
        };
        Some(Finish {
            solver: names.into_iter().find(|&name| name == solver)?,
            reflectance: reflectance.parse().ok()?,
            steps: steps.parse().ok()?,
            transfers: transfers.parse().ok()?,
            seconds: seconds.parse().ok()?,
            bound: bound.parse().ok()?,
            converged: converged.parse().ok()?,
        })
    };
    let lines = CSV.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| finish(line).expect("a line of the CSV does not fit")).collect()
}

/// Time over the number of bounces.
pub fn time_svg() -> String {
    let title = "Processor time of each solver against the number of bounces";
    race::chart(title, "CPU seconds", &finishes(), |f| f.seconds).svg()
}

/// Steps, work and time, as a Markdown table.
pub fn table() -> String {
    let finishes = finishes();
    let mut text = String::from(
        "| solver | ρ = 0.5 | 0.9 | 0.99 | 0.999 |\n|---|---|---|---|---|\n",
    );
    for contestant in contestants() {
        let _ = write!(text, "| {} ", contestant.name);
        for f in finishes.iter().filter(|f| f.solver == contestant.name) {
            let (work, time) = (f.transfers as f64 / 1e6, 1e3 * f.seconds);
            let _ = write!(text, "| {} · {work:.2} · {time:.2} ", f.steps);
        }
        text += "|\n";
    }
    text
}

/// What the table says.
pub fn text() -> String {
    let finishes = finishes();
    let of = |name: &str, rho: f64| {
        let fits = |f: &&Finish| f.solver == name && f.reflectance == rho;
        finishes.iter().find(fits).expect("it was in the race")
    };
    let times = |name: &str, rho: f64| {
        of(name, rho).transfers as f64 / of("conjugate gradients", rho).transfers as f64
    };
    let growth = |name: &str| of(name, 0.999).steps as f64 / of(name, 0.9).steps as f64;
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
        1.0 / times("overshooting", 0.5),
        times("Gauss-Seidel", 0.999),
        times("overshooting", 0.999),
    )
}
