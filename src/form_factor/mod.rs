//! Form factors: the fraction of the power leaving one surface that reaches another.
//!
//! ```text
//! F_ij = 1/A_i ∫∫ V cosθ_i cosθ_j / (π r²) dA_j dA_i         0 ≤ F_ij ≤ 1, no unit
//! A_i F_ij = A_j F_ji (reciprocity)      Σ_j F_ij = 1 (closure, in a closed room)
//! ```
//!
//! | method        | use it when                           | it fails when                    |
//! |---------------|---------------------------------------|----------------------------------|
//! | [`form_factor`] | two polygons are given              | never                            |
//! | [`between_faces`] | the matrix of a file's faces is due | never: it states its error       |
//! | [`analytic`]  | a factor must be right                | shafts hold dozens of blockers   |
//! | [`area`]      | one pair is due, past many blockers   | blockers reach into a shared edge|
//! | [`hemicube`]  | all factors of a row are due, quickly | a patch has few cells: aliasing  |
//! | [`pictures`]  | its cousins are to be compared        | as the hemicube                  |
//! | [`linear`]    | light changes across large patches    | as the hemicube                  |
//! | [`hybrid`]    | the hemicube's large errors must go   | most pairs are near              |
//! | [`cast`]      | nothing may be assumed                | never; but error falls as 1/√rays|
//! | [`shortcuts`] | textbook rules are to be judged       | near by; and they see no blocker |
//! | [`named`]     | a closed form is wanted as an oracle  | the pair has no name             |
//!
//! ```
//! use radiosity::form_factor::{form_factor, form_factor_past, named};
//! use radiosity::prelude::*;
//! let square = |z: f64| {
//!     let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
//!     Polygon::new(corners.map(|(x, y)| dvec3(x, y, z)).to_vec()).unwrap()
//! };
//! let (floor, ceiling) = (square(0.0), square(1.0).flipped());
//! let open = form_factor(&floor, &ceiling);
//! assert!((open - named::parallel_rectangles(1.0, 1.0, 1.0)).abs() < 1e-12); // 0.1998
//! let shelf = floor.clipped(Plane::through(dvec3(0.5, 0.0, 0.0), DVec3::X)).unwrap();
//! let shelf = Polygon::new(shelf.vertices().iter().map(|v| v + 0.5 * DVec3::Z).collect());
//! let past = form_factor_past(&floor, &ceiling, &[shelf.unwrap()], 1e-4);
//! assert!(0.3 * open < past && past < 0.7 * open);
//! ```
//!
//! **Not here:** what stands between ([`crate::occlusion`]); links between groups of
//! elements; mirrors and windows.
//! Chapters *Form factors* (L07) and *The hemicube* (L10). Sources: Lambert 1760;
//! Goral et al. 1984; Cohen & Greenberg 1985; Nishita & Nakamae 1985.

mod accuracy;
pub mod analytic;
pub mod area;
mod bounds;
pub mod cast;
mod close;
mod contour;
mod coordinates;
mod estimate;
mod face_matrix;
mod faces;
pub mod hemicube;
pub mod hybrid;
pub mod linear;
mod matrix;
pub mod named;
mod painter;
mod past_blockers;
mod pair;
pub mod pictures;
mod quadrature;
pub mod shortcuts;

pub use accuracy::Accuracy;
pub use close::{Closing, close, closure};
pub use contour::exchange_by_contour;
pub use estimate::{FactorEstimate, Obstruction, estimate};
pub use face_matrix::{FaceMatrix, SparseRow};
pub use faces::{FaceFactors, between_faces};
pub use matrix::{Cached, Matrix, Row};
pub use pair::{form_factor, form_factor_past};

pub(crate) use quadrature::points;

use crate::geometry::{Frame, Polygon, Ray};
use crate::mesh::ElementId;
use crate::radiometry::cosine_direction;
use crate::random::Stream;
use crate::visibility::Visibility;
use glam::dvec2;
use std::fmt;

/// One way to compute form factors: the place where methods are exchanged under a solver.
pub trait FormFactors: Sync {
    /// How many elements there are.
    fn len(&self) -> usize;

    // ANCHOR: row
    /// Writes to `row[j]` the factor from element `from` to the front of element `j`,
    /// and returns what reaches no front. `row` has [`FormFactors::len`] entries.
    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost;

    /// All rows, computed in parallel; `done` is called after each.
    fn matrix(&self, done: &(dyn Fn() + Sync)) -> Matrix {
        Matrix::row_by_row(self, done)
    }
    // ANCHOR_END: row

    /// Is there no element?
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl fmt::Debug for dyn FormFactors + '_ {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "FormFactors of {} elements", self.len())
    }
}

/// The shares of an element's power that reach no front side, as the method counts them
/// (never as one minus the rest): with them, the factors of a row sum to one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lost {
    /// Leaves the scene: empty hemicube cells, rays that hit nothing.
    pub escaped: f64,
    /// Falls on the black back of a surface, and is absorbed there; less what mirrors and
    /// panes, which have factors as others do, send on.
    pub absorbed: f64,
    /// Would be mirrored once more than is followed, and is taken as absorbed.
    pub cut: f64,
}

/// A ray that carries its share of the power leaving `element`: start and direction from
/// four numbers in `[0, 1)`; `frame` stands on the element's normal.
pub fn ray_from(element: &Polygon, frame: &Frame, [a, b, c, d]: [f64; 4]) -> Ray {
    let direction = frame.world_from_local(cosine_direction(dvec2(c, d)));
    Ray { origin: element.point_at([a, b]), direction }
}

/// How many rays count what methods without directions lose: the first tell whether
/// anything is lost at all, as in a closed room it is not.
const LOST_RAYS: [usize; 2] = [256, 2048];

/// What leaves `element`, a piece of `patch`, and reaches no front: by rays, since
/// Lambert's formula knows only what it is asked about. In a closed room exactly nothing.
fn lost_by_rays(
    surfaces: &Visibility,
    element: &Polygon,
    patch: u32,
    seed: u64,
    name: ElementId,
) -> Lost {
    let frame = Frame::about(element.normal());
    let mut lost = Lost::default();
    for rays in LOST_RAYS {
        lost = Lost::default();
        for u in Stream::named(seed, &[name.0 as u64]).points(rays) {
            match surfaces.closest(&ray_from(element, &frame, u), Some(patch)) {
                None => lost.escaped += 1.0 / rays as f64,
                Some(hit) if !hit.front => lost.absorbed += 1.0 / rays as f64,
                Some(_) => {}
            }
        }
        if lost == Lost::default() {
            break;
        }
    }
    lost
}
