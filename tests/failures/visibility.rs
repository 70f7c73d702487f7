//! Failures of visibility: rows 29 to 34.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
