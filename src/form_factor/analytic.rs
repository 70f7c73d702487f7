//! Form factors by Lambert's formula: exact where nothing stands between, and where
//! something does cut exactly for each point and integrated adaptively over the area.
//!
//! ```text
//! A_i F_ij = ∫ F(x → j) dA over i           F(x → j) by Lambert 1760, 1/(2π) Σ γₖ n·Γₖ
//! ```
//!
//! | pair                  | rule                                                        |
//! |-----------------------|-------------------------------------------------------------|
//! | apart, unhidden       | Gauss points on the smaller, as many as the accuracy needs  |
//! | near, unhidden        | the contour integral, to rounding                           |
//! | one blocker hides all | 0                                                           |
//! | partly hidden         | the visible part of each point, halving until it settles    |
//!
//! In a matrix one number serves both directions of a pair, so reciprocity holds to
//! rounding; rows that are asked for one by one agree within the tolerance.
//!
//! **Use it when** a factor must be right, or the scene has few blockers.
//! **It fails when** shafts hold dozens of blockers: then it is slow. The matrix of 607
//! faces, 100 boxes in a room, takes more than five minutes.

use super::contour::exchange_by_contour;
use super::past_blockers::{Part, past_blockers};
use super::quadrature::{over, points_for};
use super::{Accuracy, FormFactors, Lost, Matrix, Row, lost_by_rays};
use crate::geometry::Polygon;
use crate::mesh::{ElementId, Mesh};
use crate::occlusion::{Blocker, Blockers};
use crate::radiometry::projected_solid_angle;
use crate::scene::Scene;
use crate::visibility::Visibility;
use glam::DVec3;
use rayon::prelude::*;
use std::borrow::Cow;
use std::f64::consts::PI;
use std::ops::Range;

/// Form factor from a differential area at `p` to an unoccluded polygon.
///
/// Returns the dimensionless fraction, in `[0, 1]`, of the power leaving a Lambertian
/// element at `p` (unit normal `n`) that arrives at `to`; `0` when `to` lies below the
/// horizon of `p`. Either side of `to` counts.
///
/// ```text
/// F = |1/(2π) Σₖ γₖ  n · (Rₖ₊₁ × Rₖ)/|Rₖ₊₁ × Rₖ||      Rₖ = vertexₖ − p
/// ```
/// with `γₖ` the angle between `Rₖ` and `Rₖ₊₁` (Lambert 1760; Baum et al. 1989).
///
/// # Accuracy
/// Exact but for rounding off the polygon's edges; see
/// [`projected_solid_angle`].
pub fn lambert_polygon(p: DVec3, n: DVec3, to: &Polygon) -> f64 {
    projected_solid_angle(p, n, to.vertices()) / PI
}

/// `A_i F_ij = A_j F_ji` in scene units squared between the fronts of two polygons with
/// nothing between them, both factors being as right as `accuracy` asks. What lies behind
/// the other's plane is cut away first.
///
/// # Accuracy
/// A relative 1e-9 on all pairs of the accuracy tables (`tests/tables/form_factors.rs`),
/// shared edges, near-touching and cut pairs among them.
pub fn exchange(i: &Polygon, j: &Polygon, accuracy: impl Into<Accuracy>) -> f64 {
    match facing(i, j) {
        Some((i, j)) => exchange_of_facing(&i, &j, accuracy.into().allowed()),
        None => 0.0,
    }
}

/// The parts of two polygons that lie in front of each other.
fn facing<'a>(
    i: &'a Polygon,
    j: &'a Polygon,
) -> Option<(Cow<'a, Polygon>, Cow<'a, Polygon>)> {
    fn in_front<'a>(of: &Polygon, p: &'a Polygon) -> Option<Cow<'a, Polygon>> {
        let plane = of.plane();
        let (mut all, mut any) = (true, false);
        for &v in p.vertices() {
            let height = plane.height(v);
            all &= height >= 0.0;
            any |= height > 0.0;
        }
        match (any, all) {
            (false, _) => None,
            (true, true) => Some(Cow::Borrowed(p)),
            (true, false) => p.clipped(plane).map(Cow::Owned),
        }
    }
    Some((in_front(j, i)?, in_front(i, j)?))
}

// ANCHOR: exchange
pub(super) fn exchange_of_facing(i: &Polygon, j: &Polygon, tolerance: f64) -> f64 {
    // ANCHOR: rule_of_pair
    let (small, large) = by_size(i, j);
    let middle = small.centroid();
    let factor = lambert_polygon(middle, small.normal(), large);
    let (size, gap) = (small.diameter(), distance_at_least(small, middle, large));
    let most = (large.area() / (PI * gap * gap)).min(1.0); // cosines of 1, or all of it
    let relative = (tolerance / most.max(tolerance)).max(1e-14);
    match points_for(relative, size, gap) {
        Some(1) => small.area() * factor,
        Some(n) => over(small, n, |x| lambert_polygon(x, small.normal(), large)),
        None => exchange_by_contour(i.vertices(), j.vertices()),
    }
    // ANCHOR_END: rule_of_pair
}
// ANCHOR_END: exchange

