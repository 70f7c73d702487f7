//! Failures of mirrors, skies and the second pass: rows 60 to 76.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
