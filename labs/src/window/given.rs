//! What the student is given: a small lamp, Lambert's formula, and where a line goes
//! through an outline.

pub use crate::mirror_world::given::{crossing, lambert, plane};
use radiosity::prelude::DVec3;

// ANCHOR: lamp
/// A lamp so small that each of its points is seen at the same angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// Where it is.
    pub at: DVec3,
    /// The unit normal of its front.
    pub normal: DVec3,
    /// Its area, m².
    pub area: f64,
}
// ANCHOR_END: lamp
