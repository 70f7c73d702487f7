//! The patches: how they look from where, and what they do with the light on either side.
//!
//! ```text
//! B_p(s, t) = ρ_p H(s, t) + τ_p H_back(s, t)      linear across the patch, from its corners
//! ```

use crate::form_factor::linear::{Linear, Slopes};
use crate::geometry::Rgb;
use crate::mesh::{Backs, ElementId, Mesh, PatchId, TwoLevels};
use crate::scene::Scene;
use crate::solve::Enclosure;

/// Irradiance at the vertices of a mesh, W/m², and that of the other sides in the same
/// places.
pub(super) struct BothSides {
    pub front: Vec<Rgb>,
    pub back: Vec<Rgb>,
}

impl BothSides {
    pub fn new(front: &[Rgb], backs: &Backs) -> BothSides {
        BothSides { front: front.to_vec(), back: backs.apply(front) }
    }

    /// Means over the elements of a mesh.
    pub fn element_means(&self, mesh: &Mesh) -> [Vec<Rgb>; 2] {
        [&self.front, &self.back].map(|side| mesh.element_means(side))
    }
}

/// The patches of a scene, divided into elements.
pub(super) struct SmoothPatches<'a> {
    pub levels: &'a TwoLevels<'a>,
    /// What is known of each patch.
    pub enclosure: Enclosure,
    /// `τ` of each patch.
    translucence: Vec<Rgb>,
    backs: Backs,
    pub hemicubes: Linear<'a>,
}

impl<'a> SmoothPatches<'a> {
    pub fn of(
        scene: &Scene,
        levels: &'a TwoLevels<'a>,
        hemicubes: Linear<'a>,
    ) -> SmoothPatches<'a> {
        let mesh = levels.patches();
        let translucence =
            mesh.elements.iter().map(|e| mesh.material(scene, e).translucence());
        SmoothPatches {
            levels,
            enclosure: Enclosure::of(scene, mesh),
            translucence: translucence.collect(),
            backs: Backs::of(scene, mesh),
            hemicubes,
        }
    }

    /// All patches, in order.
    pub fn ids(&self) -> impl Iterator<Item = PatchId> + use<> {
        (0..self.enclosure.len() as u32).map(PatchId)
    }

    /// Irradiance at the corners of the patches, with that of their other sides.
    pub fn both_sides(&self, at_corners: &[Rgb]) -> BothSides {
        BothSides::new(at_corners, &self.backs)
    }

    /// `ρ H + τ H_back` of patch `k`.
    pub fn scattered(&self, k: PatchId, [front, back]: [Rgb; 2]) -> Rgb {
        self.enclosure.reflectance[k] * front + self.translucence[k] * back
    }

    /// `ρ H + τ H_back` across patch `k`, from the irradiance at the patches' corners.
    pub fn slopes(&self, k: PatchId, at_corners: &BothSides) -> Slopes {
        self.scattered_slopes(k, at_corners, |h| self.hemicubes.of_patch(k, h))
    }

    /// `ρ H + τ H_back` across element `e`, from the irradiance at the elements' vertices.
    pub fn element_slopes(&self, e: ElementId, at_vertices: &BothSides) -> Slopes {
        let k = self.levels.elements().element(e).patch;
        self.scattered_slopes(k, at_vertices, |h| self.hemicubes.of_element(e, h))
    }

    fn scattered_slopes(
        &self,
        k: PatchId,
        irradiance: &BothSides,
        slopes: impl Fn(&[Rgb]) -> Slopes,
    ) -> Slopes {
        let mut b =
            slopes(&irradiance.front).map(|h| self.enclosure.reflectance[k] * h);
        if self.translucence[k] != Rgb::ZERO {
            let through = slopes(&irradiance.back).map(|h| self.translucence[k] * h);
            b.iter_mut().zip(through).for_each(|(b, t)| *b += t);
        }
        b
    }

    /// `max (ρ + τ)`: by so much, at the most, light falls from one reflection to the next.
    pub fn contraction(&self) -> f64 {
        let both = self.enclosure.reflectance.iter().zip(&self.translucence);
        both.map(|(r, t)| r + t).fold(Rgb::ZERO, Rgb::max).max_element()
    }
}
