//! The hemicube: all form factors of an element from five pictures of what it sees.
//!
//! ```text
//! F_ij ≈ Σ ΔF_q    over the cells q that show the front of j
//! ΔF_q = ∫∫ 1/(π (x² + y² + 1)²) dx dy      a cell of the top,  z = 1
//! ΔF_q = ∫∫ z/(π (y² + z² + 1)²) dy dz      a cell of a side,   x = ±1 (or y = ±1)
//! Σ ΔF_q = 1
//! ```
//! The integrals have closed forms (below), so that the weights are exact and sum to 1.
//!
//! | weights                 | use them when              | they fail when     |
//! |-------------------------|----------------------------|--------------------|
//! | [`Weights::exact`]      | always                     | never              |
//! | [`Weights::at_centres`] | the classic is to be shown | their sum is not 1 |
//!
//! **Fails** when a patch is smaller than a few cells (aliasing), when it is nearer
//! than a few of its own sizes (the centre speaks for the whole element), and when a
//! grid of patches beats with the grid of cells.
//!
//! **Not here:** drawing ([`crate::raster`]); other shapes ([`super::pictures`]); pairs
//! for which it fails, done otherwise ([`super::hybrid`]). Chapter
//! *The hemicube* (L10). Sources: Cohen & Greenberg 1985; Baum, Rushmeier & Winget 1989
//! (where it fails).

use super::painter::{self, Painter};
use super::{FormFactors, Lost};
use crate::geometry::Frame;
use crate::mesh::{ElementId, Mesh};
use crate::raster::{ItemBuffer, MAX_SIZE, View};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// One of the five faces of a hemicube. `x`, `y`, `z` are the axes of its [`Frame`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CubeFace {
    /// `z = 1`; `x` runs to the right, `y` up.
    Top,
    /// `x = 1`; `y` runs to the right, `z` up.
    East,
    /// `y = 1`; `−x` runs to the right, `z` up.
    North,
    /// `x = −1`; `−y` runs to the right, `z` up.
    West,
    /// `y = −1`; `x` runs to the right, `z` up.
    South,
}

impl CubeFace {
    /// All five, the top first, the sides counter-clockwise.
    pub const ALL: [CubeFace; 5] = [
        CubeFace::Top,
        CubeFace::East,
        CubeFace::North,
        CubeFace::West,
        CubeFace::South,
    ];

    /// What the eye sees through this face. The sides end at the horizon.
    pub fn view(self, eye: DVec3, frame: &Frame) -> View {
        // ANCHOR: views
        let &Frame { x, y, z } = frame;
        let side = |right, forward| View::new(eye, right, 2.0 * z - forward, forward);
        match self {
            CubeFace::Top => View::new(eye, x, y, z),
            CubeFace::East => side(y, x),
            CubeFace::North => side(-x, y),
            CubeFace::West => side(-y, -x),
            CubeFace::South => side(x, -y),
        }
        // ANCHOR_END: views
    }

    /// Columns and rows of cells, when the top has `resolution` of each.
    pub fn size(self, resolution: u32) -> (u32, u32) {
        match self {
            CubeFace::Top => (resolution, resolution),
            _ => (resolution, resolution / 2),
        }
    }
}

/// The delta form factors `ΔF` of all cells, in order of [`ItemBuffer::pixels`].
#[derive(Clone, Debug, PartialEq)]
pub struct Weights {
    top: Vec<f64>,
    side: Vec<f64>,
}

