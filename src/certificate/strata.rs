//! Pieces of about the same area, so that points fall on all of a scene.

use crate::geometry::{Polygon, Rgb};
use crate::mesh::Mesh;
use glam::DVec3;
use std::ops::Range;

/// So many points fall on a stratum of the usual area.
const POINTS_EACH: usize = 4;

/// A stratum may be worth so much, in units of the usual one.
const MOST: f64 = 1.2;

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
///
/// Half of the points are shared out by area, half by number of elements: elements are
/// small where light changes quickly, and the error most.
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
    /// Strata for about so many points in all; `scattered` is `ρ + τ` per element.
    pub fn of(mesh: &Mesh, scattered: &[Rgb], points: usize) -> Strata {
        let reflects = |k: usize| scattered[k] != Rgb::ZERO;
        let area_of = |k: usize| mesh.elements[k].polygon.area();
        let lit: Vec<usize> =
            (0..mesh.elements.len()).filter(|&k| reflects(k)).collect();
        let area: f64 = lit.iter().map(|&k| area_of(k)).sum();
        let strata = (points / POINTS_EACH).max(4) as f64;
        // Of an element, how many strata it is worth.
        let worth =
            |k: usize| 0.5 * strata * (area_of(k) / area + 1.0 / lit.len() as f64);
        let (mut pieces, mut of_piece) = (Vec::new(), Vec::new());
        let mut members: Vec<Range<usize>> = Vec::new();
        let mut worths: Vec<f64> = Vec::new();
        let mut surface = None;
        for (k, element) in (0u32..).zip(&mesh.elements) {
            if !reflects(k as usize) {
                pieces.push(Piece { polygon: element.polygon.clone(), element: k });
                of_piece.push(NONE);
                surface = None;
                continue;
            }
            let here = Some(mesh.patch_of(element).surface);
            let worth = worth(k as usize);
            let mut parts = Vec::new();
            divide(&element.polygon, worth, &mut parts);
            for (polygon, worth) in parts {
                match (members.last_mut(), worths.last_mut()) {
                    (Some(last), Some(sum))
                        if surface == here && *sum + worth <= MOST =>
                    {
                        last.end += 1;
                        *sum += worth;
                    }
                    _ => {
                        members.push(pieces.len()..pieces.len() + 1);
                        worths.push(worth);
                    }
                }
                surface = here;
                of_piece.push(members.len() as u32 - 1);
                pieces.push(Piece { polygon, element: k });
            }
        }
        let area =
            |m: &Range<usize>| pieces[m.clone()].iter().map(|p| p.polygon.area()).sum();
        let count = |worth: &f64| {
            ((POINTS_EACH as f64 * worth).round() as usize).max(POINTS_AT_LEAST)
        };
        Strata {
            area: members.iter().map(area).collect(),
            points: worths.iter().map(count).collect(),
            pieces,
            of_piece,
            members,
        }
    }

    pub fn len(&self) -> usize {
        self.area.len()
    }

    /// The piece and the point of stratum `h` at `(u, v)` of the unit square: uniform
    /// points give points uniform in area.
    pub fn point_at(&self, h: usize, [u, v]: [f64; 2]) -> (u32, DVec3) {
        let mut rest = u * self.area[h];
        let members = self.members[h].clone();
        for k in members.clone() {
            let polygon = &self.pieces[k].polygon;
            let area = polygon.area();
            if rest < area || k + 1 == members.end {
                let u = (rest / area).clamp(0.0, 1.0);
                return (k as u32, polygon.point_at([u, v]));
            }
            rest -= area;
        }
        unreachable!("a stratum has a piece")
    }
}

/// Halves `polygon`, worth so many strata, until its parts are worth no more than
/// [`MOST`]; hands on each with its worth.
fn divide(polygon: &Polygon, worth: f64, into: &mut Vec<(Polygon, f64)>) {
    let halves: Vec<Polygon> =
        if worth > MOST { polygon.halves().collect() } else { vec![] };
    // A sliver that cannot be cut stays whole.
    if halves.len() < 2 {
        into.push((polygon.clone(), worth));
    } else {
        halves.iter().for_each(|half| divide(half, 0.5 * worth, into));
    }
}
