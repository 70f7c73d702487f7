//! Where light comes from: a place on a lamp, or a direction of the sky, drawn by chance.

use super::Room;
use super::lamps::Lamps;
use crate::geometry::Rgb;
use crate::random::Stream;
use crate::scene::Scene;
use glam::{DVec3, dvec2};
use std::f64::consts::PI;
use std::sync::Arc;

/// The lamps of a scene and its sky, each to be chosen by its power.
#[derive(Clone, Debug)]
pub struct LightSampler {
    lamps: Arc<Lamps>,
    /// The chance that the sky is chosen.
    sky: f64,
}

/// Light that may come to a point.
#[derive(Clone, Copy, Debug)]
pub struct SampledLight {
    /// From where, of unit length.
    pub direction: DVec3,
    /// Which of [`Lamps::all`] it comes from; `None` for the sky.
    pub lamp: Option<u32>,
    /// W/(m² sr), if nothing stands between.
    pub radiance: Rgb,
    /// The density, in 1/sr, with which it was drawn.
    pub pdf: f64,
}

impl LightSampler {
    /// That of a room.
    pub fn of(room: &Room) -> LightSampler {
        let lamps = room.lamps().lamps().clone();
        let shines = room.scene.sky.as_ref().is_some_and(|sky| sky.shines());
        let sky = match (shines, lamps.all().is_empty()) {
            (false, _) => 0.0,
            (true, true) => 1.0,
            (true, false) => 0.5,
        };
        LightSampler { lamps, sky }
    }

    /// The lamp that a surface is (part of).
    pub fn lamp_of(&self, surface: u32) -> Option<u32> {
        self.lamps.of_surface(surface)
    }

    // ANCHOR: sample_light
    /// Light that may come to `x`; `None` where the lamp turns its back.
    pub fn sample(
        &self,
        scene: &Scene,
        x: DVec3,
        random: &mut Stream,
    ) -> Option<SampledLight> {
        let [choice, u, v] = [random.next(), random.next(), random.next()];
        if choice < self.sky {
            let sky = scene.sky.as_ref()?;
            let (direction, pdf) = sky.sample(dvec2(u, v));
            let radiance = sky.radiance(direction);
            return Some(SampledLight {
                direction,
                lamp: None,
                radiance,
                pdf: self.sky * pdf,
            });
        }
        let id = self.lamps.by_power((choice - self.sky) / (1.0 - self.sky))?;
        let lamp = &self.lamps.all()[id as usize];
        let y = lamp.outline.point_at([u, v]);
        let direction = (y - x).try_normalize()?;
        let (pdf, radiance) = (self.pdf_of_lamp(id, x, y), lamp.emission / PI);
        (pdf > 0.0).then_some(SampledLight { direction, lamp: Some(id), radiance, pdf })
    }
    // ANCHOR_END: sample_light

    // ANCHOR: pdf_of_lamp
    /// The density, in 1/sr about `x`, with which `y` on the front of `lamp` is drawn.
    ///
    /// ```text
    /// p = chance/area · r²/cosθ
    /// ```
    pub fn pdf_of_lamp(&self, lamp: u32, x: DVec3, y: DVec3) -> f64 {
        let outline = &self.lamps.all()[lamp as usize].outline;
        let way = x - y;
        let cosine = way.dot(outline.normal()) / way.length();
        if cosine <= 0.0 {
            return 0.0;
        }
        let density = (1.0 - self.sky) * self.lamps.chance(lamp) / outline.area();
        density * way.length_squared() / cosine
    }
    // ANCHOR_END: pdf_of_lamp

    /// The density, in 1/sr, with which this `direction` of the sky is drawn.
    pub fn pdf_of_sky(&self, scene: &Scene, direction: DVec3) -> f64 {
        scene.sky.as_ref().map_or(0.0, |sky| self.sky * sky.pdf(direction))
    }
}
