//! Where light comes from, as the judge draws it: a place on a lamp, a direction of the sky.

use crate::geometry::{Polygon, Rgb};
use crate::random::Shares;
use crate::scene::Scene;
use crate::sky::Sky;
use glam::{DVec3, dvec2};
use std::f64::consts::PI;

/// All that sends light of itself: faces with `Ke > 0`, and the sky.
pub(super) struct Lights<'s> {
    lamps: Vec<Luminous<'s>>,
    /// For each surface the lamp that it is.
    of_surface: Vec<Option<u32>>,
    sky: Option<&'s Sky>,
}

/// A face that emits.
struct Luminous<'s> {
    surface: u32,
    outline: &'s Polygon,
    middle: DVec3,
    /// W/m², and the power, in W, of all channels together.
    emission: Rgb,
    power: f64,
}

/// The lights as they are drawn from one point: what is near and strong more often.
pub(super) struct FromHere<'l> {
    lights: &'l Lights<'l>,
    x: DVec3,
    shares: Shares,
    /// The chance that the sky is asked.
    sky: f64,
}

/// A light that was drawn.
pub(super) struct DrawnLight {
    /// Towards it, of unit length.
    pub direction: DVec3,
    /// The surface that it is; `None` for the sky.
    pub surface: Option<u32>,
    /// W/(m² sr), if nothing stands between.
    pub radiance: Rgb,
    /// The density, in 1/sr.
    pub pdf: f64,
}

impl<'s> Lights<'s> {
    pub fn of(scene: &'s Scene) -> Lights<'s> {
        let mut lamps = Vec::new();
        let mut of_surface = vec![None; scene.surfaces.len()];
        for (k, side) in (0u32..).zip(&scene.surfaces) {
            let (outline, emission) = (&side.polygon, scene.material(side).emission());
            if emission != Rgb::ZERO {
                of_surface[k as usize] = Some(lamps.len() as u32);
                let (surface, middle) = (k, outline.centroid());
                let power = emission.element_sum() * outline.area();
                lamps.push(Luminous { surface, outline, middle, emission, power });
            }
        }
        let sky = scene.sky.as_ref().filter(|sky| sky.shines());
        Lights { lamps, of_surface, sky }
    }

    // ANCHOR: from
    /// As they are drawn from `x`, where `normal` points: by their power over the square of
    /// how far they are, for what may stand between is not known. Lamps behind the surface,
    /// and those that turn their backs, are not asked.
    pub fn from(&self, x: DVec3, normal: DVec3) -> FromHere<'_> {
        let weight = |lamp: &Luminous| {
            let away = lamp.outline.plane().height(x) <= 0.0;
            let behind = |v: &DVec3| normal.dot(v - x) <= 0.0;
            if away || lamp.outline.vertices().iter().all(behind) {
                return 0.0;
            }
            lamp.power / (lamp.middle.distance_squared(x) + lamp.outline.area())
        };
        let weights: Vec<f64> = self.lamps.iter().map(weight).collect();
        let any = weights.iter().any(|&w| w > 0.0);
        let shares = Shares::of(if any { weights } else { Vec::new() });
        let sky = match self.sky {
            Some(_) if any => 0.25,
            Some(_) => 1.0,
            None => 0.0,
        };
        FromHere { lights: self, x, shares, sky }
    }
    // ANCHOR_END: from

    /// How much light there is, in W: of each lamp, and of the sky as it falls on a sphere
    /// of this radius.
    pub fn powers(&self, radius: f64) -> (Vec<f64>, f64) {
        let of_sky = |sky: &Sky| {
            let all = [DVec3::Y, DVec3::NEG_Y].map(|n| sky.irradiance(n).element_sum());
            // On a sphere: the mean over all normals of the irradiance is that of opposite ones.
            0.5 * (all[0] + all[1]) * 4.0 * PI * radius * radius
        };
        let lamps = self.lamps.iter().map(|lamp| lamp.power).collect();
        (lamps, self.sky.map_or(0.0, of_sky))
    }

    /// The outline of a lamp, and which surface it is.
    pub fn lamp(&self, k: usize) -> (&Polygon, u32) {
        (self.lamps[k].outline, self.lamps[k].surface)
    }

    /// How many lamps there are.
    pub fn lamps(&self) -> usize {
        self.lamps.len()
    }

    pub fn sky(&self) -> Option<&Sky> {
        self.sky
    }
}

impl FromHere<'_> {
    /// Is there any lamp to be asked?
    pub fn has_lamps(&self) -> bool {
        !self.shares.is_empty()
    }

    /// Is there any light at all?
    pub fn is_dark(&self) -> bool {
        !self.has_lamps() && self.sky == 0.0
    }

    // ANCHOR: draw
    /// Light that may come here; `None` where the lamp turns its back.
    pub fn draw(&self, [choice, u, v]: [f64; 3]) -> Option<DrawnLight> {
        if choice < self.sky {
            let sky = self.lights.sky?;
            let (direction, pdf) = sky.sample(dvec2(u, v));
            let (radiance, pdf) = (sky.radiance(direction), self.sky * pdf);
            return Some(DrawnLight { direction, surface: None, radiance, pdf });
        }
        let (k, _) = self.shares.pick((choice - self.sky) / (1.0 - self.sky));
        let lamp = &self.lights.lamps[k];
        let y = lamp.outline.point_at([u, v]);
        let direction = (y - self.x).try_normalize()?;
        let (pdf, radiance) = (self.pdf_of_lamp(lamp.surface, y), lamp.emission / PI);
        let surface = Some(lamp.surface);
        (pdf > 0.0).then_some(DrawnLight { direction, surface, radiance, pdf })
    }

    /// The density, in 1/sr, with which `y` on a surface is drawn: `chance/area · r²/cosθ`.
    pub fn pdf_of_lamp(&self, surface: u32, y: DVec3) -> f64 {
        let Some(k) = self.lights.of_surface[surface as usize] else { return 0.0 };
        if self.shares.is_empty() {
            return 0.0;
        }
        let outline = self.lights.lamps[k as usize].outline;
        let way = self.x - y;
        let cosine = way.dot(outline.normal()) / way.length();
        if cosine <= 0.0 {
            return 0.0;
        }
        let density = (1.0 - self.sky) * self.shares.share(k as usize) / outline.area();
        density * way.length_squared() / cosine
    }
    // ANCHOR_END: draw

    /// The density, in 1/sr, with which this direction of the sky is drawn.
    pub fn pdf_of_sky(&self, direction: DVec3) -> f64 {
        self.lights.sky.map_or(0.0, |sky| self.sky * sky.pdf(direction))
    }
}
