//! Form factors that are kept: all of a scene at once, or each row from its first use on.

use super::{FormFactors, Lost};
use crate::mesh::ElementId;
use rayon::prelude::*;
use std::sync::OnceLock;

/// The non-zeros of one row, in order of columns, and what the row loses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    factors: Box<[(u32, f64)]>,
    lost: Lost,
}

impl Row {
    /// From columns, in order, and factors.
    pub fn new(factors: Vec<(u32, f64)>, lost: Lost) -> Row {
        debug_assert!(factors.is_sorted_by_key(|f| f.0), "columns must be in order");
        Row { factors: factors.into(), lost }
    }

    /// From all factors of a row.
    pub fn of(factors: &[f64], lost: Lost) -> Row {
        let all = (0u32..).zip(factors.iter().copied());
        Row { factors: all.filter(|(_, f)| *f != 0.0).collect(), lost }
    }

    /// Columns and factors that are not zero.
    pub fn factors(&self) -> &[(u32, f64)] {
        &self.factors
    }

    /// What reaches no front.
    pub fn lost(&self) -> Lost {
        self.lost
    }

    fn write(&self, row: &mut [f64]) -> Lost {
        row.fill(0.0);
        self.factors.iter().for_each(|&(j, f)| row[j as usize] = f);
        self.lost
    }
}

/// The matrix of form factors, row `i` from element `i`; zeros are not stored.
#[derive(Clone, Debug, Default, PartialEq)]
#[must_use]
pub struct Matrix {
    rows: Vec<Row>,
}

impl Matrix {
    /// Rows that come from elsewhere.
    pub fn from_rows(rows: Vec<Row>) -> Matrix {
        Matrix { rows }
    }

    /// Computes all rows of a method, in parallel; calls `done` after each.
    pub fn row_by_row(
        method: &(impl FormFactors + ?Sized),
        done: &(dyn Fn() + Sync),
    ) -> Matrix {
        let n = method.len();
        let row = |buffer: &mut Vec<f64>, i: usize| {
            let lost = method.row(ElementId(i as u32), buffer);
            done();
            Row::of(buffer, lost)
        };
        let rows = (0..n).into_par_iter().map_init(|| vec![0.0; n], row);
        Matrix { rows: rows.collect() }
    }

    /// The rows.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }
}

impl FormFactors for Matrix {
    fn len(&self) -> usize {
        self.rows.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        self.rows[from].write(row)
    }
}

/// Keeps each row of a method after its first use.
#[derive(Debug)]
pub struct Cached<'a> {
    method: &'a dyn FormFactors,
    rows: Vec<OnceLock<Row>>,
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

    fn kept(&self, from: ElementId) -> &Row {
        self.rows[from].get_or_init(|| {
            let mut row = vec![0.0; self.method.len()];
            let lost = self.method.row(from, &mut row);
            Row::of(&row, lost)
        })
    }
}

impl FormFactors for Cached<'_> {
    fn len(&self) -> usize {
        self.method.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        self.kept(from).write(row)
    }
}
