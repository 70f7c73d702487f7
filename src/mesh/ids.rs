//! Which patch, element or vertex: numbers that cannot be taken for one another, by which
//! lists are indexed.

/// Lists are indexed by this id: `list[id]` is the entry whose place it tells.
macro_rules! indexes_lists {
    ($($id:ident),*) => {$(
        impl<T> std::ops::Index<$id> for [T] {
            type Output = T;
            fn index(&self, id: $id) -> &T {
                &self[id.0 as usize]
            }
        }
        impl<T> std::ops::IndexMut<$id> for [T] {
            fn index_mut(&mut self, id: $id) -> &mut T {
                &mut self[id.0 as usize]
            }
        }
        impl<T> std::ops::Index<$id> for Vec<T> {
            type Output = T;
            fn index(&self, id: $id) -> &T {
                &self[id.0 as usize]
            }
        }
        impl<T> std::ops::IndexMut<$id> for Vec<T> {
            fn index_mut(&mut self, id: $id) -> &mut T {
                &mut self[id.0 as usize]
            }
        }
    )*};
}

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
