//! Light that is known before anything is solved: that was reflected once.
//!
//! ```text
//! B₁ = ρ H_direct + τ H_direct,back          + E, where the lamps are not summed exactly
//! ```
//! It has the shadow edges of the direct light. So it is linear across elements, not patches;
//! a patch that is far away sends its linear part and the right mean.

use super::patches::{BothSides, SmoothPatches};
use crate::form_factor::linear::{CornerView, Slopes, sent};
use crate::geometry::Rgb;
use crate::mesh::{Backs, ElementId};
use crate::scene::Scene;
use glam::DVec3;

/// Light that was reflected once, W/m².
pub(super) struct FirstBounce {
    /// `H_direct` at the vertices of the elements.
    direct: BothSides,
    /// `B₁` across patches.
    of_patches: Vec<Slopes>,
    /// `B₁` across elements.
    of_elements: Vec<Slopes>,
    /// `E + B₁` without lamps, mean of each patch.
    pub means: Vec<Rgb>,
}

impl FirstBounce {
    /// Of the direct light at the vertices of the elements.
    pub fn of(scene: &Scene, patches: &SmoothPatches, direct: &[Rgb]) -> FirstBounce {
        let (levels, emission) = (patches.levels, &patches.enclosure.emission);
        let mut at_corners = levels.at_patch_corners(direct).to_vec();
        levels.patches().anchor(&mut at_corners);
        let at_corners = patches.both_sides(&at_corners);
        let fine = levels.elements();
        let direct = BothSides::new(direct, &Backs::of(scene, fine));
        let arriving = direct.element_means(fine).map(|h| levels.patch_means(&h));
        let reflected = |k| patches.scattered(k, [arriving[0][k], arriving[1][k]]);
        let of_patch = |k| {
            let mut b = patches.slopes(k, &at_corners);
            b[0] += reflected(k) - patches.hemicubes.mean(k, &b);
            b
        };
        let of_element = |e| patches.element_slopes(e, &direct);
        let elements = (0..fine.elements.len() as u32).map(ElementId);
        FirstBounce {
            of_patches: patches.ids().map(of_patch).collect(),
            of_elements: elements.map(of_element).collect(),
            means: patches.ids().map(|k| emission[k] + reflected(k)).collect(),
            direct,
        }
    }

    /// `H`, W/m², of this light where so much of it is seen.
    pub fn irradiance(&self, view: &CornerView) -> Rgb {
        let of_patch = |&place: &usize| {
            let (k, m) = &view.patches[place];
            sent(&self.of_patches[*k], m)
        };
        view.whole.iter().map(of_patch).sum::<Rgb>()
            + view
                .elements
                .iter()
                .map(|(e, m)| sent(&self.of_elements[*e], m))
                .sum::<Rgb>()
    }

    /// `B₁` at the point `x` of an element, without lamps.
    pub fn at(&self, patches: &SmoothPatches, e: ElementId, x: DVec3) -> Rgb {
        let mesh = patches.levels.elements();
        let element = mesh.element(e);
        let sides = [&self.direct.front, &self.direct.back];
        patches.scattered(element.patch, sides.map(|h| mesh.value_at(element, x, h)))
    }
}
