//! Extended form factors by hemicubes: where a cell shows a mirror, the world behind it is
//! drawn.
//!
//! ```text
//! view in the mirror = view moved by R       the same pixels; what it draws is clipped to
//! weight of a cell   = ΔF · share            the front of the mirror, and counted only where
//!                                            the picture before showed the mirror
//! ```
//! So a cell that shows a mirror is a stencil, as in the lecture. Behind a pane the same view
//! is drawn once more, beyond the pane.

use super::VirtualWorld;
use super::books::{Books, RowMet};
use crate::form_factor::hemicube::{CubeFace, Weights};
use crate::form_factor::{FormFactors, Lost};
use crate::geometry::{Frame, Plane};
use crate::mesh::{ElementId, Mesh};
use crate::raster::{ItemBuffer, Seen, View};
use std::collections::BTreeMap;

/// Hemicubes that look into a virtual world; otherwise as
/// [`crate::form_factor::hemicube::Hemicube`].
#[derive(Debug)]
pub struct ExtendedHemicube<'a> {
    mesh: &'a Mesh,
    world: &'a VirtualWorld,
    channel: usize,
    resolution: u32,
    weights: Weights,
}

/// A picture to be drawn: from where, beyond which plane, and what each cell counts.
struct CubeLook<'w> {
    view: View,
    beyond: Option<Plane>,
    weights: std::borrow::Cow<'w, [f64]>,
    left: u32,
    /// The surface that is not drawn: a flat one does not see itself, but for in a mirror.
    own: Option<u32>,
}

impl<'a> ExtendedHemicube<'a> {
    /// Factors of this `channel` (0, 1 or 2) by hemicubes of this resolution.
    ///
    /// # Panics
    /// As [`crate::form_factor::hemicube::Hemicube::new`].
    pub fn new(
        mesh: &'a Mesh,
        world: &'a VirtualWorld,
        channel: usize,
        resolution: u32,
    ) -> ExtendedHemicube<'a> {
        let weights = Weights::exact(resolution);
        ExtendedHemicube { mesh, world, channel, resolution, weights }
    }

    /// Books what a picture shows, and returns what is to be looked at next.
    fn read(
        &self,
        look: &CubeLook,
        buffer: &ItemBuffer,
        books: &mut Books,
    ) -> Vec<CubeLook<'static>> {
        // By mirror and side: what each cell counts in the next picture.
        let mut mirrored: BTreeMap<(u32, bool), Vec<f64>> = BTreeMap::new();
        let mut passed: BTreeMap<(u32, bool), Vec<f64>> = BTreeMap::new();
        for (cell, seen) in buffer.pixels().enumerate() {
            let share = look.weights[cell];
            if share == 0.0 {
                continue;
            }
            let (element, front) = match seen {
                Seen::Nothing => {
                    books.lost.escaped += share;
                    continue;
                }
                Seen::Front(id) => (id, true),
                Seen::Back(id) => (id, false),
            };
            let surface = self.mesh.surface_of(&self.mesh.elements[element as usize]);
            let mirror = self.world.mirror_of[surface as usize];
            let cosine = match mirror {
                Some(_) => self.cosine(&look.view, buffer, cell, element),
                None => 1.0,
            };
            let next =
                books.arrives(share, RowMet { element, front, cosine }, look.left);
            let Some(id) = mirror else { continue };
            for (share, map) in next.into_iter().zip([&mut mirrored, &mut passed]) {
                if share > 0.0 {
                    let empty = || vec![0.0; look.weights.len()];
                    map.entry((id, front)).or_insert_with(empty)[cell] = share;
                }
            }
        }
        self.next(look, mirrored, passed)
    }

    fn next(
        &self,
        look: &CubeLook,
        mirrored: BTreeMap<(u32, bool), Vec<f64>>,
        passed: BTreeMap<(u32, bool), Vec<f64>>,
    ) -> Vec<CubeLook<'static>> {
        let plane = |(id, front): (u32, bool)| {
            let plane = self.world.mirrors[id as usize].outline.plane();
            if front { plane } else { plane.flipped() }
        };
        // ANCHOR: reflected
        let reflected = mirrored.into_iter().map(|(id, weights)| CubeLook {
            view: look.view.moved(&plane(id).mirror()),
            beyond: Some(plane(id)),
            weights: weights.into(),
            left: look.left - 1,
            own: None,
        });
        // ANCHOR_END: reflected
        let through = passed.into_iter().map(|(id, weights)| CubeLook {
            view: look.view,
            beyond: Some(plane(id).flipped()),
            weights: weights.into(),
            left: look.left,
            own: look.own,
        });
        reflected.chain(through).collect()
    }

    fn draw(&self, look: &CubeLook, buffer: &mut ItemBuffer) {
        for (id, element) in (0u32..).zip(&self.mesh.elements) {
            if Some(self.mesh.surface_of(element)) == look.own {
                continue;
            }
            let polygon = &element.polygon;
            let Some(plane) = look.beyond else {
                buffer.draw(&look.view, polygon, id);
                continue;
            };
            let margin = self.world.margin;
            let heights = || polygon.vertices().iter().map(|&v| plane.height(v));
            if heights().all(|h| h <= margin) {
                continue;
            }
            if heights().all(|h| h >= -margin) {
                buffer.draw(&look.view, polygon, id);
            } else if let Some(rest) = polygon.clipped(plane) {
                buffer.draw(&look.view, &rest, id);
            }
        }
    }

    /// Between a cell's line of sight and an element's normal.
    fn cosine(
        &self,
        view: &View,
        cells: &ItemBuffer,
        cell: usize,
        element: u32,
    ) -> f64 {
        let (width, height) = (cells.width(), cells.height());
        let (x, y) = (cell as u32 % width, cell as u32 / width);
        let direction = view.direction(View::pixel_centre(x, y, width, height));
        let normal = self.mesh.elements[element as usize].polygon.normal();
        (direction.dot(normal).abs() / direction.length()).min(1.0)
    }
}

