//! Splitting elements in four, as a quadtree does, and keeping the mesh balanced.

use super::build::Builder;
use super::{Element, Mesh};

impl Mesh {
    /// The mesh with the elements that are marked split: triangles and quadrilaterals in
    /// four, other outlines in a quadrilateral for each corner.
    ///
    /// **Balanced**: no edge has more than one T-vertex. Where one would have more, that
    /// element is split as well. Patches stay what they are; vertices keep their ids,
    /// new ones follow.
    ///
    /// # Panics
    /// When there is not one mark for each element.
    pub fn split(&self, marked: &[bool]) -> Mesh {
        assert_eq!(marked.len(), self.elements.len(), "one mark for each element");
        let mut builder = self.divided(marked);
        loop {
            let unbalanced = builder.unbalanced();
            if !unbalanced.contains(&true) {
                return builder.finish();
            }
            builder = builder.mesh().divided(&unbalanced);
        }
    }

    /// The same elements and vertices, each element a patch of its own.
    pub(super) fn with_elements_as_patches(&self) -> Mesh {
        if self.patches.iter().all(|patch| patch.elements.len() == 1) {
            return self.clone();
        }
        let mut builder = Builder::over(self);
        for element in &self.elements {
            let patch = self.patch_of(element).clone();
            builder.add_patch(patch, [element.polygon.clone()]);
        }
        builder.finish()
    }

    fn divided(&self, marked: &[bool]) -> Builder {
        let mut builder = Builder::over(self);
        for patch in &self.patches {
            let ids = patch.elements.start as usize..patch.elements.end as usize;
            let pieces = ids.flat_map(|k| {
                let polygon = &self.elements[k].polygon;
                if marked[k] { polygon.quarters() } else { vec![polygon.clone()] }
            });
            builder.add_patch(patch.clone(), pieces);
        }
        builder
    }
}

impl Builder {
    /// The elements with an edge that holds more than one T-vertex.
    fn unbalanced(&self) -> Vec<bool> {
        let mesh = self.mesh();
        let too_long = |element: &Element| {
            let surface = mesh.surface_of(element);
            let middle = element.polygon.centroid();
            element.polygon.edges().any(|(a, b)| {
                let there =
                    |t: f64| self.known(surface, a.lerp(b, t), middle).is_some();
                // Of an edge as short as rounding, all its points are corners.
                let long = || a.distance(b) > self.shortest_divided();
                there(0.5) && (there(0.25) || there(0.75)) && long()
            })
        };
        mesh.elements.iter().map(too_long).collect()
    }
}
