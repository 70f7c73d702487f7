//! Puts a mesh together: gives corners that coincide the same vertex.

use super::contact::Planes;
use super::{Element, Mesh, Patch, PatchId, VertexId};
use crate::geometry::Polygon;
use crate::scene::Surface;
use glam::DVec3;
use std::collections::HashMap;
use std::sync::Arc;

/// A mesh that grows patch by patch.
pub(super) struct Builder {
    mesh: Mesh,
    welder: Welder,
}

impl Builder {
    /// An empty mesh of a scene with these planes.
    pub(super) fn new(planes: Arc<Planes>) -> Builder {
        let welder = Welder::new(planes.rounding);
        let mesh = Mesh {
            patches: vec![],
            elements: vec![],
            vertices: vec![],
            anchors: vec![],
            planes,
        };
        Builder { mesh, welder }
    }

    /// A mesh without elements that has the vertices of `old`, under the same ids.
    pub(super) fn over(old: &Mesh) -> Builder {
        let mut builder = Builder::new(Arc::clone(&old.planes));
        builder.mesh.vertices.clone_from(&old.vertices);
        for element in &old.elements {
            let (surface, middle) =
                (old.surface_of(element), element.polygon.centroid());
            for (&id, &at) in element.corners.iter().zip(element.polygon.vertices()) {
                let place = builder.place(surface, at, middle);
                builder.welder.known.insert(place, id);
            }
        }
        builder
    }

    /// Adds a patch of surface `id`, divided into `elements`.
    pub(super) fn add(
        &mut self,
        id: u32,
        surface: &Surface,
        elements: impl IntoIterator<Item = Polygon>,
    ) {
        let patch = Patch {
            surface: id,
            face: surface.face,
            material: surface.material,
            elements: 0..0,
        };
        self.add_patch(patch, elements);
    }

    /// Adds a patch like `patch`, divided into `elements`.
    pub(super) fn add_patch(
        &mut self,
        patch: Patch,
        elements: impl IntoIterator<Item = Polygon>,
    ) {
        let id = PatchId(self.mesh.patches.len() as u32);
        let first = self.mesh.elements.len() as u32;
        for polygon in elements {
            let middle = polygon.centroid();
            let corners = polygon.vertices().iter().map(|&at| {
                let place = self.place(patch.surface, at, middle);
                self.welder.vertex(place, at, &mut self.mesh.vertices)
            });
            let corners = corners.collect();
            self.mesh.elements.push(Element { corners, polygon, patch: id });
        }
        let elements = first..self.mesh.elements.len() as u32;
        self.mesh.patches.push(Patch { elements, ..patch });
    }

    /// The vertex at a point of the outline of an element of `surface` with this middle.
    pub(super) fn known(
        &self,
        surface: u32,
        at: DVec3,
        middle: DVec3,
    ) -> Option<VertexId> {
        self.welder.known.get(&self.place(surface, at, middle)).copied()
    }

    /// The quarters of an edge that is no longer than this may be one vertex, in scene
    /// units.
    pub(super) fn shortest_divided(&self) -> f64 {
        8.0 * self.welder.quantum
    }

    fn place(&self, surface: u32, at: DVec3, middle: DVec3) -> VertexPlace {
        let (plane, contacts) = self.mesh.planes.of_surface(surface);
        (plane, self.welder.quanta(at), contacts.sides(at, middle))
    }

    /// The mesh so far.
    pub(super) fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The mesh, its T-vertices anchored.
    pub(super) fn finish(mut self) -> Mesh {
        self.mesh.anchors = self.anchors();
        self.mesh
    }
}

/// What tells vertices apart: plane, place in quanta, sides of the contacts there.
type VertexPlace = (u32, [i64; 3], Vec<(u32, bool)>);

/// Gives corners that coincide the same vertex.
struct Welder {
    known: HashMap<VertexPlace, VertexId>,
    quantum: f64,
}

impl Welder {
    fn new(rounding: f64) -> Welder {
        // Far above rounding, far below any element; no round number, so that
        // coordinates do not lie on the border between two quanta.
        Welder { known: HashMap::new(), quantum: 12.345 * rounding }
    }

    fn quanta(&self, at: DVec3) -> [i64; 3] {
        (at / self.quantum).to_array().map(|x| x.round() as i64)
    }

    fn vertex(
        &mut self,
        place: VertexPlace,
        at: DVec3,
        vertices: &mut Vec<DVec3>,
    ) -> VertexId {
        *self.known.entry(place).or_insert_with(|| {
            vertices.push(at);
            VertexId(vertices.len() as u32 - 1)
        })
    }
}
