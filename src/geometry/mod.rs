//! Points, planes, frames and the one shape of the course: the convex planar polygon.
//!
//! ```text
//! A n = ½ Σₖ vₖ × vₖ₊₁        area and unit normal (Newell), right-handed
//! ```
//!
//! | type        | use it when                                             |
//! |-------------|---------------------------------------------------------|
//! | [`Polygon`] | a surface: checked once, convex and planar ever after   |
//! | [`Plane`]   | something is clipped, or asked on which side it lies    |
//! | [`Frame`]   | directions are given relative to a normal               |
//! | [`Ray`]     | one point is asked what it sees in one direction        |
//!
//! ```
//! use radiosity::prelude::*;
//! let square = |z: f64| {
//!     let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
//!     Polygon::new(corners.map(|(x, y)| dvec3(x, y, z)).to_vec()).unwrap()
//! };
//! let floor = square(0.0);
//! assert_eq!((floor.area(), floor.normal()), (1.0, DVec3::Z));
//! let left = floor.clipped(Plane::through(dvec3(0.25, 0.0, 0.0), -DVec3::X)).unwrap();
//! assert_eq!(left.area(), 0.25); // in front of the plane is where its normal points
//! ```
//!
//! **Not here:** curved shapes; they are tessellated before they arrive.
//! Chapter *What radiosity assumes* (L01). Sources: Newell (in Sutherland et al. 1974);
//! Sutherland & Hodgman 1974 (clipping).

mod indexed;
mod polygon;
mod split;

pub(crate) use indexed::indexes_lists;
pub(crate) use polygon::newell;
pub use polygon::{Outline, Polygon, PolygonError, clip, clip_into};
pub use split::{MAX_CORNERS, split};

use glam::{DAffine3, DMat3, DVec3};

/// Three numbers, one for each colour channel; the unit is that of the quantity.
pub type Rgb = DVec3;

/// A half-line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts, in scene units.
    pub origin: DVec3,
    /// Where it goes; of unit length.
    pub direction: DVec3,
}

/// An oriented plane `n · x = offset`; its front is where `n` points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Unit normal.
    pub normal: DVec3,
    /// Signed distance of the plane from the origin, in scene units.
    pub offset: f64,
}

impl Plane {
    /// The plane through `point` with unit `normal`.
    pub fn through(point: DVec3, normal: DVec3) -> Plane {
        debug_assert!(normal.is_normalized(), "normal must have unit length: {normal}");
        Plane { normal, offset: normal.dot(point) }
    }

    /// Signed distance of `x`, positive in front, in scene units.
    pub fn height(&self, x: DVec3) -> f64 {
        self.normal.dot(x) - self.offset
    }

    /// The mirror: the isometry that takes each point to the other side, as far off.
    ///
    /// ```text
    /// x' = x − 2 (n·x − offset) n
    /// ```
    pub fn mirror(&self) -> DAffine3 {
        // ANCHOR: mirror
        let n = self.normal;
        let column = |axis: DVec3| axis - 2.0 * n.dot(axis) * n;
        let matrix =
            DMat3::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z));
        DAffine3::from_mat3_translation(matrix, 2.0 * self.offset * n)
        // ANCHOR_END: mirror
    }

    /// The plane after an isometry.
    pub fn moved(&self, by: &DAffine3) -> Plane {
        let point = by.transform_point3(self.offset * self.normal);
        Plane::through(point, by.transform_vector3(self.normal).normalize())
    }

    /// The same plane seen from behind.
    pub fn flipped(&self) -> Plane {
        Plane { normal: -self.normal, offset: -self.offset }
    }
}

/// A right-handed orthonormal frame; `z` is the normal of the surface it stands on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// First tangent.
    pub x: DVec3,
    /// Second tangent.
    pub y: DVec3,
    /// Normal.
    pub z: DVec3,
}

impl Frame {
    /// A frame about the unit normal `z`; the tangents are chosen, the same ones each time.
    pub fn about(z: DVec3) -> Frame {
        debug_assert!(z.is_normalized(), "z must have unit length: {z}");
        let (x, y) = z.any_orthonormal_pair();
        Frame { x, y, z }
    }

    /// The frame about `z` whose `x` points as nearly as it can along `towards`.
    ///
    /// Falls back to [`Frame::about`] where `towards` is parallel to `z`.
    pub fn towards(z: DVec3, towards: DVec3) -> Frame {
        match towards.reject_from_normalized(z).try_normalize() {
            Some(x) => Frame { x, y: z.cross(x), z },
            None => Frame::about(z),
        }
    }

    /// World direction of the local one.
    pub fn world_from_local(&self, v: DVec3) -> DVec3 {
        self.x * v.x + self.y * v.y + self.z * v.z
    }

    /// Local direction of the world's.
    pub fn local_from_world(&self, v: DVec3) -> DVec3 {
        DVec3::new(self.x.dot(v), self.y.dot(v), self.z.dot(v))
    }
}

/// The smallest axis-parallel box that holds all `points`; `(∞, -∞)` for none.
pub fn bounds(points: impl IntoIterator<Item = DVec3>) -> (DVec3, DVec3) {
    points.into_iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(lo, hi), p| {
        (lo.min(p), hi.max(p))
    })
}
