//! Unbiased gathering: random walks, with direct light exactly at every step.
//!
//! ```text
//! H(x₀) = H_direct(x₀) + ρ₁ (H_direct(x₁) + ρ₂ (H_direct(x₂) + …))     on the average
//! σ_mean = σ/√walks                                                    its standard error
//! ```
//! Each step goes where light would come from, with the density of the cosine; a walk
//! ends by chance, with the share of light that a surface keeps for itself. No mesh, no
//! factors, no bias: what is wrong is told by the spread of the walks. The yardstick for
//! all that is faster.
//!
//! Sources: Kajiya 1986; Ward, Rubinstein & Clear 1988 (gathering backwards).

use crate::form_factor::ray_from;
use crate::geometry::{Frame, Rgb};
use crate::mesh::Mesh;
use crate::random::Stream;
use crate::room::{Direct, OnPiece, Room};
use crate::scene::Scene;
use crate::ways::{Arrival, Met, Specular};
use glam::DVec3;
use rayon::prelude::*;
use std::f64::consts::PI;

/// The mean irradiance of an element, by walks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gathered {
    /// `H`, W/m².
    pub irradiance: Rgb,
    /// Its standard error, W/m².
    pub error: Rgb,
}

/// The mean irradiance of each element of `mesh`, by so many `walks` (two at least) each.
///
/// # Accuracy
/// Unbiased, mirrors, glass and the sky included; the standard error is told, and falls as
/// one over the root of the walks.
pub fn gather_unbiased(
    room: &Room,
    mesh: &Mesh,
    walks: usize,
    seed: u64,
) -> Vec<Gathered> {
    let (scene, direct) = (room.scene, room.lamps());
    let on = scene.surfaces.iter().map(|s| direct.on(&s.polygon)).collect();
    let rays = Specular::through(scene, room.visibility(), room.solids());
    let walker = Walker { scene, direct, on, rays };
    let of_element = |k: usize| {
        let mut random = Stream::named(seed, &[k as u64]);
        let surface = mesh.surface_of(&mesh.elements[k]);
        let (mut sum, mut squares) = (Rgb::ZERO, Rgb::ZERO);
        for _ in 0..walks {
            let place = [random.next(), random.next()];
            let x = mesh.elements[k].polygon.point_at(place);
            let h = walker.walk(surface, x, &mut random);
            sum += h;
            squares += h * h;
        }
        let n = walks as f64;
        let mean = sum / n;
        let variance = (squares / n - mean * mean).max(Rgb::ZERO) / (n - 1.0);
        Gathered { irradiance: mean, error: variance.map(f64::sqrt) }
    };
    (0..mesh.elements.len()).into_par_iter().map(of_element).collect()
}

/// A scene, ready for walks.
struct Walker<'s> {
    scene: &'s Scene,
    direct: &'s Direct<'s>,
    on: Vec<OnPiece<'s>>,
    rays: Specular<'s>,
}

impl Walker<'_> {
    /// What arrives at `x` on `surface`, W/m², by one walk.
    fn walk(&self, mut surface: u32, mut x: DVec3, random: &mut Stream) -> Rgb {
        let mut share = Rgb::ONE;
        let mut sum = Rgb::ZERO;
        loop {
            // ANCHOR: walk
            sum += share * self.on[surface as usize].irradiance(x);
            let (light, places) = self.step(surface, x, random);
            sum += share * light;
            let worth = |p: &(u32, DVec3, Rgb)| (share * p.2).max_element();
            let all: f64 = places.iter().map(worth).sum();
            let goes_on = all.min(1.0);
            let mut chance = random.next() / goes_on * all;
            let next = places.into_iter().find(|place| {
                chance -= worth(place);
                chance < 0.0
            });
            let Some(next) = next else { return sum };
            share *= next.2 * (all / worth(&next) / goes_on);
            (surface, x) = (next.0, next.1);
            // ANCHOR_END: walk
        }
    }

    /// One ray from `x`: the light that it finds, W/m², but for what is summed as direct;
    /// and the sides where light may have come from, each with its share.
    fn step(
        &self,
        surface: u32,
        x: DVec3,
        random: &mut Stream,
    ) -> (Rgb, Vec<(u32, DVec3, Rgb)>) {
        let polygon = &self.scene.surfaces[surface as usize].polygon;
        let frame = Frame::about(polygon.normal());
        let mut ray =
            ray_from(polygon, &frame, [0.0, 0.0, random.next(), random.next()]);
        ray.origin = x;
        let (mut light, mut places) = (Rgb::ZERO, Vec::new());
        self.rays.follow((ray, Some(surface)), random, &mut |arrival| {
            let Arrival { met, weight, chain, .. } = arrival;
            match *met {
                Met::Surface { surface, point, front: true, .. } => {
                    let side = &self.scene.surfaces[surface as usize];
                    let material = self.scene.material(side);
                    if !self.direct.follows(chain) {
                        light += weight * material.emission();
                    }
                    places.push((surface, point, weight * material.diffuse()));
                    if let Some(back) = side.back {
                        places.push((back, point, weight * material.translucence()));
                    }
                }
                Met::Sky(direction) => {
                    light += weight * PI * self.direct.other_sky(direction, chain);
                }
                _ => {}
            }
        });
        (light, places)
    }
}
