//! Pieces of about the same worth, so that points fall on all of a scene and where light lands.

use super::landings::{Landed, Landings};
use crate::geometry::Polygon;
use crate::material::Material;
use crate::mesh::Mesh;
use crate::scene::Scene;
use glam::DVec3;
use std::ops::Range;

/// So many points fall on a stratum of the usual worth.
const POINTS_EACH: usize = 4;

/// A stratum may be worth so much, in units of the usual one.
const MOST: f64 = 1.2;

/// No stratum has fewer: the variance within it must show.
const POINTS_AT_LEAST: usize = 2;

/// An element is halved at most this often: to a millionth of its edge.
const DEEPEST: u32 = 40;

/// An element, or a part of a large one.
pub(super) struct Piece {
    pub polygon: Polygon,
    pub element: u32,
}

/// All fronts in strata: each a part of one surface, made of pieces that follow one another.
///
/// Points are shared out by area, by number of elements, and by where light lands: elements
/// are small where light changes quickly, and the error most; and a spot of light may be
/// smaller than any of them.
pub(super) struct Strata {
    pub pieces: Vec<Piece>,
    /// Per piece: its stratum.
    pub of_piece: Vec<u32>,
    /// Per stratum: its pieces.
    pub members: Vec<Range<usize>>,
    /// Per stratum, scene units squared.
    pub area: Vec<f64>,
    /// Per stratum: how many points it gets.
    pub points: Vec<usize>,
    /// Per stratum: the few directions from which light was seen to come.
    pub from: Vec<Vec<DVec3>>,
}

/// A part of an element, what it is worth, and the directions of [`Landed::from`].
struct ElementPart {
    polygon: Polygon,
    worth: f64,
    from: Vec<DVec3>,
}

/// What a part of an element is worth, in strata.
struct Worth {
    of_area: f64,
    of_element: f64,
    of_landing: f64,
}

impl Worth {
    /// For so many strata in all.
    fn of(mesh: &Mesh, landings: &Landings, strata: f64) -> Worth {
        // ANCHOR: worth
        let area: f64 = mesh.polygons().map(Polygon::area).sum();
        let by_light = if landings.kept > 0 { 0.2 } else { 0.0 };
        let rest = 0.5 * (1.0 - by_light);
        Worth {
            of_area: rest * strata / area,
            of_element: rest * strata / mesh.elements.len() as f64,
            of_landing: by_light * strata / landings.kept.max(1) as f64,
        }
        // ANCHOR_END: worth
    }

    /// Halves a part, which is so much of its element and in which light landed at these
    /// places, until its parts are worth no more than [`MOST`]; hands on each with its worth.
    fn divide(
        &self,
        polygon: Polygon,
        share: f64,
        landings: &[Landed],
        into: &mut Vec<ElementPart>,
    ) {
        let worth = self.of_area * polygon.area()
            + self.of_element * share
            + self.of_landing * landings.len() as f64;
        let deep = share < 0.5_f64.powi(DEEPEST as i32);
        let halves: Vec<Polygon> =
            if worth > MOST && !deep { polygon.halves().collect() } else { vec![] };
        // A sliver that cannot be cut stays whole.
        let [first, second] = &halves[..] else {
            let from = landings.iter().filter_map(|landed| landed.from).collect();
            into.push(ElementPart { polygon, worth, from });
            return;
        };
        let (here, there): (Vec<Landed>, Vec<Landed>) =
            landings.iter().partition(|landed| first.contains(landed.at, 0.0));
        for (half, landings) in [(first, here), (second, there)] {
            let share = share * half.area() / polygon.area();
            self.divide(half.clone(), share, &landings, into);
        }
    }
}

impl Strata {
    /// Strata for about so many points in all.
    pub fn of(mesh: &Mesh, landings: &Landings, points: usize) -> Strata {
        let worth = Worth::of(mesh, landings, (points / POINTS_EACH).max(4) as f64);
        let (mut pieces, mut of_piece) = (Vec::new(), Vec::new());
        let mut members: Vec<Range<usize>> = Vec::new();
        let mut worths: Vec<f64> = Vec::new();
        let mut from: Vec<Vec<DVec3>> = Vec::new();
        let mut before = None;
        for (k, element) in (0u32..).zip(&mesh.elements) {
            let here = Some(mesh.patch_of(element).surface);
            let mut parts = Vec::new();
            let places = landings.on.get(k as usize).map_or(&[][..], |p| &p[..]);
            worth.divide(element.polygon.clone(), 1.0, places, &mut parts);
            for ElementPart { polygon, worth, from: directions } in parts {
                match (members.last_mut(), worths.last_mut()) {
                    (Some(last), Some(sum))
                        if before == here && *sum + worth <= MOST =>
                    {
                        last.end += 1;
                        *sum += worth;
                        let of_stratum = from.last_mut();
                        of_stratum.into_iter().for_each(|f: &mut Vec<_>| {
                            f.extend_from_slice(&directions);
                        });
                    }
                    _ => {
                        from.push(directions);
                        members.push(pieces.len()..pieces.len() + 1);
                        worths.push(worth);
                    }
                }
                before = here;
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
            from,
        }
    }

    pub fn len(&self) -> usize {
        self.area.len()
    }

    /// What a stratum is made of.
    pub fn material<'s>(
        &self,
        h: usize,
        scene: &'s Scene,
        mesh: &Mesh,
    ) -> &'s Material {
        let element = self.pieces[self.members[h].start].element;
        mesh.material(scene, &mesh.elements[element as usize])
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
