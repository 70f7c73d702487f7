//! Tiles joined to what they are parts of: whole walls, mirrors, lamps.

use crate::geometry::{Frame, Polygon};
use glam::DVec3;
use std::collections::HashMap;

/// Groups polygons of one `class` that share corners: for each its group, and the groups.
pub(super) fn joined(
    polygons: &[&Polygon],
    margin: f64,
    class: impl Fn(usize) -> [i64; 5],
) -> (Vec<u32>, Vec<Vec<usize>>) {
    // The odd factor keeps round numbers off the border between two quanta.
    let quantum = 1.2345 * margin;
    let mut parent: Vec<usize> = (0..polygons.len()).collect();
    let mut seen: HashMap<([i64; 5], [i64; 3]), usize> = HashMap::new();
    for (id, polygon) in polygons.iter().enumerate() {
        for &corner in polygon.vertices() {
            let place = (corner / quantum).to_array().map(|x| x.round() as i64);
            let other = *seen.entry((class(id), place)).or_insert(id);
            let (a, b) = (root(&mut parent, id), root(&mut parent, other));
            parent[a.max(b)] = a.min(b);
        }
    }
    let mut number = vec![u32::MAX; polygons.len()];
    let (mut group_of, mut groups) = (Vec::new(), Vec::<Vec<usize>>::new());
    for id in 0..polygons.len() {
        let root = root(&mut parent, id);
        if number[root] == u32::MAX {
            number[root] = groups.len() as u32;
            groups.push(Vec::new());
        }
        group_of.push(number[root]);
        groups[number[root] as usize].push(id);
    }
    (group_of, groups)
}

fn root(parent: &mut [usize], mut id: usize) -> usize {
    while parent[id] != id {
        parent[id] = parent[parent[id]];
        id = parent[id];
    }
    id
}

/// The convex hull of coplanar tiles (Andrew's monotone chain).
pub(super) fn convex_hull(tiles: &[usize], surfaces: &[&Polygon]) -> Polygon {
    let first = surfaces[tiles[0]];
    if tiles.len() == 1 {
        return first.clone();
    }
    // An odd angle, so that no edge runs along an axis and rounding cannot change the
    // order of its corners.
    let frame = Frame::about(first.normal());
    let (sine, cosine) = 1.0_f64.sin_cos();
    let flat = |v: DVec3| {
        let (x, y) = (frame.x.dot(v), frame.y.dot(v));
        (cosine * x + sine * y, cosine * y - sine * x)
    };
    let corners = tiles.iter().flat_map(|&t| surfaces[t].vertices());
    let mut points: Vec<(f64, f64, DVec3)> =
        corners.map(|&v| (flat(v).0, flat(v).1, v)).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let size = points[0].2.distance(points[points.len() - 1].2);
    let chain = |points: &mut dyn Iterator<Item = &(f64, f64, DVec3)>| {
        let mut chain: Vec<(f64, f64, DVec3)> = Vec::new();
        for &p in points {
            while let [.., a, b] = chain[..] {
                let turn = (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0);
                if turn > 1e-9 * size * size {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut outline = chain(&mut points.iter());
    outline.extend(chain(&mut points.iter().rev()));
    let outline = outline.into_iter().map(|p| p.2).collect();
    Polygon::piece(outline, first.normal()).unwrap_or_else(|| first.clone())
}

/// Polygons of one `class` that share corners in one plane, joined: each group's convex
/// hull where they fill it, else each by itself; with the polygons that it is made of.
pub fn joined_tiles(
    polygons: &[&Polygon],
    margin: f64,
    class: impl Fn(usize) -> i64,
) -> Vec<(Polygon, Vec<usize>)> {
    let (_, groups) =
        joined(polygons, margin, |k| in_plane(polygons[k], margin, class(k)));
    let mut whole = Vec::new();
    for tiles in groups {
        let hull = convex_hull(&tiles, polygons);
        let area: f64 = tiles.iter().map(|&t| polygons[t].area()).sum();
        if (hull.area() - area).abs() <= 1e-9 * area {
            whole.push((hull, tiles));
        } else {
            whole.extend(tiles.into_iter().map(|t| (polygons[t].clone(), vec![t])));
        }
    }
    whole
}

/// What polygons of one plane and `class` have in common.
pub(super) fn in_plane(p: &Polygon, margin: f64, class: i64) -> [i64; 5] {
    let [x, y, z] = (1.2345e8 * p.normal()).to_array();
    let offset = p.plane().offset / (1.2345 * margin);
    let [x, y, z, offset] = [x, y, z, offset].map(|v| v.round() as i64);
    [x, y, z, offset, class]
}