/// The smaller one first; the same order whichever way the pair is named.
fn by_size<'a>(i: &'a Polygon, j: &'a Polygon) -> (&'a Polygon, &'a Polygon) {
    let (a, b) = (i.diameter(), j.diameter());
    let place = |p: &Polygon| p.vertices()[0].to_array();
    if a < b || (a == b && place(i) < place(j)) { (i, j) } else { (j, i) }
}

/// The one first on which the other's light casts the softer shadows: the one that is
/// farther, in its own sizes, from the nearest corner of a blocker. From far off, what a
/// blocker hides changes slowly; close by, its shadow is a small spot that points may miss.
fn by_shadow<'a>(
    i: &'a Polygon,
    j: &'a Polygon,
    blockers: &[&Blocker],
) -> (&'a Polygon, &'a Polygon) {
    let (small, large) = by_size(i, j);
    let gap = |p: &Polygon| {
        let plane = p.plane();
        let corners = blockers.iter().flat_map(|b| b.corners());
        let lowest = corners.map(|&v| plane.height(v)).fold(f64::INFINITY, f64::min);
        lowest.max(0.0) / p.diameter()
    };
    if gap(small) < gap(large) { (large, small) } else { (small, large) }
}

/// A lower bound of the distance between two polygons: how far the sphere around one, with
/// this `middle`, keeps off the sphere around the other, or off its plane.
fn distance_at_least(small: &Polygon, middle: DVec3, large: &Polygon) -> f64 {
    let radius = |p: &Polygon, c: DVec3| {
        p.vertices().iter().map(|v| v.distance_squared(c)).fold(0.0, f64::max).sqrt()
    };
    let other = large.centroid();
    let spheres = middle.distance(other) - radius(small, middle) - radius(large, other);
    let off = |p: &Polygon, q: &Polygon| {
        p.vertices().iter().map(|&v| q.plane().height(v)).fold(f64::INFINITY, f64::min)
    };
    spheres.max(off(small, large)).max(off(large, small))
}

/// The method, ready for a scene.
#[derive(Debug)]
#[must_use]
pub struct Analytic {
    elements: Vec<Polygon>,
    /// The elements, cut where blockers touch them: there what is seen jumps.
    pieces: Vec<Vec<Polygon>>,
    surface_of: Vec<u32>,
    blockers: Blockers,
    surfaces: Visibility,
    tolerance: f64,
    /// The same where nothing stands between.
    open_tolerance: f64,
    /// Are rays cast to count what escapes?
    losses: bool,
    seed: u64,
}

/// A partly hidden pair is halved at most this often: to 1/1024 of its edge.
const DEEPEST: u32 = 10;

impl Analytic {
    /// Factors between the elements of `mesh`, each about as right as `accuracy` asks;
    /// `seed` chooses the rays that count what escapes.
    pub fn new(
        scene: &Scene,
        mesh: &Mesh,
        accuracy: impl Into<Accuracy>,
        seed: u64,
    ) -> Analytic {
        let tolerance = accuracy.into().allowed();
        Analytic {
            elements: mesh.polygons().cloned().collect(),
            pieces: mesh.cut_at_contacts(),
            surface_of: mesh.elements.iter().map(|e| mesh.surface_of(e)).collect(),
            blockers: Blockers::of(scene),
            surfaces: Visibility::new(scene.surfaces.iter().map(|s| &s.polygon)),
            tolerance,
            open_tolerance: tolerance,
            losses: true,
            seed,
        }
    }

    /// The absolute error of a factor that is aimed at where something stands between.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// What names the rays that count what escapes.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Asks for a thousandth of the tolerance where nothing stands between: for few, large
    /// elements, where that costs little.
    pub fn sharp(self) -> Analytic {
        Analytic { open_tolerance: 1e-3 * self.tolerance, ..self }
    }

    /// Counts no losses: for factors alone, without an account of the light.
    pub fn without_losses(self) -> Analytic {
        Analytic { losses: false, ..self }
    }

    /// The outline of an element.
    pub(super) fn polygon(&self, i: ElementId) -> &Polygon {
        &self.elements[i]
    }

    /// What may stand between elements.
    pub(super) fn blockers(&self) -> &Blockers {
        &self.blockers
    }

    fn lost(&self, from: ElementId) -> Lost {
        let i = from.0 as usize;
        if !self.losses {
            return Lost::default();
        }
        let (element, surface) = (&self.elements[i], self.surface_of[i]);
        lost_by_rays(&self.surfaces, element, surface, self.seed, from)
    }

