//! Failures of the hemicube and the raster: rows 18 to 28.

use super::Row;

/// The rows of this family.
pub const ROWS: &[Row] = &[];
