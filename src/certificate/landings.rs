//! Where light lands: rays from the lamps and the sky, carried on by what shines and by a
//! bounce or two.
//!
//! Points that are spread by area miss a small bright spot. Rays that start where light does
//! do not: where many land, strata are small, and points are many. And what none of `N` rays
//! has found has, with 95 % confidence, no more than `3/N` of the light, for
//!
//! ```text
//! (1 − 3/N)^N ≈ e^{−3} = 0.05
//! ```

use super::lights::Lights;
use super::{Judged, Sampling};
use crate::geometry::{Frame, Ray, Rgb, bounds};
use crate::mesh::Locator;
use crate::radiometry::cosine_direction;
use crate::random::{Shares, Stream};
use crate::scene::Scene;
use crate::ways::{Met, Specular};
use glam::{DVec3, dvec2};
use rayon::prelude::*;

/// So many rays of none of which anything is known may be `3/N` of all light.
pub(super) const MISSED: f64 = 3.0;

/// Rays are sent in flights of so many, until enough is known or this is enough.
const FLIGHT: u64 = 4096;
const MOST_FLIGHTS: u64 = 256;

/// So many rays at least for each point, to tell where light lands.
const ENOUGH: f64 = 20.0;

/// Light is followed so often after it has been scattered.
const BOUNCES: u32 = 2;

/// So many landings are kept, of those on reflecting and of those on black fronts.
const KEPT: usize = 1 << 15;

/// Where light landed.
#[derive(Default)]
pub(super) struct Landings {
    /// For each element of the mesh those on it.
    pub on: Vec<Vec<Landed>>,
    /// How many of them there are.
    pub kept: usize,
    /// The power that each stands for, in W: all channels together.
    pub power: f64,
    /// How many rays were sent.
    pub sent: f64,
    /// The share of the light that was sent which reflecting fronts sent on when it first
    /// met them; where none reflects, which met a front.
    pub reflected: f64,
}

/// A place where light landed.
#[derive(Clone, Copy)]
pub(super) struct Landed {
    pub at: DVec3,
    /// Against the ray, of unit length, where it is one of the few directions of its kind:
    /// by mirrors, through glass, from the sky.
    pub from: Option<DVec3>,
}

/// The same, as it is found.
struct Landing {
    surface: u32,
    landed: Landed,
    /// How much of it is sent on, if light has come here first.
    first: f64,
    reflects: bool,
}

/// The scene, as light meets it.
pub(super) struct Source<'a> {
    pub scene: &'a Scene,
    pub rays: &'a Specular<'a>,
    pub lights: &'a Lights<'a>,
    /// Does any front reflect?
    pub reflects: bool,
    /// A ball that holds all of the scene: its middle and its radius.
    pub ball: (DVec3, f64),
}

/// A ball that holds all of a scene.
pub(super) fn ball(scene: &Scene) -> (DVec3, f64) {
    let corners = scene.surfaces.iter().flat_map(|s| s.polygon.vertices());
    let (low, high) = bounds(corners.copied());
    (0.5 * (low + high), 0.5 * low.distance(high))
}

