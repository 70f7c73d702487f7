//! Repairs outlines that are no [`Polygon`] yet: splits non-planar and non-convex ones.
//!
//! ```text
//! project along Newell's normal → refuse crossings → clip ears → merge what stays convex
//! ```
//!
//! The ear whose cut is shortest goes first, so a twisted quad folds along its shorter
//! diagonal. No corner is added: two faces that share an edge still share it.
//!
//! **Not here:** holes. A bridge to a hole runs along an edge twice, and is refused.
//! Sources: Newell (in Sutherland et al. 1974); Meisters 1975 (ears);
//! Hertel & Mehlhorn 1983 (merging).

use super::polygon::{diameter, newell, without_repeats};
use super::{Frame, Polygon, PolygonError};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// The longest outline that [`split`] takes: its work grows with the square of it.
pub const MAX_CORNERS: usize = 4096;

/// Splits an outline into convex planar pieces; one piece when it is fit as it is.
///
/// The pieces have the front of the outline, and their corners are corners of it. For a
/// planar outline their areas add up to its area; a twisted one has no area of its own,
/// and that of the folded surface stands for it.
///
/// # Errors
/// What cannot be repaired: too few or too many corners, a coordinate that is not finite,
/// no area, edges that cross or touch. Crossings are looked for on the outline projected
/// along its mean normal, so a strip that twists by more than half a turn counts as
/// crossing.
pub fn split(outline: &[DVec3]) -> Result<Vec<Polygon>, PolygonError> {
    if outline.len() > MAX_CORNERS {
        return Err(PolygonError::TooManyVertices(outline.len()));
    }
    match Polygon::new(outline.to_vec()) {
        Ok(polygon) => return Ok(vec![polygon]),
        Err(
            PolygonError::NotPlanar(_)
            | PolygonError::NotConvex
            | PolygonError::ZeroArea
            | PolygonError::SelfIntersecting,
        ) => {}
        Err(hopeless) => return Err(hopeless),
    }
    let corners = without_repeats(outline.to_vec());
    let Some(flat) = project(&corners) else {
        return Err(PolygonError::ZeroArea);
    };
    if crosses(&flat) {
        return Err(PolygonError::SelfIntersecting);
    }
    if area(&flat) <= 1e-14 {
        return Err(PolygonError::ZeroArea);
    }
    let triangles = ears(&flat).ok_or(PolygonError::SelfIntersecting)?;
    merged(&corners, triangles)
}

/// The outline as seen along its normal, scaled to size 1; `None` when it is a line.
///
/// A bow-tie of equal halves has no mean normal; that of its sharpest corner will do.
fn project(corners: &[DVec3]) -> Option<Vec<DVec2>> {
    let size = diameter(corners);
    let unit: Vec<DVec3> = corners.iter().map(|&v| (v - corners[0]) / size).collect();
    let n = unit.len();
    let corner =
        |k: usize| (unit[(k + 1) % n] - unit[k]).cross(unit[(k + 2) % n] - unit[k]);
    let sharpest = (0..n).map(corner).max_by(|a, b| a.length().total_cmp(&b.length()));
    let mean = newell(&unit);
    let normal = if mean.length() > 1e-14 { mean } else { sharpest? };
    if normal.is_nan() || normal.length() <= 1e-14 {
        return None;
    }
    let frame = Frame::about(normal.normalize());
    Some(unit.iter().map(|v| DVec2::new(frame.x.dot(*v), frame.y.dot(*v))).collect())
}

/// Twice the signed area of the triangle `a b c`; positive when it turns left.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

fn area(flat: &[DVec2]) -> f64 {
    (1..flat.len() - 1).map(|k| 0.5 * turn(flat[0], flat[k], flat[k + 1])).sum()
}

/// Distances below this, in an outline of size 1, are rounding.
const TOUCH: f64 = 1e-12;

/// Do two edges cross or touch, other than neighbours in their common corner?
fn crosses(flat: &[DVec2]) -> bool {
    let n = flat.len();
    let edge = |k: usize| (flat[k % n], flat[(k + 1) % n]);
    for i in 0..n {
        let (a, b) = edge(i);
        let (_, c) = edge(i + 1);
        let folds_back =
            turn(a, b, c).abs() <= TOUCH * a.distance(b) && (b - a).dot(c - b) < 0.0;
        if folds_back {
            return true;
        }
        let last = if i == 0 { n - 1 } else { n };
        if (i + 2..last).any(|j| meet((a, b), edge(j))) {
            return true;
        }
    }
    false
}

