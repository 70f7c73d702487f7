//! The tree of rays: what shiny surfaces make of one ray, followed branch by branch.

use super::look::Look;
use crate::geometry::{Ray, Rgb};
use crate::material::Material;
use crate::random::Stream;
use crate::room::Room;
use crate::scene::Scene;
use crate::visibility::Visibility;
use crate::ways::{Media, Meeting, Solids, ways};
use glam::DVec3;
use std::sync::Arc;

/// How a ray came to where it is.
#[derive(Clone, Debug)]
pub(super) struct Journey {
    /// What its light counts in the picture: the product of all shares.
    pub weight: Rgb,
    /// Of how many rays, sent instead of one, it is one: none is too faint for that.
    pub one_of: f64,
    /// How often it was sent on.
    pub depth: u32,
    /// The solids that it is in.
    pub media: Media,
    /// The surface that it starts from, which it does not meet.
    pub leaving: Option<u32>,
    /// Are lamps that it meets next dark, because their light is counted already?
    pub lamps_are_counted: bool,
}

impl Journey {
    /// That of a ray from the eye.
    pub(super) fn start() -> Journey {
        Journey {
            weight: Rgb::ONE,
            one_of: 1.0,
            depth: 0,
            media: Media::default(),
            leaving: None,
            lamps_are_counted: false,
        }
    }
}

/// What is counted while a sample of a pixel is traced, and what its random numbers are
/// called.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    pub rays: u64,
    /// The weights of the branches that were cut.
    pub cut: Rgb,
    pub seed: u64,
    pub pixel: u64,
    pub sample: u64,
    /// How often this sample has drawn points.
    pub draws: u64,
}

impl Tally {
    /// `n` points of the unit square. Those that a sample draws first go on where the
    /// sample of the pixel before it ended, so that a pixel's samples share the work.
    pub(super) fn points(
        &mut self,
        n: usize,
    ) -> impl Iterator<Item = [f64; 2]> + use<> {
        self.draws += 1;
        let first = self.draws == 1;
        let name = [self.pixel, if first { 0 } else { self.draws }, self.sample];
        let skipped = if first { n * self.sample as usize } else { 0 };
        let name = if first { &name[..1] } else { &name[..] };
        Stream::named(self.seed, name).points(skipped + n).skip(skipped)
    }

    /// A number in `[0, 1)`; those of a pixel's samples lie evenly.
    pub(super) fn offset(&self) -> f64 {
        let shift = Stream::named(self.seed, &[self.pixel, self.draws]).next();
        (shift + self.sample as f64 * GOLDEN).fract()
    }
}

/// Multiples of it leave no gap, modulo 1, for long.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// A scene, ready to follow rays through.
#[derive(Debug)]
pub(super) struct Tree<'s> {
    pub scene: &'s Scene,
    pub visibility: Arc<Visibility>,
    pub solids: Arc<Solids>,
    pub look: Look,
    /// Are lamps summed exactly where gloss scatters light, so that scattered rays that meet
    /// them next find them dark?
    pub lamps_are_counted: bool,
}

/// What a surface sends along a ray without mirroring or passing any: its diffuse light,
/// and its gloss.
pub(super) type Shade<'a> = &'a dyn Fn(&Meeting, &Journey, &mut Tally) -> Rgb;

impl<'s> Tree<'s> {
    pub(super) fn of(room: &Room<'s>, look: Look) -> Tree<'s> {
        let (visibility, solids) = (room.visibility().clone(), room.solids().clone());
        let lamps_are_counted = false;
        Tree { scene: room.scene, visibility, solids, look, lamps_are_counted }
    }

    pub(super) fn material(&self, surface: u32) -> &'s Material {
        self.scene.material(&self.scene.surfaces[surface as usize])
    }

    /// The radiance, W/(m² sr), that comes against a ray.
    pub(super) fn arriving(
        &self,
        ray: &Ray,
        journey: &Journey,
        tally: &mut Tally,
        shade: Shade,
    ) -> Rgb {
        // ANCHOR: arriving
        tally.rays += 1;
        let Some(hit) = self.visibility.closest(ray, journey.leaving) else {
            return self.sky(ray.direction);
        };
        let at = Meeting::of(self.scene, &self.solids, ray, &hit);
        self.leaving(&at, journey, tally, shade)
        // ANCHOR_END: arriving
    }

    /// What a ray finds that leaves the scene.
    pub(super) fn sky(&self, direction: DVec3) -> Rgb {
        self.scene.sky.as_ref().map_or(Rgb::ZERO, |sky| sky.radiance(direction))
    }

    /// The radiance, W/(m² sr), that leaves a surface against the ray that meets it.
    pub(super) fn leaving(
        &self,
        at: &Meeting,
        journey: &Journey,
        tally: &mut Tally,
        shade: Shade,
    ) -> Rgb {
        // ANCHOR: leaving
        let mut sum = shade(at, journey, tally);
        let mut media = journey.media.clone();
        for way in ways(at, &mut media) {
            let Some(direction) = way.from(at.direction) else { continue };
            let Some(mut on) = self.sent_on(at, journey, way.share, tally) else {
                continue;
            };
            on.media = if way.crosses { at.beyond(&media) } else { media.clone() };
            let ray = Ray { origin: at.point, direction };
            sum += way.denser * way.share * self.arriving(&ray, &on, tally, shade);
        }
        sum
        // ANCHOR_END: leaving
    }

    /// The journey after a bounce that keeps this share, unless it is cut; in the same media.
    pub(super) fn sent_on(
        &self,
        at: &Meeting,
        journey: &Journey,
        share: Rgb,
        tally: &mut Tally,
    ) -> Option<Journey> {
        // ANCHOR: sent_on
        let (weight, depth) = (journey.weight * share, journey.depth + 1);
        let faint = journey.one_of * weight.max_element() < self.look.weight;
        if faint || depth > self.look.depth {
            tally.cut += weight;
            return None;
        }
        let leaving = Some(at.surface);
        let on = Journey { weight, depth, leaving, ..journey.clone() };
        Some(Journey { lamps_are_counted: false, ..on })
        // ANCHOR_END: sent_on
    }
}
