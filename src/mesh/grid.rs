//! Cuts one convex polygon into cells of even size.

use crate::geometry::Polygon;
use glam::DVec3;

/// The cells of `polygon`, with edges no longer than `max_edge`.
pub(super) fn cells(polygon: &Polygon, max_edge: f64) -> Vec<Polygon> {
    let outlines = match polygon.vertices() {
        &[a, b, c] => triangles([a, b, c], steps_of_triangle(polygon, max_edge)),
        &[a, b, c, d] => quads([a, b, c, d], steps_of_quad([a, b, c, d], max_edge)),
        corners => kites(corners, polygon.centroid())
            .flat_map(|kite| quads(kite, steps_of_quad(kite, max_edge)))
            .collect(),
    };
    let normal = polygon.normal();
    outlines.into_iter().filter_map(|v| Polygon::piece(v, normal)).collect()
}

/// How many cells [`cells`] makes.
pub(super) fn count(polygon: &Polygon, max_edge: f64) -> f64 {
    let quad = |corners| {
        let (nu, nv) = steps_of_quad(corners, max_edge);
        nu as f64 * nv as f64
    };
    match polygon.vertices() {
        &[_, _, _] => (steps_of_triangle(polygon, max_edge) as f64).powi(2),
        &[a, b, c, d] => quad([a, b, c, d]),
        corners => kites(corners, polygon.centroid()).map(quad).sum(),
    }
}

fn steps(length: f64, max_edge: f64) -> usize {
    // A shade less than the quotient, so that an exact multiple is not one too many.
    (length / max_edge - 1e-9).ceil().max(1.0) as usize
}

fn steps_of_triangle(polygon: &Polygon, max_edge: f64) -> usize {
    steps(polygon.diameter(), max_edge)
}

fn steps_of_quad([a, b, c, d]: [DVec3; 4], max_edge: f64) -> (usize, usize) {
    let along = a.distance(b).max(c.distance(d));
    let across = b.distance(c).max(d.distance(a));
    (steps(along, max_edge), steps(across, max_edge))
}

/// A quadrilateral for each corner: the middle of the edge before, the corner, the middle
/// of the edge after, the centre.
fn kites(corners: &[DVec3], centre: DVec3) -> impl Iterator<Item = [DVec3; 4]> + '_ {
    let n = corners.len();
    (0..n).map(move |k| {
        let before = corners[(k + n - 1) % n].midpoint(corners[k]);
        let after = corners[k].midpoint(corners[(k + 1) % n]);
        [before, corners[k], after, centre]
    })
}

fn quads([a, b, c, d]: [DVec3; 4], (nu, nv): (usize, usize)) -> Vec<Vec<DVec3>> {
    let at = |i: usize, j: usize| {
        let (u, v) = (i as f64 / nu as f64, j as f64 / nv as f64);
        a.lerp(b, u).lerp(d.lerp(c, u), v)
    };
    let cell = |i, j| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
    (0..nv).flat_map(|j| (0..nu).map(move |i| cell(i, j))).collect()
}

fn triangles([a, b, c]: [DVec3; 3], n: usize) -> Vec<Vec<DVec3>> {
    let at = |i: usize, j: usize| {
        let (u, v) = (i as f64 / n as f64, j as f64 / n as f64);
        a + u * (b - a) + v * (c - a)
    };
    let mut cells = Vec::new();
    for j in 0..n {
        for i in 0..n - j {
            cells.push(vec![at(i, j), at(i + 1, j), at(i, j + 1)]);
            if i + j + 1 < n {
                cells.push(vec![at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
    }
    cells
}
