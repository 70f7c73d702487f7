//! The reference: an unbiased path tracer, small, and slow.
//!
//! ```text
//! L(x ← ω) = Σ over paths of weight · L_e            on the average
//! f cosθ L/(p_lamp + p_lobe)     what a lamp adds, found either way (balance heuristic)
//! ```
//! Paths begin at the eye. At each surface one of the things it does is drawn by chance, so
//! that every path spells one word ([`Word`]); then one point of a lamp, or direction of the
//! sky, is asked for its light straight (through panes, which do not bend it), and the path
//! goes on as the lobe says. A lamp that it meets counts too: of the two chances to find the
//! same light, each has the share that it is likelier by. No step can then count more than
//! twice what a white surface shows before the lamp: corners make no sparks.
//!
//! No mesh, no form factors, no levels: what it says is right but for the standard error,
//! which it tells. Only light that no chance finds twice is slow: lamps seen by way of curved
//! glass.
//!
//! Sources: Kajiya 1986; Veach & Guibas 1995 (multiple importance sampling); Arvo & Kirk
//! 1990 (Russian roulette).

mod measure;

pub use measure::{Estimate, Traced};

use super::classes::{Class, Word};
use crate::geometry::{Frame, Ray, Rgb};
use crate::material::Lobe;
use crate::random::Stream;
use crate::room::{LightSampler, Room, SampledLight};
use crate::scene::Scene;
use crate::visibility::Visibility;
use crate::ways::{Event, Letter, Media, Meeting, Solids, Way, choose, straight, ways};
use glam::{DVec3, dvec2};
use std::f64::consts::PI;
use std::sync::Arc;

/// How lamps are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Strategy {
    /// By drawing points on them: fails for lamps that are near and large.
    Lamps,
    /// By drawing directions of the lobe: fails for lamps that are small.
    Lobes,
    /// By both, each where it is the likelier.
    #[default]
    Both,
}

/// A scene, ready to be traced.
#[derive(Debug)]
pub struct PathTracer<'s> {
    scene: &'s Scene,
    visibility: Arc<Visibility>,
    solids: Arc<Solids>,
    lamps: LightSampler,
    strategy: Strategy,
}

/// What is called for each contribution, in W/(m² sr).
type PathTally<'t> = &'t mut dyn FnMut(Class, Rgb);

/// A path so far.
struct Walk {
    ray: Ray,
    leaving: Option<u32>,
    /// What power found from here on counts.
    weight: Rgb,
    /// The same of radiance is so many times as much: the squared index here over there.
    denser: f64,
    word: Word,
    media: Media,
    /// Where a lobe last scattered, and the density, in 1/sr, of this direction; then the
    /// lamps were asked there too. `None` where they could not be.
    scattered: Option<(DVec3, f64)>,
    bounces: u32,
}

impl Walk {
    /// Goes a way from a surface that was chosen by this chance.
    fn take(&mut self, met: &Meeting, way: &Way, chance: f64) {
        self.word = self.word.then(way.letter());
        self.weight *= way.share / chance;
        self.denser *= way.denser;
        if way.crosses {
            self.media = met.beyond(&self.media);
        }
        (self.ray.origin, self.leaving) = (met.point, Some(met.surface));
        self.bounces += 1;
    }
}

/// Paths longer than this live on by chance.
const SURE_BOUNCES: u32 = 3;
/// Paths longer than this may die even if they lose nothing, caught in glass.
const LONG: u32 = 32;

impl<'s> PathTracer<'s> {
    /// Makes a scene ready.
    pub fn of(room: &Room<'s>) -> PathTracer<'s> {
        PathTracer {
            scene: room.scene,
            visibility: room.visibility().clone(),
            solids: room.solids().clone(),
            lamps: LightSampler::of(room),
            strategy: Strategy::Both,
        }
    }

    /// The same, with lamps found in another way: all three must agree.
    pub fn by(self, strategy: Strategy) -> PathTracer<'s> {
        PathTracer { strategy, ..self }
    }