impl Source<'_> {
    /// Sends rays until what they may have missed is no more than the share that is asked for of
    /// what they saw reflected, or they are many.
    pub fn landings(&self, field: &Judged, sampling: Sampling) -> Landings {
        let Sampling { points, unseen, seed, .. } = sampling;
        let (mut powers, of_sky) = self.lights.powers(self.ball.1);
        powers.push(of_sky);
        let mut all = Landings {
            on: vec![Vec::new(); field.mesh.elements.len()],
            ..Landings::default()
        };
        if powers.iter().all(|&p| p == 0.0) {
            return all;
        }
        let emitted: f64 = powers.iter().sum();
        let shares = Shares::of(powers);
        let elements = field.mesh.elements.iter();
        let pieces = elements.map(|e| (field.mesh.surface_of(e), &e.polygon));
        let locator = Locator::of(self.scene, pieces);
        let mut kept = [0; 2];
        for flight in 0..MOST_FLIGHTS {
            let ray = |k: u64| {
                let mut random = Stream::named(seed, &[u64::MAX - 1, flight, k]);
                self.flight(&shares, &mut random)
            };
            let landed: Vec<Vec<Landing>> =
                (0..FLIGHT).into_par_iter().map(ray).collect();
            all.sent += FLIGHT as f64;
            for landing in landed.into_iter().flatten() {
                all.reflected += landing.first;
                let count = &mut kept[usize::from(landing.reflects)];
                let outline = |k: u32| &field.mesh.elements[k as usize].polygon;
                let piece = locator.piece(landing.surface, landing.landed.at, outline);
                if let Some(piece) = piece.filter(|_| *count < KEPT) {
                    all.on[piece as usize].push(landing.landed);
                    *count += 1;
                }
            }
            let enough =
                all.sent >= ENOUGH * points as f64 && MISSED <= unseen * all.reflected;
            if enough {
                break;
            }
        }
        all.kept = kept[0] + kept[1];
        all.power = emitted / all.sent;
        all.reflected /= all.sent;
        all
    }

    /// Where the light of one ray lands.
    fn flight(&self, shares: &Shares, random: &mut Stream) -> Vec<Landing> {
        let mut landed = Vec::new();
        let (k, rest) = shares.pick(random.next());
        let of_sky = k == self.lights.lamps();
        let mut start = self.start(k, rest, random);
        for bounce in 0..=BOUNCES {
            let Some((ray, leaving)) = start.take() else { break };
            let mut last = None;
            self.rays.follow((ray, leaving), random, &mut |arrival| {
                let Met::Surface { surface, point, front: true } = arrival.met else {
                    return;
                };
                let material =
                    self.scene.material(&self.scene.surfaces[surface as usize]);
                let scattered = material.scattered().max_element();
                if scattered == 0.0 && !material.shine().is_dull() {
                    return; // it only shines
                }
                let counts = arrival.weight.max_element().min(1.0);
                let sends_on = if self.reflects { scattered } else { 1.0 };
                let first = if bounce == 0 { counts * sends_on } else { 0.0 };
                let reflects = scattered > 0.0;
                let chain = arrival.chain;
                let is_rare =
                    bounce == 0 && (of_sky || chain.bounces > 0 || chain.bent);
                let from = is_rare.then_some(-arrival.direction);
                let there = Landed { at: point, from };
                landed.push(Landing { surface, landed: there, first, reflects });
                last = reflects.then_some((surface, point));
            });
            start = last.and_then(|(surface, x)| self.scattered(surface, x, random));
        }
        landed
    }

    /// A ray of lamp `k`, or of the sky, which comes after all lamps.
    fn start(
        &self,
        k: usize,
        rest: f64,
        random: &mut Stream,
    ) -> Option<(Ray, Option<u32>)> {
        let mut next = || random.next();
        if let Some(sky) = self.lights.sky().filter(|_| k == self.lights.lamps()) {
            let (direction, _) = sky.sample(dvec2(rest, next()));
            let frame = Frame::about(direction);
            let disc = cosine_direction(dvec2(next(), next())).truncate();
            let across = frame.x * disc.x + frame.y * disc.y;
            let (middle, radius) = self.ball;
            let origin = middle + radius * (across + 2.0 * direction);
            return Some((Ray { origin, direction: -direction }, None));
        }
        let (outline, surface) = self.lights.lamp(k);
        let origin = outline.point_at([rest, next()]);
        let local = cosine_direction(dvec2(next(), next()));
        let direction = Frame::about(outline.normal()).world_from_local(local);
        Some((Ray { origin, direction }, Some(surface)))
    }

    /// On from `x` on a front, to the one side or the other, if chance spares it.
    fn scattered(
        &self,
        surface: u32,
        x: DVec3,
        random: &mut Stream,
    ) -> Option<(Ray, Option<u32>)> {
        let side = &self.scene.surfaces[surface as usize];
        let material = self.scene.material(side);
        let mean = |c: Rgb| c.element_sum() / 3.0;
        let (rho, tau) = (mean(material.diffuse()), mean(material.translucence()));
        let chance = random.next();
        if chance >= rho + tau {
            return None;
        }
        let towards = if chance < rho { 1.0 } else { -1.0 };
        let local = cosine_direction(dvec2(random.next(), random.next()));
        let frame = Frame::about(towards * side.polygon.normal());
        let direction = frame.world_from_local(local);
        Some((Ray { origin: x, direction }, Some(surface)))
    }
}
