//! Which patch, element or vertex: numbers that cannot be taken for one another, by which
//! lists are indexed.

use crate::geometry::indexes_lists;

/// Which patch of a [`Mesh`](super::Mesh).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PatchId(pub u32);

/// Which element of a [`Mesh`](super::Mesh).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ElementId(pub u32);

/// Which corner value of a [`Mesh`](super::Mesh).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VertexId(pub u32);

indexes_lists!(PatchId, ElementId, VertexId);
