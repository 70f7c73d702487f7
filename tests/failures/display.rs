//! Failures of pictures and files: rows 77 to 82.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
