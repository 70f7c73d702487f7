//! What is out of scale: the ground that a house stands on.
//!
//! ```text
//! extent > 10 (size of all that is smaller + distance)         then it is out of scale
//! edges ≤ max_edge + distance to what is in scale              and is divided like this
//! ```
//! Ground beside a house, or a triangle at the horizon, would have nearly all elements if
//! all were of one size, and the rooms none. What is so much larger than everything else
//! together is divided as finely as that only next to it, and the less the farther off: it
//! has a few elements more for each doubling of its size, and takes none from the rooms.

use super::grid;
use crate::geometry::{Polygon, bounds};
use crate::scene::Scene;
use glam::DVec3;
use std::collections::HashMap;

/// So many times larger than all that is smaller is out of scale.
const LARGER: f64 = 10.0;

/// A surface lights what is this many times its own size away, and no scale is larger.
const FARTHEST: f64 = 10.0;

/// A box that holds the surfaces of a plane.
struct InPlane {
    ends: (DVec3, DVec3),
    surfaces: Vec<usize>,
}

fn size((low, high): (DVec3, DVec3)) -> f64 {
    low.distance(high)
}

/// The distance between two boxes, 0 where they meet.
fn distance(a: (DVec3, DVec3), b: (DVec3, DVec3)) -> f64 {
    (a.0 - b.1).max(b.0 - a.1).max(DVec3::ZERO).length()
}

/// What of a scene is in scale.
pub(super) struct Scale {
    /// The box that holds it.
    in_scale: (DVec3, DVec3),
    /// For each surface whether it is out of scale.
    out: Vec<bool>,
}

impl Scale {
    pub(super) fn of(scene: &Scene) -> Scale {
        let mut planes = planes(scene);
        planes.sort_by(|a, b| size(a.ends).total_cmp(&size(b.ends)));
        // The box of each plane and all smaller ones.
        let mut boxes: Vec<(DVec3, DVec3)> = Vec::with_capacity(planes.len());
        for plane in &planes {
            let (low, high) = *boxes.last().unwrap_or(&plane.ends);
            boxes.push((low.min(plane.ends.0), high.max(plane.ends.1)));
        }
        let is_out = |k: &usize| {
            let (own, smaller) = (planes[*k].ends, boxes[*k - 1]);
            let far = distance(own, smaller).min(FARTHEST * size(smaller));
            size(own) > LARGER * (size(smaller) + far)
        };
        let last = (1..planes.len()).rev().find(|k| !is_out(k)).unwrap_or(0);
        let mut out = vec![false; scene.surfaces.len()];
        let of_planes = planes.iter().skip(last + 1).flat_map(|p| &p.surfaces);
        of_planes.for_each(|&k| out[k] = true);
        let in_scale = boxes.get(last).copied().unwrap_or_default();
        Scale { in_scale, out }
    }

    /// The cells of surface `k`, with edges no longer than `max_edge`, or farther off as
    /// long as that and the distance.
    pub(super) fn cells(&self, k: usize, of: &Polygon, max_edge: f64) -> Vec<Polygon> {
        if !self.out[k] {
            return grid::cells(of, max_edge);
        }
        let (mut left, mut cells) = (vec![of.clone()], Vec::new());
        while let Some(cell) = left.pop() {
            let longest = cell.edges().map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
            let here = bounds(cell.vertices().iter().copied());
            match longest <= max_edge + distance(here, self.in_scale) {
                true => cells.push(cell),
                false => left.extend(cell.quarters()),
            }
        }
        cells
    }

    /// How many cells these are.
    pub(super) fn count(&self, k: usize, of: &Polygon, max_edge: f64) -> f64 {
        match self.out[k] {
            true => self.cells(k, of, max_edge).len() as f64,
            false => grid::count(of, max_edge),
        }
    }

    /// The area of all that is in scale, scene units squared.
    pub(super) fn area(&self, scene: &Scene) -> f64 {
        let all = scene.surfaces.iter().zip(&self.out);
        all.filter(|(_, out)| !**out).map(|(s, _)| s.polygon.area()).sum()
    }
}

/// The surfaces by planes, whichever way they look.
fn planes(scene: &Scene) -> Vec<InPlane> {
    let margin = 1.2345 * 100.0 * scene.rounding();
    let mut number: HashMap<[i64; 4], usize> = HashMap::new();
    let mut planes: Vec<InPlane> = Vec::new();
    for (k, surface) in scene.surfaces.iter().enumerate() {
        let mut plane = surface.polygon.plane();
        if plane.normal.to_array().into_iter().find(|x| x.abs() > 1e-6) < Some(0.0) {
            plane = plane.flipped();
        }
        let [x, y, z] = (1.2345e7 * plane.normal).to_array();
        let key = [x, y, z, plane.offset / margin].map(|x| x.round() as i64);
        let own = bounds(surface.polygon.vertices().iter().copied());
        let at = *number.entry(key).or_insert_with(|| {
            planes.push(InPlane { ends: own, surfaces: Vec::new() });
            planes.len() - 1
        });
        let InPlane { ends, surfaces } = &mut planes[at];
        *ends = (ends.0.min(own.0), ends.1.max(own.1));
        surfaces.push(k);
    }
    planes
}
