//! Failures of rules for two polygons: rows 8 to 14.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
