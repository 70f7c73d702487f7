//! The radiance of one beam by random walks: no bins, no bias.

use super::Bins;
use crate::geometry::{Frame, Ray, Rgb};
use crate::material::Brdf;
use crate::mesh::{ElementId, Mesh};
use crate::random::Stream;
use crate::scene::Scene;
use crate::visibility::Visibility;
use glam::{DVec3, dvec2};
use std::f64::consts::FRAC_1_PI;

/// The mean radiance of a beam, by walks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamRadiance {
    /// `L`, W/(m² sr).
    pub radiance: Rgb,
    /// Its standard error.
    pub error: Rgb,
}

/// The mean radiance that `element` sends into `bin`, by so many `walks` (two at least).
///
/// ```text
/// L(x, ωₒ) = E/π + f(ωᵢ, ωₒ) cosθᵢ/p(ωᵢ) · L(x', −ωᵢ)           on the average
/// ```
/// Each walk starts anywhere on the element and anywhere in the bin, and goes on as the
/// BRDF samples; it ends by chance. `brdfs` has one for each material of `scene`.
///
/// # Accuracy
/// Unbiased; the standard error is told, and falls as one over the root of the walks.
pub fn beam_by_walks(
    scene: &Scene,
    mesh: &Mesh,
    brdfs: &[Brdf],
    (element, bins, bin): (ElementId, Bins, u32),
    walks: usize,
    seed: u64,
) -> BeamRadiance {
    let surfaces = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
    let walk = Walk { scene, brdfs, surfaces };
    let of = mesh.element(element);
    let frame = Frame::about(of.polygon.normal());
    let mut random = Stream::named(seed, &[u64::from(element.0), u64::from(bin)]);
    let (mut sum, mut squares) = (Rgb::ZERO, Rgb::ZERO);
    for _ in 0..walks {
        let x = of.polygon.point_at([random.next(), random.next()]);
        let wo = bins.direction(bin, dvec2(random.next(), random.next()));
        let wo = frame.world_from_local(wo);
        let radiance = walk.radiance(mesh.surface_of(of), x, wo, &mut random);
        sum += radiance;
        squares += radiance * radiance;
    }
    let n = walks as f64;
    let mean = sum / n;
    let variance = (squares / n - mean * mean).max(Rgb::ZERO) / (n - 1.0);
    BeamRadiance { radiance: mean, error: variance.map(f64::sqrt) }
}

struct Walk<'a> {
    scene: &'a Scene,
    brdfs: &'a [Brdf],
    surfaces: Visibility,
}

impl Walk<'_> {
    /// What `surface` sends from its point `x` along `wo`, on the average.
    fn radiance(
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
