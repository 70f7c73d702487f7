//! What the student is given.

use radiosity::prelude::DVec3;

// ANCHOR: spot
/// A point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Where it is, in m.
    pub at: DVec3,
    /// Unit normal, on the front. Behind it there is neither light sent nor received.
    pub normal: DVec3,
}
// ANCHOR_END: spot

// ANCHOR: sent
/// What a diffuse surface sends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sent {
    /// Radiosity, W/m²: all that leaves, for each area.
    pub radiosity: f64,
    /// Radiance, W/(m² sr): what an eye sees of it.
    pub radiance: f64,
}
// ANCHOR_END: sent
