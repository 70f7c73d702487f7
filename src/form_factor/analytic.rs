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
//! One number serves both directions of a pair, so reciprocity holds to rounding.
//!
//! **Use it when** a factor must be right, or the scene has few blockers.
//! **It fails when** the scene has thousands of blockers in each shaft: then it is slow.

use super::contour::exchange_by_contour;
use super::quadrature::{over, points_for};
use super::shaft::Shafts;
use super::visible::{hides_all, lambert_visible};
use super::{FormFactors, Lost, lost_by_rays};
use crate::geometry::{Plane, Polygon};
use crate::mesh::{ElementId, Mesh};
use crate::radiometry::projected_solid_angle;
use crate::scene::Scene;
use glam::DVec3;
use std::f64::consts::PI;

/// Form factor from a differential area at `p` to an unoccluded polygon.
///
/// Returns the dimensionless fraction, in `[0, 1]`, of the power leaving a Lambertian
/// element at `p` (unit normal `n`) that arrives at `to`; `0` when `to` lies below the
/// horizon of `p`. Either side of `to` counts.
///
/// ```text
/// F = 1/(2π) Σₖ γₖ  n · (Rₖ × Rₖ₊₁)/|Rₖ × Rₖ₊₁|        Rₖ = vertexₖ − p
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
/// nothing between them, with an absolute error of both factors below `tolerance`; a
/// `tolerance` of 1e-300 asks for the best there is. What lies behind the other's plane is
/// cut away first.
///
/// # Accuracy
/// A relative 1e-9 on all pairs of the accuracy tables (`tests/tables_form_factors.rs`),
/// shared edges, near-touching and cut pairs among them.
pub fn exchange(i: &Polygon, j: &Polygon, tolerance: f64) -> f64 {
    match facing(i, j) {
        Some((i, j)) => exchange_of_facing(&i, &j, tolerance),
        None => 0.0,
    }
}

/// The parts of two polygons that lie in front of each other.
fn facing(i: &Polygon, j: &Polygon) -> Option<(Polygon, Polygon)> {
    Some((i.clipped(j.plane())?, j.clipped(i.plane())?))
}

// ANCHOR: exchange
fn exchange_of_facing(i: &Polygon, j: &Polygon, tolerance: f64) -> f64 {
    let (small, large) = by_size(i, j);
    let gap = distance_at_least(small, large);
    let factor = lambert_polygon(small.centroid(), small.normal(), large);
    let relative = (tolerance / factor.max(tolerance)).max(1e-14);
    match points_for(relative, small.diameter(), gap) {
        Some(1) => small.area() * factor,
        Some(n) => over(small, n, |x| lambert_polygon(x, small.normal(), large)),
        None => exchange_by_contour(i.vertices(), j.vertices()),
    }
}
// ANCHOR_END: exchange

/// The smaller one first; the same order whichever way the pair is named.
fn by_size<'a>(i: &'a Polygon, j: &'a Polygon) -> (&'a Polygon, &'a Polygon) {
    let place = |p: &Polygon| p.centroid().to_array();
    let (a, b) = (i.diameter(), j.diameter());
    if a < b || (a == b && place(i) < place(j)) { (i, j) } else { (j, i) }
}

/// A lower bound of the distance between two polygons: their bounding spheres', or how
/// far one keeps off the other's plane.
fn distance_at_least(i: &Polygon, j: &Polygon) -> f64 {
    let radius = |p: &Polygon, c: DVec3| {
        p.vertices().iter().map(|v| v.distance(c)).fold(0.0, f64::max)
    };
    let (ci, cj) = (i.centroid(), j.centroid());
    let spheres = ci.distance(cj) - radius(i, ci) - radius(j, cj);
    let off = |p: &Polygon, q: &Polygon| {
        p.vertices().iter().map(|&v| q.plane().height(v)).fold(f64::INFINITY, f64::min)
    };
    spheres.max(off(i, j)).max(off(j, i))
}

/// The method, ready for a scene.
pub struct Analytic {
    elements: Vec<Polygon>,
    patch_of: Vec<u32>,
    shafts: Shafts,
    tolerance: f64,
    seed: u64,
}

/// A partly hidden pair is halved at most this often: to 1/64 of its edge.
const DEEPEST: u32 = 6;