impl Weights {
    /// `ΔF` integrated over each cell; positive, dimensionless, with sum 1 to rounding.
    ///
    /// ```text
    /// ∫∫ top  = 1/(2π) [x/√(1+x²) atan(y/√(1+x²)) + y/√(1+y²) atan(x/√(1+y²))]
    /// ∫∫ side = −1/(2π) 1/√(1+z²) atan(y/√(1+z²))
    /// ```
    /// between the corners of the cell (Howell's B-3 for the top). Each weight is a
    /// difference of four such terms, good to 1e-16 absolute.
    pub fn exact(resolution: u32) -> Weights {
        // ANCHOR: exact
        let part = |x: f64, y: f64| x / x.hypot(1.0) * (y / x.hypot(1.0)).atan();
        let top = |x: f64, y: f64| (part(x, y) + part(y, x)) / TAU;
        let side = |y: f64, z: f64| -(y / z.hypot(1.0)).atan() / z.hypot(1.0) / TAU;
        let integral = |f: &dyn Fn(f64, f64) -> f64, [x0, x1, y0, y1]: [f64; 4]| {
            f(x1, y1) - f(x0, y1) - f(x1, y0) + f(x0, y0)
        };
        Weights::cell_by_cell(resolution, |c| integral(&top, c), |c| integral(&side, c))
        // ANCHOR_END: exact
    }

    /// The classic weights: the integrand at the centre of each cell times its area.
    ///
    /// Their sum misses 1 by .0021, .00053, .00013, .00003 at a resolution of 16, 32,
    /// 64, 128: an error that [`Weights::exact`] does not make, and not the one that
    /// matters.
    pub fn at_centres(resolution: u32) -> Weights {
        // ANCHOR: at_centres
        let cell = |[x0, x1, y0, y1]: [f64; 4]| {
            let (x, y) = (0.5 * (x0 + x1), 0.5 * (y0 + y1));
            (y, (x1 - x0) * (y1 - y0) / (PI * (x * x + y * y + 1.0).powi(2)))
        };
        Weights::cell_by_cell(resolution, |c| cell(c).1, |c| cell(c).0 * cell(c).1)
        // ANCHOR_END: at_centres
    }

    /// Weights from a rule for a top cell and one for a side cell `[x0, x1, y0, y1]`.
    fn cell_by_cell(
        resolution: u32,
        top: impl Fn([f64; 4]) -> f64,
        side: impl Fn([f64; 4]) -> f64,
    ) -> Weights {
        assert!(resolution >= 2 && resolution.is_multiple_of(2), "odd: {resolution}");
        let step = 2.0 / resolution as f64;
        let cells = |rows: u32, rule: &dyn Fn([f64; 4]) -> f64| {
            let cell = |k: u32| {
                let (x, y) = (k % resolution, k / resolution);
                let (x0, y1) = (x as f64 * step - 1.0, 1.0 - y as f64 * step);
                rule([x0, x0 + step, y1 - step, y1])
            };
            (0..rows * resolution).map(cell).collect()
        };
        Weights { top: cells(resolution, &top), side: cells(resolution / 2, &side) }
    }

    /// The weights of one face's cells.
    pub fn of(&self, face: CubeFace) -> &[f64] {
        if face == CubeFace::Top { &self.top } else { &self.side }
    }

    /// Sum over the five faces.
    pub fn sum(&self) -> f64 {
        self.top.iter().sum::<f64>() + 4.0 * self.side.iter().sum::<f64>()
    }
}

// ANCHOR: budget
/// The relative error, root mean square over places, with which a hemicube of this
/// `resolution` finds an element of apparent `size`: side over distance, facing the eye,
/// turned at random.
///
/// ```text
/// error ≈ 0.45 k^(−3/2)          k = size · resolution/2 cells along its side
/// ```
/// The element has `k²` cells, of which about `4k` are cut by its outline. Each of these
/// counts wholly or not at all: off by about a third of a cell, at random. A share
/// `√(4k)/(3k²)` of the element, less some luck.
///
/// # Accuracy
/// Within a quarter from a third of a cell to thirty (`tests/factors/pictures.rs`). An element
/// whose sides run along the cells is off by up to `1/k`: that is what
/// [`Hemicube::turned`] is for.
pub fn aliasing_error(resolution: u32, size: f64) -> f64 {
    0.45 * (0.5 * size * f64::from(resolution)).powf(-1.5)
}

/// The least resolution that finds an element of apparent `size` with this relative `error`
/// (positive): [`aliasing_error`] solved for the resolution, and rounded up to an even
/// number; [`MAX_SIZE`] when even that would not do.
pub fn resolution_for(error: f64, size: f64) -> u32 {
    let cells = (0.45 / error).powf(2.0 / 3.0);
    let pairs = (cells / size).ceil(); // 2k/size, halved
    if pairs < f64::from(MAX_SIZE / 2) { 2 * (pairs as u32).max(1) } else { MAX_SIZE }
}
// ANCHOR_END: budget

