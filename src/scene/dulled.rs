//! A scene as classical radiosity takes it: nothing shines.

use super::Scene;
use crate::geometry::Rgb;
use crate::material::optics::pane;
use crate::material::{Coefficients, Material, Shine};

/// What a surface may reflect and let through, both diffusely, at the most.
const MOST: f64 = 0.999;

impl Scene {
    /// The same scene with all that shines made dull: what was mirrored is scattered
    /// evenly, and so is what was let through.
    ///
    /// ```text
    /// Kd' = Kd + Ks                                    mirrors, gloss
    /// Kd' = Kd + s R    Td' = Td + s Tf T              panes, glass: s = 1 − Kd − Td
    /// ```
    /// with the `R` and `T` of a pane for light from straight ahead. The power that leaves
    /// a surface is about the same; its direction is lost.
    pub fn dulled(&self) -> Scene {
        let mut scene = self.clone();
        scene.materials = self.materials.iter().map(dulled).collect();
        scene.add_backs(|material| material.translucence() != Rgb::ZERO, false);
        scene
    }
}

fn dulled(material: &Material) -> Material {
    if material.shine().is_dull() {
        return material.clone();
    }
    let (mut diffuse, mut translucence) = (material.diffuse(), material.translucence());
    // ANCHOR: dulled
    let shine = material.shine();
    diffuse += shine.reflectance();
    if let Some((index, tint)) = shine.clear() {
        let (r, t) = pane(1.0, index);
        let share = material.smooth_share();
        diffuse += share * r;
        translucence += share * tint * t;
    }
    // ANCHOR_END: dulled
    let scale = (MOST / (diffuse + translucence).max_element()).min(1.0);
    let coefficients = Coefficients {
        emission: material.emission(),
        diffuse: scale * diffuse,
        translucence: scale * translucence,
        shine: Shine::default(),
    };
    // It is passive by the scale.
    Material::new(material.name(), coefficients).unwrap_or_else(|_| material.clone())
}
