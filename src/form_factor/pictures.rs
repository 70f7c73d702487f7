//! Cousins of the hemicube: other pictures of what an element sees.
//!
//! ```text
//! ΔF_q = F(eye → cell q)             by Lambert's formula, cut at the horizon
//! cubic tetrahedron    Σ ΔF_q = 1
//! single plane         Σ ΔF_q = 4/π s atan s,  s = w/√(1 + w²): the rest passes by
//! ```
//!
//! | method                     | use it when                        | it fails when         |
//! |----------------------------|------------------------------------|-----------------------|
//! | [`Pictures::tetrahedron`]  | three pictures are cheaper than 5  | as the hemicube       |
//! | [`Pictures::single_plane`] | one is, and the horizon is dark    | a light is down there |
//!
//! The **cubic tetrahedron** is the corner of a cube, cut off by the plane of the element:
//! three right-angled triangles, all alike, each a picture of 3 × 3 units of which one half
//! lies below the horizon. The **single plane** is the top of a hemicube made wider.
//!
//! Both fail as the hemicube does, and for the same reasons ([`super::hemicube`]).
//!
//! **Not here:** planes whose cells are divided where they are heavy, as Sillion & Puech
//! did. Chapter *The hemicube* (L10). Sources: Beran-Koehn & Pavicic 1991 (cubic
//! tetrahedron); Sillion & Puech 1989 (single plane).

use super::painter::{self, Painter};
use super::{FormFactors, Lost};
use crate::geometry::Frame;
use crate::mesh::{ElementId, Mesh};
use crate::radiometry::projected_solid_angle;
use crate::raster::View;
use glam::{DVec3, dvec2};
use std::f64::consts::{PI, TAU};

/// One square picture, given in the frame of the element: `z` is the normal.
#[derive(Clone, Debug, PartialEq)]
struct Window {
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    weights: Vec<f64>,
}

impl Window {
    /// A picture with so many cells to a side, each with its weight.
    fn new(right: DVec3, up: DVec3, forward: DVec3, resolution: u32) -> Window {
        let view = View::new(DVec3::ZERO, right, up, forward);
        Window { right, up, forward, weights: cell_factors(&view, resolution) }
    }

    /// What the eye sees through it.
    fn view(&self, eye: DVec3, frame: &Frame) -> View {
        let [right, up, forward] =
            [self.right, self.up, self.forward].map(|v| frame.world_from_local(v));
        View::new(eye, right, up, forward)
    }
}

// ANCHOR: cell_factors
/// The form factor from the eye, which looks up along z, to each cell of a square picture;
/// 0 for cells below the horizon.
fn cell_factors(view: &View, resolution: u32) -> Vec<f64> {
    let step = 2.0 / f64::from(resolution);
    let cell = |k: u32| {
        let (x, y) = (f64::from(k % resolution), f64::from(k / resolution));
        let corners = [(0., 0.), (1., 0.), (1., 1.), (0., 1.)].map(|(u, v)| {
            view.direction(dvec2((x + u) * step - 1.0, 1.0 - (y + v) * step))
        });
        projected_solid_angle(DVec3::ZERO, DVec3::Z, &corners) / PI
    };
    (0..resolution * resolution).map(cell).collect()
}
// ANCHOR_END: cell_factors

/// Form factors by pictures that are taken at the centres of the elements.
///
/// # Accuracy
/// That of [`super::hemicube::Hemicube`] with as many cells to a steradian. The rows are
/// not reciprocal. Nothing is repaired.
#[derive(Debug)]
pub struct Pictures<'m> {
    painter: Painter<'m>,
    windows: Vec<Window>,
    resolution: u32,
}

