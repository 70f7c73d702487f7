//! What a patch corner sees by mirrors, through panes, and of the sky.
//!
//! ```text
//! H = Σ_cells ΔF Σ_k w_k B_k(x_k) + π L_sky        along the ray that goes on from a cell
//! ```
//! The cells of a hemicube that show a mirror, a pane, glass or gloss are not at their end.
//! Some of them, spread evenly, send a ray onwards ([`Specular`]); what it meets is seen
//! instead.

use crate::form_factor::linear::{Linear, Moments, Onwards};
use crate::geometry::{Ray, Rgb};
use crate::material::Shine;
use crate::mesh::Mesh;
use crate::random::Stream;
use crate::room::Direct;
use crate::scene::{Scene, Surface};
use crate::solve::LostPower;
use crate::specular::{Arrival, Branching, Carries, Chain, Met, Specular};
use glam::DVec3;
use std::f64::consts::PI;

/// Moments per channel.
pub(super) type Coloured = [Rgb; 4];

/// Rays that a whole hemicube of flat mirrors would send onwards.
const RAYS: f64 = 512.0;

/// The same where gloss or glass bends them: these have to find the lamps, too, which flat
/// mirrors show as images.
const RAYS_BENT: f64 = 2048.0;

/// What the rays of a corner found.
#[derive(Clone, Debug, Default)]
pub(super) struct Beyond {
    /// `H`, W/m², of lamps, of the sky, and of light that was reflected once.
    pub once: Rgb,
    /// What of it is the sky's.
    pub sky: Rgb,
    /// How patches are seen that send light which was reflected more often.
    pub patches: Vec<(u32, Coloured)>,
    /// Shares of what is sent this way.
    pub lost: LostPower,
}

/// The scene as rays meet it, in elements.
pub(super) struct Onward<'a> {
    scene: &'a Scene,
    elements: &'a Mesh,
    rays: Specular<'a>,
    /// How many a whole hemicube sends onwards.
    density: f64,
}

impl<'a> Onward<'a> {
    pub fn new(scene: &'a Scene, elements: &'a Mesh) -> Onward<'a> {
        let pieces = elements.elements.iter();
        let pieces = pieces.map(|e| (elements.surface_of(e), &e.polygon));
        let bends = |s: &Surface| {
            matches!(
                scene.material(s).shine(),
                Shine::Gloss { .. } | Shine::Glass { .. }
            )
        };
        let density = if scene.surfaces.iter().any(bends) { RAYS_BENT } else { RAYS };
        let rays = Specular::of_pieces(scene, pieces);
        Onward { scene, elements, rays, density }
    }

    /// Which patches rays go on from.
    pub fn marks(scene: &Scene, patches: &Mesh) -> Onwards {
        let shine = |k: usize| {
            let surface = patches.surface_of(&patches.elements[k]) as usize;
            scene.material(&scene.surfaces[surface]).shine()
        };
        let all = 0..patches.elements.len();
        Onwards {
            fronts: all.clone().map(|k| !shine(k).is_dull()).collect(),
            backs: all.map(|k| shine(k).passes()).collect(),
            sky: scene.sky.is_some(),
        }
    }

    /// The light of the sky in these cells, W/m².
    pub fn sky(&self, direct: &Direct, cells: &[(DVec3, f64)]) -> Rgb {
        let radiance = |d: DVec3| direct.other_sky(d, &Chain::default());
        cells.iter().map(|&(d, f)| PI * f * radiance(d)).sum()
    }

    /// What is found beyond these cells. `once` is the radiosity of an element at a point:
    /// its light that was reflected once.
    pub fn beyond(
        &self,
        point: DVec3,
        cells: &[(DVec3, f64)],
        linear: &Linear,
        direct: &Direct,
        once: &dyn Fn(u32, DVec3) -> Rgb,
    ) -> Beyond {
        let mut found = Beyond::default();
        let name = point.to_array().map(f64::to_bits);
        let mut random = Stream::named(0, &name);
        let (mut sum, mut next) = (0.0, random.next() / self.density);
        for &(direction, share) in cells {
            sum += share;
            while sum > next {
                next += 1.0 / self.density;
                let ray = Ray { origin: point, direction };
                let how = (Branching::One, Carries::Radiance);
                self.rays.follow((ray, None), how, &mut random, &mut |arrival| {
                    self.add(arrival, linear, direct, once, &mut found);
                });
            }
        }
        found.patches.sort_unstable_by_key(|p| p.0);
        found.patches.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1.iter_mut().zip(next.1).for_each(|(sum, m)| *sum += m);
            }
            same
        });
        found
    }

    fn add(
        &self,
        arrival: &Arrival,
        linear: &Linear,
        direct: &Direct,
        once: &dyn Fn(u32, DVec3) -> Rgb,
        found: &mut Beyond,
    ) {
        let &Arrival { met, weight, chain } = arrival;
        let weight = weight / self.density;
        let first = chain == Chain::default();
        if !first {
            found.lost.absorbed -= weight; // it went on from where it had arrived
        }
        match met {
            Met::Sky(direction) => {
                found.lost.escaped += weight;
                let light = PI * direct.other_sky(direction, &chain);
                found.once += weight * light;
                found.sky += weight * light;
            }
            Met::Cut => found.lost.absorbed += weight,
            Met::Surface { surface, piece, point, front } => {
                let surface = &self.scene.surfaces[surface as usize];
                let material = self.scene.material(surface);
                if !front {
                    found.lost.absorbed += weight; // of a front the irradiance tells
                }
                if first || !front {
                    return;
                }
                if !direct.sums(&chain) {
                    found.once += weight * material.emission();
                }
                if material.scattered() != Rgb::ZERO {
                    found.once += weight * once(piece, point);
                    let patch = self.elements.elements[piece as usize].patch.0;
                    let m: Moments = linear.moments_at(patch as usize, point);
                    found.patches.push((patch, m.map(|m| m * weight)));
                }
            }
        }
    }
}
