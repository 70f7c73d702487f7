//! Values between the corners of an element.

use super::{Element, Mesh};
use crate::geometry::{Polygon, Rgb};
use glam::DVec3;
use smallvec::SmallVec;

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

// ANCHOR: wachspress
/// The weights of the corners of a convex polygon at `p`: each in `[0, 1]`, with sum 1.
///
/// ```text
/// w_k = C_k Π a_j  over the edges j that do not meet in corner k;  then  w_k / Σ w
/// ```
/// with `a_j` the triangle from edge `j` to `p` and `C_k` the triangle of corner `k`
/// and its neighbours (Wachspress 1975; Meyer, Lee, Barr & Desbrun 2002). A point a
/// hair outside counts as on the edge. A corner in the middle of a straight edge has
/// weight 0.
pub fn wachspress(polygon: &Polygon, p: DVec3) -> SmallVec<[f64; 8]> {
    let v = polygon.vertices();
    let n = v.len();
    let triangle = |a: DVec3, b: DVec3, c: DVec3| {
        (b - a).cross(c - a).dot(polygon.normal()).max(0.0)
    };
    let edge = |j: usize| triangle(v[j], v[(j + 1) % n], p);
    let weight = |k: usize| {
        let before = (k + n - 1) % n;
        let others = (0..n).filter(|&j| j != k && j != before);
        triangle(v[before], v[k], v[(k + 1) % n]) * others.map(edge).product::<f64>()
    };
    let weights: SmallVec<[f64; 8]> = (0..n).map(weight).collect();
    let sum: f64 = weights.iter().sum();
    let even = 1.0 / n as f64; // no point of the polygon at all: the mean
    weights.iter().map(|w| if sum > 0.0 { w / sum } else { even }).collect()
}
// ANCHOR_END: wachspress
