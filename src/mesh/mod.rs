//! Patches and elements: the pieces on which light is taken to be constant.
//!
//! A **patch** is one [`Surface`](crate::scene::Surface); it is divided into **elements**.
//! (Substructuring, where patches shoot and elements receive, rests on this pair.)
//!
//! **Not here:** splitting where the light asks for it. Chapters *The pipeline* (L08) and
//! *Substructuring* (L11). Sources: Cohen, Greenberg, Immel & Brock 1986.

use crate::geometry::Polygon;
use crate::scene::{FaceId, MaterialId};
use glam::DVec3;
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
