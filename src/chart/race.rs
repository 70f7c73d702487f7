//! The race of the solvers: one room, one accuracy, all ways to get there.

use super::WorkDone;
use crate::form_factor::analytic::Analytic;
use crate::form_factor::{FormFactors, Lost, Matrix, Row, close};
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::scene::built_in;
use crate::solve::{
    Brightest, ConjugateGradients, Enclosure, GaussSeidel, Jacobi, Overshoot, Shoot,
    Solver, contraction, error_bound,
};

/// A solver by name.
#[derive(Debug)]
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish {
    /// Steps are sweeps or shots; factors are transfers, from one element to one other.
    pub work: WorkDone,
    /// The error is at most this, relative to the reflected light.
    pub bound: f64,
    /// Is that the accuracy asked for?
    pub converged: bool,
}

/// The room of the race: the L-shaped room, closed, its lamp round the corner, in factors
/// that are reciprocal and closed to rounding. They are computed once and serve for every
/// reflectance.
#[derive(Debug)]
pub struct Race {
    enclosure: Enclosure,
    factors: Matrix,
    /// What everyone is to reach: [`error_bound`], relative to the reflected light.
    pub accuracy: f64,
}

/// Who has used so many factors is out of the race.
const MOST_TRANSFERS: u64 = 5_000_000_000;

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

    /// Runs one solver in a room of this reflectance.
    pub fn run(&self, contestant: &Contestant, reflectance: f64) -> Finish {
        let mut enclosure = self.enclosure.clone();
        enclosure.reflectance.fill(Rgb::splat(reflectance));
        let rows = self.factors.rows();
        let length = |k: usize| rows[k].factors().len() as u64;
        let all: u64 = (0..rows.len()).map(length).sum();
        let contraction = contraction(&enclosure, &self.factors);
        let bytes = all * size_of::<(u32, f64)>() as u64;
        let mut finish = Finish {
            work: WorkDone { bytes, ..WorkDone::default() },
            bound: f64::INFINITY,
            converged: false,
        };
        let mut solver = (contestant.start)(&enclosure, &self.factors);
        while !finish.converged && finish.work.factors < MOST_TRANSFERS {
            let Some(step) = solver.next() else { break };
            finish.work.steps += 1;
            finish.work.factors +=
                step.shot.map_or(all, |from| length(from.0 as usize));
            finish.bound = error_bound(step.residual, contraction);
            finish.converged = finish.bound <= self.accuracy;
        }
        finish
    }
}
