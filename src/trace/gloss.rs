//! Gloss: light gathered over the cone about the reflection ray.

use super::cone::Cone;
use super::look::{LobeAs, Look};
use super::tree::{Journey, Shade, Tally, Tree};
use crate::geometry::{Frame, Ray, Rgb};
use crate::material::Lobe;
use crate::material::optics::reflect;
use crate::room::LampsSeen;
use crate::ways::Meeting;
use glam::{DVec3, dvec2};
use std::f64::consts::TAU;

/// Gloss met by a ray.
pub(super) struct Glossy<'s> {
    at: Meeting<'s>,
    look: Look,
    /// `Ks`.
    reflectance: Rgb,
    exponent: f64,
}

impl<'s> Glossy<'s> {
    /// The gloss of what was met, if it has any.
    pub(super) fn of(at: &Meeting<'s>, look: Look) -> Option<Glossy<'s>> {
        let (reflectance, exponent) = at.material.shine().gloss()?;
        Some(Glossy { at: *at, look, reflectance, exponent })
    }

    /// The middle of the lobe.
    fn axis(&self) -> DVec3 {
        reflect(self.at.direction, self.at.normal)
    }

    pub(super) fn albedo(&self) -> Rgb {
        let cosine = -self.at.direction.dot(self.at.normal);
        let lobe = Lobe::Phong { exponent: self.exponent };
        self.reflectance * lobe.albedo(cosine.clamp(0.0, 1.0))
    }

    /// The radiance, W/(m² sr), that the lamps have the gloss show, straight from them.
    ///
    /// ```text
    /// L = Ks (n + 2)/2π Σ_lamps E/π · mean of Ω⊥(lamp ∩ cone) over the stack
    /// ```
    pub(super) fn of_lamps(&self, lamps: &LampsSeen, offset: f64) -> Rgb {
        // ANCHOR: of_lamps
        let (cones, counts) = self.cones(offset);
        let mut sum = Rgb::ZERO;
        for (radiance, pieces) in lamps.seen_from(self.at.surface, self.at.point) {
            let overlaps = pieces.iter().flat_map(|piece| {
                let overlap =
                    |c: &Cone| c.overlap(self.at.point, self.at.normal, piece);
                cones.iter().map(overlap)
            });
            sum += radiance * overlaps.sum::<f64>();
        }
        counts * sum
        // ANCHOR_END: of_lamps
    }

    /// The cones that stand for the lobe, and what radiance counts in each for every
    /// steradian of projected solid angle.
    // ANCHOR: cones
    fn cones(&self, offset: f64) -> (Vec<Cone>, Rgb) {
        match self.look.lobe {
            LobeAs::OneCone(share) => {
                let cone = Cone::holding(share, self.exponent, self.axis());
                let all = cone.projected_solid_angle(self.at.normal);
                (vec![cone], self.albedo() / all)
            }
            LobeAs::Stack(k) => {
                let level = |j: usize| (j as f64 + offset) / k as f64;
                let cone = |j| Cone::above(level(j), self.exponent, self.axis());
                let peak = (self.exponent + 2.0) / TAU;
                ((0..k).map(cone).collect(), self.reflectance * peak / k as f64)
            }
        }
    }
    // ANCHOR_END: cones

    /// A direction of the lobe from a point of the unit square, and what radiance from
    /// there counts; `None` below the horizon.
    fn direction(&self, u: [f64; 2]) -> Option<(DVec3, Rgb)> {
        let u = dvec2(u[0], u[1]);
        if let LobeAs::OneCone(share) = self.look.lobe {
            let cone = Cone::holding(share, self.exponent, self.axis());
            let cosine = 1.0 - u.x * (1.0 - cone.half_angle.cos());
            let sine = ((1.0 - cosine) * (1.0 + cosine)).sqrt();
            let (s, c) = (TAU * u.y).sin_cos();
            let local = DVec3::new(sine * c, sine * s, cosine);
            let w = Frame::about(cone.axis).world_from_local(local);
            let of_cone = cone.projected_solid_angle(self.at.normal);
            let solid = TAU * (1.0 - cone.half_angle.cos());
            let counts = self.albedo() * (w.dot(self.at.normal) * solid / of_cone);
            return (w.dot(self.at.normal) > 0.0).then_some((w, counts));
        }
        let lobe = Lobe::Phong { exponent: self.exponent };
        let frame = Frame::about(self.at.normal);
        let wo = frame.local_from_world(-self.at.direction);
        let wi = lobe.sample(wo, u);
        let counts = self.reflectance * (lobe.value(wi, wo) * wi.z / lobe.pdf(wi, wo));
        (wi.z > 0.0).then(|| (frame.world_from_local(wi), counts))
    }

    /// The radiance, W/(m² sr), that the gloss shows of all else: by rays.
    // ANCHOR: by_rays
    pub(super) fn by_rays(
        &self,
        tree: &Tree,
        journey: &Journey,
        tally: &mut Tally,
        shade: Shade,
    ) -> Rgb {
        let importance = journey.weight.max_element().min(1.0);
        let rays = (self.look.gloss as f64 * importance).ceil().max(1.0) as usize;
        let one = Journey { one_of: journey.one_of * rays as f64, ..journey.clone() };
        let mut sum = Rgb::ZERO;
        for u in tally.points(rays) {
            let Some((direction, counts)) = self.direction(u) else { continue };
            let share = counts / rays as f64;
            let Some(mut on) = tree.sent_on(&self.at, &one, share, tally) else {
                continue;
            };
            on.lamps_are_counted = tree.lamps_are_counted;
            let ray = Ray { origin: self.at.point, direction };
            sum += share * tree.arriving(&ray, &on, tally, shade);
        }
        sum
    }
    // ANCHOR_END: by_rays
}
