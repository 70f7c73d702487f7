//! Failures of whole matrices of factors: rows 15 to 17.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
