//! The race of the solvers: one room, one accuracy, all ways to get there.

use super::{Chart, Line, Mark};
use crate::form_factor::analytic::Analytic;
use crate::form_factor::{FormFactors, Lost, Matrix, Row, close};
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::scene::built_in;
use crate::solve::{
    Brightest, ConjugateGradients, Enclosure, GaussSeidel, Jacobi, Overshoot, Shoot,
    Solver, contraction, error_bound,
};
use std::fmt::Write;

/// A solver by name.
pub struct Contestant {
    /// As the table calls it.
    pub name: &'static str,
    /// Puts it on the start.
    pub start: for<'a> fn(&'a Enclosure, &'a Matrix) -> Box<dyn Solver + 'a>,
}

/// All solvers there are.
pub fn contestants() -> [Contestant; 6] {
    [
        Contestant { name: "Jacobi", start: |e, f| Box::new(Jacobi::new(e, f)) },
        Contestant {
            name: "Gauss-Seidel",
            start: |e, f| Box::new(GaussSeidel::new(e, f)),
        },
        Contestant {
            name: "shooting by radiosity",
            start: |e, f| Box::new(Shoot::new(e, f, Brightest::ByRadiosity)),
        },
        Contestant {
            name: "shooting by power",
            start: |e, f| Box::new(Shoot::new(e, f, Brightest::ByPower)),
        },
        Contestant {
            name: "overshooting",
            start: |e, f| Box::new(Overshoot::new(e, f)),
        },
        Contestant {
            name: "conjugate gradients",
            start: |e, f| Box::new(ConjugateGradients::new(e, f)),
        },
    ]
}

/// How a solver came in.
#[derive(Clone, Debug, PartialEq)]
pub struct Finish {
    /// The solver.
    pub solver: &'static str,
    /// The reflectance of the room.
    pub reflectance: f64,
    /// Sweeps, or shots.
    pub steps: usize,
    /// Factors used: light sent from one element to one other.
    pub transfers: u64,
    /// Processor time of one thread, s.
    pub seconds: f64,
    /// The error is at most this.
    pub bound: f64,
    /// Is that the accuracy asked for?
    pub converged: bool,
}

/// The room of the race: the L-shaped room, closed, its lamp round the corner, in factors
/// that are reciprocal and closed to rounding. They are computed once and serve for every
/// reflectance.
pub struct Race {
    enclosure: Enclosure,
    factors: Matrix,
    /// What everyone is to reach: [`error_bound`], relative to the reflected light.
    pub accuracy: f64,
}

/// Who has used so many factors is out of the race.
const MOST_TRANSFERS: u64 = 5_000_000_000;

/// A time is the least of so many, unless one takes longer than [`LONG`].
const ROUNDS: usize = 5;

/// What takes longer than this, in s, is measured once.
const LONG: f64 = 0.5;

impl Race {
    /// With elements whose edges are no longer than `edge`, m.
    pub fn new(edge: f64, accuracy: f64) -> Race {
        let scene = built_in("l-room").expect("the room is built in");
        let mesh = Mesh::uniform(&scene, edge);
        let enclosure = Enclosure::of(&scene, &mesh);
        let exact = Analytic::new(&scene, &mesh, 1e-5, 0).sharp().without_losses();
        let found = exact.matrix(&|| ());
        // What is left of errors near 1e-5 is spread, for the race is about solvers: theory
        // speaks of rows that sum to one.
        let mut rows: Vec<_> =
            found.rows().iter().map(|row| row.factors().to_vec()).collect();
        close(&mut rows, &enclosure.area);
        let rows = rows.into_iter().map(|row| Row::new(row, Lost::default())).collect();
        Race { enclosure, factors: Matrix::from_rows(rows), accuracy }
    }

    /// How many elements there are.
    pub fn elements(&self) -> usize {
        self.enclosure.len()
    }

    /// Runs one solver in a room of this reflectance; `clock` tells the processor time of
    /// the calling thread, in s. Sums over threads are not the race: run it on one.
    pub fn run(
        &self,
        contestant: &Contestant,
        reflectance: f64,
        clock: &dyn Fn() -> f64,
    ) -> Finish {
        let mut enclosure = self.enclosure.clone();
        enclosure.reflectance.fill(Rgb::splat(reflectance));
        let mut best = self.once(&enclosure, contestant, clock);
        for _ in 1..ROUNDS {
            if best.seconds > LONG {
                break;
            }
            let again = self.once(&enclosure, contestant, clock);
            best.seconds = best.seconds.min(again.seconds);
        }
        best
    }

    fn once(
        &self,
        enclosure: &Enclosure,
        contestant: &Contestant,
        clock: &dyn Fn() -> f64,
    ) -> Finish {
        let rows = self.factors.rows();
        let length = |k: usize| rows[k].factors().len() as u64;
        let all = (0..rows.len()).map(length).sum();
        let contraction = contraction(enclosure, &self.factors);
        let mut finish = Finish {
            solver: contestant.name,
            reflectance: enclosure.largest_reflectance().x,
            steps: 0,
            transfers: 0,
            seconds: 0.0,
            bound: f64::INFINITY,
            converged: false,
        };
        let start = clock();
        let mut solver = (contestant.start)(enclosure, &self.factors);
        while !finish.converged && finish.transfers < MOST_TRANSFERS {
            let Some(step) = solver.next() else { break };
            finish.steps += 1;
            finish.transfers += step.shot.map_or(all, |from| length(from.0 as usize));
            finish.bound = error_bound(step.residual, contraction);
            finish.converged = finish.bound <= self.accuracy;
        }
        finish.seconds = clock() - start;
        finish
    }
}

/// All runs as a table for programs, after the `#` lines of `origin`.
pub fn csv(origin: &str, finishes: &[Finish]) -> String {
    let mut csv: String = origin.lines().map(|line| format!("# {line}\n")).collect();
    csv += "solver,reflectance,steps,transfers,cpu_seconds,bound,converged\n";
    for f in finishes {
        // Writing to a string cannot fail.
        let _ = writeln!(
            csv,
            "{},{},{},{},{:.3e},{:.3e},{}",
            f.solver,
            f.reflectance,
            f.steps,
            f.transfers,
            f.seconds,
            f.bound,
            f.converged
        );
    }
    csv
}

/// A number of each run, as a table for people: a line for each solver, a column for each
/// reflectance.
pub fn table(finishes: &[Finish], number: impl Fn(&Finish) -> String) -> String {
    let mut table = String::new();
    let mut named = "";
    for f in finishes {
        if f.solver != named {
            named = f.solver;
            table += &format!("\n{named:<22}");
        }
        let shown = if f.converged { number(f) } else { "-".into() };
        table += &format!("{shown:>12}");
    }
    table.trim_start().to_string() + "\n"
}

/// A number of each run over `1/(1 − ρ)`, the number of bounces that light makes.
pub fn chart(
    title: &str,
    upward: &str,
    finishes: &[Finish],
    number: impl Fn(&Finish) -> f64,
) -> Chart {
    let mut lines: Vec<Line> = vec![];
    for f in finishes.iter().filter(|f| f.converged) {
        let x = 1.0 / (1.0 - f.reflectance);
        let mark = Mark { x, y: number(f), label: String::new() };
        match lines.last_mut().filter(|line| line.name == f.solver) {
            Some(line) => line.marks.push(mark),
            None => lines.push(Line { name: f.solver.into(), marks: vec![mark] }),
        }
    }
    Chart {
        title: title.into(),
        across: "1/(1 − ρ): how often light bounces".into(),
        upward: upward.into(),
        least: 0.0,
        lines,
        ..Chart::default()
    }
}
