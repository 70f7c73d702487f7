//! What the student is given: a room of patches and elements, one colour.

use crate::draw::{uniform, whole_number};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::prelude::{DVec3, Polygon};
use radiosity::random::Stream;

// ANCHOR: room
/// A room: `m` patches, `n` elements.
#[derive(Clone, Debug)]
pub struct Room {
    /// Of each element: its area, m².
    pub area: Vec<f64>,
    /// Of each element: which patch it is part of.
    pub patch_of: Vec<usize>,
    /// Of each element: the factors to the patches, `n` rows of `m`.
    pub rows: Vec<Vec<f64>>,
    /// Of each patch, and of all its elements: emitted radiosity, W/m².
    pub emission: Vec<f64>,
    /// Of each patch, and of all its elements: reflectance.
    pub reflectance: Vec<f64>,
}
// ANCHOR_END: room

// ANCHOR: sample
/// An element as the oracle sees it.
#[derive(Clone, Debug)]
pub struct Sample {
    /// Its area, m².
    pub area: f64,
    /// The radiosity at its corners and its middle, W/m², in any order.
    pub radiosity: Vec<f64>,
}
// ANCHOR_END: sample

// ANCHOR: anchor
/// A T-vertex.
#[derive(Clone, Copy, Debug)]
pub struct Anchor {
    /// Which vertex it is.
    pub vertex: usize,
    /// The ends `a` and `b` of the edge that it lies on.
    pub ends: [usize; 2],
    /// Where on the edge: 0 is `a`, 1 is `b`.
    pub at: f64,
}
// ANCHOR_END: anchor

impl Room {
    /// A box of some size: six walls are the patches, one of which emits. Each is cut into
    /// a few elements of unequal sizes. Factors are Lambert's, from the middles of the elements.
    pub fn draw(stream: &mut Stream) -> Room {
        let [w, d, h] = std::array::from_fn(|_| uniform(stream, 0.6, 2.0));
        let (x, y, z, o) = (DVec3::X * w, DVec3::Y * d, DVec3::Z * h, DVec3::ZERO);
        let walls = [(o, y, z), (x, z, y), (o, z, x), (y, x, z), (o, x, y), (z, y, x)];
        let outline = |[corner, a, b]: [DVec3; 3]| {
            let corners = vec![corner, corner + a, corner + a + b, corner + b];
            Polygon::new(corners).expect("a rectangle is a polygon")
        };
        let lit = whole_number(stream, 0, 6);
        let mut room = Room {
            area: vec![],
            patch_of: vec![],
            rows: vec![],
            emission: (0..6).map(|k| if k == lit { 2.0 } else { 0.0 }).collect(),
            reflectance: (0..6).map(|_| uniform(stream, 0.2, 0.8)).collect(),
        };
        let patches = walls.map(|(corner, a, b)| outline([corner, a, b]));
        for (patch, (corner, a, b)) in walls.into_iter().enumerate() {
            let cut = uniform(stream, 0.15, 0.4);
            let slices = [(0.0, cut), (cut, 0.55), (0.55, 1.0)];
            for (from, to) in slices {
                let e = outline([corner + from * a, (to - from) * a, b]);
                let (at, normal) = (e.centroid(), e.normal());
                room.area.push(e.area());
                room.patch_of.push(patch);
                let factor = |(q, to): (usize, &Polygon)| match q == patch {
                    true => 0.0,
                    false => lambert_polygon(at, normal, to),
                };
                room.rows.push(patches.iter().enumerate().map(factor).collect());
            }
        }
        room
    }

    /// How many patches there are.
    pub fn patches(&self) -> usize {
        self.emission.len()
    }
}
