//! Pieces of about the same area, so that points fall on all of a scene.

use super::Enclosure;
use crate::geometry::{Polygon, Rgb};
use crate::mesh::Mesh;
use glam::DVec3;
use std::ops::Range;

/// So many points fall on a stratum of the usual area.
const POINTS_EACH: usize = 4;

/// No stratum has fewer: the variance within it must show.
const POINTS_AT_LEAST: usize = 2;

/// Belongs to no stratum: a piece that reflects nothing.
pub(super) const NONE: u32 = u32::MAX;

/// An element, or a part of a large one.
pub(super) struct Piece {
    pub polygon: Polygon,
    pub element: u32,
}

/// The reflecting surfaces in strata: each a part of one surface, made of pieces that
/// follow one another.
pub(super) struct Strata {
    pub pieces: Vec<Piece>,
    /// Per piece: its stratum, or [`NONE`].
    pub of_piece: Vec<u32>,
    /// Per stratum: its pieces.
    pub members: Vec<Range<usize>>,
    /// Per stratum, scene units squared.
    pub area: Vec<f64>,
    /// Per stratum: how many points it gets.
    pub points: Vec<usize>,
}

impl Strata {
    /// Strata for about so many points in all.
    pub fn of(mesh: &Mesh, enclosure: &Enclosure, points: usize) -> Strata {
        let reflects = |k: usize| enclosure.reflectance[k] != Rgb::ZERO;
        let lit = (0..enclosure.len()).filter(|&k| reflects(k));
        let total: f64 = lit.map(|k| enclosure.area[k]).sum();
        let usual = total / (points / POINTS_EACH).max(4) as f64;
        let mut strata = Strata {
            pieces: Vec::new(),
            of_piece: Vec::new(),
            members: Vec::new(),
            area: Vec::new(),
            points: Vec::new(),
        };
        let mut surface = None;
        for (k, element) in mesh.elements.iter().enumerate() {
            let here = Some(mesh.patch_of(element).surface);
            let mut pieces = Vec::new();
            if reflects(k) {
                divide(&element.polygon, usual, &mut pieces);
            } else {
                pieces.push(element.polygon.clone());
            }
            for polygon in pieces {
                let area = polygon.area();
                let at = strata.pieces.len();
                strata.pieces.push(Piece { polygon, element: k as u32 });
                if !reflects(k) {
                    strata.of_piece.push(NONE);
                    continue;
                }
                match strata.area.last_mut() {
                    Some(sum) if surface == here && *sum + area <= 1.2 * usual => {
                        *sum += area;
                        let last = strata.members.len() - 1;
                        strata.members[last].end = at + 1;
                    }
                    _ => {
                        strata.area.push(area);
                        strata.members.push(at..at + 1);
                    }
                }
                strata.of_piece.push(strata.area.len() as u32 - 1);
                surface = here;
            }
        }
        let count = |&area: &f64| {
            let share = (POINTS_EACH as f64 * area / usual).round() as usize;
            share.max(POINTS_AT_LEAST)
        };
        strata.points = strata.area.iter().map(count).collect();
        strata
    }

    pub fn len(&self) -> usize {
        self.area.len()
    }

    /// The piece and the point of stratum `h` at `(u, v)` of the unit square: uniform
    /// points give points uniform in area.
    pub fn point_at(&self, h: usize, [u, v]: [f64; 2]) -> (&Piece, DVec3) {
        let mut rest = u * self.area[h];
        let members = &self.pieces[self.members[h].clone()];
        for (k, piece) in members.iter().enumerate() {
            let area = piece.polygon.area();
            if rest < area || k + 1 == members.len() {
                let u = (rest / area).clamp(0.0, 1.0);
                return (piece, piece.polygon.point_at([u, v]));
            }
            rest -= area;
        }
        unreachable!("a stratum has a piece")
    }
}

/// Halves `polygon` until its parts are no larger than 1.2 times `usual`.
fn divide(polygon: &Polygon, usual: f64, into: &mut Vec<Polygon>) {
    let parts: Vec<Polygon> =
        if polygon.area() > 1.2 * usual { polygon.halves().collect() } else { vec![] };
    // A sliver that cannot be cut stays whole.
    if parts.len() == 2 {
        parts.iter().for_each(|part| divide(part, usual, into));
    } else {
        into.push(polygon.clone());
    }
}