/// Have two segments a point in common?
fn meet((a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2)) -> bool {
    let apart = |a: f64, b: f64, c: f64, d: f64| {
        a.max(b) + TOUCH < c.min(d) || c.max(d) + TOUCH < a.min(b)
    };
    if apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y) {
        return false;
    }
    // Which side of pq is r on: -1, 0 (on it, to rounding) or 1?
    let side = |p: DVec2, q: DVec2, r: DVec2| {
        let t = turn(p, q, r);
        if t.abs() <= TOUCH * p.distance(q) { 0 } else { t.signum() as i32 }
    };
    side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0
}

/// Cuts a simple outline into triangles, shortest cut first.
///
/// `None` when rounding leaves no ear, which a simple outline always has.
fn ears(flat: &[DVec2]) -> Option<Vec<Vec<usize>>> {
    let mut left: Vec<usize> = (0..flat.len()).collect();
    let cut = |left: &[usize], k: usize| {
        let m = left.len();
        let [i, j, l] = [left[(k + m - 1) % m], left[k], left[(k + 1) % m]];
        let (a, b, c) = (flat[i], flat[j], flat[l]);
        let inside = |p: DVec2| {
            turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0
        };
        let free = || left.iter().all(|&p| [i, j, l].contains(&p) || !inside(flat[p]));
        if turn(a, b, c) > TOUCH * a.distance(c) && free() {
            a.distance_squared(c)
        } else {
            f64::INFINITY // no ear
        }
    };
    let mut cuts: Vec<f64> = (0..left.len()).map(|k| cut(&left, k)).collect();
    let mut triangles = Vec::with_capacity(flat.len() - 2);
    while left.len() > 3 {
        let best = (0..left.len()).min_by(|&a, &b| cuts[a].total_cmp(&cuts[b]))?;
        if cuts[best].is_infinite() {
            return None;
        }
        let m = left.len();
        triangles.push(vec![
            left[(best + m - 1) % m],
            left[best],
            left[(best + 1) % m],
        ]);
        left.remove(best);
        cuts.remove(best);
        // Only the two neighbours see a new corner.
        let m = left.len();
        for k in [(best + m - 1) % m, best % m] {
            cuts[k] = cut(&left, k);
        }
    }
    triangles.push(left);
    Some(triangles)
}

/// Takes cuts away again where the two pieces beside them make one that is convex.
fn merged(
    corners: &[DVec3],
    mut pieces: Vec<Vec<usize>>,
) -> Result<Vec<Polygon>, PolygonError> {
    let polygon =
        |piece: &[usize]| Polygon::new(piece.iter().map(|&k| corners[k]).collect());
    let edges = |piece: &[usize]| {
        let ends = piece.iter().copied().cycle().skip(1);
        piece.iter().copied().zip(ends).collect::<Vec<_>>()
    };
    // On the left of which piece lies an edge?
    let mut left: HashMap<(usize, usize), usize> = HashMap::new();
    for (k, piece) in pieces.iter().enumerate() {
        left.extend(edges(piece).into_iter().map(|edge| (edge, k)));
    }
    let cuts: Vec<_> = pieces.iter().flat_map(|piece| edges(piece)).collect();
    for (a, b) in cuts {
        let (Some(&one), Some(&other)) = (left.get(&(a, b)), left.get(&(b, a))) else {
            continue; // an edge of the outline, or a cut taken away from the other side
        };
        let both = joined(&pieces[one], &pieces[other], a);
        if polygon(&both).is_ok() {
            left.remove(&(a, b));
            left.remove(&(b, a));
            for edge in edges(&pieces[other]) {
                left.entry(edge).and_modify(|piece| *piece = one);
            }
            pieces[one] = both;
            pieces[other].clear();
        }
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces.iter().map(|piece| polygon(piece)).collect()
}

/// Two outlines made one along the edge that leaves `a` in the first.
fn joined(one: &[usize], other: &[usize], a: usize) -> Vec<usize> {
    // All of `piece` from just after corner `k` round to it.
    let round = |piece: &[usize], k: usize| {
        let at = piece.iter().position(|&corner| corner == k).map_or(0, |at| at + 1);
        [&piece[at..], &piece[..at]].concat()
    };
    let mut both = round(one, a); // b … a
    both.extend(round(other, a)); // … b a
    both.truncate(both.len() - 2);
    both
}
