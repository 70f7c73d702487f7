//! The form factors between faces, with what they say of themselves.

use super::{Closing, close};

/// Form factors between faces: what is not zero, row by row, in order of columns.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct FaceMatrix {
    /// `rows[i]` holds `(j, F_ij)`.
    pub rows: Vec<SparseRow>,
    /// The area of one side of each face, scene units squared.
    pub areas: Vec<f64>,
    /// Does some of what leaves a front reach no front?
    pub open: bool,
    /// How far a factor may be off, absolute: as the method estimates it; in a closed scene,
    /// where rows must sum to one, what they miss at least.
    pub error: f64,
}

/// Columns and numbers.
pub type SparseRow = Vec<(u32, f64)>;

impl FaceMatrix {
    /// `F_ij`.
    pub fn factor(&self, i: u32, j: u32) -> f64 {
        let row = &self.rows[i as usize];
        row.binary_search_by_key(&j, |e| e.0).map_or(0.0, |k| row[k].1)
    }

    /// `max |1 − Σ_j F_ij|` over the faces that have an area.
    pub fn closure(&self) -> f64 {
        let rows = self.rows.iter().zip(&self.areas).filter(|(_, area)| **area > 0.0);
        let missed =
            |row: &SparseRow| (1.0 - row.iter().map(|e| e.1).sum::<f64>()).abs();
        rows.map(|(row, _)| missed(row)).fold(0.0, f64::max)
    }

    /// `max |A_i F_ij − A_j F_ji| / max(A_i, A_j)`.
    pub fn reciprocity(&self) -> f64 {
        let mut most = 0.0_f64;
        for (i, row) in (0u32..).zip(&self.rows) {
            for &(j, factor) in row {
                let (a, b) = (self.areas[i as usize], self.areas[j as usize]);
                let apart = (a * factor - b * self.factor(j, i)).abs();
                most = most.max(apart / a.max(b));
            }
        }
        most
    }

    /// Scales the rows of a closed scene to sums of one, as [`close()`] does; `None`, and
    /// nothing is changed, in an open one, where that would invent light.
    pub fn close(&mut self) -> Option<Closing> {
        (!self.open).then(|| close(&mut self.rows, &self.areas))
    }
}
