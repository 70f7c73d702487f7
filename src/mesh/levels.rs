//! Patches and their elements: two meshes of one scene, the finer made from the coarser.
//!
//! ```text
//! B_p = Σ A_e B_e / Σ A_e          over the elements e of patch p      up: the mean
//! H_v = Σ_c w_c(x_v) H_c           over the corners c of patch p       down: interpolated
//! ```
//! What sends light is to be few and large, what receives it many and small; each level has
//! corner values of its own. Light is carried from one level to the other in these two ways.
//!
//! Sources: Cohen, Greenberg, Immel & Brock 1986 (substructuring).

use super::{Element, ElementId, Mesh, Patch, PatchId, Place};
use crate::geometry::Rgb;

/// A mesh whose elements are taken for patches, and a finer one that divides these.
///
/// It is made by splitting alone. So what follows always holds: the patches of the finer
/// mesh are the elements of the coarser one, under the same numbers; and its vertices begin
/// with those of the coarser one.
#[derive(Clone, Debug)]
pub struct TwoLevels<'m> {
    coarse: &'m Mesh,
    fine: Mesh,
}

impl<'m> TwoLevels<'m> {
    /// Each element of `mesh` as a patch that is one element still.
    pub fn undivided(mesh: &'m Mesh) -> TwoLevels<'m> {
        TwoLevels { coarse: mesh, fine: mesh.with_elements_as_patches() }
    }

    /// The elements that are marked split, as [`Mesh::split`] does.
    ///
    /// # Panics
    /// When there is not one mark for each element.
    pub fn split(self, marked: &[bool]) -> TwoLevels<'m> {
        TwoLevels { fine: self.fine.split(marked), ..self }
    }

    /// The mesh whose elements are the patches, in order.
    pub fn patches(&self) -> &'m Mesh {
        self.coarse
    }

    /// The mesh that divides them.
    pub fn elements(&self) -> &Mesh {
        &self.fine
    }

    /// The same, when the patches are no longer asked for.
    pub fn into_elements(self) -> Mesh {
        self.fine
    }

    /// The patch, as the element of the coarser mesh that it is.
    pub fn patch(&self, id: PatchId) -> &'m Element {
        &self.coarse.elements[ElementId(id.0)]
    }

    /// The elements of a patch.
    pub fn elements_of(
        &self,
        id: PatchId,
    ) -> impl Iterator<Item = (ElementId, &Element)> {
        let Patch { elements, .. } = &self.fine.patches[id];
        elements.clone().map(ElementId).map(|e| (e, self.fine.element(e)))
    }

    /// Has the patch more than one element?
    pub fn is_divided(&self, id: PatchId) -> bool {
        self.fine.patches[id].elements.len() > 1
    }

    /// Values per element, as their means over each patch, by area.
    pub fn patch_means(&self, of_elements: &[Rgb]) -> Vec<Rgb> {
        let mut sums = vec![(Rgb::ZERO, 0.0); self.fine.patches.len()];
        for (element, &value) in self.fine.elements.iter().zip(of_elements) {
            let (sum, area) = &mut sums[element.patch];
            *sum += element.polygon.area() * value;
            *area += element.polygon.area();
        }
        sums.into_iter().map(|(sum, area)| sum / area).collect()
    }

    /// Of values per vertex of the finer mesh, those at the corners of the patches.
    pub fn at_patch_corners<'v>(&self, of_vertices: &'v [Rgb]) -> &'v [Rgb] {
        &of_vertices[..self.coarse.vertices.len()]
    }

    /// Values at the corners of the patches, interpolated to the vertices of the finer mesh;
    /// 0 at T-vertices, whose values [`Mesh::anchor`] finds.
    pub fn interpolated(&self, of_corners: &[Rgb]) -> Vec<Rgb> {
        let at_vertex = |(place, &at): (&Option<Place>, _)| match place {
            Some(Place { element, .. }) => {
                let patch = self.patch(self.fine.elements[*element as usize].patch);
                self.coarse.value_at(patch, at, of_corners)
            }
            None => Rgb::ZERO,
        };
        self.fine.places(0.0).iter().zip(&self.fine.vertices).map(at_vertex).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::built_in;

    /// A field that is linear in space goes down to the elements exactly, and its means
    /// come up again.
    #[test]
    fn linear_fields_go_down_and_their_means_come_up() {
        let scene = built_in("furnace").unwrap();
        let patches = Mesh::uniform(&scene, 0.4);
        let mut levels = TwoLevels::undivided(&patches);
        for round in 0..3 {
            let count = levels.elements().elements.len();
            let marks: Vec<bool> = (0..count).map(|k| k % 5 == round).collect();
            levels = levels.split(&marks);
        }
        assert!(levels.elements().elements.len() > 2 * patches.elements.len());
        // The place itself: a field with three channels, each of them linear.
        let (fine, coarse) = (&levels.elements().vertices, &patches.vertices);
        assert_eq!(levels.at_patch_corners(fine), &coarse[..]);
        let mut down = levels.interpolated(coarse);
        levels.elements().anchor(&mut down);
        let size = scene.diagonal();
        assert!(down.iter().zip(fine).all(|(a, b)| a.distance(*b) < 1e-12 * size));
        let means = levels.patch_means(&levels.elements().element_means(fine));
        let whole = patches.element_means(coarse);
        for (k, (mean, whole)) in means.iter().zip(&whole).enumerate() {
            let id = PatchId(k as u32);
            let area: f64 = levels.elements_of(id).map(|(_, e)| e.polygon.area()).sum();
            let off = area - levels.patch(id).polygon.area();
            assert!(off.abs() < 1e-9 * area);
            assert!(mean.distance(*whole) < 1e-9 * size, "{mean} {whole}");
        }
    }
}
