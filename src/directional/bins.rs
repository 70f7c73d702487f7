//! Directions in bins: the hemisphere as a picture of a few pixels.

use crate::radiometry::cosine_direction;
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::FRAC_1_PI;

const FRAC_4_PI: f64 = 4.0 * FRAC_1_PI;

/// The hemisphere, cut into `side²` bins of equal projected solid angle, `π/side²` sr.
///
/// The squares of a chessboard, mapped to the disc without folding and raised to the
/// hemisphere, as [`cosine_direction`] does. Directions are local: z is the normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bins {
    side: u32,
}

impl Bins {
    /// `side` bins along an edge (positive).
    pub fn new(side: u32) -> Bins {
        assert!(side > 0, "there must be a bin");
        Bins { side }
    }

    /// How many.
    pub fn len(self) -> usize {
        (self.side * self.side) as usize
    }

    /// There is one at least.
    pub fn is_empty(self) -> bool {
        false
    }

    /// How many along an edge of the chessboard.
    pub fn side(self) -> u32 {
        self.side
    }

    /// The direction at a point of the unit square of `bin`.
    ///
    /// Points that fill the square evenly fill the bin evenly by projected solid angle.
    pub fn direction(self, bin: u32, u: DVec2) -> DVec3 {
        let corner = dvec2(f64::from(bin % self.side), f64::from(bin / self.side));
        cosine_direction((corner + u) / f64::from(self.side))
    }

    /// Whose bin a local direction of unit length is; `None` below the horizon.
    pub fn bin_of(self, direction: DVec3) -> Option<u32> {
        if direction.z <= 0.0 {
            return None;
        }
        let last = self.side - 1;
        let cells = f64::from(self.side) * square_of(direction.truncate());
        let [x, y] = cells.to_array().map(|c| (c as u32).min(last));
        Some(y * self.side + x)
    }
}

/// The point of the unit square that the map without folding takes to this one of the
/// unit disc (Shirley & Chiu 1997, the other way).
fn square_of(d: DVec2) -> DVec2 {
    // ANCHOR: square_of
    let radius = d.length();
    let o = if radius == 0.0 {
        DVec2::ZERO
    } else if d.x.abs() > d.y.abs() {
        let signed = radius.copysign(d.x);
        dvec2(signed, FRAC_4_PI * signed * (d.y / d.x).atan())
    } else {
        let signed = radius.copysign(d.y);
        dvec2(FRAC_4_PI * signed * (d.x / d.y).atan(), signed)
    };
    0.5 * (o + DVec2::ONE)
    // ANCHOR_END: square_of
}
