//! Rays that go on: by mirrors, through panes and glass, and by gloss.
//!
//! ```text
//! L(x ← ω) = Σ_k w_k B_k/π + w L_sky      over the surfaces k that the ray meets in turn
//! w_k+1 = w_k · Ks,  w_k R(θ),  w_k T(θ), …      R + T ≤ 1: no ray gains
//! L/n² is what Snell's law leaves alone, so that L grows by n² in a medium of index n
//! ```
//! A ray that meets a mirror goes on, with less weight; at a pane or at glass it divides.
//! At each surface on the way the light that this surface scatters diffusely is added. The
//! same walk serves whoever asks what arrives at a point: pass 1, its certificate, and the
//! caustics that lamps send through glass.
//!
//! | [`Specular::follow`]    | use it when                       | it fails when               |
//! |-------------------------|-----------------------------------|-----------------------------|
//! | [`Branching::Both`]     | a smooth answer is wanted         | glass in glass: many rays   |
//! | [`Branching::One`]      | many rays are drawn anyway        | few are: noise              |
//!
//! Both are right on average: where a branch is dropped, the other counts for it. Only what
//! is left after [`MOST_BOUNCES`] is cut off, and told.
//!
//! **Not here:** images in flat mirrors ([`crate::virtual_world`]), which need no rays.
//! Chapter *Mirrors and windows* (L17, L18). Sources: Whitted 1980; Veach 1997 (radiance
//! in media).

use crate::geometry::{Frame, Polygon, Ray, Rgb};
use crate::material::optics::{fresnel, pane, reflect, refract};
use crate::material::{Lobe, Shine};
use crate::random::Stream;
use crate::scene::Scene;
use crate::visibility::{Hit, Visibility};
use glam::{DVec3, dvec2};
use smallvec::{SmallVec, smallvec};

/// A scene, ready for rays that are followed.
#[derive(Debug)]
pub struct Specular<'s> {
    scene: &'s Scene,
    visibility: Visibility,
    /// The surface that each piece is part of.
    surface_of: Vec<u32>,
    shines: bool,
}

/// What was met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Met {
    /// A surface: its diffuse light is to be added, if it is the front that was met.
    Surface {
        /// Which of [`Scene::surfaces`].
        surface: u32,
        /// Which of the pieces that rays were told of: the same, unless by
        /// [`Specular::of_pieces`].
        piece: u32,
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
}

/// What is done where a ray divides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Branching {
    /// One branch is taken, by chance.
    One,
    /// Both are followed while they count more than this; then one.
    Both(f64),
}

/// What a ray carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carries {
    /// Radiance, from where it is seen to where it comes from.
    Radiance,
    /// Power, from a lamp onwards.
    Power,
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
    /// The indices of the solids that it is in, the innermost last.
    media: SmallVec<[f64; 2]>,
}

impl Leg {
    /// The same ray after a bounce.
    fn on(&self, ray: Ray, leaving: u32, weight: Rgb) -> Leg {
        let chain = Chain { bounces: self.chain.bounces + 1, ..self.chain };
        let weight = self.weight * weight;
        Leg { ray, leaving: Some(leaving), weight, chain, media: self.media.clone() }
    }
}

impl<'s> Specular<'s> {
    /// Makes a scene ready.
    pub fn of(scene: &'s Scene) -> Specular<'s> {
        let polygons = scene.surfaces.iter().map(|s| &s.polygon);
        Specular::of_pieces(scene, (0..).zip(polygons))
    }

    /// The same with the surfaces in `pieces`, each with the surface that it is part of: a
    /// ray then tells which piece it met.
    pub fn of_pieces<'p>(
        scene: &'s Scene,
        pieces: impl Iterator<Item = (u32, &'p Polygon)>,
    ) -> Specular<'s> {
        let (surface_of, polygons): (Vec<u32>, Vec<&Polygon>) = pieces.unzip();
        let visibility = Visibility::new(polygons);
        let shines =
            scene.surfaces.iter().any(|s| !scene.material(s).shine().is_dull());
        Specular { scene, visibility, surface_of, shines }
    }

    /// The pieces, in order, as rays meet them.
    pub fn visibility(&self) -> &Visibility {
        &self.visibility
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
        (branching, carries): (Branching, Carries),
        random: &mut Stream,
        visit: &mut dyn FnMut(&Arrival),
    ) {
        let (weight, chain) = (Rgb::ONE, Chain::default());
        let first = Leg { ray, leaving, weight, chain, media: smallvec![] };
        let mut legs: SmallVec<[Leg; 4]> = smallvec![first];
        while let Some(leg) = legs.pop() {
            let met = self.meet(&leg, visit);
            let Some((hit, point)) = met else { continue };
            let next = self.onwards(&leg, &hit, point, carries, random);
            select(next, branching, random, &mut legs);
        }
    }
    // ANCHOR_END: follow

