//! Failures of form factors, in points and pieces: rows 1 to 7.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
