//! Patches and elements: the pieces on which light is taken to be constant, or linear.
//!
//! ```text
//! B(x) ≈ B_i  for x on element i          B_v = Σ A_i B_i / Σ A_i  over elements at v
//! B_p = Σ A_i B_i / Σ A_i                 over the elements of patch p
//! B_t = (1 − t) B_a + t B_b               T-vertex t on the edge ab of a larger element
//! ```
//!
//! A **patch** is a piece of one [`Surface`] (all of it, unless it
//! is asked to be smaller); it is divided into **elements**. Elements of one patch do not
//! see each other, and from outside a patch is what its elements are on the average.
//! Elements never straddle a line where another surface touches or pierces their patch,
//! and no vertex mixes light from both sides of such a line: a wall leaks neither light
//! nor shadow.
//!
//! | method            | use it when                          | it fails when              |
//! |-------------------|--------------------------------------|----------------------------|
//! | [`Mesh::whole`]   | factors between faces are asked for  | light varies over a face   |
//! | [`Mesh::uniform`] | a solution of even fineness is asked | a shadow edge is sharper   |
//! | [`Mesh::patched`] | patches are to be split later on     | they stay whole            |
//! | [`Mesh::split`]   | some elements are too large          | the wrong ones are chosen  |
//! | [`TwoLevels`]     | few patches send, many elements show | both must be as fine       |
//!
//! ```
//! use radiosity::{mesh::Mesh, scene::built_in};
//! let scene = built_in("furnace").unwrap();
//! let mesh = Mesh::uniform(&scene, 0.3); // no edge is longer
//! let area: f64 = mesh.polygons().map(|p| p.area()).sum();
//! assert!(mesh.elements.len() > mesh.patches.len());
//! assert!((area - scene.face_areas().iter().sum::<f64>()).abs() < 1e-12);
//! ```
//!
//! **Not here:** which elements to split ([`crate::solve`]). Chapters *The pipeline* (L08)
//! and *Patches and elements* (L11, L12). Sources: Cohen, Greenberg, Immel & Brock 1986
//! (substructuring); Baum, Mann, Smith & Winget 1991 (contact lines, balance, anchors).

mod anchor;
mod backs;
mod build;
mod contact;
mod grid;
mod ids;
mod interpolate;
mod levels;
mod locate;
mod place;
mod scale;
mod split;

pub use backs::Backs;
pub use ids::{ElementId, PatchId, VertexId};
pub use interpolate::wachspress;
pub use levels::TwoLevels;
pub use locate::Locator;
pub use place::Place;

use crate::geometry::{Polygon, Rgb};
use crate::material::Material;
use crate::scene::{Face, FaceId, MaterialId, Scene, SceneError, Side, Surface};
use anchor::Anchor;
use build::Builder;
use contact::Planes;
use glam::DVec3;
use scale::Scale;
use std::ops::Range;
use std::sync::Arc;

/// A piece of a surface of the scene.
#[derive(Clone, Debug)]
pub struct Patch {
    /// Which of [`Scene::surfaces`].
    pub surface: u32,
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
#[must_use]
pub struct Mesh {
    /// In order of the scene's surfaces.
    pub patches: Vec<Patch>,
    /// In order of patches.
    pub elements: Vec<Element>,
    /// Positions of the shared corners.
    pub vertices: Vec<DVec3>,
    anchors: Vec<Anchor>,
    planes: Arc<Planes>,
}

impl Mesh {
    /// One element for each surface of the scene.
    pub fn whole(scene: &Scene) -> Mesh {
        let mut builder = Builder::new(Arc::new(Planes::of(scene)));
        for (id, surface) in (0u32..).zip(&scene.surfaces) {
            builder.add(id, surface, [surface.polygon.clone()]);
        }
        builder.finish()
    }

    /// Elements whose edges are no longer than `max_edge` (scene units; positive), those
    /// of a surface in one patch. Ground that is out of scale, ten times larger than all
    /// that stands on it together, has edges that are longer by the distance to that.
    ///
    /// Quadrilaterals become grids, triangles become triangles, other outlines are first
    /// cut into quadrilaterals about their middle; then each cell that another surface
    /// touches along a line is cut along that line.
    pub fn uniform(scene: &Scene, max_edge: f64) -> Mesh {
        Mesh::cells(scene, max_edge, |builder, id, surface, cells| {
            builder.add(id, surface, cells);
        })
    }

    /// The same elements, each a patch of its own, for [`Mesh::split`] to divide.
    pub fn patched(scene: &Scene, max_edge: f64) -> Mesh {
        Mesh::cells(scene, max_edge, |builder, id, surface, cells| {
            cells.into_iter().for_each(|cell| builder.add(id, surface, [cell]));
        })
    }

    /// A mesh of patches whose elements come from elsewhere: for each patch the surface
    /// that it is a piece of, and its elements, which do not straddle contact lines.
    pub fn of_pieces(
        scene: &Scene,
        patches: impl IntoIterator<Item = (u32, Vec<Polygon>)>,
    ) -> Mesh {
        let mut builder = Builder::new(Arc::new(Planes::of(scene)));
        for (id, elements) in patches {
            builder.add(id, &scene.surfaces[id as usize], elements);
        }
        builder.finish()
    }

