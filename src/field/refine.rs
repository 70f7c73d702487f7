//! Splitting elements until light is linear enough between their corners.
//!
//! ```text
//! ∫ (H − H̃)² dA ≈ A (4/9 δ_centre² + 1/9 Σ_edges δ_edge²)       Simpson; δ = 0 at corners
//! error² = Σ_elements c² ∫ (H − H̃)² dA,   c = max(ρ/‖B − E‖, 1/‖H‖)     what is to be small
//! ```
//! An element is asked at its centre and in the middle of its edges, where its parts would
//! have their corners: there the interpolation `H̃` is held against the light itself. The
//! elements with the largest errors are split, those that make up 60 % of the square of the
//! error at a time, until what is left is small enough. Near lamps and at shadow boundaries
//! this is often, elsewhere never.
//!
//! It is asked next to lamps, too: a lamp that is smaller and nearer than the element lights
//! a spot that the usual points would miss.
//!
//! **Fails** when something shows at none of these points: a bright spot in the middle of
//! a quarter, that no lamp is near.

use crate::geometry::Rgb;
use crate::mesh::{Element, Mesh, TwoLevels, VertexId};
use crate::scene::Scene;
use glam::DVec3;
use rayon::prelude::*;
use std::collections::HashMap;

/// Light at a point of an element, W/m².
pub(super) type LightAt<'a> = &'a (dyn Fn(&Element, DVec3) -> Rgb + Sync);

/// Points of an element, each with an area, in scene units squared.
pub(super) type NearLamps<'a> = &'a (dyn Fn(&Element) -> Vec<(DVec3, f64)> + Sync);

/// Where an element is asked for its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Asked {
    /// At the centre only, the edges being taken for half as wrong: where light is dear.
    Centre,
    /// At the centre and in the middle of each edge.
    All,
}

/// How light is made linear between corners.
pub(super) struct Refinement<'a> {
    pub scene: &'a Scene,
    pub light: LightAt<'a>,
    /// What an error in `H` of an element counts, in m²/W per root of an area.
    pub counts: &'a (dyn Fn(&Element) -> Rgb + Sync),
    pub ask: Asked,
    /// Places in an element next to small lamps, where light may peak; and over what area.
    pub near_lamps: NearLamps<'a>,
    /// Corners at the rim of a surface are asked this share of an element inside it.
    pub inside: f64,
    /// The error asked for, relative.
    pub target: f64,
    /// The most elements.
    pub most: usize,
}

/// The light that an error is held against.
#[derive(Clone, Copy, Debug)]
pub(super) struct LightScale {
    /// `‖B − E‖²`, per channel.
    pub reflected: Rgb,
    /// `‖H‖²`.
    pub arriving: Rgb,
}

impl LightScale {
    /// `c` of a surface that scatters this: its error matters by what it sends on, and, were
    /// it black, by what arrives. A channel without light does not count.
    pub fn counts(&self, scattered: Rgb) -> Rgb {
        let of = |k: usize| {
            let seen = scattered[k] / self.reflected[k].sqrt();
            let arrives = 1.0 / self.arriving[k].sqrt();
            let finite = |c: f64| if c.is_finite() { c } else { 0.0 };
            finite(seen).max(finite(arrives))
        };
        Rgb::new(of(0), of(1), of(2))
    }
}

/// Splitting what makes up most of the error should take away much of it. When what is left
/// is more than this share of the least so far, so many times in a row, then what is split
/// is noise, which does not fall - or, where light is exact, a spot of which each part that
/// is found shows more.
const NO_GAIN: f64 = 0.9;
const IN_VAIN: [usize; 2] = [2, 8];

/// No element is split whose area is a smaller share of the scene's, or an edge of which is
/// a smaller share of the root of that: corners nearer than rounding are one.
const SMALLEST: f64 = 1e-9;
const SHORTEST: f64 = 1e-6;

/// Nor one with an edge of fewer times what counts as rounding, where that is more.
const SHORTEST_TOLD_APART: f64 = 1e3;