impl ExtendedHemicube<'_> {
    /// Shows all pictures that are drawn for an element, with what each cell counts in it:
    /// nothing where another picture has to tell. For figures.
    pub fn pictures(
        &self,
        from: ElementId,
        mut show: impl FnMut(CubeFace, &ItemBuffer, &[f64]),
    ) {
        self.draw_all(from, &mut vec![0.0; self.len()], &mut show);
    }

    fn draw_all(
        &self,
        from: ElementId,
        row: &mut [f64],
        show: &mut dyn FnMut(CubeFace, &ItemBuffer, &[f64]),
    ) -> Lost {
        let element = self.mesh.element(from);
        let (eye, normal) = (element.polygon.centroid(), element.polygon.normal());
        let own = Some(self.mesh.surface_of(element));
        let (world, mesh, channel) = (self.world, self.mesh, self.channel);
        let mut books = Books { world, mesh, channel, row, lost: Lost::default() };
        for face in CubeFace::ALL {
            let (width, height) = face.size(self.resolution);
            let mut buffer = ItemBuffer::new(width, height);
            let mut looks = vec![CubeLook {
                view: face.view(eye, &Frame::about(normal)),
                beyond: None,
                weights: self.weights.of(face).into(),
                left: world.levels(),
                own,
            }];
            while let Some(look) = looks.pop() {
                buffer.reset(width, height);
                self.draw(&look, &mut buffer);
                show(face, &buffer, &look.weights);
                looks.extend(self.read(&look, &buffer, &mut books));
            }
        }
        books.lost
    }
}

impl FormFactors for ExtendedHemicube<'_> {
    fn len(&self) -> usize {
        self.mesh.elements.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        row.fill(0.0);
        self.draw_all(from, row, &mut |_, _, _| ())
    }
}
