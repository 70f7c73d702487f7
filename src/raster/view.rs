//! From the world to the picture, and back.

use crate::scene::Camera;
use glam::{DAffine3, DMat3, DVec2, DVec3, dvec3};

/// An eye and the pyramid that it looks through.
///
/// A world point `p` is at `(X, Y, W) = M (p − eye)`, on the picture at `(X/W, Y/W)`:
/// `x` to the right, `y` up, both from −1 to 1. `W` is the depth along the line of
/// sight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    eye: DVec3,
    clip_from_world: DMat3,
    world_from_clip: DMat3,
}

impl View {
    /// The view from `eye` with `X = right · (p − eye)`, `Y = up · (p − eye)` and
    /// `W = forward · (p − eye)`.
    ///
    /// The three vectors need be neither unit nor orthogonal, only independent. With
    /// `up = 2 n − forward` the picture ends below at the plane through the eye with
    /// normal `n`: the side of a hemicube.
    pub fn new(eye: DVec3, right: DVec3, up: DVec3, forward: DVec3) -> View {
        let clip_from_world = DMat3::from_cols(right, up, forward).transpose();
        View { eye, clip_from_world, world_from_clip: clip_from_world.inverse() }
    }

    /// The view of a camera, for a picture whose width is `aspect` times its height.
    ///
    /// Where the line of sight is parallel to `camera.up`, some other direction is up.
    pub fn of_camera(camera: &Camera, aspect: f64) -> View {
        let forward = (camera.target - camera.eye).normalize_or(DVec3::NEG_Z);
        let right = forward
            .cross(camera.up)
            .try_normalize()
            .unwrap_or_else(|| forward.any_orthonormal_vector());
        let half = (0.5 * camera.fov.to_radians()).tan();
        let up = right.cross(forward);
        View::new(camera.eye, right / (half * aspect), up / half, forward)
    }

    /// The view in another place, by an isometry. Moved to a mirror's other side, it shows
    /// in each pixel what this one sees there in the mirror.
    pub fn moved(&self, place: &DAffine3) -> View {
        let rows = self.clip_from_world.transpose();
        let turned = |axis: DVec3| place.transform_vector3(axis);
        let [right, up, forward] = [rows.x_axis, rows.y_axis, rows.z_axis].map(turned);
        View::new(place.transform_point3(self.eye), right, up, forward)
    }

    /// The same view with the picture moved by `by`, in picture coordinates.
    pub fn shifted(&self, by: DVec2) -> View {
        let rows = self.clip_from_world.transpose();
        let (right, up, forward) = (rows.x_axis, rows.y_axis, rows.z_axis);
        View::new(self.eye, right + by.x * forward, up + by.y * forward, forward)
    }

    /// Where it is seen from.
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// Picture coordinates `(X, Y, W)` of a world point.
    pub fn clip_from_world(&self, p: DVec3) -> DVec3 {
        self.clip_from_world * (p - self.eye)
    }

    /// Picture coordinates of a plane's normal: `n' · (X, Y, W) = n · (p − eye)`.
    pub fn plane_from_world(&self, normal: DVec3) -> DVec3 {
        self.world_from_clip.transpose() * normal
    }

    /// The world direction seen at a place of the picture, with `W = 1`; not of unit
    /// length.
    pub fn direction(&self, at: DVec2) -> DVec3 {
        self.world_from_clip * dvec3(at.x, at.y, 1.0)
    }

    /// The place on the picture of the centre of pixel `(x, y)`, row 0 on top.
    pub fn pixel_centre(x: u32, y: u32, width: u32, height: u32) -> DVec2 {
        let along = |k: u32, n: u32| (2.0 * k as f64 + 1.0) / n as f64 - 1.0;
        DVec2::new(along(x, width), -along(y, height))
    }
}
