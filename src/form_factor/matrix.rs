//! Form factors that are kept: all of a scene at once, or each row from its first use on.

use super::{FormFactors, Lost};
use crate::mesh::ElementId;
use rayon::prelude::*;
use std::sync::OnceLock;

/// The matrix of form factors, row `i` from element `i`.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    factors: Vec<f64>,
    lost: Vec<Lost>,
}

impl Matrix {
    /// Computes all rows, in parallel; calls `done` after each.
    pub fn of(method: &dyn FormFactors, done: impl Fn() + Sync) -> Matrix {
        let n = method.len();
        let mut factors = vec![0.0; n * n];
        let rows = factors.par_chunks_mut(n.max(1)).enumerate().map(|(i, row)| {
            let lost = method.row(ElementId(i as u32), row);
            done();
            lost
        });
        let lost = rows.collect();
        Matrix { factors, lost }
    }

    /// A matrix whose numbers come from elsewhere: `rows[i][j] = F_ij`.
    pub fn from_rows(rows: &[Vec<f64>], lost: Vec<Lost>) -> Matrix {
        assert!(
            rows.iter().all(|r| r.len() == rows.len()),
            "the matrix must be square"
        );
        assert_eq!(lost.len(), rows.len(), "one Lost for each row");
        Matrix { factors: rows.concat(), lost }
    }

    /// Row `i`: the factors from element `i`.
    pub fn factors(&self, i: usize) -> &[f64] {
        let n = self.lost.len();
        &self.factors[i * n..(i + 1) * n]
    }

    /// What of the power of element `i` reaches no front.
    pub fn lost(&self, i: usize) -> Lost {
        self.lost[i]
    }
}

impl FormFactors for Matrix {
    fn len(&self) -> usize {
        self.lost.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        row.copy_from_slice(self.factors(from.0 as usize));
        self.lost[from.0 as usize]
    }
}

/// Keeps each row of a method after its first use.
pub struct Cached<'a> {
    method: &'a dyn FormFactors,
    rows: Vec<OnceLock<(Vec<f64>, Lost)>>,
}

impl<'a> Cached<'a> {
    /// Nothing is computed yet.
    pub fn new(method: &'a dyn FormFactors) -> Cached<'a> {
        Cached { method, rows: (0..method.len()).map(|_| OnceLock::new()).collect() }
    }

    /// Computes the rows of these elements, in parallel, ahead of their use.
    pub fn prepare(&self, elements: &[ElementId]) {
        elements.par_iter().for_each(|&from| {
            self.kept(from);
        });
    }

    /// How many rows have been computed.
    pub fn computed(&self) -> usize {
        self.rows.iter().filter(|row| row.get().is_some()).count()
    }

    fn kept(&self, from: ElementId) -> &(Vec<f64>, Lost) {
        self.rows[from.0 as usize].get_or_init(|| {
            let mut row = vec![0.0; self.method.len()];
            let lost = self.method.row(from, &mut row);
            (row, lost)
        })
    }
}

impl FormFactors for Cached<'_> {
    fn len(&self) -> usize {
        self.method.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        let (factors, lost) = self.kept(from);
        row.copy_from_slice(factors);
        *lost
    }
}
