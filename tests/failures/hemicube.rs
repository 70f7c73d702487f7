//! Failures of the hemicube: rows 18 to 22.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
