//! A solved mesh as a camera sees it.

use super::{Picture, draw};
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::raster::{ItemBuffer, Seen, View};
use crate::scene::Camera;
use glam::{DVec3, dvec2};
use image::RgbImage;
use rayon::prelude::*;
use std::f64::consts::PI;

/// A camera and the size of its picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shot {
    /// From where, and how, the scene is seen.
    pub camera: Camera,
    /// Width in pixels, at most [`crate::raster::MAX_SIZE`].
    pub width: u32,
    /// Height in pixels, at most [`crate::raster::MAX_SIZE`].
    pub height: u32,
    /// Samples along each side of a pixel: 1 leaves stairs at edges, 3 takes the mean
    /// of nine.
    pub samples: u32,
}

impl Shot {
    /// The elements with one radiance each, `B/π`; backs and the void are black.
    ///
    /// `radiosity` holds `B` of the front of each element, in W/m².
    // ANCHOR: flat
    pub fn flat(&self, mesh: &Mesh, radiosity: &[Rgb]) -> Picture {
        debug_assert_eq!(radiosity.len(), mesh.elements.len(), "one B per element");
        self.shade(mesh, |element, _, _| radiosity[element] / PI)
    }
    // ANCHOR_END: flat

    /// The elements with radiance interpolated between their corners, in the world
    /// (that is, correctly in perspective); backs and the void are black.
    ///
    /// `radiosity` holds `B` of each vertex of the mesh, in W/m²
    /// ([`Mesh::vertex_values`], [`Mesh::value_at`]).
    pub fn smooth(&self, mesh: &Mesh, radiosity: &[Rgb]) -> Picture {
        debug_assert_eq!(radiosity.len(), mesh.vertices.len(), "one B per vertex");
        self.shade(mesh, |element, eye, direction| {
            let element = &mesh.elements[element];
            let plane = element.polygon.plane();
            let hit =
                eye - direction * (plane.height(eye) / plane.normal.dot(direction));
            mesh.value_at(element, hit, radiosity) / PI
        })
    }

    /// The ids of the elements at the centres of the pixels: for picking.
    pub fn items(&self, mesh: &Mesh) -> ItemBuffer {
        let mut items = ItemBuffer::new(self.width, self.height);
        draw_all(&mut items, &self.view(), mesh);
        items
    }

    /// `picture` of the same shot with the outlines of all elements that it shows.
    pub fn with_mesh(&self, picture: RgbImage, mesh: &Mesh) -> RgbImage {
        draw::outlines(picture, mesh, &self.view(), &self.items(mesh))
    }

    /// The view of the camera.
    pub fn view(&self) -> View {
        View::of_camera(&self.camera, self.width as f64 / self.height as f64)
    }

    // ANCHOR: shade
    /// The mean over the samples of each pixel of `radiance(element, eye, direction)`.
    ///
    /// The picture is drawn once for each sample, moved by parts of a pixel.
    fn shade(
        &self,
        mesh: &Mesh,
        radiance: impl Fn(usize, DVec3, DVec3) -> Rgb + Sync,
    ) -> Picture {
        let mut picture = Picture::new(self.width, self.height);
        let mut items = ItemBuffer::new(self.width, self.height);
        for view in self.views() {
            items.reset(self.width, self.height);
            draw_all(&mut items, &view, mesh);
            let rows = picture.pixels.par_chunks_mut(self.width as usize).enumerate();
            rows.for_each(|(y, row)| {
                for (x, pixel) in row.iter_mut().enumerate() {
                    if let Seen::Front(element) = items.seen(x as u32, y as u32) {
                        let (x, y) = (x as u32, y as u32);
                        let at = View::pixel_centre(x, y, self.width, self.height);
                        *pixel +=
                            radiance(element as usize, view.eye(), view.direction(at));
                    }
                }
            });
        }
        let samples = (self.samples.max(1) as f64).powi(2);
        picture.pixels.iter_mut().for_each(|pixel| *pixel /= samples);
        picture
    }
    // ANCHOR_END: shade

    /// The view of each sample of a pixel: the picture is moved by parts of a pixel.
    pub fn views(&self) -> impl Iterator<Item = View> + use<> {
        let view = self.view();
        let n = self.samples.max(1);
        let pixel = dvec2(2.0 / self.width as f64, 2.0 / self.height as f64);
        let part = move |k: u32| (k as f64 + 0.5) / n as f64 - 0.5;
        (0..n * n).map(move |k| view.shifted(pixel * dvec2(part(k % n), part(k / n))))
    }
}

/// Draws the elements with their indices as ids.
fn draw_all(items: &mut ItemBuffer, view: &View, mesh: &Mesh) {
    for (id, polygon) in mesh.polygons().enumerate() {
        items.draw(view, polygon, id as u32);
    }
}
