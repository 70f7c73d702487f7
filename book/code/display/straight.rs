//! Interpolation in perspective: in the world, or on the picture.

use crate::shooting::beside;
use glam::{DVec3, dvec3};
use radiosity::film::{Picture, RgbImage, Shot};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::wachspress;
use radiosity::raster::View;
use radiosity::scene::Camera;

/// A floor that leads away from an eye 1 m above it: from 1 m ahead to 9 m.
fn floor() -> Polygon {
    let corners = [(-1.0, 1.0), (1.0, 1.0), (1.0, 9.0), (-1.0, 9.0)];
    let corners = corners.map(|(x, y)| dvec3(x, y, 0.0)).to_vec();
    Polygon::new(corners).expect("a rectangle is a polygon")
}

fn shot() -> Shot {
    let camera =
        Camera { eye: DVec3::Z, target: dvec3(0.0, 1.0, 1.0), up: DVec3::Z, fov: 92.0 };
    Shot { camera, width: 160, height: 120, samples: 1 }
}

/// A value that is 0 at the near edge and 1 at the far one, at a place of the picture:
/// interpolated in the world, and on the picture.
pub fn values(at: glam::DVec2) -> Option<[f64; 2]> {
    let (floor, view) = (floor(), shot().view());
    let place = |v: &DVec3| {
        let v = view.clip_from_world(*v);
        dvec3(v.x / v.z, v.y / v.z, 0.0)
    };
    let flat = Polygon::new(floor.vertices().iter().map(place).collect()).ok()?;
    let direction = view.direction(at);
    let hit = view.eye() - direction * (view.eye().z / direction.z);
    if direction.z >= 0.0 || !floor.contains(hit, 1e-9) {
        return None;
    }
    let of = |weights: &[f64]| weights[2] + weights[3];
    let on_picture = wachspress(&flat, at.extend(0.0));
    Some([of(&wachspress(&floor, hit)), of(&on_picture)])
}

/// Eight stripes of equal width on the floor, either way.
pub fn picture() -> RgbImage {
    let shot = shot();
    let panel = |which: usize| {
        let mut picture = Picture::new(shot.width, shot.height);
        for (k, pixel) in picture.pixels.iter_mut().enumerate() {
            let (x, y) = (k as u32 % shot.width, k as u32 / shot.width);
            let at = View::pixel_centre(x, y, shot.width, shot.height);
            *pixel = match values(at) {
                Some(v) if ((8.0 * v[which]) as u32).is_multiple_of(2) => {
                    Rgb::splat(0.8)
                }
                Some(_) => dvec3(0.08, 0.2, 0.5),
                None => Rgb::splat(0.02),
            };
        }
        picture.display(1.0)
    };
    beside(&[panel(0), panel(1)])
}
