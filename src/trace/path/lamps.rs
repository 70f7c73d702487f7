//! Where light comes from: a place on a lamp, or a direction of the sky, drawn by chance.

use crate::geometry::Rgb;
use crate::random::Stream;
use crate::scene::Scene;
use glam::{DVec3, dvec2};
use std::f64::consts::PI;

/// The lamps of a scene and its sky, each to be chosen by its power.
#[derive(Clone, Debug)]
pub(super) struct Lamps {
    /// The surfaces that emit, each with the chance of it or one before it; the last has 1.
    by_power: Vec<(f64, u32)>,
    /// Per surface, the density of a point on it once a lamp is chosen: 1/area.
    density: Vec<f64>,
    /// The chance that the sky is chosen.
    sky: f64,
}

/// Light that may come to a point.
pub(super) struct Light {
    /// From where, of unit length.
    pub direction: DVec3,
    /// The surface that it comes from; `None` for the sky.
    pub lamp: Option<u32>,
    /// W/(m² sr), if nothing stands between.
    pub radiance: Rgb,
    /// The density, in 1/sr, with which it was drawn.
    pub pdf: f64,
}

impl Lamps {
    pub fn of(scene: &Scene) -> Lamps {
        let power = |k: usize| {
            let surface = &scene.surfaces[k];
            surface.polygon.area() * scene.material(surface).emission().element_sum()
        };
        let lit = (0..scene.surfaces.len()).filter(|&k| power(k) > 0.0);
        let all: f64 = lit.clone().map(power).sum();
        let mut so_far = 0.0;
        let mut density = vec![0.0; scene.surfaces.len()];
        let mut by_power: Vec<(f64, u32)> = lit
            .map(|k| {
                so_far += power(k) / all;
                density[k] = power(k) / all / scene.surfaces[k].polygon.area();
                (so_far, k as u32)
            })
            .collect();
        if let Some(last) = by_power.last_mut() {
            last.0 = 1.0; // whatever rounding left
        }
        let shines = scene.sky.as_ref().is_some_and(|sky| sky.shines());
        let sky = match (shines, by_power.is_empty()) {
            (false, _) => 0.0,
            (true, true) => 1.0,
            (true, false) => 0.5,
        };
        Lamps { by_power, density, sky }
    }

    // ANCHOR: sample_light
    /// Light that may come to `x`; `None` where the lamp turns its back.
    pub fn sample(
        &self,
        scene: &Scene,
        x: DVec3,
        random: &mut Stream,
    ) -> Option<Light> {
        let [choice, u, v] = [random.next(), random.next(), random.next()];
        if choice < self.sky {
            let sky = scene.sky.as_ref()?;
            let (direction, pdf) = sky.sample(dvec2(u, v));
            let radiance = sky.radiance(direction);
            return Some(Light {
                direction,
                lamp: None,
                radiance,
                pdf: self.sky * pdf,
            });
        }
        let choice = (choice - self.sky) / (1.0 - self.sky);
        let k = self.by_power.partition_point(|&(so_far, _)| so_far <= choice);
        let &(_, lamp) = self.by_power.get(k)?;
        let surface = &scene.surfaces[lamp as usize];
        let y = surface.polygon.point_at([u, v]);
        let direction = (y - x).try_normalize()?;
        let pdf = self.pdf_of_lamp(scene, lamp, x, y);
        let radiance = scene.material(surface).emission() / PI;
        (pdf > 0.0).then_some(Light { direction, lamp: Some(lamp), radiance, pdf })
    }
    // ANCHOR_END: sample_light

    // ANCHOR: pdf_of_lamp
    /// The density, in 1/sr about `x`, with which `y` on the front of `lamp` is drawn.
    ///
    /// ```text
    /// p = chance/area · r²/cosθ
    /// ```
    pub fn pdf_of_lamp(&self, scene: &Scene, lamp: u32, x: DVec3, y: DVec3) -> f64 {
        let normal = scene.surfaces[lamp as usize].polygon.normal();
        let way = x - y;
        let cosine = way.dot(normal) / way.length();
        if cosine <= 0.0 {
            return 0.0;
        }
        (1.0 - self.sky) * self.density[lamp as usize] * way.length_squared() / cosine
    }
    // ANCHOR_END: pdf_of_lamp

    /// The density, in 1/sr, with which this `direction` of the sky is drawn.
    pub fn pdf_of_sky(&self, scene: &Scene, direction: DVec3) -> f64 {
        scene.sky.as_ref().map_or(0.0, |sky| self.sky * sky.pdf(direction))
    }
}
