//! Failures of meshing and display: rows 35 to 46.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
