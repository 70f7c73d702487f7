//! Failures of pictures of ids: rows 23 to 28.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
