//! Coplanar faces that look the same way and overlap: the smaller one wins.
//!
//! A poster drawn on a wall, a lamp in the plane of the ceiling. Both would claim the same
//! points, and rounding would decide pixel by pixel (z-fighting). Candidates are found by
//! a sweep along the longest side of the scene, so that large scenes stay cheap.
//!
//! A face that lets light through takes nothing from what lies in its plane, nor does that
//! from it: light meets both ([`super::layers`]).

use super::{FaceId, Repair, Surface};
use crate::geometry::{Plane, Polygon, bounds};
use glam::DVec3;

/// Distances below this share of the scene's diagonal are rounding: OBJ exporters write
/// six decimals, which in a room of 5 m is 1e-7 of it.
const ROUNDING: f64 = 1e-6;

/// Of the diagonal no more counts than this many times the smaller of two surfaces.
const LARGER: f64 = 1e3;

/// The surfaces with all overlaps cut out of the larger faces, in order of faces.
pub(super) fn settled(
    surfaces: Vec<Surface>,
    faces: usize,
    passes: &dyn Fn(&Surface) -> bool,
    warnings: &mut Vec<Repair>,
) -> Vec<Surface> {
    let mut pairs = overlapping(&surfaces, &|a, b| a.dot(b) > SAME);
    pairs.retain(|&(i, j)| !passes(&surfaces[i]) && !passes(&surfaces[j]));
    if pairs.is_empty() {
        return surfaces;
    }
    let winners = winners(&surfaces, faces, pairs);
    let diagonal = diagonal(&surfaces);
    let mut lost: Vec<(FaceId, FaceId, f64)> = Vec::new();
    let mut left = Vec::with_capacity(surfaces.len());
    for (surface, winners) in surfaces.iter().zip(winners) {
        let mut pieces = vec![(surface.polygon.clone(), extent(&surface.polygon))];
        for winner in winners.iter().map(|&w| &surfaces[w]) {
            let hole = (&winner.polygon, extent(&winner.polygon));
            let tolerance = tolerance(&extent(&surface.polygon), &hole.1, diagonal);
            let touched =
                pieces.extract_if(.., |piece| !apart(&piece.1, &hole.1, tolerance));
            let touched: Vec<_> = touched.map(|piece| piece.0).collect();
            let mut taken = 0.0;
            for piece in touched {
                taken += piece.area();
                for part in cut(piece, hole.0, tolerance) {
                    taken -= part.area();
                    let extent = extent(&part);
                    pieces.push((part, extent));
                }
            }
            match lost.iter_mut().rfind(|l| (l.0, l.1) == (surface.face, winner.face)) {
                Some(entry) => entry.2 += taken,
                None => lost.push((surface.face, winner.face, taken)),
            }
        }
        let piece = |(polygon, _)| Surface { polygon, ..surface.clone() };
        left.extend(pieces.into_iter().map(piece));
    }
    warnings.extend(lost.into_iter().map(|(face, by, area)| Repair::Covered {
        face,
        by,
        area,
    }));
    left
}

/// The place of each face in the order in which they lie in front: the smallest first.
///
/// Areas are compared as f32, so that equal faces with corners in another order are still
/// equal, and the earlier one comes first.
pub(super) fn ranks(surfaces: &[Surface], faces: usize) -> Vec<usize> {
    let mut areas = vec![0.0; faces];
    for s in surfaces {
        areas[s.face] += s.polygon.area();
    }
    let mut order: Vec<usize> = (0..faces).collect();
    order.sort_by(|&a, &b| (areas[a] as f32).total_cmp(&(areas[b] as f32)));
    let mut ranks = vec![0; faces];
    order.into_iter().enumerate().for_each(|(rank, face)| ranks[face] = rank);
    ranks
}

/// For each surface those that win over it, in order, of pairs that overlap.
fn winners(
    surfaces: &[Surface],
    faces: usize,
    pairs: Vec<(usize, usize)>,
) -> Vec<Vec<usize>> {
    let ranks = ranks(surfaces, faces);
    let rank = |s: &Surface| ranks[s.face];
    let mut winners = vec![Vec::new(); surfaces.len()];
    for (i, j) in pairs {
        let first_wins = rank(&surfaces[i]) < rank(&surfaces[j]);
        let (winner, loser) = if first_wins { (i, j) } else { (j, i) };
        winners[loser].push(winner);
    }
    winners.iter_mut().for_each(|winners| winners.sort_unstable());
    winners
}

