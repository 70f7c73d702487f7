//! Rays that go on: by mirrors, through panes and glass, and by gloss.
//!
//! ```text
//! L(x ← ω) = Σ_k w_k B_k/π + w L_sky      over the surfaces k that the ray meets in turn
//! w_k+1 = w_k · share · denser            of one way on, or of each
//! ```
//! A ray that meets a mirror goes on, with less weight; at a pane or at glass it divides.
//! At each surface on the way the light that this surface scatters diffusely is added. The
//! same walk serves whoever asks what arrives at a point: pass 1 and its certificate.
//!
//! Where a branch is dropped, the other counts for it: both [`Branching`]s are right on
//! average. Only what is left after [`MOST_BOUNCES`] is cut off, and told.

use super::{Event, Media, Meeting, Solids, choose, straight, ways};
use crate::geometry::{Frame, Ray, Rgb};
use crate::material::Lobe;
use crate::random::Stream;
use crate::scene::Scene;
use crate::visibility::{Hit, Visibility};
use glam::{DVec3, dvec2};
use smallvec::{SmallVec, smallvec};
use std::borrow::Cow;

/// A scene, ready for rays that are followed.
#[derive(Debug)]
pub struct Specular<'s> {
    scene: &'s Scene,
    solids: Cow<'s, Solids>,
    visibility: &'s Visibility,
    shines: bool,
    branching: Branching,
}

/// What was met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Met {
    /// A surface: its diffuse light is to be added, if it is the front that was met.
    Surface {
        /// Which of [`Scene::surfaces`].
        surface: u32,
        /// Where.
        point: DVec3,
        /// The front? (A back that reflects or lets light through is a surface of its own.)
        front: bool,
    },
    /// Nothing, in this direction: the sky.
    Sky(DVec3),
    /// The end: too many bounces.
    Cut,
}

/// How a ray came to where it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Chain {
    /// How often it was mirrored, refracted or scattered by gloss.
    pub bounces: u32,
    /// How often it went straight through a pane.
    pub panes: u32,
    /// Was it bent by anything but flat mirrors and panes?
    pub bent: bool,
}

/// Where a ray arrived, and what it counts there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// What was met.
    pub met: Met,
    /// What the radiance (or the power) counts, per channel.
    pub weight: Rgb,
    /// On which way.
    pub chain: Chain,
    /// In which direction it came here, of unit length.
    pub direction: DVec3,
}

/// What is done where a ray divides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Branching {
    /// One branch is taken, by chance.
    One,
    /// Both are followed while they count more than this; then one.
    Both(f64),
}

/// After so many bounces a ray is cut.
pub const MOST_BOUNCES: u32 = 64;

/// A ray that counts less lives on by chance.
const LIGHT_WEIGHT: f64 = 0.05;

/// A ray on its way.
struct Leg {
    ray: Ray,
    leaving: Option<u32>,
    weight: Rgb,
    chain: Chain,
    media: Media,
}

