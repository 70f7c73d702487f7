//! From where a scene is seen.

use super::Surface;
use crate::geometry::{Polygon, bounds};
use glam::DVec3;

/// From where, and how, the scene is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Position, in scene units.
    pub eye: DVec3,
    /// A point in the middle of the picture.
    pub target: DVec3,
    /// The world's up.
    pub up: DVec3,
    /// Vertical field of view, in degrees, in `(0, 180)`.
    pub fov: f64,
}

impl Camera {
    /// A view that shows `surfaces`, for scenes that bring none.
    ///
    /// ```text
    /// s = Σ A n        zero for closed surfaces, and points out of an opening
    /// c = Σ A sign(n · (middle − centroid))       > 0 when the fronts look inwards
    /// ```
    ///
    /// A room with an opening (`|s|` above a fifth of the area of the scene's box) is
    /// looked into from there, a closed room from a corner inside, and an object from
    /// outside, a little from above.
    pub fn showing(surfaces: &[Surface], up: DVec3) -> Camera {
        let corners =
            surfaces.iter().flat_map(|s| s.polygon.vertices().iter().copied());
        let (low, high) = bounds(corners);
        let (middle, size) = (0.5 * (low + high), high - low);
        let up = up.normalize_or(DVec3::Y);
        let mut opening = DVec3::ZERO;
        let mut inwards = 0.0;
        for polygon in surfaces.iter().map(|s| &s.polygon) {
            let (area, normal) = (polygon.area(), polygon.normal());
            opening += area * normal;
            inwards += area * normal.dot(middle - polygon.centroid()).signum();
        }
        let side = DVec3::new(size.y * size.z, size.z * size.x, size.x * size.y);
        // Two directions across `up`, fixed for a given `up`.
        let (right, back) = up.any_orthonormal_pair();
        if opening.length() <= 0.2 * side.max_element() && inwards > 0.0 {
            // Of four corners the one that most fronts look at: not all may be inside.
            let corner = |(r, b): (f64, f64)| {
                middle + size * (0.4 * r * right + 0.42 * b * back + 0.1 * up)
            };
            let seen = |eye: DVec3| {
                let looks = |p: &&Polygon| p.plane().height(eye) > 0.0;
                let polygons = surfaces.iter().map(|s| &s.polygon);
                polygons.filter(looks).map(Polygon::area).sum::<f64>()
            };
            let corners =
                [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)].map(corner);
            let eye = corners.into_iter().max_by(|&a, &b| seen(a).total_cmp(&seen(b)));
            let eye = eye.unwrap_or(middle);
            return Camera { eye, target: middle, up, fov: 75.0 };
        }
        let mut from = opening.normalize_or(up);
        if opening.length() <= 0.2 * side.max_element() {
            from = right + 2.0 * back + up; // a closed object
        } else if from.dot(up).abs() > 0.9 {
            from += back; // not straight down on it
        }
        let fov = 40.0_f64;
        let distance = 0.5 * size.length() / (0.5 * fov.to_radians()).sin();
        Camera { eye: middle + distance * from.normalize(), target: middle, up, fov }
    }
}
