//! Values between the corners of an element.

use super::{Element, Mesh};
use crate::geometry::{Polygon, Rgb};
use glam::DVec3;
use smallvec::{SmallVec, smallvec};

impl Mesh {
    /// The value at `p`, a point of `element`, between those of its corners.
    ///
    /// Linear along every edge, so that neighbours agree there; exact for linear
    /// fields; on a triangle Gouraud's (barycentric), on a rectangle bilinear. See
    /// [`wachspress`].
    pub fn value_at(&self, element: &Element, p: DVec3, of_vertices: &[Rgb]) -> Rgb {
        let weights = wachspress(&element.polygon, p);
        let of_corner = element.corners.iter().map(|c| of_vertices[c.0 as usize]);
        weights.iter().zip(of_corner).map(|(&weight, value)| weight * value).sum()
    }
}

/// The weights of the corners of a convex polygon at `p`: each in `[0, 1]`, with sum 1.
///
/// ```text
/// w_k = C_k / (a_k a_{k−1});  then  w_k / Σ w
/// ```
/// with `a_k` the triangle from the edge that begins in corner `k` to `p` and `C_k` the
/// triangle of corner `k` and its neighbours (Wachspress 1975; Meyer, Lee, Barr & Desbrun
/// 2002). A corner in the middle of a straight edge has weight 0.
///
/// # Accuracy
/// `Σ w_k v_k = p` but for rounding: `64 ε` of the largest coordinate, times how often the
/// least height of a corner above the line through its neighbours goes into the polygon's
/// size. The scale does not matter, nor the number of corners by itself. A point a hair
/// outside counts as on the edge. In an outline so narrow that all corners are on one line
/// but for rounding, the weights are even.
pub fn wachspress(polygon: &Polygon, p: DVec3) -> SmallVec<[f64; 8]> {
    let v = polygon.vertices();
    let corners = real_corners(polygon);
    let n = corners.len();
    let size = v.iter().fold(0.0_f64, |most, v| most.max((p - v).abs().max_element()));
    let twice = |a: DVec3, b: DVec3| a.cross(b).dot(polygon.normal());
    let edge = |k: usize| (v[corners[(k + 1) % n]] - v[corners[k]]) / size;
    let edges: SmallVec<[DVec3; 8]> = (0..n).map(edge).collect();
    let height = |k: usize| {
        let above = twice(edges[k], (p - v[corners[k]]) / size);
        if above > 0.0 { above } else { HARDLY * edges[k].length() }
    };
    let heights: SmallVec<[f64; 8]> = (0..n).map(height).collect();
    // The reciprocals of the weights, so that nothing overflows on an edge.
    let inverse = |k: usize| {
        let before = (k + n - 1) % n;
        let corner = twice(edges[before], edges[k]).max(0.0);
        if corner > 0.0 { heights[before] * heights[k] / corner } else { f64::INFINITY }
    };
    let inverses: SmallVec<[f64; 8]> = (0..n).map(inverse).collect();
    let least = inverses.iter().copied().fold(f64::INFINITY, f64::min);
    if least == f64::INFINITY {
        return smallvec![1.0 / v.len() as f64; v.len()];
    }
    let sum: f64 = inverses.iter().map(|i| least / i).sum();
    let mut weights: SmallVec<[f64; 8]> = smallvec![0.0; v.len()];
    for (corner, inverse) in corners.iter().zip(inverses) {
        weights[*corner] = least / inverse / sum;
    }
    weights
}

/// The height above an edge, in parts of the polygon's size, of a point that lies on it:
/// the square of its square is still a number.
const HARDLY: f64 = 1e-70;

/// The corners at which the outline turns by more than rounding.
fn real_corners(polygon: &Polygon) -> SmallVec<[usize; 8]> {
    let v = polygon.vertices();
    let n = v.len();
    let size = v.iter().fold(0.0_f64, |most, v| most.max(v.abs().max_element()));
    let turns = |&k: &usize| {
        let (before, after) = (v[k] - v[(k + n - 1) % n], v[(k + 1) % n] - v[k]);
        let off = before.cross(after).dot(polygon.normal());
        before.dot(after) <= 0.0
            || off > 8.0 * f64::EPSILON * size * (before + after).length()
    };
    let corners: SmallVec<[usize; 8]> = (0..n).filter(turns).collect();
    if corners.len() < 3 { (0..n).collect() } else { corners }
}