    fn cells(
        scene: &Scene,
        max_edge: f64,
        add: impl Fn(&mut Builder, u32, &Surface, Vec<Polygon>),
    ) -> Mesh {
        assert!(max_edge > 0.0, "max_edge must be positive: {max_edge}");
        let planes = Arc::new(Planes::of(scene));
        let mut builder = Builder::new(Arc::clone(&planes));
        let scale = Scale::of(scene);
        for (id, surface) in (0u32..).zip(&scene.surfaces) {
            let (_, contacts) = planes.of_surface(id);
            let cells = scale.cells(id as usize, &surface.polygon, max_edge);
            let cells = cells.into_iter().flat_map(|cell| contacts.cut(cell)).collect();
            add(&mut builder, id, surface, cells);
        }
        builder.finish()
    }

    /// How many elements [`Mesh::uniform`] makes, contact lines aside.
    pub fn count_uniform(scene: &Scene, max_edge: f64) -> f64 {
        let scale = Scale::of(scene);
        let surfaces = scene.surfaces.iter().enumerate();
        surfaces.map(|(k, s)| scale.count(k, &s.polygon, max_edge)).sum()
    }

    /// The area of all surfaces, scene units squared, but for ground that is out of scale:
    /// elements with edges of `√(area/n)` are about `n`.
    pub fn area_in_scale(scene: &Scene) -> f64 {
        Scale::of(scene).area(scene)
    }

    /// Each element cut along the lines where other surfaces touch or pierce it, which
    /// [`Mesh::uniform`] has done already and [`Mesh::whole`] has not.
    pub fn cut_at_contacts(&self) -> Vec<Vec<Polygon>> {
        let cut = |e: &Element| {
            let (_, contacts) = self.planes.of_surface(self.surface_of(e));
            contacts.cut(e.polygon.clone())
        };
        self.elements.iter().map(cut).collect()
    }

    /// A scene like `scene`, of which this is a mesh, whose faces are the elements: all
    /// fronts, in order.
    ///
    /// Other programs that are handed such a scene have no choice of elements left.
    ///
    /// # Errors
    /// An element so small that rounding has left it no shape.
    pub fn as_faces(&self, scene: &Scene) -> Result<Scene, SceneError> {
        let surface = |e: &Element| &scene.surfaces[self.surface_of(e) as usize];
        let fronts = self.elements.iter().filter(|e| surface(e).side == Side::Front);
        let face = |e: &Element| Face {
            outline: e.polygon.vertices().to_vec(),
            material: surface(e).material,
        };
        let (faces, materials) = (fronts.map(face).collect(), scene.materials.clone());
        let (tiled, _) =
            Scene::assemble(&scene.name, materials, faces, Some(scene.camera))?;
        Ok(Scene { sky: scene.sky.clone(), ..tiled })
    }

    /// The element `id`.
    pub fn element(&self, id: ElementId) -> &Element {
        &self.elements[id]
    }

    /// The patch that `element` is part of.
    pub fn patch_of(&self, element: &Element) -> &Patch {
        &self.patches[element.patch]
    }

    /// What the element is made of.
    pub fn material<'s>(&self, scene: &'s Scene, element: &Element) -> &'s Material {
        &scene.materials[self.patch_of(element).material]
    }

    /// The area of a patch: the sum of its elements', scene units squared.
    pub fn patch_area(&self, patch: &Patch) -> f64 {
        let ids = patch.elements.start as usize..patch.elements.end as usize;
        self.elements[ids].iter().map(|e| e.polygon.area()).sum()
    }

    /// Which of [`Scene::surfaces`] the element is part of.
    pub fn surface_of(&self, element: &Element) -> u32 {
        self.patch_of(element).surface
    }

    /// The outlines of all elements, in order.
    pub fn polygons(&self) -> impl ExactSizeIterator<Item = &Polygon> + Clone {
        self.elements.iter().map(|e| &e.polygon)
    }

    /// Means over the elements of what is linear between corners: those of their corners,
    /// which is exact on triangles and parallelograms.
    pub fn element_means(&self, of_vertices: &[Rgb]) -> Vec<Rgb> {
        let mean = |e: &Element| {
            let sum: Rgb = e.corners.iter().map(|&c| of_vertices[c]).sum();
            sum / e.corners.len() as f64
        };
        self.elements.iter().map(mean).collect()
    }

    /// Values at the vertices: the area-weighted means of the elements that meet there.
    ///
    /// Elements meet only within one plane and material, and on one side of a contact.
    /// T-vertices take the value of the edge that they lie on.
    pub fn vertex_values(&self, of_elements: &[Rgb]) -> Vec<Rgb> {
        let mut sums = vec![(Rgb::ZERO, 0.0); self.vertices.len()];
        for (element, &value) in self.elements.iter().zip(of_elements) {
            let area = element.polygon.area();
            for &corner in &element.corners {
                let (sum, weight) = &mut sums[corner];
                *sum += area * value;
                *weight += area;
            }
        }
        let mean = |(sum, weight): (Rgb, f64)| sum / weight;
        let mut values: Vec<Rgb> = sums.into_iter().map(mean).collect();
        self.anchor(&mut values);
        values
    }
}
