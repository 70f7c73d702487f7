//! A scene: surfaces with materials, and a camera that looks at them.
//!
//! Every `f` of an OBJ file is a *face* with a [`FaceId`]; most faces are one [`Surface`],
//! but a face that is not convex, not planar, or partly covered by a smaller coplanar one
//! becomes several. What reports per face - the CSV of `solve`, the matrix - sums them up.
//!
//! **Not here:** subdivision into patches and elements ([`crate::mesh`]); reading files
//! ([`crate::obj`]). Chapter *The pipeline* (L08).

mod builtin;

pub use builtin::{BuiltIn, built_in, builtins};

use crate::geometry::{Polygon, bounds};
use crate::material::Material;
use glam::DVec3;

/// Which `f` of the OBJ file, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FaceId(pub u32);

/// Which material of [`Scene::materials`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MaterialId(pub u32);

/// A convex planar piece of a face.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Its outline; the front is where light is emitted and reflected.
    pub polygon: Polygon,
    /// What it is made of.
    pub material: MaterialId,
    /// The face that it is (part of).
    pub face: FaceId,
}

/// From where, and how, the scene is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Position, in scene units.
    pub eye: DVec3,
    /// A point in the middle of the picture.
    pub target: DVec3,
    /// The world's up.
    pub up: DVec3,
    /// Vertical field of view, in degrees, in `(0, 180)`.
    pub fov: f64,
}

/// Surfaces, materials, a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Its name: that of the built-in scene or of the file.
    pub name: String,
    /// All pieces of all faces, in order of faces.
    pub surfaces: Vec<Surface>,
    /// All materials.
    pub materials: Vec<Material>,
    /// How many faces the OBJ file has.
    pub faces: usize,
    /// A view that shows the scene.
    pub camera: Camera,
}

impl Scene {
    /// The material of `surface`.
    pub fn material(&self, surface: &Surface) -> &Material {
        &self.materials[surface.material.0 as usize]
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

    /// Does any surface emit?
    pub fn has_emitter(&self) -> bool {
        self.surfaces.iter().any(|s| self.material(s).emits())
    }
}
