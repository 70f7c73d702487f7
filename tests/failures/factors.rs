//! Failures of form factors: rows 1 to 17.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
