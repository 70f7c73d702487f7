//! What a patch corner sees by mirrors, through panes, and of the sky.
//!
//! ```text
//! H = Σ_cells ΔF Σ_k w_k B_k(x_k) + π L_sky        along the ray that goes on from a cell
//! ```
//! The cells of a hemicube that show a mirror, a pane, glass or gloss are not at their end.
//! Some of them, spread evenly, send a ray onwards ([`Specular`]); what it meets is seen
//! instead.

use super::first_bounce::FirstBounce;
use super::patches::SmoothPatches;
use crate::form_factor::linear::{Followed, Moments};
use crate::geometry::{Ray, Rgb};
use crate::mesh::{ElementId, Locator, Mesh, PatchId};
use crate::random::Stream;
use crate::room::{Direct, Room};
use crate::scene::{Scene, Surface};
use crate::solve::LostPower;
use crate::ways::{Arrival, Chain, Met, Specular};
use glam::DVec3;
use std::f64::consts::PI;

/// Moments per channel: with the colour of the mirrors and panes on the way.
pub(super) type RgbMoments = [Rgb; 4];

/// Rays that a whole hemicube of flat mirrors would send onwards.
const RAYS: f64 = 512.0;

/// The same where gloss or glass bends them: these have to find the lamps, too, which flat
/// mirrors show as images.
const RAYS_BENT: f64 = 2048.0;

/// More cells of one hemicube that show the sky are no cracks between outlines.
const MOST_CRACKS: usize = 64;

/// Off the middle of a cell, where regular outlines may meet; far less than a cell.
const BESIDE: DVec3 = DVec3::new(1.9e-6, 2.9e-6, 3.7e-6);

/// What a point sees by mirrors and through panes.
#[derive(Clone, Debug, Default)]
pub(super) struct SpecularView {
    /// `H`, W/m², of lamps, of the sky, and of light that was reflected once.
    pub known: Rgb,
    /// What of it is the sky's.
    pub sky: Rgb,
    /// How patches are seen that send light which was reflected more often.
    pub patches: Vec<(PatchId, RgbMoments)>,
    /// Shares of what is sent this way.
    pub lost: LostPower,
}

/// Mirrors, panes, glass and gloss, as the rays of hemicubes meet them.
pub(super) struct SpecularTransport<'a> {
    scene: &'a Scene,
    direct: &'a Direct<'a>,
    rays: Specular<'a>,
    elements: &'a Mesh,
    locator: Locator,
    /// How many a whole hemicube sends onwards.
    density: f64,
}

impl<'a> SpecularTransport<'a> {
    /// What rays meet is told as a place on an element of the mesh.
    pub fn new<'r: 'a>(
        room: &'a Room<'r>,
        elements: &'a Mesh,
    ) -> SpecularTransport<'a> {
        let (scene, direct) = (room.scene, room.lamps());
        let pieces = elements.elements.iter();
        let pieces = pieces.map(|e| (elements.surface_of(e), &e.polygon));
        let locator = Locator::of(scene, pieces);
        let bends = |s: &Surface| scene.material(s).shine().bends();
        let density = if scene.surfaces.iter().any(bends) { RAYS_BENT } else { RAYS };
        let rays = Specular::through(scene, room.visibility(), room.solids());
        SpecularTransport { scene, direct, rays, elements, locator, density }
    }

    /// Which patches rays go on from.
    pub fn followed(scene: &Scene, patches: &Mesh) -> Followed {
        let shines =
            || patches.elements.iter().map(|e| patches.material(scene, e).shine());
        Followed {
            fronts: shines().map(|shine| !shine.is_dull()).collect(),
            backs: shines().map(|shine| shine.passes()).collect(),
            sky: scene.sky.is_some(),
        }
    }

    /// Drops the cells that do not show the sky: where two outlines meet, the item buffer may
    /// leave a cell open that a ray finds closed. Many cells are no cracks.
    pub fn close_cracks(&self, point: DVec3, cells: &mut Vec<(DVec3, f64)>) {
        if cells.len() > MOST_CRACKS {
            return;
        }
        cells.retain(|&(direction, _)| {
            let ray =
                Ray { origin: point, direction: (direction + BESIDE).normalize() };
            self.rays.visibility().closest(&ray, None).is_none()
        });
    }

    /// The light of the sky in these cells, W/m².
    pub fn sky(&self, cells: &[(DVec3, f64)]) -> Rgb {
        let radiance = |d: DVec3| self.direct.other_sky(d, &Chain::default());
        cells.iter().map(|&(d, f)| PI * f * radiance(d)).sum()
    }

    /// What is seen from a point when the rays through these cells are followed.
    pub fn seen_through(
        &self,
        point: DVec3,
        cells: &[(DVec3, f64)],
        patches: &SmoothPatches,
        first: &FirstBounce,
    ) -> SpecularView {
        let mut seen = SpecularView::default();
        let name = point.to_array().map(f64::to_bits);
        let mut random = Stream::named(0, &name);
        let (mut sum, mut next) = (0.0, random.next() / self.density);
        for &(direction, share) in cells {
            sum += share;
            while sum > next {
                next += 1.0 / self.density;
                let ray = Ray { origin: point, direction };
                self.rays.follow((ray, None), &mut random, &mut |arrival| {
                    self.add(arrival, patches, first, &mut seen);
                });
            }
        }
        seen.patches.sort_unstable_by_key(|p| p.0);
        seen.patches.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1.iter_mut().zip(next.1).for_each(|(sum, m)| *sum += m);
            }
            same
        });
        seen
    }

    fn add(
        &self,
        arrival: &Arrival,
        patches: &SmoothPatches,
        first: &FirstBounce,
        seen: &mut SpecularView,
    ) {
        let &Arrival { met, weight, chain, .. } = arrival;
        let weight = weight / self.density;
        let straight = chain == Chain::default();
        if !straight {
            seen.lost.absorbed -= weight; // it went on from where it had arrived
        }
        match met {
            Met::Sky(direction) => {
                seen.lost.escaped += weight;
                let light = PI * self.direct.other_sky(direction, &chain);
                seen.known += weight * light;
                seen.sky += weight * light;
            }
            Met::Cut => seen.lost.absorbed += weight,
            Met::Surface { surface: id, point, front } => {
                let surface = &self.scene.surfaces[id as usize];
                let material = self.scene.material(surface);
                if !front {
                    seen.lost.absorbed += weight; // of a front the irradiance tells
                }
                if straight || !front {
                    return;
                }
                if !self.direct.follows(&chain) {
                    seen.known += weight * material.emission();
                }
                let outline = |k: u32| &self.elements.element(ElementId(k)).polygon;
                let element = self.locator.piece(id, point, outline).map(ElementId);
                if let Some(element) =
                    element.filter(|_| material.scattered() != Rgb::ZERO)
                {
                    seen.known += weight * first.at(patches, element, point);
                    let patch = patches.levels.elements().element(element).patch;
                    let m: Moments = patches.hemicubes.moments_at(patch, point);
                    seen.patches.push((patch, m.map(|m| m * weight)));
                }
            }
        }
    }
}
