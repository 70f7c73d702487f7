//! Closed rooms with exact form factors.
//!
//! ```text
//! F_ij = A_j / Σ A          pieces of a ball, from within: each sees itself, too
//! ```
//! Those of a box are found by the contour integral, to rounding.

use super::given::Room;
use crate::draw::{uniform, whole_number};
use crate::shapes::rectangle;
use radiosity::form_factor::analytic::exchange;
use radiosity::prelude::{DVec3, Polygon};
use radiosity::random::Stream;

/// A ball from within, in pieces of these areas; nothing emits, all is black.
pub fn ball(area: Vec<f64>) -> Room {
    let whole: f64 = area.iter().sum();
    let row: Vec<f64> = area.iter().map(|a| a / whole).collect();
    let n = area.len();
    dark(area, vec![row; n])
}

/// A box with these sides, one element a wall; nothing emits, all is black.
pub fn cuboid([w, d, h]: [f64; 3]) -> Room {
    let (x, y, z, o) = (DVec3::X * w, DVec3::Y * d, DVec3::Z * h, DVec3::ZERO);
    let walls = [(o, y, z), (x, z, y), (o, z, x), (y, x, z), (o, x, y), (z, y, x)];
    let walls = walls.map(|(corner, a, b)| rectangle(corner, a, b));
    let factor = |i: &Polygon, j: &Polygon| exchange(i, j, 1e-15) / i.area();
    let row = |i: &Polygon| walls.iter().map(|j| factor(i, j)).collect();
    let factors = walls.iter().map(row).collect();
    dark(walls.iter().map(Polygon::area).collect(), factors)
}

fn dark(area: Vec<f64>, factors: Vec<Vec<f64>>) -> Room {
    let n = area.len();
    Room { area, emission: vec![0.0; n], reflectance: vec![0.0; n], factors }
}

/// A ball or a box of any size.
pub fn draw(stream: &mut Stream, curved: bool) -> Room {
    if curved {
        let n = whole_number(stream, 4, 9);
        ball((0..n).map(|_| uniform(stream, 0.2, 3.0)).collect())
    } else {
        cuboid(std::array::from_fn(|_| uniform(stream, 0.5, 3.0)))
    }
}

/// The room with every element in a paint and a light of its own.
pub fn coloured(mut room: Room, stream: &mut Stream) -> Room {
    room.reflectance.iter_mut().for_each(|rho| *rho = uniform(stream, 0.1, 0.9));
    room.emission.iter_mut().for_each(|e| *e = uniform(stream, 0.2, 3.0));
    room
}

/// The room in one paint, one of its elements being a lamp.
pub fn white(mut room: Room, reflectance: f64, stream: &mut Stream) -> Room {
    room.reflectance.fill(reflectance);
    let lamp = whole_number(stream, 0, room.area.len());
    room.emission[lamp] = uniform(stream, 5.0, 20.0);
    room
}

/// Any radiosities.
pub fn light(room: &Room, stream: &mut Stream) -> Vec<f64> {
    room.area.iter().map(|_| uniform(stream, 0.5, 3.0)).collect()
}
