//! What the student is given: round lamps, glances, and what they meet.

use radiosity::prelude::DVec3;

// ANCHOR: cap
/// What a point sees of a round lamp: all directions so near to one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cap {
    /// The unit direction to its middle.
    pub axis: DVec3,
    /// The angle from there to its rim, in rad, at most π/2.
    pub half_angle: f64,
}
// ANCHOR_END: cap

// ANCHOR: glance
/// A glance along a ray; surfaces that it meets are glossy by this half angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glance {
    /// Where it starts.
    pub from: DVec3,
    /// Where it goes; of unit length.
    pub direction: DVec3,
    /// Of the cone about each reflection, in rad.
    pub half_angle: f64,
    /// Each cone is looked at by `strata` · `strata` rays.
    pub strata: usize,
}
// ANCHOR_END: glance

// ANCHOR: hit
/// What a glance meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Where.
    pub at: DVec3,
    /// The unit normal there, towards the eye.
    pub normal: DVec3,
    /// The radiance of its own, diffuse light, W/(m² sr).
    pub light: f64,
    /// The share of the mean radiance over the cone that it reflects; 0 for dull ones.
    pub gloss: f64,
}
// ANCHOR_END: hit
