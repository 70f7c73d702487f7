//! T-vertices: where shading tears, and where a pixel falls through.

use super::enlarged;
use crate::shooting::beside;
use glam::{DVec3, dvec3};
use radiosity::film::{RgbImage, Shot, colour_of_id};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::Mesh;
use radiosity::raster::{ItemBuffer, Seen};
use radiosity::scene::{Camera, built_in};
use std::f64::consts::PI;

fn rectangle(corner: DVec3, a: DVec3, b: DVec3) -> Polygon {
    let corners = vec![corner, corner + a, corner + a + b, corner + b];
    Polygon::new(corners).expect("a rectangle is a polygon")
}

/// A floor of four elements under a low lamp, one of them split, seen from the side: its
/// T-vertices with the light that is there, and anchored.
pub fn torn() -> RgbImage {
    let floor = rectangle(dvec3(-0.5, -0.5, 0.0), DVec3::X, DVec3::Y);
    let lamp = rectangle(dvec3(-0.1, -0.1, 0.2), DVec3::Y * 0.2, DVec3::X * 0.2);
    let scene = crate::map::grey([(floor, 0.0, 0.5)]);
    let mesh = Mesh::patched(&scene, 0.5).split(&[true, false, false, false]);
    let light = |&v: &DVec3| Rgb::splat(PI * lambert_polygon(v, DVec3::Z, &lamp));
    let own: Vec<Rgb> = mesh.vertices.iter().map(light).collect();
    let mut anchored = own.clone();
    mesh.anchor(&mut anchored);
    let camera = Camera {
        eye: dvec3(-0.75, -0.95, 0.55),
        target: dvec3(-0.1, -0.1, 0.0),
        up: DVec3::Z,
        fov: 45.0,
    };
    let shot = Shot { camera, width: 160, height: 120, samples: 2 };
    beside(&[own, anchored].map(|b| shot.smooth(&mesh, &b).display(4.0)))
}

/// Cells along an edge of the hemicubes that are searched for holes.
const RESOLUTION: u32 = 128;

/// What was found in a closed room: every cell that shows nothing is a hole.
pub struct Holes {
    /// Cells looked at.
    pub cells: usize,
    /// Those that show nothing.
    pub holes: usize,
    /// About the first of them.
    pub closeup: Option<RgbImage>,
}

/// Looks around from each element.
pub fn holes(name: &str) -> Holes {
    let scene = built_in(name).expect("it is built in");
    let mesh = Mesh::uniform(&scene, scene.diagonal() / 5.0);
    let cube = Hemicube::new(&mesh, RESOLUTION);
    let mut found = Holes { cells: 0, holes: 0, closeup: None };
    for polygon in mesh.polygons() {
        cube.faces(polygon.centroid(), polygon.normal(), |_, items| {
            found.cells += items.pixels().count();
            for (cell, seen) in items.pixels().enumerate() {
                if seen == Seen::Nothing {
                    found.holes += 1;
                    let at = [cell as u32 % RESOLUTION, cell as u32 / RESOLUTION];
                    found.closeup.get_or_insert_with(|| closeup(items, at));
                }
            }
        });
    }
    found
}

/// The ids about a pixel, in colours; nothing is black.
fn closeup(items: &ItemBuffer, at: [u32; 2]) -> RgbImage {
    const HALF: u32 = 7;
    let within = |x: u32, size: u32| x.clamp(HALF, size - 1 - HALF) - HALF;
    let (left, top) = (within(at[0], items.width()), within(at[1], items.height()));
    let picture = RgbImage::from_fn(2 * HALF + 1, 2 * HALF + 1, |x, y| {
        match items.seen(left + x, top + y) {
            Seen::Front(id) | Seen::Back(id) => colour_of_id(id).into(),
            Seen::Nothing => [0; 3].into(),
        }
    });
    enlarged(&picture, 12)
}

/// In the L-shaped room, whose pieces are meshed each by itself.
pub fn in_the_l_room() -> Holes {
    holes("l-room")
}

/// In a cube, where corners meet corners.
pub fn in_the_cube() -> Holes {
    holes("furnace")
}

/// How rare they are.
pub fn text() -> String {
    let Holes { cells, holes, .. } = in_the_l_room();
    format!(
        "Of {:.1} million cells of hemicubes in the closed L-shaped room, {holes} show nothing: a \
         share of {:.0e}. In a cube, where corners meet corners, none does.",
        cells as f64 / 1e6,
        holes as f64 / cells as f64
    )
}
