//! Failures of solvers: rows 47 to 59.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
