//! Lists that are indexed by ids of their own, so that no id is taken for another.

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
pub(crate) use indexes_lists;
