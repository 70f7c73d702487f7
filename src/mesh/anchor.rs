//! T-vertices: corners that lie on the edge of a larger neighbour.
//!
//! ```text
//! jump = h² |B''| / 8        where B is bent and the T-vertex has a value of its own
//! ```
//! The large element is linear along its edge `ab`. A T-vertex at `(1 − t) a + t b` that
//! had a value of its own would tear the picture open there. So it takes the edge's:
//! it is *anchored*.

use super::build::Builder;
use super::{Element, Mesh, VertexId};
use crate::geometry::Rgb;
use glam::DVec3;
use std::collections::{BTreeMap, HashMap, HashSet};

/// A T-vertex and the edge that it lies on.
#[derive(Clone, Debug)]
pub(super) struct Anchor {
    vertex: VertexId,
    ends: [VertexId; 2],
    /// Where on the edge, from 0 to 1.
    at: f64,
}

impl Mesh {
    // ANCHOR: anchor
    /// Gives T-vertices the values of the edges that they lie on.
    pub fn anchor(&self, of_vertices: &mut [Rgb]) {
        for Anchor { vertex, ends, at } in &self.anchors {
            let [a, b] = ends.map(|end| of_vertices[end]);
            of_vertices[*vertex] = a.lerp(b, *at);
        }
    }
    // ANCHOR_END: anchor

    /// The T-vertices, which take their values from the edges that they lie on.
    pub fn t_vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        self.anchors.iter().map(|a| a.vertex)
    }
}

/// Lines of one plane that are nearer than this many times what counts as rounding are one.
const LINES_APART: f64 = 1e3;

/// An edge of an element that no other element has in common with it.
struct HangingEdge {
    ends: [VertexId; 2],
    element: usize,
}

impl Builder {
    /// The T-vertices of the mesh; those on longer edges first, since theirs may end in
    /// T-vertices of longer ones still. Where two rows of elements are divided at
    /// different places, the ends of the longer edges keep values of their own.
    pub(super) fn anchors(&self) -> Vec<Anchor> {
        let mesh = self.mesh();
        let place = |id: VertexId| mesh.vertices[id];
        let mut found: Vec<(f64, Anchor)> = Vec::new();
        for edges in self.free_edges().values() {
            let mut along: Vec<VertexId> = edges.iter().flat_map(|e| e.ends).collect();
            let [start, end] = edges[0].ends.map(place);
            let axis = (end - start).normalize();
            let height = |id: VertexId| axis.dot(place(id));
            along.sort_by(|&a, &b| height(a).total_cmp(&height(b)).then(a.cmp(&b)));
            along.dedup();
            for edge in edges {
                let [from, to] = edge.ends.map(height);
                let (low, high) = (from.min(to), from.max(to));
                let margin = 1e-6 * (high - low);
                let first = along.partition_point(|&v| height(v) <= low + margin);
                let inside = along[first..].iter();
                for &vertex in inside.take_while(|&&v| height(v) < high - margin) {
                    let element = &mesh.elements[edge.element];
                    let surface = mesh.surface_of(element);
                    let middle = element.polygon.centroid();
                    // On the other side of a wall it is another vertex.
                    let same = self.known(surface, place(vertex), middle);
                    if same == Some(vertex) {
                        let at = (height(vertex) - from) / (to - from);
                        found
                            .push((high - low, Anchor { vertex, ends: edge.ends, at }));
                    }
                }
            }
        }
        let order = |a: &(f64, Anchor), b: &(f64, Anchor)| {
            b.0.total_cmp(&a.0).then(a.1.vertex.cmp(&b.1.vertex))
        };
        found.sort_by(order);
        let (mut held, mut holding) = (HashSet::new(), HashSet::new());
        let mut anchors = Vec::new();
        for (_, anchor) in found {
            // What holds others up must know its value before them.
            if !holding.contains(&anchor.vertex) && held.insert(anchor.vertex) {
                holding.extend(anchor.ends);
                anchors.push(anchor);
            }
        }
        anchors
    }

    /// Edges that only one element has, by the line in which they lie.
    fn free_edges(&self) -> BTreeMap<(u32, [i64; 6]), Vec<HangingEdge>> {
        let mesh = self.mesh();
        let mut edges: HashMap<[VertexId; 2], (usize, usize)> = HashMap::new();
        for (element, Element { corners, .. }) in mesh.elements.iter().enumerate() {
            for (k, &a) in corners.iter().enumerate() {
                let b = corners[(k + 1) % corners.len()];
                let edge = edges.entry([a.min(b), a.max(b)]).or_insert((0, element));
                edge.0 += 1;
            }
        }
        let near = LINES_APART * mesh.planes.rounding;
        let mut origins: HashMap<u32, DVec3> = HashMap::new();
        let mut lines: BTreeMap<(u32, [i64; 6]), Vec<HangingEdge>> = BTreeMap::new();
        let mut free: Vec<([VertexId; 2], usize)> = edges
            .into_iter()
            .filter(|(_, (count, _))| *count == 1)
            .map(|(ends, (_, element))| (ends, element))
            .collect();
        free.sort_unstable();
        for (ends, element) in free {
            let surface = mesh.surface_of(&mesh.elements[element]);
            let (plane, _) = mesh.planes.of_surface(surface);
            let origin = *origins.entry(plane).or_insert(mesh.vertices[ends[0]]);
            let [a, b] = ends.map(|end| mesh.vertices[end] - origin);
            let Some(axis) = (b - a).try_normalize() else { continue };
            // Either sense of the line is the same line; nothing is at right angles to
            // this odd direction but by chance.
            let axis = axis * axis.dot(DVec3::new(0.5773, 0.7113, 0.4019)).signum();
            let foot = (a - a.dot(axis) * axis) / near;
            let [x, y, z] = (1.2345e6 * axis).to_array();
            let [u, v, w] = (1.2345 * foot).to_array();
            let line = [x, y, z, u, v, w].map(|c| c.round() as i64);
            lines.entry((plane, line)).or_default().push(HangingEdge { ends, element });
        }
        lines
    }
}
