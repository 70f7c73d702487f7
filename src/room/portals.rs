//! Openings of a scene through which the sky is seen.
//!
//! The free edges of the surfaces, those that no other surface continues, bound the
//! openings. Where an opening is flat and convex and the whole scene lies on one side of it,
//! it is a window: the sky behind it can be summed as a lamp's light is.

use crate::geometry::{Frame, Polygon, Ray, Rgb};
use crate::radiometry::cosine_direction;
use crate::random::Stream;
use crate::scene::{Scene, Side, Surface};
use crate::visibility::Visibility;
use glam::{DVec3, dvec2};
use std::collections::HashMap;

/// Rays that must all leave by the openings found.
const RAYS: usize = 4000;

/// The openings of a scene, facing inwards; none when the sky is also seen otherwise.
pub(super) fn portals(scene: &Scene) -> Vec<Polygon> {
    let margin = 1e3 * scene.rounding();
    // Light goes through panes and glass: they close nothing.
    let closes =
        |s: &&Surface| s.side == Side::Front && !scene.material(s).shine().passes();
    let solid: Vec<&Polygon> =
        scene.surfaces.iter().filter(closes).map(|s| &s.polygon).collect();
    let visibility = Visibility::new(solid.iter().copied());
    let inwards = |p: Polygon| {
        let above = |p: &Polygon| {
            scene.surfaces.iter().all(|s| {
                // What light passes and is a hair outside must not be left out.
                let passes = scene.material(s).shine().passes();
                let outside = if passes { scene.rounding() } else { margin };
                let mut vertices = s.polygon.vertices().iter();
                vertices.all(|&v| p.plane().height(v) >= -outside)
            })
        };
        [p.flipped(), p].into_iter().find(above)
    };
    let is_open = |p: &Polygon| {
        let from = p.centroid() + margin * p.normal();
        let out = Ray { origin: from, direction: -p.normal() };
        visibility.closest(&out, None).is_none()
    };
    let loops = loops(&free_edges(&solid, margin), margin);
    let flat = loops.into_iter().filter_map(|outline| Polygon::new(outline).ok());
    let found: Vec<Polygon> = flat.filter_map(inwards).filter(is_open).collect();
    // The other sides of sheets, and panes that scatter, see the sky, too.
    let more = scene.surfaces.iter().filter(|s| {
        let material = scene.material(s);
        !closes(s) && material.scattered() != Rgb::ZERO
    });
    let seeing: Vec<&Polygon> =
        solid.iter().copied().chain(more.map(|s| &s.polygon)).collect();
    if !found.is_empty() && all_leave_by(&found, &seeing, &visibility) {
        found
    } else {
        Vec::new()
    }
}

/// Do rays from all surfaces that leave the scene leave by one of these?
fn all_leave_by(portals: &[Polygon], seeing: &[&Polygon], all: &Visibility) -> bool {
    let each = (RAYS / seeing.len()).max(16);
    seeing.iter().enumerate().all(|(k, polygon)| {
        let frame = Frame::about(polygon.normal());
        Stream::named(0, &[k as u64]).points(each).all(|[a, b, c, d]| {
            let origin = polygon.point_at([a, b]);
            let direction = frame.world_from_local(cosine_direction(dvec2(c, d)));
            let ray = Ray { origin, direction };
            let passes = |p: &Polygon| {
                let (height, sinks) =
                    (p.plane().height(origin), p.normal().dot(direction));
                let at = origin + direction * (height / -sinks);
                sinks < 0.0 && height >= 0.0 && p.contains(at, 1e-9 * p.diameter())
            };
            all.closest(&ray, Some(k as u32)).is_some() || portals.iter().any(passes)
        })
    })
}

/// The parts of edges that belong to one polygon only.
///
/// All edges on one line are counted along it, up or down as they run; where the count is
/// one, nobody continues the surface.
fn free_edges(polygons: &[&Polygon], margin: f64) -> Vec<(DVec3, DVec3)> {
    let mut lines: HashMap<[i64; 6], Vec<(DVec3, DVec3)>> = HashMap::new();
    for (a, b) in polygons.iter().flat_map(|p| p.edges()) {
        let mut along = (b - a).normalize();
        let first = along.to_array().into_iter().find(|x| x.abs() > 1e-6);
        if first.is_some_and(|x| x < 0.0) {
            along = -along;
        }
        let foot = a - a.dot(along) * along;
        // The odd factors keep round numbers off the border between two quanta.
        let [u, v] = [along * 1.2345e5, foot / (12.345 * margin)];
        let key = [u.x, u.y, u.z, v.x, v.y, v.z].map(|x| x.round() as i64);
        lines.entry(key).or_default().push((a, b));
    }
    let mut lines: Vec<_> = lines.into_iter().collect();
    lines.sort_unstable_by_key(|line| line.0);
    lines.into_iter().flat_map(|(_, edges)| free_on_line(&edges, margin)).collect()
}

fn free_on_line(edges: &[(DVec3, DVec3)], margin: f64) -> Vec<(DVec3, DVec3)> {
    let (origin, end) = edges[0];
    let along = (end - origin).normalize();
    let at = |p: DVec3| along.dot(p - origin);
    let mut ends: Vec<(f64, DVec3)> =
        edges.iter().flat_map(|&(a, b)| [(at(a), a), (at(b), b)]).collect();
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    ends.dedup_by(|next, kept| next.0 - kept.0 <= margin);
    let mut free = Vec::new();
    for pair in ends.windows(2) {
        let [(s, a), (t, b)] = [pair[0], pair[1]];
        let middle = 0.5 * (s + t);
        let over = |&&(a, b): &&(DVec3, DVec3)| {
            at(a).min(at(b)) < middle && middle < at(a).max(at(b))
        };
        let here: Vec<_> = edges.iter().filter(over).collect();
        if let [(from, to)] = here[..] {
            free.push(if at(*from) < at(*to) { (a, b) } else { (b, a) });
        }
    }
    free
}

/// Joins edges to closed outlines that turn their front to where the edges' do not.
fn loops(edges: &[(DVec3, DVec3)], margin: f64) -> Vec<Vec<DVec3>> {
    let mut left: Vec<(DVec3, DVec3)> = edges.to_vec();
    let mut found = Vec::new();
    while let Some((start, mut end)) = left.pop() {
        let mut outline = vec![start];
        while start.distance(end) > 10.0 * margin {
            let near = |e: &(DVec3, DVec3)| e.0.distance(end) <= 10.0 * margin;
            let Some(k) = left.iter().position(near) else { break };
            let next = left.swap_remove(k);
            outline.push(next.0);
            end = next.1;
        }
        if start.distance(end) <= 10.0 * margin {
            found.push(straightened(&outline));
        }
    }
    found
}

/// Without the corners in the middle of straight edges.
fn straightened(outline: &[DVec3]) -> Vec<DVec3> {
    let n = outline.len();
    let turns = |k: &usize| {
        let (a, b, c) = (outline[(k + n - 1) % n], outline[*k], outline[(k + 1) % n]);
        (b - a).normalize().cross((c - b).normalize()).length() > 1e-6
    };
    (0..n).filter(turns).map(|k| outline[k]).collect()
}
