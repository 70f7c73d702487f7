//! What the student is given: the cells, what their rays hit, and the exact values.
//!
//! ```text
//!          z                     the hemicube stands on the element, in its frame:
//!      ____|____                 x, y in the element, z along its normal;
//!     /   top  /|                top face at z = 1, |x|, |y| ≤ 1, n × n cells;
//!    /________/ |  side          four sides of half that height, n × n/2 cells,
//!    |        | /                0 ≤ z ≤ 1; cells are squares of edge 2/n
//!    |________|/
//! ```
//! Cell (column, row) of a face has index `row · n + column`. On the top, columns run
//! along x and rows along y; on a side, columns run round the cube and rows up from 0.

use super::Work;
use radiosity::form_factor::{FormFactors, Lost};
use radiosity::mesh::ElementId;
use radiosity::prelude::{DVec3, Frame, Polygon, dvec3};
use std::f64::consts::PI;

/// How many faces a hemicube has: face 0 is the top, 1 to 4 are the sides.
pub const FACES: usize = 5;

// ANCHOR: weights
/// The weights of the cells: the form factors from the element to each of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Weights {
    /// `n × n` cells of the top face; index `row · n + column`.
    pub top: Vec<f64>,
    /// `n × n/2` cells of one side face; row 0 stands on the base.
    pub side: Vec<f64>,
}
// ANCHOR_END: weights

// ANCHOR: fragment
/// Something that the ray through one cell hits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fragment {
    /// The index of the cell in its face.
    pub cell: usize,
    /// The distance, in any unit; never negative.
    pub depth: f64,
    /// The element that is hit.
    pub element: usize,
    /// Is its front hit? Its back is black.
    pub front: bool,
}
// ANCHOR_END: fragment

// ANCHOR: item
/// What one cell sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// Nothing: light leaves the scene.
    Nothing,
    /// The front of this element.
    Front(usize),
    /// The black back of some element.
    Back,
}
// ANCHOR_END: item

/// The direction through a cell's centre, in the element's frame; not of unit length.
pub fn through(n: usize, face: usize, cell: usize) -> DVec3 {
    let middle = |k: usize| (2 * k + 1) as f64 / n as f64;
    let (u, v) = (middle(cell % n) - 1.0, middle(cell / n));
    match face {
        0 => dvec3(u, v - 1.0, 1.0),
        1 => dvec3(1.0, u, v),
        2 => dvec3(-u, 1.0, v),
        3 => dvec3(-1.0, -u, v),
        _ => dvec3(u, -1.0, v),
    }
}

/// How many cells a face has.
pub fn cells(n: usize, face: usize) -> usize {
    if face == 0 { n * n } else { n * (n / 2) }
}

/// All that the cells of a face hit, in no order of depth; the element itself included,
/// at a depth of about 0.
pub fn fragments(
    eye: DVec3,
    frame: &Frame,
    n: usize,
    face: usize,
    elements: &[Polygon],
) -> Vec<Fragment> {
    let hit = move |cell: usize, element: usize, polygon: &Polygon| {
        let ray = frame.world_from_local(through(n, face, cell)).normalize();
        let slope = polygon.normal().dot(ray);
        let depth = polygon.normal().dot(polygon.vertices()[0] - eye) / slope;
        let inside = depth > -1e-9
            && depth.is_finite()
            && polygon.contains(eye + ray * depth, 0.0);
        let front = slope < 0.0;
        inside.then_some(Fragment { cell, depth: depth.max(0.0), element, front })
    };
    let each = elements.iter().enumerate();
    let of = |(element, polygon)| {
        (0..cells(n, face)).filter_map(move |cell| hit(cell, element, polygon))
    };
    each.flat_map(of).collect()
}

/// The student's five functions, put together.
pub struct StudentHemicube<'a> {
    work: &'a Work,
    elements: &'a [Polygon],
    weights: Weights,
    n: usize,
}

impl<'a> StudentHemicube<'a> {
    /// A hemicube of `n` cells along an edge, `n` even, in a scene of `elements`.
    pub fn new(
        work: &'a Work,
        elements: &'a [Polygon],
        n: usize,
    ) -> StudentHemicube<'a> {
        StudentHemicube { work, elements, weights: (work.weights)(n), n }
    }

    /// The student's tables.
    pub fn weights(&self) -> &Weights {
        &self.weights
    }
}

impl FormFactors for StudentHemicube<'_> {
    fn len(&self) -> usize {
        self.elements.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        let own = from.0 as usize;
        let polygon = &self.elements[own];
        let (eye, frame) = (polygon.centroid(), Frame::about(polygon.normal()));
        let items = std::array::from_fn(|face| {
            let seen = fragments(eye, &frame, self.n, face, self.elements);
            (self.work.item_buffer)(cells(self.n, face), own, &seen)
        });
        (self.work.factor_row)(&items, &self.weights, row)
    }
}

/// The exact weight of the square cell about (x, y, 1), in closed form (Howell, B-3).
pub fn exact_top(x: f64, y: f64, edge: f64) -> f64 {
    let corner = |a: f64, b: f64| {
        let (p, q) = (a.hypot(1.0), b.hypot(1.0));
        (a / p * (b / p).atan() + b / q * (a / q).atan()) / (2.0 * PI)
    };
    between(corner, x, y, edge)
}

/// The exact weight of the square cell about (1, y, z), in closed form (Howell, B-4).
pub fn exact_side(y: f64, z: f64, edge: f64) -> f64 {
    let below = |b: f64, h: f64| {
        let q = h.hypot(1.0);
        -(b / q).atan() / q / (2.0 * PI)
    };
    between(below, y, z, edge)
}

/// What a square about (u, v) adds to an integral known as a function of its corner.
fn between(integral: impl Fn(f64, f64) -> f64, u: f64, v: f64, edge: f64) -> f64 {
    let h = 0.5 * edge;
    integral(u + h, v + h) + integral(u - h, v - h)
        - integral(u + h, v - h)
        - integral(u - h, v + h)
}

/// The tables of weights, each cell weighed by `top` and `side` as in [`Work`].
pub fn table(
    n: usize,
    top: impl Fn(f64, f64, f64) -> f64,
    side: impl Fn(f64, f64, f64) -> f64,
) -> Weights {
    let edge = 2.0 / n as f64;
    let weigh_top = |cell| {
        let at = through(n, 0, cell);
        top(at.x, at.y, edge)
    };
    let weigh_side = |cell| {
        let at = through(n, 1, cell);
        side(at.y, at.z, edge)
    };
    Weights {
        top: (0..cells(n, 0)).map(weigh_top).collect(),
        side: (0..cells(n, 1)).map(weigh_side).collect(),
    }
}