    /// One sample of the radiance, in W/(m² sr), that arrives against the ray.
    ///
    /// # Accuracy
    /// Right on the average over `random`.
    pub fn radiance(&self, ray: Ray, random: &mut Stream) -> Rgb {
        let mut sum = Rgb::ZERO;
        self.radiance_by_class(ray, random, &mut |_, light| sum += light);
        sum
    }

    /// The same, with each path's share handed to `tally` under its class.
    pub fn radiance_by_class(&self, ray: Ray, random: &mut Stream, tally: PathTally) {
        let walk = Walk {
            ray,
            leaving: None,
            weight: Rgb::ONE,
            denser: 1.0,
            word: Word::default(),
            media: Media::default(),
            scattered: None,
            bounces: 0,
        };
        self.trace(walk, random, tally);
    }

    /// One sample of the irradiance, in W/m², at `x` on the front of a surface, by class:
    /// that of the light as the eye would see it on a diffuse surface there.
    pub fn irradiance_by_class(
        &self,
        (surface, x): (u32, DVec3),
        random: &mut Stream,
        tally: PathTally,
    ) {
        let normal = self.scene.surfaces[surface as usize].polygon.normal();
        let mut walk = Walk {
            ray: Ray { origin: x, direction: -normal },
            leaving: Some(surface),
            weight: Rgb::splat(PI),
            denser: 1.0,
            word: Word::default().then(Letter::D),
            media: Media::default(),
            scattered: None,
            bounces: 0,
        };
        let (frame, wo) = (Frame::about(normal), DVec3::Z);
        let diffuse = LobeAt { lobe: Lobe::Lambert, frame, wo };
        if self.scatter(&mut walk, &diffuse, random, tally) {
            self.trace(walk, random, tally);
        }
    }

    fn trace(&self, mut walk: Walk, random: &mut Stream, tally: PathTally) {
        while self.step(&mut walk, random, tally) && survives(&mut walk, random) {}
    }

    // ANCHOR: step
    /// To the next surface and away from it; false where the path ends.
    fn step(&self, walk: &mut Walk, random: &mut Stream, tally: PathTally) -> bool {
        let Some(hit) = self.visibility.closest(&walk.ray, walk.leaving) else {
            self.meet_sky(walk, tally);
            return false;
        };
        let met = Meeting::of(self.scene, &self.solids, &walk.ray, &hit);
        self.meet_lamp(walk, &met, tally);
        let ways = ways(&met, &mut walk.media);
        let Some((k, chance)) = choose(ways.iter().map(Way::odds), random.next())
        else {
            return false;
        };
        walk.take(&met, &ways[k], chance);
        // ANCHOR_END: step
        match ways[k].event {
            Event::Scattered { lobe, normal } => {
                let frame = Frame::about(normal);
                let wo = frame.local_from_world(-met.direction);
                let wo = wo.with_z(wo.z.abs());
                return self.scatter(walk, &LobeAt { lobe, frame, wo }, random, tally);
            }
            Event::Passed => {
                walk.scattered = walk.scattered.map(|(from, pdf)| (from, pdf * chance));
            }
            Event::Mirrored(from) | Event::Bent(from) => {
                (walk.ray.direction, walk.scattered) = (from, None);
            }
        }
        true
    }

    fn meet_sky(&self, walk: &Walk, tally: PathTally) {
        let Some(sky) = &self.scene.sky else { return };
        let direction = walk.ray.direction;
        let share =
            self.share_of_lobe(walk, |_| self.lamps.pdf_of_sky(self.scene, direction));
        let weight = share * walk.denser * walk.weight;
        tally(walk.word.class(), weight * sky.radiance(direction));
    }

    fn meet_lamp(&self, walk: &Walk, met: &Meeting, tally: PathTally) {
        let lamp = self.lamps.lamp_of(met.surface).filter(|_| met.front);
        if let Some(lamp) = lamp {
            let share = self.share_of_lobe(walk, |from| {
                self.lamps.pdf_of_lamp(lamp, from, met.point)
            });
            let weight = share * walk.denser * walk.weight;
            tally(walk.word.class(), weight * met.material.emission() / PI);
        }
    }

