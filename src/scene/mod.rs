//! A scene: surfaces with materials, and a camera that looks at them.
//!
//! Every `f` of an OBJ file is a *face* with a [`FaceId`]; most faces are one [`Surface`],
//! but a face that is not convex, not planar, or partly covered by a smaller coplanar one
//! becomes several. What reports per face - the CSV of `solve`, the matrix - sums them up.
//!
//! ```text
//! face ─ split, less what covers it ─▶ surfaces ─ mesh ─▶ patches ─▶ elements
//! ```
//! What acts on both its sides is two surfaces, back to back.
//!
//! | made by             | from                                                |
//! |---------------------|-----------------------------------------------------|
//! | [`Scene::assemble`] | faces and materials: splits, and settles overlaps   |
//! | [`built_in`]        | a name; [`builtins`] lists them                     |
//! | [`crate::obj`]      | a file                                              |
//!
//! ```
//! use radiosity::glam::DVec3;
//! use radiosity::material::Material;
//! use radiosity::scene::{Face, MaterialId, Scene, built_in};
//! let outline = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
//! let faces = vec![Face { outline, material: MaterialId(0) }];
//! let made = Scene::assemble("square", vec![Material::black("soot")], faces, None);
//! let (scene, repairs) = made.unwrap();
//! assert_eq!((scene.face_areas(), repairs.len()), (vec![1.0], 0));
//! assert!(built_in("cornell").unwrap().has_emitter());
//! ```
//!
//! **Not here:** subdivision into patches and elements ([`crate::mesh`]); reading files
//! ([`crate::obj`]). Chapter *The pipeline* (L08). Sources: Goral et al. 1984; those of the
//! Cornell box stand by it.

mod assemble;
mod builtin;
mod camera;
mod dulled;
mod layers;
mod overlap;

pub use assemble::{Repair, SceneError};
pub use builtin::{BuiltIn, BuiltInError, built_in, builtins};
pub use camera::Camera;

use crate::geometry::{Polygon, bounds, indexes_lists};
use crate::material::Material;
use crate::sky::Sky;
use glam::DVec3;

/// Which `f` of the OBJ file, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FaceId(pub u32);

/// Which material of [`Scene::materials`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MaterialId(pub u32);

indexes_lists!(FaceId, MaterialId);

/// One `f` of an OBJ file, as it stands there.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Its corners, counter-clockwise seen from the front, in scene units.
    pub outline: Vec<DVec3>,
    /// What it is made of.
    pub material: MaterialId,
}

/// A convex planar piece of one side of a face.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Its outline; the front is where light is emitted and reflected.
    pub polygon: Polygon,
    /// What it is made of.
    pub material: MaterialId,
    /// The face that it is (part of).
    pub face: FaceId,
    /// Which side of the face.
    pub side: Side,
    /// The surface that is its other side, in the same place; `None` where that side is
    /// black, or where light goes straight through.
    pub back: Option<u32>,
}

/// Which side of a face a surface is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Side {
    /// From where its corners run counter-clockwise.
    #[default]
    Front,
    /// The other: a face that lets light through diffusely, or is two-sided, has two.
    Back,
}

/// Surfaces, materials, a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Its name: that of the built-in scene or of the file.
    pub name: String,
    /// All faces as they were given, indexed by [`FaceId`].
    pub faces: Vec<Face>,
    /// All pieces of all faces, in order of faces, fronts before backs. No two of them that
    /// look the same way overlap. A face that others cover wholly has none.
    pub surfaces: Vec<Surface>,
    /// All materials, indexed by [`MaterialId`].
    pub materials: Vec<Material>,
    /// A view that shows the scene.
    pub camera: Camera,
    /// The light of rays that leave the scene; without it they find darkness.
    pub sky: Option<Sky>,
}

impl Scene {
    /// The material of `surface`.
    pub fn material(&self, surface: &Surface) -> &Material {
        &self.materials[surface.material]
    }

    /// Area of one side of each face, less what smaller faces cover; in scene units
    /// squared.
    pub fn face_areas(&self) -> Vec<f64> {
        let mut areas = vec![0.0; self.faces.len()];
        for surface in self.fronts() {
            areas[surface.face] += surface.polygon.area();
        }
        areas
    }

    /// The surfaces that are fronts of faces.
    pub fn fronts(&self) -> impl Iterator<Item = &Surface> {
        self.surfaces.iter().filter(|s| s.side == Side::Front)
    }

    /// The fronts of the faces alone, all black and opaque, under no sky: what matters to
    /// form factors between faces.
    pub fn bare_geometry(&self) -> Scene {
        let bare = |front: &Surface| Surface { back: None, ..front.clone() };
        Scene {
            surfaces: self.fronts().map(bare).collect(),
            materials: self
                .materials
                .iter()
                .map(|m| Material::black(m.name()))
                .collect(),
            sky: None,
            ..self.clone()
        }
    }

    /// The box that holds all surfaces.
    pub fn bounds(&self) -> (DVec3, DVec3) {
        bounds(self.surfaces.iter().flat_map(|s| s.polygon.vertices().iter().copied()))
    }

    /// Length of the diagonal of [`Scene::bounds`], in scene units.
    pub fn diagonal(&self) -> f64 {
        let (low, high) = self.bounds();
        low.distance(high)
    }

    /// Lengths below this are rounding, in scene units.
    ///
    /// A billionth of the diagonal: what coordinates with few digits leave between corners
    /// that are meant to coincide. And no more than a ten-millionth of the smallest
    /// surface, so that what lies far off, such as wide ground, joins nothing here: also not
    /// [what lies on each other](Scene::assemble).
    pub fn rounding(&self) -> f64 {
        let sizes = self.surfaces.iter().map(|s| {
            let (low, high) = bounds(s.polygon.vertices().iter().copied());
            low.distance(high)
        });
        (1e-9 * self.diagonal()).min(1e-7 * sizes.fold(f64::INFINITY, f64::min))
    }

    /// Does any surface mirror, gloss or let light through in directions of its own, so
    /// that it looks different from different places?
    pub fn shines(&self) -> bool {
        self.surfaces.iter().any(|s| !self.material(s).shine().is_dull())
    }

    /// Is there nothing but opaque surfaces that scatter diffusely, and no sky: what
    /// radiosity was made for?
    pub fn is_plain(&self) -> bool {
        self.sky.is_none()
            && !self.shines()
            && self.surfaces.iter().all(|s| s.back.is_none())
    }

    /// Does any surface emit, or the sky shine?
    pub fn has_emitter(&self) -> bool {
        self.sky.as_ref().is_some_and(Sky::shines)
            || self.surfaces.iter().any(|s| self.material(s).emits())
    }
}
