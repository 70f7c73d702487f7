//! The Cornell box, solved, as a camera shows it.

use super::enlarged;
use crate::pipeline::stages::{EDGE, solved};
use crate::{ledger, map};
use radiosity::film::{FalseColour, Picture, RgbImage, Shot, colour_of_id};
use radiosity::geometry::Rgb;
use radiosity::raster::{ItemBuffer, Seen, View};
use radiosity::scene::{Camera, built_in};

/// Pixels along an edge of a picture.
const SIZE: u32 = 160;

/// Pixels along an edge of those whose pixels are to be seen.
const COARSE: u32 = 32;

/// What is brighter is white in the four views: W/(m² sr).
const WHITE: f64 = 1.0;

pub(super) fn camera() -> Camera {
    built_in("cornell").expect("`cornell` is built in").camera
}

fn shot(size: u32, samples: u32) -> Shot {
    Shot { camera: camera(), width: size, height: size, samples }
}

/// Smoothly shaded.
pub fn smooth() -> Picture {
    shot(SIZE, 2).smooth(&solved().field.mesh, &solved().vertex_radiosity)
}

/// One radiance for each element.
pub fn flat() -> Picture {
    shot(SIZE, 2).flat(&solved().field.mesh, &solved().radiosity)
}

/// Flat, smooth, with its mesh, in false colour.
pub fn views() -> [RgbImage; 4] {
    let (flat, smooth) = (flat(), smooth());
    let mesh = shot(SIZE, 1).with_mesh(flat.display(1.0 / WHITE), &solved().field.mesh);
    let colours = scale(&smooth).draw(&smooth);
    [flat.display(1.0 / WHITE), smooth.display(1.0 / WHITE), mesh, colours]
}

fn scale(picture: &Picture) -> FalseColour {
    FalseColour::of(picture)
}

/// The key to the last view.
pub fn key() -> String {
    let FalseColour { low, high } = scale(&smooth());
    map::key(low, high, 5, |v| format!("{v:.3}"))
}

/// The caption of the four views.
pub fn caption() -> String {
    let (patches, elements) =
        (solved().field.patches, solved().field.mesh.elements.len());
    let _ = patches;
    format!(
        "The Cornell box in {elements} elements of at most {EDGE} m, {SIZE} × {SIZE} pixels of \
         2 × 2 samples: one solution, drawn in four ways.\n"
    )
}

/// What each pixel keeps of a coarse picture: the id, and how near that is.
pub fn kept() -> [RgbImage; 2] {
    let (mesh, shot) = (&solved().field.mesh, shot(COARSE, 1));
    let items: ItemBuffer = shot.items(mesh);
    let view = shot.view();
    let mut near = Picture::new(COARSE, COARSE);
    let mut ids = RgbImage::new(COARSE, COARSE);
    for (k, seen) in items.pixels().enumerate() {
        let (x, y) = (k as u32 % COARSE, k as u32 / COARSE);
        let Seen::Front(id) = seen else { continue };
        ids.put_pixel(x, y, colour_of_id(id).into());
        let plane = mesh.elements[id as usize].polygon.plane();
        let direction = view.direction(View::pixel_centre(x, y, COARSE, COARSE));
        let depth = -plane.height(view.eye()) / plane.normal.dot(direction);
        near.pixels[k] = Rgb::splat(1.0 / depth);
    }
    let nearest = near.pixels.iter().map(|p| p.x).fold(0.0, f64::max);
    [enlarged(&ids, 6), enlarged(&near.display(1.0 / nearest), 6)]
}

/// Where the light of the views went.
pub fn ledger() -> String {
    ledger::table(solved())
}
