//! What the student is given: what is known at a point, and of a room's pieces.

pub use crate::gather::given::Room;

// ANCHOR: point
/// What is known at a random point of a room, for one colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The area, in m², that the point stands for.
    pub area: f64,
    /// `E`, W/m².
    pub emission: f64,
    /// `ρ`.
    pub reflectance: f64,
    /// `B`, W/m²: what the solution has stored here.
    pub stored: f64,
    /// `H`, W/m²: what arrives, gathered twice; the two know nothing of each other.
    pub gathered: [f64; 2],
}
// ANCHOR_END: point