    /// `A_i F_ij` past everything that stands between, in scene units squared.
    pub fn exchange(&self, i: ElementId, j: ElementId) -> f64 {
        self.exchange_and_error(i, j).0
    }

    /// `A_i F_ij` past everything that stands between, and about how far it may be off,
    /// both in scene units squared.
    ///
    /// The error is by how much the rules of each part disagree, summed over the parts, and
    /// half of the tolerance at least; where nothing stands between, what was asked for.
    pub fn exchange_and_error(&self, i: ElementId, j: ElementId) -> (f64, f64) {
        let (a, b) = (self.polygon(i), self.polygon(j));
        let Some((a, b)) = facing(a, b) else { return (0.0, 0.0) };
        self.exchange_past(i, j, &self.blockers.between(&a, &b))
    }

    /// Calls `found(j, exchange, error)`, as [`Analytic::exchange_and_error`], for the
    /// elements `j` of `range` that see something of element `i`; faster than pair by pair.
    pub fn exchanges(
        &self,
        i: ElementId,
        range: Range<usize>,
        mut found: impl FnMut(ElementId, f64, f64),
    ) {
        let i = i.0 as usize;
        let element = &self.elements[i];
        // What may stand between the element and a whole wall is found once.
        let mut known: Option<(u32, Vec<&Blocker>)> = None;
        for j in range {
            let surface = self.surface_of[j];
            if surface == self.surface_of[i] {
                continue; // a flat surface does not see itself
            }
            if facing(element, &self.elements[j]).is_none() {
                continue;
            }
            let wall = self.blockers.wall_of(surface as usize);
            if known.as_ref().is_none_or(|(of, _)| *of != wall) {
                let whole = &self.blockers.walls()[wall as usize];
                known = Some((wall, self.blockers.between(element, whole)));
            }
            let between = &known.as_ref().expect("just found").1;
            let j = ElementId(j as u32);
            let (exchange, error) = self.exchange_past(ElementId(i as u32), j, between);
            if exchange != 0.0 || error != 0.0 {
                found(j, exchange, error);
            }
        }
    }

    fn exchange_past(
        &self,
        i: ElementId,
        j: ElementId,
        between: &[&Blocker],
    ) -> (f64, f64) {
        let area = self.polygon(i).area().min(self.polygon(j).area());
        let (mut sum, mut off) = (0.0, 0.0);
        for a in &self.pieces[i] {
            for b in &self.pieces[j] {
                let Some((a, b)) = facing(a, b) else { continue };
                let (from, to) = by_shadow(&a, &b, between);
                // Each pair of pieces may err by its share.
                let share = from.area().min(to.area()) / area;
                let allowed = self.tolerance * area * share.min(1.0);
                let between = self.blockers.narrowed(between, from, to);
                let part = Part { from, to, estimate: None, allowed, depth: DEEPEST };
                let (exchange, error) =
                    past_blockers(&self.blockers, &part, &between, self.open_tolerance);
                // A gap that all points miss leaves no trace in their disagreement.
                let hidden = !between.is_empty() && error > 0.0;
                let least = if hidden { 0.5 * allowed } else { 0.0 };
                (sum, off) = (sum + exchange, off + error.max(least));
            }
        }
        (sum, off)
    }
}

impl FormFactors for Analytic {
    fn len(&self) -> usize {
        self.elements.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        let area = self.polygon(from).area();
        row.fill(0.0);
        self.exchanges(from, 0..row.len(), |j, exchange, _| {
            row[j] = exchange / area;
        });
        self.lost(from)
    }

    /// Each pair once, for both directions.
    fn matrix(&self, done: &(dyn Fn() + Sync)) -> Matrix {
        let n = self.elements.len();
        let upper = |i: usize| {
            let mut row = Vec::new();
            self.exchanges(ElementId(i as u32), i + 1..n, |j, exchange, _| {
                if exchange != 0.0 {
                    row.push((j.0, exchange));
                }
            });
            done();
            row
        };
        let upper: Vec<Vec<(u32, f64)>> = (0..n).into_par_iter().map(upper).collect();
        let mut rows: Vec<Vec<(u32, f64)>> = vec![Vec::new(); n];
        for (i, pairs) in upper.iter().enumerate() {
            for &(j, found) in pairs {
                rows[j as usize]
                    .push((i as u32, found / self.elements[j as usize].area()));
            }
        }
        let finish = |(i, mut row): (usize, Vec<(u32, f64)>)| {
            let element = &self.elements[i];
            row.extend(upper[i].iter().map(|&(j, found)| (j, found / element.area())));
            Row::new(row, self.lost(ElementId(i as u32)))
        };
        Matrix::from_rows(rows.into_par_iter().enumerate().map(finish).collect())
    }
}
