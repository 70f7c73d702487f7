//! Hemicube rows with the pairs done exactly for which the hemicube fails.
//!
//! The hemicube rests on three assumptions. Each is asked of each pair, as an error that it
//! would cause, and where that exceeds the tolerance, the exact factor is put in:
//!
//! ```text
//! proximity    the centre speaks for all of i        ⅓ (s_i/d)² F;  F if the plane of j
//!                                                    cuts i;  and d ≥ 2 s
//! visibility   the centre sees what all of i sees    ½ F if something may stand between
//! aliasing     j has many cells                      3 · 0.45 k^(−3/2) F,  k² of them
//! ```
//! with `s` the sizes, `d` the distance, and for `F` an estimate that is rather too large.
//!
//! | method         | use it when                              | it fails when            |
//! |----------------|------------------------------------------|--------------------------|
//! | [`Hybrid`]     | most pairs are far, and a few are near   | most pairs fail a test   |
//!
//! **Not here:** the hemicube itself ([`super::hemicube`]), the exact factors
//! ([`super::analytic`]). Chapter *The hemicube* (L10). Source: Baum, Rushmeier & Winget
//! 1989, whose tests these are in spirit; they subdivide, we ask for an error.

use super::analytic::Analytic;
use super::hemicube::{Hemicube, aliasing_error};
use super::shortcuts::size;
use super::{FormFactors, Lost};
use crate::geometry::Polygon;
use crate::mesh::{ElementId, Mesh};
use crate::occlusion::Blockers;
use crate::scene::Scene;
use std::f64::consts::PI;

/// What the hemicube takes for granted of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Assumption {
    /// The two are so far apart that the centre of the one speaks for all of it.
    Proximity,
    /// What hides some of the other hides the same of it from everywhere on the one.
    Visibility,
    /// The other covers so many cells that their number tells its size.
    Aliasing,
}

/// Hemicubes, and exact factors for pairs that break an [`Assumption`].
///
/// # Accuracy
/// Each factor is within about the tolerance: the errors of pairs that are left to the
/// hemicube are estimates, not bounds. In a Cornell box of 2000 elements, cubes of 256 are
/// off by up to 5e-2. A tolerance of 1e-2 leaves 2e-3 for a fifth more time, and an eighth
/// of the error in root mean square; 1e-3 leaves 1e-3, and a tenth.
///
/// The rows are not reciprocal, and no longer sum to 1: what the hemicube gets wrong in one
/// place it gets wrong in another the other way, and only large errors are repaired.
#[derive(Debug)]
pub struct Hybrid<'m> {
    hemicube: Hemicube<'m>,
    exact: Analytic,
    blockers: Blockers,
    mesh: &'m Mesh,
    sizes: Vec<f64>,
    tolerance: f64,
}

impl<'m> Hybrid<'m> {
    /// Factors between the elements of `mesh`, each with an absolute error near `tolerance`
    /// (positive), from turned hemicubes of this `resolution`; `seed` turns them.
    ///
    /// # Panics
    /// As [`Hemicube::new`].
    pub fn new(
        scene: &Scene,
        mesh: &'m Mesh,
        resolution: u32,
        tolerance: f64,
        seed: u64,
    ) -> Hybrid<'m> {
        assert!(tolerance > 0.0, "tolerance must be positive: {tolerance}");
        Hybrid {
            hemicube: Hemicube::new(mesh, resolution).turned(seed),
            exact: Analytic::new(scene, mesh, tolerance, seed),
            blockers: Blockers::of(scene),
            mesh,
            sizes: mesh.polygons().map(size).collect(),
            tolerance,
        }
    }

    // ANCHOR: broken
    /// Which assumption the pair breaks first, when its factor is taken at the centre of
    /// `i`; `None` when the hemicube will do, or when neither sees the other's front.
    pub fn broken(&self, i: ElementId, j: ElementId) -> Option<Assumption> {
        let [a, b] = [i, j].map(|id| &self.mesh.element(id).polygon);
        let [size_i, size_j] = [i, j].map(|id| self.sizes[id]);
        let ((_, up), (low, down)) = (heights(b, a), heights(a, b));
        if up <= 0.0 || down <= 0.0 {
            return None;
        }
        let distance = a.centroid().distance(b.centroid());
        let (cos_i, cos_j) = ((up / distance).min(1.0), (down / distance).min(1.0));
        let square = distance * distance;
        let factor = cos_i * cos_j * b.area() / (PI * square + b.area());
        let near = distance < 2.0 * size_i.max(size_j);
        // Of an element that the plane of the other cuts, the centre says nothing.
        let off = if low < 0.0 { 1.0 } else { size_i * size_i / (3.0 * square) };
        if near || off * factor > self.tolerance {
            return Some(Assumption::Proximity);
        }
        let apparent = (b.area() * cos_j / square).sqrt();
        // Three times what is off in the mean: there are very many pairs.
        let off = 3.0 * aliasing_error(self.hemicube.resolution(), apparent);
        if off * factor > self.tolerance {
            return Some(Assumption::Aliasing);
        }
        let hidden = 0.5 * factor > self.tolerance;
        (hidden && !self.blockers.between(a, b).is_empty())
            .then_some(Assumption::Visibility)
    }
    // ANCHOR_END: broken
}

/// The least and the greatest height of a polygon over the plane of another.
fn heights(of: &Polygon, above: &Polygon) -> (f64, f64) {
    let plane = above.plane();
    let heights = of.vertices().iter().map(|&v| plane.height(v));
    heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)))
}

impl FormFactors for Hybrid<'_> {
    fn len(&self) -> usize {
        self.mesh.elements.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        let lost = self.hemicube.row(from, row);
        let element = self.mesh.element(from);
        let surface = self.mesh.surface_of(element);
        for (j, factor) in (0u32..).zip(row) {
            let to = ElementId(j);
            let own = self.mesh.surface_of(self.mesh.element(to)) == surface;
            if !own && self.broken(from, to).is_some() {
                *factor = self.exact.exchange(from, to) / element.polygon.area();
            }
        }
        lost
    }
}