    /// The next surface on the way, if the ray is to go on from there.
    fn meet(&self, leg: &Leg, visit: &mut dyn FnMut(&Arrival)) -> Option<(Hit, DVec3)> {
        let mut arrive = |met| {
            visit(&Arrival { met, weight: leg.weight, chain: leg.chain });
        };
        let Some(hit) = self.visibility.closest(&leg.ray, leg.leaving) else {
            arrive(Met::Sky(leg.ray.direction));
            return None;
        };
        let point = leg.ray.origin + hit.distance * leg.ray.direction;
        let (piece, front) = (hit.item, hit.front);
        let surface = self.surface_of[piece as usize];
        arrive(Met::Surface { surface, piece, point, front });
        let surface = &self.scene.surfaces[surface as usize];
        let shine = self.scene.material(surface).shine();
        if shine.is_dull() || !(hit.front || shine.passes()) {
            return None;
        }
        if leg.chain.bounces + leg.chain.panes >= MOST_BOUNCES {
            arrive(Met::Cut);
            return None;
        }
        Some((hit, point))
    }

    /// The ways on from a surface that shines.
    fn onwards(
        &self,
        leg: &Leg,
        hit: &Hit,
        point: DVec3,
        carries: Carries,
        random: &mut Stream,
    ) -> SmallVec<[Leg; 2]> {
        let surface = self.surface_of[hit.item as usize] as usize;
        let surface = &self.scene.surfaces[surface];
        let material = self.scene.material(surface);
        let outer = surface.polygon.normal();
        let normal = if hit.front { outer } else { -outer };
        let direction = leg.ray.direction;
        let cosine = -direction.dot(normal);
        let to = |direction, weight| {
            leg.on(Ray { origin: point, direction }, hit.item, weight)
        };
        let mirrored = |weight| to(reflect(direction, normal), weight);
        let share = material.smooth_share();
        match material.shine() {
            Shine::Dull => smallvec![],
            // ANCHOR: onwards
            Shine::Mirror { reflectance } => smallvec![mirrored(reflectance)],
            Shine::Pane { index, tint } => {
                let (r, t) = pane(cosine, index);
                let mut through = to(direction, t * share * tint);
                through.chain = Chain { panes: leg.chain.panes + 1, ..leg.chain };
                smallvec![mirrored(r * share), through]
            }
            // ANCHOR_END: onwards
            Shine::Gloss { reflectance, exponent } => {
                let (lobe, frame) = (Lobe::Phong { exponent }, Frame::about(normal));
                let wo = frame.local_from_world(-direction);
                let wi = lobe.sample(wo, dvec2(random.next(), random.next()));
                if wi.z <= 0.0 {
                    return smallvec![];
                }
                let weight = lobe.value(wi, wo) * wi.z / lobe.pdf(wi, wo);
                let mut on = to(frame.world_from_local(wi), weight * reflectance);
                on.chain.bent = true;
                smallvec![on]
            }
            Shine::Glass { index, tint } => {
                let mut media = leg.media.clone();
                let (here, beyond) = if hit.front {
                    media.push(index);
                    (leg.media.last().copied().unwrap_or(1.0), index)
                } else {
                    media.pop();
                    (index, media.last().copied().unwrap_or(1.0))
                };
                let r = fresnel(cosine, here / beyond).mean();
                let mut back = mirrored(r * share);
                back.chain.bent = true;
                let Some(refracted) = refract(direction, normal, here / beyond) else {
                    return smallvec![back];
                };
                let grown = match carries {
                    Carries::Radiance => (here / beyond).powi(2),
                    Carries::Power => 1.0,
                };
                let mut through = to(refracted, (1.0 - r) * grown * share * tint);
                through.chain.bent = true;
                through.media = media;
                smallvec![back, through]
            }
        }
    }
}

/// Puts on the stack what of the ways on is followed.
fn select(
    ways: SmallVec<[Leg; 2]>,
    branching: Branching,
    random: &mut Stream,
    legs: &mut SmallVec<[Leg; 4]>,
) {
    let all = ways.iter().map(|w| w.weight.max_element()).sum::<f64>();
    let both = matches!(branching, Branching::Both(least) if all > least);
    // ANCHOR: one_branch
    let mut chance = if both || ways.len() < 2 { -1.0 } else { all * random.next() };
    for mut way in ways {
        let weight = way.weight.max_element();
        if chance >= 0.0 {
            chance -= weight;
            if chance >= 0.0 {
                continue; // the other one
            }
            way.weight *= all / weight;
            chance = f64::INFINITY;
        }
        let weight = way.weight.max_element();
        if weight < LIGHT_WEIGHT {
            if LIGHT_WEIGHT * random.next() >= weight {
                continue;
            }
            way.weight *= LIGHT_WEIGHT / weight;
        }
        if weight > 0.0 {
            legs.push(way);
        }
    }
    // ANCHOR_END: one_branch
}