impl<'m> Pictures<'m> {
    /// Cubic tetrahedra with `resolution` cells along each leg of the three triangles.
    ///
    /// The leg is three units long where half a hemicube's top is one: for cells as fine as
    /// a hemicube's, ask for 1.5 times its resolution.
    ///
    /// # Panics
    /// When `resolution` is below 2 or above [`crate::raster::MAX_SIZE`].
    pub fn tetrahedron(mesh: &'m Mesh, resolution: u32) -> Pictures<'m> {
        assert!(resolution >= 2, "a triangle needs 2 cells to a leg, not {resolution}");
        // ANCHOR: tetrahedron
        // The cube's edges, all at one angle to the normal: cos = 1/√3.
        let edge = |k: u32| {
            let (sin, cos) = (TAU / 3.0 * f64::from(k)).sin_cos();
            DVec3::new(2f64.sqrt() * cos, 2f64.sqrt() * sin, 1.0) / 3f64.sqrt()
        };
        // The face in front of an edge reaches along the others from −2 to 1.
        let face = |k: u32| {
            let (forward, right, up) = (edge(k), edge(k + 1), edge(k + 2));
            let centred = |v: DVec3| (2.0 * v + forward) / 3.0;
            Window::new(centred(right), centred(up), forward, resolution)
        };
        // ANCHOR_END: tetrahedron
        let mut windows: Vec<Window> = (0..3).map(face).collect();
        windows.iter_mut().for_each(|w| lift_from_horizon(&mut w.weights, resolution));
        Pictures { painter: Painter::new(mesh), windows, resolution }
    }

    /// Single planes at distance 1 that reach `half_width` (positive) to each side, with
    /// `resolution` × `resolution` cells.
    ///
    /// What passes beside the plane is seen by nobody and counted nowhere, neither in the
    /// row nor as lost: [`unseen_by_plane`] says how much it is.
    ///
    /// # Panics
    /// When `resolution` is 0 or above [`crate::raster::MAX_SIZE`], or `half_width` is not
    /// positive.
    pub fn single_plane(
        mesh: &'m Mesh,
        resolution: u32,
        half_width: f64,
    ) -> Pictures<'m> {
        assert!(resolution > 0 && half_width > 0.0, "{resolution} {half_width}");
        let (x, y) = (DVec3::X / half_width, DVec3::Y / half_width);
        let windows = vec![Window::new(x, y, DVec3::Z, resolution)];
        Pictures { painter: Painter::new(mesh), windows, resolution }
    }

    /// Turns the pictures about each normal by an angle of its own, drawn from `seed`; see
    /// [`super::hemicube::Hemicube::turned`].
    pub fn turned(mut self, seed: u64) -> Pictures<'m> {
        self.painter.turned = Some(seed);
        self
    }

    /// The weights of the cells, picture by picture, in order of
    /// [`crate::raster::ItemBuffer::pixels`].
    pub fn weights(&self) -> impl Iterator<Item = &[f64]> {
        self.windows.iter().map(|window| &window.weights[..])
    }

    /// Writes to `row[j]` the factor from a differential area at `point`, with unit
    /// `normal`, to the front of element `j`; returns what reaches no front.
    pub fn at(&self, point: DVec3, normal: DVec3, row: &mut [f64]) -> Lost {
        self.gather(point, normal, None, row)
    }

    fn gather(
        &self,
        point: DVec3,
        normal: DVec3,
        own: Option<u32>,
        row: &mut [f64],
    ) -> Lost {
        debug_assert_eq!(row.len(), self.len(), "one factor per element");
        row.fill(0.0);
        let mut lost = Lost::default();
        let frame = self.painter.frame(point, normal);
        self.painter.with_buffer(|buffer| {
            for window in &self.windows {
                buffer.reset(self.resolution, self.resolution);
                self.painter.paint(&window.view(point, &frame), own, buffer);
                painter::gather(buffer, &window.weights, row, &mut lost);
            }
        });
        lost
    }
}

/// The cells on the diagonal of a triangle are cut in half by the horizon, and their
/// centres lie on it, where nothing can be told. Their weight goes to the neighbours above,
/// half to each; in the two corners there is but one.
fn lift_from_horizon(weights: &mut [f64], resolution: u32) {
    let n = resolution as usize;
    for y in 0..n {
        weights[y * n..y * n + y].fill(0.0); // below; row 0 is on top
        let weight = std::mem::take(&mut weights[y * n + y]);
        let right = (y + 1 < n).then(|| y * n + y + 1);
        let above = (y > 0).then(|| (y - 1) * n + y);
        let neighbours = || right.into_iter().chain(above);
        let share = weight / neighbours().count() as f64;
        neighbours().for_each(|k| weights[k] += share);
    }
}

// ANCHOR: unseen
/// The share of an element's light that passes beside a single plane at distance 1 that
/// reaches `half_width` to each side; in `(0, 1)`.
///
/// ```text
/// 1 − 4/π s atan s      s = w/√(1 + w²)      (four corners of Howell's B-3)
/// ```
/// 44.6 % at 1, where it is what the sides of a hemicube see; `(½ + 1/π)/w²` of wide ones.
pub fn unseen_by_plane(half_width: f64) -> f64 {
    let s = half_width / half_width.hypot(1.0);
    1.0 - 4.0 / PI * s * s.atan()
}
// ANCHOR_END: unseen

impl FormFactors for Pictures<'_> {
    fn len(&self) -> usize {
        self.painter.mesh.elements.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        let element = self.painter.mesh.element(from);
        let polygon = &element.polygon;
        self.gather(
            polygon.centroid(),
            polygon.normal(),
            Some(self.painter.mesh.surface_of(element)),
            row,
        )
    }
}