impl Analytic {
    /// Factors between the elements of `mesh`, each with an absolute error near
    /// `tolerance`; `seed` chooses the rays that count what escapes.
    pub fn new(scene: &Scene, mesh: &Mesh, tolerance: f64, seed: u64) -> Analytic {
        Analytic {
            elements: mesh.polygons().cloned().collect(),
            patch_of: mesh.elements.iter().map(|e| e.patch.0).collect(),
            shafts: Shafts::of(scene),
            tolerance,
            seed,
        }
    }

    /// `A_i F_ij` past everything that stands between, in scene units squared.
    pub fn exchange(&self, i: ElementId, j: ElementId) -> f64 {
        let (a, b) = (&self.elements[i.0 as usize], &self.elements[j.0 as usize]);
        let Some((a, b)) = facing(a, b) else { return 0.0 };
        self.exchange_past(&a, &b, &self.shafts.between(&a, &b))
    }

    fn exchange_past(&self, a: &Polygon, b: &Polygon, between: &[u32]) -> f64 {
        let blockers: Vec<&Polygon> =
            between.iter().map(|&k| &self.shafts.surfaces()[k as usize]).collect();
        let (small, large) = by_size(a, b);
        let allowed = self.tolerance * small.area().min(large.area());
        self.past_blockers(small, large, &blockers, None, allowed, DEEPEST)
    }

    /// `∫ F(x → to) dA` over `from`, to an absolute error near `allowed`; `estimate` is
    /// what the caller found by points.
    fn past_blockers(
        &self,
        from: &Polygon,
        to: &Polygon,
        blockers: &[&Polygon],
        estimate: Option<f64>,
        allowed: f64,
        depth: u32,
    ) -> f64 {
        let blockers = self.shafts.narrowed(blockers, from, to);
        if blockers.is_empty() {
            return exchange_of_facing(from, to, self.tolerance);
        }
        if blockers.iter().any(|blocker| hides_all(blocker, from, to)) {
            return 0.0;
        }
        let by_points = |part: &Polygon| {
            over(part, 2, |x| lambert_visible(x, part.normal(), to, &blockers))
        };
        let coarse = estimate.unwrap_or_else(|| by_points(from));
        let parts = quarters(from);
        let fine: Vec<f64> = parts.iter().map(by_points).collect();
        let sum = fine.iter().sum::<f64>();
        if depth == 0 || (coarse - sum).abs() <= allowed {
            return sum;
        }
        let halves = parts.iter().zip(&fine).map(|(part, &found)| {
            let found = Some(found);
            self.past_blockers(part, to, &blockers, found, 0.5 * allowed, depth - 1)
        });
        halves.sum()
    }
}

/// Cuts a polygon across its middle, twice.
fn quarters(polygon: &Polygon) -> Vec<Polygon> {
    let cut = |p: &Polygon| {
        let longest = p
            .edges()
            .max_by(|(a, b), (c, d)| a.distance(*b).total_cmp(&c.distance(*d)))
            .expect("a polygon has edges");
        let along = (longest.1 - longest.0).normalize();
        let plane = Plane::through(p.centroid(), along);
        [p.clipped(plane), p.clipped(plane.flipped())].into_iter().flatten()
    };
    cut(polygon).flat_map(|half| cut(&half).collect::<Vec<_>>()).collect()
}

impl FormFactors for Analytic {
    fn len(&self) -> usize {
        self.elements.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        let element = &self.elements[from.0 as usize];
        let mut known: Option<(u32, Vec<u32>)> = None;
        for (j, factor) in row.iter_mut().enumerate() {
            *factor = 0.0;
            let other = &self.elements[j];
            let patch = self.patch_of[j];
            if patch == self.patch_of[from.0 as usize] {
                continue; // a flat patch does not see itself
            }
            let Some((a, b)) = facing(element, other) else { continue };
            // What may stand between the element and the whole other patch is found once.
            if known.as_ref().is_none_or(|(of, _)| *of != patch) {
                let target = &self.shafts.surfaces()[patch as usize];
                known = Some((patch, self.shafts.between(element, target)));
            }
            let between = &known.as_ref().expect("just found").1;
            *factor = self.exchange_past(&a, &b, between) / element.area();
        }
        lost_by_rays(
            self.shafts.visibility(),
            element,
            self.patch_of[from.0 as usize],
            self.seed,
            from,
        )
    }
}
