//! The cube as an eye sees it, and what its floor keeps.

use super::{EXPONENT, Tiny, floor_pixels, is_floor, scene, shot};
use crate::ledger;
use glam::DVec3;
use radiosity::directional::Directional;
use radiosity::film::{Picture, RgbImage};
use radiosity::room::Room;
use radiosity::trace::PathTracer;
use std::sync::OnceLock;

/// Longest edge of the patches that are shown, in metres.
const EDGE: f64 = 0.125;

/// Bins along an edge of the chessboard, in the panels.
pub const SIDES: [u32; 3] = [1, 4, 8];

/// Rays from each patch, shared by its beams.
const RAYS: usize = 4096;

/// Paths for each pixel of the last panel.
const PATHS: usize = 256;

/// What is brighter than this is white, in all panels: W/(m² sr).
const WHITE: f64 = 0.55;

/// By patches and bins.
pub fn by_bins(side: u32) -> Picture {
    let tiny = Tiny::new(EDGE, side, RAYS / (side * side) as usize);
    tiny.picture(&tiny.solve().0, &shot(3))
}

/// By paths; computed once.
pub fn by_paths() -> &'static Picture {
    static TRUTH: OnceLock<Picture> = OnceLock::new();
    TRUTH.get_or_init(|| {
        let scene = scene();
        PathTracer::of(&Room::of(&scene))
            .picture(&shot(1), PATHS, 0, &|_, _, _| {})
            .picture
    })
}

/// A panel for the page: each pixel as a square of 3.
pub fn panel(picture: &Picture) -> RgbImage {
    enlarged(&picture.display(1.0 / WHITE), 3)
}

fn enlarged(picture: &RgbImage, times: u32) -> RgbImage {
    let (width, height) = (times * picture.width(), times * picture.height());
    RgbImage::from_fn(width, height, |x, y| *picture.get_pixel(x / times, y / times))
}

/// How wrong a panel's floor is, as the test of the pictures finds it.
pub fn off(picture: &Picture) -> f64 {
    error(picture, by_paths())
}

/// The caption of the panels.
pub fn caption() -> String {
    let patches = radiosity::mesh::Mesh::uniform(&scene(), EDGE).elements.len();
    let [one, few, many] = SIDES.map(|side| side * side);
    format!(
        "A cube with a floor that glosses (exponent {EXPONENT}), in {patches} patches: with {one}, \
         {few} and {many} directions for each, and by path tracing, {PATHS} paths for each \
         pixel.\n"
    )
}

/// The floor from above in coarse patches, each with what it sends to all sides.
pub fn floor() -> RgbImage {
    let tiny = Tiny::new(0.25, FLOOR_SIDE, 256);
    let (light, ..) = tiny.solve();
    let cells = 4 * (FLOOR_SIDE + 1) - 1;
    let mut sheet = Picture::new(cells, cells);
    sheet.pixels.fill(radiosity::geometry::Rgb::splat(0.3 * WHITE));
    for (k, e) in tiny.mesh.elements.iter().enumerate() {
        if !is_floor(&e.polygon) {
            continue;
        }
        let middle = 4.0 * e.polygon.centroid();
        let (column, row) = (middle.x as u32, 3 - middle.y as u32);
        square(&mut sheet, [column, row], &light, k as u32);
    }
    enlarged(&sheet.display(1.0 / WHITE), 8)
}

/// Directions along an edge of each patch's picture.
const FLOOR_SIDE: u32 = 8;

/// Writes what a patch sends: its picture's right is the world's +x, its top +y.
fn square(sheet: &mut Picture, at: [u32; 2], light: &Directional, patch: u32) {
    let bins = radiosity::directional::Bins::new(FLOOR_SIDE);
    for bin in 0..bins.len() as u32 {
        let (x, y) = (bin % FLOOR_SIDE, bin / FLOOR_SIDE);
        let local: DVec3 = bins.direction(bin, glam::DVec2::splat(0.5));
        let row = at[1] * (FLOOR_SIDE + 1) + FLOOR_SIDE - 1 - y;
        let column = at[0] * (FLOOR_SIDE + 1) + x;
        let pixel = (row * sheet.width + column) as usize;
        let id = radiosity::mesh::ElementId(patch);
        sheet.pixels[pixel] = light.towards(id, local);
    }
}

/// The caption of that.
pub fn floor_caption() -> String {
    format!(
        "The floor from above, in 16 patches. In each, {} pixels: what the patch sends in \
         {} directions, straight up in the middle, flat away at the rim.\n",
        FLOOR_SIDE * FLOOR_SIDE,
        FLOOR_SIDE * FLOOR_SIDE,
    )
}

/// Where the light of the cube went.
pub fn ledger() -> String {
    let tiny = Tiny::new(0.25, 4, 256);
    let (_, bounces, account) = tiny.solve();
    format!("{}\nAfter {bounces} bounces.\n", ledger::of(&account))
}

/// The error of a picture of the floor: root mean square over its pixels, relative to that
/// of the `truth`.
fn error(picture: &Picture, truth: &Picture) -> f64 {
    let (mut off, mut norm) = (0.0, 0.0);
    let floor = floor_pixels(&shot(1));
    for ((a, b), _) in
        picture.pixels.iter().zip(&truth.pixels).zip(floor).filter(|(_, floor)| *floor)
    {
        off += (*a - *b).length_squared();
        norm += b.length_squared();
    }
    (off / norm).sqrt()
}