impl<'s> Specular<'s> {
    /// Of a scene whose surfaces and solids are ready to be met.
    pub fn through(
        scene: &'s Scene,
        visibility: &'s Visibility,
        solids: &'s Solids,
    ) -> Specular<'s> {
        let solids = Cow::Borrowed(solids);
        let shines = scene.shines();
        Specular { scene, solids, visibility, shines, branching: Branching::One }
    }

    /// The same for whoever has nothing but the surfaces ready.
    pub fn within(scene: &'s Scene, visibility: &'s Visibility) -> Specular<'s> {
        let (solids, shines) = (Cow::Owned(Solids::of(scene)), scene.shines());
        Specular { scene, solids, visibility, shines, branching: Branching::One }
    }

    /// The same, rays dividing like this; they take one branch unless it is said.
    pub fn branching(self, branching: Branching) -> Specular<'s> {
        Specular { branching, ..self }
    }

    /// The surfaces, in order, as rays meet them.
    pub fn visibility(&self) -> &Visibility {
        self.visibility
    }

    /// Is there any surface that rays go on from?
    pub fn shines(&self) -> bool {
        self.shines
    }

    // ANCHOR: follow
    /// Calls `visit` for all that a ray meets, until it is used up; `leaving` is the surface
    /// that it leaves.
    ///
    /// On average over `random` the visits sum to what arrives along the ray. Weights are
    /// in `[0, 1]`, but for the n² of radiance in glass and the noise of chance.
    pub fn follow(
        &self,
        (ray, leaving): (Ray, Option<u32>),
        random: &mut Stream,
        visit: &mut dyn FnMut(&Arrival),
    ) {
        let (weight, chain, media) = (Rgb::ONE, Chain::default(), Media::default());
        let mut legs: SmallVec<[Leg; 4]> =
            smallvec![Leg { ray, leaving, weight, chain, media }];
        while let Some(leg) = legs.pop() {
            if let Some(hit) = self.meet(&leg, visit) {
                let next = self.onwards(leg, &hit, random);
                select(next, self.branching, random, &mut legs);
            }
        }
    }
    // ANCHOR_END: follow

    /// What passes straight along a ray, through panes, as far as the front of `target`; of
    /// the sky where that is none. 0 where something stands between.
    pub fn clear(
        &self,
        (mut ray, mut leaving): (Ray, Option<u32>),
        target: Option<u32>,
    ) -> Rgb {
        let (mut share, mut media) = (Rgb::ONE, Media::default());
        loop {
            let Some(hit) = self.visibility.closest(&ray, leaving) else {
                return if target.is_none() { share } else { Rgb::ZERO };
            };
            let met = Meeting::of(self.scene, &self.solids, &ray, &hit);
            if met.front && Some(met.surface) == target {
                return share;
            }
            let Some((passed, _)) = straight(&met, &mut media) else {
                return Rgb::ZERO;
            };
            share *= passed;
            (ray.origin, leaving) = (met.point, Some(met.surface));
        }
    }

    /// The next surface on the way, if the ray is to go on from there.
    fn meet(&self, leg: &Leg, visit: &mut dyn FnMut(&Arrival)) -> Option<Hit> {
        let mut arrive = |met| {
            let Leg { weight, chain, .. } = *leg;
            visit(&Arrival { met, weight, chain, direction: leg.ray.direction });
        };
        let Some(hit) = self.visibility.closest(&leg.ray, leg.leaving) else {
            arrive(Met::Sky(leg.ray.direction));
            return None;
        };
        let point = leg.ray.origin + hit.distance * leg.ray.direction;
        let (surface, front) = (hit.item, hit.front);
        arrive(Met::Surface { surface, point, front });
        let surface = &self.scene.surfaces[surface as usize];
        if self.scene.material(surface).shine().is_dull() {
            return None;
        }
        if leg.chain.bounces + leg.chain.panes >= MOST_BOUNCES {
            arrive(Met::Cut);
            return None;
        }
        Some(hit)
    }

    /// The ways on from a surface that shines, but for what it scatters diffusely.
    fn onwards(
        &self,
        mut leg: Leg,
        hit: &Hit,
        random: &mut Stream,
    ) -> SmallVec<[Leg; 2]> {
        let met = Meeting::of(self.scene, &self.solids, &leg.ray, hit);
        let bends = met.material.shine().bends();
        let mut on = SmallVec::new();
        for way in ways(&met, &mut leg.media) {
            let mut chain = Chain { bent: leg.chain.bent || bends, ..leg.chain };
            match way.event {
                Event::Passed if !bends => chain.panes += 1,
                _ => chain.bounces += 1,
            }
            let came = match way.event {
                Event::Scattered { lobe: Lobe::Lambert, .. } => None,
                Event::Scattered { lobe, normal } => drawn(lobe, normal, &met, random),
                _ => way.from(met.direction).map(|direction| (direction, 1.0)),
            };
            let Some((direction, times)) = came else { continue };
            on.push(Leg {
                ray: Ray { origin: met.point, direction },
                leaving: Some(hit.item),
                weight: leg.weight * (times * way.denser * way.share),
                chain,
                media: if way.crosses {
                    met.beyond(&leg.media)
                } else {
                    leg.media.clone()
                },
            });
        }
        on
    }
}

/// A direction of a lobe, and what the reflectance counts there; `None` below the horizon.
fn drawn(
    lobe: Lobe,
    normal: DVec3,
    met: &Meeting,
    random: &mut Stream,
) -> Option<(DVec3, f64)> {
    let frame = Frame::about(normal);
    let wo = frame.local_from_world(-met.direction);
    let wi = lobe.sample(wo, dvec2(random.next(), random.next()));
    let weight = lobe.value(wi, wo) * wi.z / lobe.pdf(wi, wo);
    (wi.z > 0.0).then(|| (frame.world_from_local(wi), weight))
}

/// Puts on the stack what of the ways on is followed.
fn select(
    mut on: SmallVec<[Leg; 2]>,
    branching: Branching,
    random: &mut Stream,
    legs: &mut SmallVec<[Leg; 4]>,
) {
    let weight = |leg: &Leg| leg.weight.max_element();
    on.retain(|leg| weight(leg) > 0.0);
    let all = on.iter().map(weight).sum::<f64>();
    let both = matches!(branching, Branching::Both(least) if all > least);
    if !both
        && on.len() > 1
        && let Some((k, _)) = choose(on.iter().map(weight), random.next())
    {
        let mut one = on.swap_remove(k);
        one.weight *= all / weight(&one);
        on = smallvec![one];
    }
    for mut leg in on {
        let counts = weight(&leg);
        if counts < LIGHT_WEIGHT {
            if LIGHT_WEIGHT * random.next() >= counts {
                continue;
            }
            leg.weight *= LIGHT_WEIGHT / counts;
        }
        legs.push(leg);
    }
}
