//! What the student is given.

// ANCHOR: map
/// A panorama of one channel: radiance in W/(m² sr), row by row from the zenith down.
#[derive(Clone, Debug)]
pub struct Map {
    /// Texels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// All texels, `width` × `height`.
    pub radiance: Vec<f64>,
}
// ANCHOR_END: map

impl Map {
    /// The texel in this column, counted from the left, and row, counted from above.
    pub fn at(&self, column: usize, row: usize) -> f64 {
        self.radiance[row * self.width + column]
    }
}