/// Form factors by hemicubes at the centres of the elements.
///
/// # Accuracy
/// At resolution 256 within 1 % for elements that are flat, far apart by several of
/// their sizes, and wider than ten cells. The rows are not reciprocal. Nothing is
/// repaired.
#[derive(Debug)]
pub struct Hemicube<'m> {
    painter: Painter<'m>,
    resolution: u32,
    weights: Weights,
}

impl<'m> Hemicube<'m> {
    /// Hemicubes whose top has `resolution` × `resolution` cells, with exact weights.
    ///
    /// # Panics
    /// When `resolution` is odd, zero or above [`crate::raster::MAX_SIZE`].
    pub fn new(mesh: &'m Mesh, resolution: u32) -> Hemicube<'m> {
        Hemicube::with_weights(mesh, resolution, Weights::exact(resolution))
    }

    /// The same with the classic weights ([`Weights::at_centres`]).
    ///
    /// # Panics
    /// As [`Hemicube::new`].
    pub fn classic(mesh: &'m Mesh, resolution: u32) -> Hemicube<'m> {
        Hemicube::with_weights(mesh, resolution, Weights::at_centres(resolution))
    }

    fn with_weights(mesh: &'m Mesh, resolution: u32, weights: Weights) -> Hemicube<'m> {
        Hemicube { painter: Painter::new(mesh), resolution, weights }
    }

    /// Turns each hemicube about its normal by an angle of its own, drawn from `seed`.
    ///
    /// Cells then no longer beat with rows of small patches: streaks become noise.
    pub fn turned(mut self, seed: u64) -> Hemicube<'m> {
        self.painter.turned = Some(seed);
        self
    }

    /// Cells along an edge of the top.
    pub fn resolution(&self) -> u32 {
        self.resolution
    }

    /// The weights of the cells.
    pub fn weights(&self) -> &Weights {
        &self.weights
    }

    /// Writes to `row[j]` the factor from a differential area at `point`, with unit
    /// `normal`, to the front of element `j`; returns what reaches no front.
    ///
    /// Elements in the plane of the point are seen edge-on, that is, not at all.
    pub fn at(&self, point: DVec3, normal: DVec3, row: &mut [f64]) -> Lost {
        self.gather(point, normal, None, row)
    }

    /// Shows the five faces of the hemicube at `point`, one after the other, with the
    /// ids of the elements: for figures, and for one's own sums.
    pub fn faces(
        &self,
        point: DVec3,
        normal: DVec3,
        show: impl FnMut(CubeFace, &ItemBuffer),
    ) {
        self.draw(point, &self.frame(point, normal), None, show);
    }

    /// The frame of the hemicube at `point`.
    pub fn frame(&self, point: DVec3, normal: DVec3) -> Frame {
        self.painter.frame(point, normal)
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
        self.draw(point, &self.frame(point, normal), own, |face, cells| {
            painter::gather(cells, self.weights.of(face), row, &mut lost);
        });
        lost
    }

    /// Draws the elements through the five faces, but for those of surface `own`.
    fn draw(
        &self,
        eye: DVec3,
        frame: &Frame,
        own: Option<u32>,
        mut show: impl FnMut(CubeFace, &ItemBuffer),
    ) {
        self.painter.with_buffer(|buffer| {
            // ANCHOR: faces
            for face in CubeFace::ALL {
                let (width, height) = face.size(self.resolution);
                buffer.reset(width, height);
                self.painter.paint(&face.view(eye, frame), own, buffer);
                show(face, buffer);
            }
            // ANCHOR_END: faces
        });
    }
}

impl FormFactors for Hemicube<'_> {
    fn len(&self) -> usize {
        self.painter.mesh.elements.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        let element = self.painter.mesh.element(from);
        let (polygon, own) = (&element.polygon, self.painter.mesh.surface_of(element));
        self.gather(polygon.centroid(), polygon.normal(), Some(own), row)
    }
}