    // ANCHOR: share
    /// The share of a lamp found by a lobe's direction, beside that of lamps asked;
    /// `density(x)` is that with which it is asked from `x`.
    fn share_of_lobe(&self, walk: &Walk, density: impl Fn(DVec3) -> f64) -> f64 {
        match (walk.scattered, self.strategy) {
            (None, _) | (_, Strategy::Lobes) => 1.0,
            (_, Strategy::Lamps) => 0.0,
            (Some((x, pdf)), Strategy::Both) => pdf / (pdf + density(x)),
        }
    }
    // ANCHOR_END: share

    /// Scatters at the ray's origin: asks a lamp, and draws the direction that the path
    /// takes; false where it ends.
    fn scatter(
        &self,
        walk: &mut Walk,
        &LobeAt { lobe, frame, wo }: &LobeAt,
        random: &mut Stream,
        tally: PathTally,
    ) -> bool {
        let x = walk.ray.origin;
        if self.strategy != Strategy::Lobes
            && let Some(light) = self.lamps.sample(self.scene, x, random)
        {
            let wi = frame.local_from_world(light.direction);
            let seen = lobe.value(wi, wo) * wi.z.max(0.0);
            if seen > 0.0
                && let Some(clear) = self.clear(walk, &light)
            {
                let by_lobe = match self.strategy {
                    Strategy::Both => lobe.pdf(wi, wo) * clear.chance,
                    _ => 0.0,
                };
                let share = walk.denser * seen / (light.pdf + by_lobe);
                let weight = share * walk.weight * clear.share;
                tally(clear.word.class(), weight * light.radiance);
            }
        }
        let wi = lobe.sample(wo, dvec2(random.next(), random.next()));
        let pdf = lobe.pdf(wi, wo);
        let seen = lobe.value(wi, wo) * wi.z.max(0.0);
        walk.weight *= if pdf > 0.0 { seen / pdf } else { 0.0 };
        walk.ray.direction = frame.world_from_local(wi);
        walk.scattered = Some((x, pdf));
        seen > 0.0
    }

    /// Looks from the ray's origin towards a lamp, through panes; `None` where something
    /// stands between.
    fn clear(&self, walk: &Walk, light: &SampledLight) -> Option<Clear> {
        let mut ray = Ray { origin: walk.ray.origin, direction: light.direction };
        let (mut leaving, mut media) = (walk.leaving, walk.media.clone());
        let mut clear = Clear { share: Rgb::ONE, chance: 1.0, word: walk.word };
        loop {
            let Some(hit) = self.visibility.closest(&ray, leaving) else {
                return light.lamp.is_none().then_some(clear);
            };
            let met = Meeting::of(self.scene, &self.solids, &ray, &hit);
            if met.front
                && light
                    .lamp
                    .is_some_and(|k| self.lamps.lamp_of(met.surface) == Some(k))
            {
                return Some(clear);
            }
            let (share, chance) = straight(&met, &mut media)?;
            clear.share *= share;
            clear.chance *= chance;
            clear.word = clear.word.then(Letter::S);
            ray.origin = met.point;
            leaving = Some(met.surface);
        }
    }
}

/// A lobe in a frame, and where the light that it scatters goes, there.
struct LobeAt {
    lobe: Lobe,
    frame: Frame,
    wo: DVec3,
}

/// A clear view of a lamp.
struct Clear {
    /// What panes between let through.
    share: Rgb,
    /// The chance that a path would go through them all.
    chance: f64,
    /// The word, with the panes.
    word: Word,
}

// ANCHOR: survives
/// Russian roulette: a path of little weight ends by chance; others count for it.
fn survives(walk: &mut Walk, random: &mut Stream) -> bool {
    if walk.bounces < SURE_BOUNCES {
        return true;
    }
    let most = if walk.bounces < LONG { 1.0 } else { 0.9 };
    let chance = walk.weight.max_element().min(most);
    walk.weight /= chance;
    random.next() < chance
}
// ANCHOR_END: survives
