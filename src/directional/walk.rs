//! Radiance by random walks: no patches, no bins, no bias.

use crate::geometry::{Frame, Ray, Rgb};
use crate::material::Brdf;
use crate::random::Stream;
use crate::scene::Scene;
use crate::visibility::Visibility;
use glam::{DVec3, dvec2};
use std::f64::consts::FRAC_1_PI;

/// Random walks against the light, in a scene whose surfaces scatter by their BRDFs.
pub struct Walk<'a> {
    scene: &'a Scene,
    /// One for each material.
    brdfs: Vec<Brdf>,
    surfaces: Visibility,
}

impl<'a> Walk<'a> {
    /// Ready to walk.
    pub fn of(scene: &'a Scene) -> Walk<'a> {
        let surfaces = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
        let brdfs = scene.materials.iter().map(|m| m.brdf()).collect();
        Walk { scene, brdfs, surfaces }
    }

    /// The radiance, W/(m² sr), that a surface sends from its point `x` along `wo`, of unit
    /// length, as one walk finds it.
    ///
    /// ```text
    /// L(x, ωₒ) = E/π + f(ωᵢ, ωₒ) cosθᵢ/p(ωᵢ) · L(x', −ωᵢ)         on the average
    /// ```
    /// It goes on as the BRDF samples, and ends by chance.
    ///
    /// # Accuracy
    /// Unbiased: the mean of many walks is right, to `σ/√walks`. A small lamp is rarely
    /// met, and `σ` large.
    pub fn radiance(
        &self,
        mut surface: u32,
        mut x: DVec3,
        mut wo: DVec3,
        random: &mut Stream,
    ) -> Rgb {
        let (mut sum, mut weight) = (Rgb::ZERO, Rgb::ONE);
        loop {
            let on = &self.scene.surfaces[surface as usize];
            let brdf = &self.brdfs[on.material.0 as usize];
            sum += weight * FRAC_1_PI * self.scene.material(on).emission();
            let frame = Frame::about(on.polygon.normal());
            let local = frame.local_from_world(wo);
            let wi = brdf.sample(local, dvec2(random.next(), random.next()));
            if wi.z <= 0.0 {
                return sum; // below the horizon, where the BRDF is 0
            }
            weight *= brdf.value(wi, local) * wi.z / brdf.pdf(wi, local);
            let goes_on = weight.max_element().min(1.0);
            if random.next() >= goes_on {
                return sum;
            }
            weight /= goes_on;
            let direction = frame.world_from_local(wi);
            let hit =
                self.surfaces.closest(&Ray { origin: x, direction }, Some(surface));
            let Some(hit) = hit.filter(|hit| hit.front) else { return sum };
            (surface, x) = (hit.item, x + hit.distance * direction);
            wo = -direction;
        }
    }
}
