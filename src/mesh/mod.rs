//! Patches and elements: the pieces on which light is taken to be constant.
//!
//! ```text
//! B(x) ≈ B_i  for x on element i          B_v = Σ A_i B_i / Σ A_i  over elements at v
//! ```
//!
//! A **patch** is one [`Surface`](crate::scene::Surface); it is divided into **elements**.
//! (Substructuring, where patches shoot and elements receive, rests on this pair.)
//! Elements never straddle a line where another surface touches or pierces their patch,
//! and no vertex mixes light from both sides of such a line: a wall leaks neither light
//! nor shadow.
//!
//! | method            | use it when                          | it fails when              |
//! |-------------------|--------------------------------------|----------------------------|
//! | [`Mesh::whole`]   | factors between faces are asked for  | light varies over a face   |
//! | [`Mesh::uniform`] | a solution of even fineness is asked | a shadow edge is sharper   |
//!
//! **Not here:** splitting where the light asks for it. Chapters *The pipeline* (L08) and
//! *Substructuring* (L11). Sources: Cohen, Greenberg, Immel & Brock 1986; Baum, Mann,
//! Smith & Winget 1991 (contact lines).

mod contact;
mod grid;
mod interpolate;

pub use interpolate::wachspress;

use crate::geometry::{Polygon, Rgb};
use crate::scene::{FaceId, MaterialId, Scene};
use contact::{Contacts, Planes};
use glam::DVec3;
use std::collections::HashMap;
use std::ops::Range;

/// Which patch of a [`Mesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PatchId(pub u32);

/// Which element of a [`Mesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ElementId(pub u32);

/// Which corner value of a [`Mesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VertexId(pub u32);

/// One surface of the scene.
#[derive(Clone, Debug)]
pub struct Patch {
    /// The face of the OBJ file that it is part of.
    pub face: FaceId,
    /// What it is made of.
    pub material: MaterialId,
    /// Its elements, as indices into [`Mesh::elements`].
    pub elements: Range<u32>,
}

/// One piece of a patch.
#[derive(Clone, Debug)]
pub struct Element {
    /// Its outline.
    pub polygon: Polygon,
    /// Whose piece it is.
    pub patch: PatchId,
    /// For each corner of the outline, the vertex whose radiosity it shows.
    pub corners: Vec<VertexId>,
}

/// The elements of all patches of a scene.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// In order of the scene's surfaces.
    pub patches: Vec<Patch>,
    /// In order of patches.
    pub elements: Vec<Element>,
    /// Positions of the shared corners.
    pub vertices: Vec<DVec3>,
}

impl Mesh {
    /// One element for each surface of the scene.
    pub fn whole(scene: &Scene) -> Mesh {
        Mesh::build(scene, |polygon, _| vec![polygon.clone()])
    }

    /// Elements whose edges are no longer than `max_edge` (scene units; positive).
    ///
    /// Quadrilaterals become grids, triangles become triangles, other outlines are first
    /// cut into quadrilaterals about their middle; then each cell that another surface
    /// touches along a line is cut along that line.
    pub fn uniform(scene: &Scene, max_edge: f64) -> Mesh {
        assert!(max_edge > 0.0, "max_edge must be positive: {max_edge}");
        Mesh::build(scene, |polygon, contacts| {
            let cells = grid::cells(polygon, max_edge);
            cells.into_iter().flat_map(|cell| contacts.cut(cell)).collect()
        })
    }

    /// How many elements [`Mesh::uniform`] makes, contact lines aside.
    pub fn count_uniform(scene: &Scene, max_edge: f64) -> f64 {
        scene.surfaces.iter().map(|s| grid::count(&s.polygon, max_edge)).sum()
    }

    fn build(
        scene: &Scene,
        divide: impl Fn(&Polygon, &Contacts) -> Vec<Polygon>,
    ) -> Mesh {
        let planes = Planes::of(scene);
        let mut welder = Welder::new(scene.diagonal());
        let mut mesh = Mesh { patches: vec![], elements: vec![], vertices: vec![] };
        for (id, surface) in scene.surfaces.iter().enumerate() {
            let (plane, contacts) = planes.of_surface(id);
            let first = mesh.elements.len() as u32;
            for polygon in divide(&surface.polygon, contacts) {
                let middle = polygon.centroid();
                let corners = polygon.vertices().iter().map(|&at| {
                    let sides = contacts.sides(at, middle);
                    welder.vertex(plane, at, sides, &mut mesh.vertices)
                });
                let corners = corners.collect();
                mesh.elements.push(Element {
                    corners,
                    polygon,
                    patch: PatchId(id as u32),
                });
            }
            let elements = first..mesh.elements.len() as u32;
            let (face, material) = (surface.face, surface.material);
            mesh.patches.push(Patch { face, material, elements });
        }
        mesh
    }

    /// Each element cut along the lines where other surfaces touch or pierce it, which
    /// [`Mesh::uniform`] has done already and [`Mesh::whole`] has not.
    pub fn cut_at_contacts(&self, scene: &Scene) -> Vec<Vec<Polygon>> {
        let planes = Planes::of(scene);
        let cut = |e: &Element| {
            let (_, contacts) = planes.of_surface(e.patch.0 as usize);
            contacts.cut(e.polygon.clone())
        };
        self.elements.iter().map(cut).collect()
    }

    /// The element `id`.
    pub fn element(&self, id: ElementId) -> &Element {
        &self.elements[id.0 as usize]
    }

    /// The patch that `element` is part of.
    pub fn patch_of(&self, element: &Element) -> &Patch {
        &self.patches[element.patch.0 as usize]
    }

    /// The outlines of all elements, in order.
    pub fn polygons(&self) -> impl ExactSizeIterator<Item = &Polygon> + Clone {
        self.elements.iter().map(|e| &e.polygon)
    }

    /// Values at the vertices: the area-weighted means of the elements that meet there.
    ///
    /// Elements meet only within one plane and material, and on one side of a contact.
    pub fn vertex_values(&self, of_elements: &[Rgb]) -> Vec<Rgb> {
        let mut sums = vec![(Rgb::ZERO, 0.0); self.vertices.len()];
        for (element, &value) in self.elements.iter().zip(of_elements) {
            let area = element.polygon.area();
            for corner in &element.corners {
                let (sum, weight) = &mut sums[corner.0 as usize];
                *sum += area * value;
                *weight += area;
            }
        }
        sums.into_iter().map(|(sum, weight)| sum / weight).collect()
    }
}

/// What tells vertices apart: plane, place in quanta, sides of the contacts there.
type Place = (u32, [i64; 3], Vec<(u32, bool)>);

/// Gives corners that coincide the same vertex.
struct Welder {
    known: HashMap<Place, VertexId>,
    quantum: f64,
}

impl Welder {
    fn new(diagonal: f64) -> Welder {
        // Far above rounding, far below any element; no round number, so that
        // coordinates do not lie on the border between two quanta.
        Welder { known: HashMap::new(), quantum: 1.2345e-8 * diagonal }
    }

    fn vertex(
        &mut self,
        plane: u32,
        at: DVec3,
        sides: Vec<(u32, bool)>,
        vertices: &mut Vec<DVec3>,
    ) -> VertexId {
        let place = (at / self.quantum).to_array().map(|x| x.round() as i64);
        *self.known.entry((plane, place, sides)).or_insert_with(|| {
            vertices.push(at);
            VertexId(vertices.len() as u32 - 1)
        })
    }
}