/// Do two normals with this cosine look the same way?
pub(super) const SAME: f64 = 0.999;

/// Pairs of surfaces of different faces that overlap in one plane and whose normals are
/// `alike`.
pub(super) fn overlapping(
    surfaces: &[Surface],
    alike: &dyn Fn(DVec3, DVec3) -> bool,
) -> Vec<(usize, usize)> {
    let boxes: Vec<Extent> = surfaces.iter().map(|s| extent(&s.polygon)).collect();
    let diagonal = diagonal(surfaces);
    let (low, high) = bounds(boxes.iter().flat_map(|b| [b.0, b.1]));
    let axis = (high - low).max_position();
    let mut order: Vec<usize> = (0..surfaces.len()).collect();
    order.sort_by(|&i, &j| boxes[i].0[axis].total_cmp(&boxes[j].0[axis]));

    let mut pairs = Vec::new();
    for (at, &i) in order.iter().enumerate() {
        for &j in &order[at + 1..] {
            if boxes[j].0[axis] > boxes[i].1[axis] {
                break; // and so do all that follow
            }
            let (a, b) = (&surfaces[i], &surfaces[j]);
            let tolerance = tolerance(&boxes[i], &boxes[j], diagonal);
            if a.face != b.face
                && !apart(&boxes[i], &boxes[j], tolerance)
                && alike(a.polygon.normal(), b.polygon.normal())
                && overlap(&a.polygon, &b.polygon, tolerance)
            {
                pairs.push((i, j));
            }
        }
    }
    pairs
}

/// The lowest and the highest corner of a box.
type Extent = (DVec3, DVec3);

fn extent(polygon: &Polygon) -> Extent {
    bounds(polygon.vertices().iter().copied())
}

/// Is there a gap wider than this between the boxes?
fn apart(a: &Extent, b: &Extent, gap: f64) -> bool {
    a.0.cmpgt(b.1 + gap).any() || b.0.cmpgt(a.1 + gap).any()
}

pub(super) fn diagonal(surfaces: &[Surface]) -> f64 {
    let corners = surfaces.iter().flat_map(|s| s.polygon.vertices().iter().copied());
    let (low, high) = bounds(corners);
    low.distance(high)
}

/// What counts as rounding between surfaces in these boxes, in scene units.
fn tolerance(a: &Extent, b: &Extent, diagonal: f64) -> f64 {
    let smaller = a.0.distance(a.1).min(b.0.distance(b.1));
    ROUNDING * diagonal.min(LARGER * smaller)
}

/// Do the two lie in one plane and share more than an edge?
fn overlap(a: &Polygon, b: &Polygon, tolerance: f64) -> bool {
    let in_plane_of = |a: &Polygon, b: &Polygon| {
        b.vertices().iter().all(|&v| a.plane().height(v).abs() <= tolerance)
    };
    (in_plane_of(a, b) || in_plane_of(b, a)) && common(a, b, tolerance).is_some()
}

/// What two coplanar polygons have in common, if it is wider than rounding.
fn common(a: &Polygon, b: &Polygon, tolerance: f64) -> Option<Polygon> {
    let inwards =
        |(p, q): (DVec3, DVec3)| Plane::through(p, b.normal().cross(q - p).normalize());
    let both =
        b.edges().try_fold(a.clone(), |rest, edge| rest.clipped(inwards(edge)))?;
    (both.area() > tolerance * both.diameter()).then_some(both)
}

/// `piece` less `hole`, untouched where the two do not overlap.
fn cut(piece: Polygon, hole: &Polygon, tolerance: f64) -> Vec<Polygon> {
    if common(&piece, hole, tolerance).is_none() {
        return vec![piece];
    }
    // A rim thinner than rounding is no surface.
    let sound = |p: &Polygon| p.area() > 1e-3 * tolerance * p.diameter();
    piece.without(hole).into_iter().filter(sound).collect()
}