impl Refinement<'_> {
    /// The elements of the patches split until they suffice, and the light at their
    /// vertices.
    pub fn run<'m>(&self, patches: &'m Mesh) -> (TwoLevels<'m>, Vec<Rgb>) {
        self.run_from(patches, Vec::new(), Vec::new())
    }

    /// The same, when the `light` at the places that were `asked`, one for each corner of
    /// the patches, is known.
    pub fn run_from<'m>(
        &self,
        patches: &'m Mesh,
        mut asked: Vec<DVec3>,
        mut light: Vec<Rgb>,
    ) -> (TwoLevels<'m>, Vec<Rgb>) {
        let mut levels = TwoLevels::undivided(patches);
        let total = Mesh::area_in_scale(self.scene);
        self.ask_vertices(levels.elements(), &mut asked, &mut light);
        let mut known = HashMap::new();
        let most_in_vain = IN_VAIN[(self.ask == Asked::All) as usize];
        let (mut least, mut in_vain) = (f64::INFINITY, 0);
        loop {
            let mesh = levels.elements();
            let errors = self.errors(mesh, &light, &mut known);
            let sum: f64 = errors.iter().sum();
            in_vain = if sum > NO_GAIN * least { in_vain + 1 } else { 0 };
            least = sum.min(least);
            let enough = sum <= self.target * self.target || in_vain == most_in_vain;
            if enough || mesh.elements.len() >= self.most {
                return (levels, light);
            }
            let mut marks = self.largest(mesh, &errors, total);
            if !marks.contains(&true) {
                return (levels, light);
            }
            mesh.mark_backs(self.scene, &mut marks);
            levels = levels.split(&marks);
            self.ask_vertices(levels.elements(), &mut asked, &mut light);
        }
    }

    /// The square of the error of each element; what is `known` is not looked for again.
    fn errors(
        &self,
        mesh: &Mesh,
        light: &[Rgb],
        known: &mut HashMap<[VertexId; 3], f64>,
    ) -> Vec<f64> {
        let name = |e: &Element| [0, 1, 2].map(|k| e.corners[k]);
        let new: Vec<&Element> =
            mesh.elements.iter().filter(|e| !known.contains_key(&name(e))).collect();
        let found: Vec<f64> =
            new.par_iter().map(|e| self.error(mesh, e, light)).collect();
        known.extend(new.iter().map(|e| name(e)).zip(found));
        mesh.elements.iter().map(|e| known[&name(e)]).collect()
    }

    /// Marks the elements that make up 60 % of the square of the error, the worst first.
    fn largest(&self, mesh: &Mesh, errors: &[f64], total: f64) -> Vec<bool> {
        let rounding = SHORTEST_TOLD_APART * self.scene.rounding();
        let shortest = rounding.max(SHORTEST * total.sqrt());
        let divisible = |k: &usize| {
            let polygon = &mesh.elements[*k].polygon;
            polygon.area() > SMALLEST * total
                && polygon.edges().all(|(a, b)| a.distance(b) > shortest)
        };
        let mut order: Vec<usize> = (0..errors.len()).filter(divisible).collect();
        order.sort_by(|&a, &b| errors[b].total_cmp(&errors[a]).then(a.cmp(&b)));
        let (sum, mut marked) = (errors.iter().sum::<f64>(), 0.0);
        let mut marks = vec![false; errors.len()];
        // Each that is split leaves three more, and its neighbours' balance some.
        let room = (self.most - errors.len()).div_ceil(3);
        for k in order.into_iter().take(room) {
            if marked > 0.6 * sum {
                break;
            }
            marked += errors[k];
            marks[k] = errors[k] > 0.0;
        }
        marks
    }

    /// Asks for the light at the vertices, but where it is known already.
    fn ask_vertices(&self, mesh: &Mesh, asked: &mut Vec<DVec3>, light: &mut Vec<Rgb>) {
        let places = mesh.places(self.inside);
        let old = asked.len();
        let found: Vec<Option<Rgb>> = places
            .par_iter()
            .enumerate()
            .map(|(k, place)| {
                let same = |p: &DVec3| k < old && asked[k] == *p;
                let place = place.as_ref().filter(|place| !same(&place.at))?;
                Some((self.light)(&mesh.elements[place.element as usize], place.at))
            })
            .collect();
        asked.resize(places.len(), DVec3::NAN);
        light.resize(places.len(), Rgb::ZERO);
        for (k, (place, found)) in places.iter().zip(found).enumerate() {
            if let (Some(place), Some(found)) = (place, found) {
                (asked[k], light[k]) = (place.at, found);
            }
        }
        mesh.anchor(light);
    }

    /// The square of the error of one element, as it counts; worst channel.
    fn error(&self, mesh: &Mesh, element: &Element, light: &[Rgb]) -> f64 {
        let counts = (self.counts)(element);
        if counts == Rgb::ZERO {
            return 0.0;
        }
        let polygon = &element.polygon;
        let (centre, v) = (polygon.centroid(), polygon.vertices());
        let off = |at: DVec3| {
            let there = (self.light)(element, at.lerp(centre, self.inside));
            let off = counts * (there - mesh.value_at(element, at, light));
            off * off
        };
        // ANCHOR: simpson
        let centre = off(centre);
        let squares = match self.ask {
            Asked::Centre => 5.0 / 9.0 * centre,
            Asked::All => {
                let middle = |k: usize| off(v[k].midpoint(v[(k + 1) % v.len()]));
                let edges = (0..v.len()).map(middle).sum::<Rgb>() / v.len() as f64;
                4.0 / 9.0 * (centre + edges)
            }
        };
        // ANCHOR_END: simpson
        let near_lamps = (self.near_lamps)(element).into_iter();
        let near_lamps =
            near_lamps.map(|(at, area)| area.min(polygon.area()) * off(at));
        let share = polygon.area() * squares + near_lamps.sum::<Rgb>();
        share.to_array().into_iter().filter(|s| s.is_finite()).fold(0.0, f64::max)
    }
}
