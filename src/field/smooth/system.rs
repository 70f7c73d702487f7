//! The linear system of the patches: what their corners see, and what light that makes.
//!
//! ```text
//! H_v = H₁,v + Σ_p Σ_k b_k(p) m_k(v, p)        irradiance at the corner v: reflected light
//! b(p) = ρ_p (H at the corners of p) + τ_p (H_back there) + c_p
//! ```
//! `H₁` is known before: what was reflected once, and the sky. The correction `c_p` makes up
//! for light that is not linear across the patch, once that is known.

use super::anderson::Anderson;
use super::first_bounce::FirstBounce;
use super::patches::{BothSides, SmoothPatches};
use super::specular::{RgbMoments, SpecularTransport, SpecularView};
use super::{INSIDE, MOST_ROUNDS};
use crate::form_factor::linear::{Linear, Moments, Slopes, sent};
use crate::geometry::Rgb;
use crate::mesh::{Backs, Mesh, PatchId, Place, TwoLevels};
use crate::room::{Direct, Room};
use crate::scene::Scene;
use crate::solve::LostPower;
use crate::work::Progress;
use glam::DVec3;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A row of the system: what is seen from one corner.
#[derive(Clone, Debug, Default)]
pub(super) struct CornerRow {
    /// `H₁`, W/m²: of light that was reflected once, and of the sky.
    known: Rgb,
    /// What of it is the sky's.
    pub sky: Rgb,
    /// How it sees the patches, which send light that was reflected more often.
    patches: Vec<(PatchId, Moments)>,
    /// How it sees them by mirrors and through panes.
    by_mirrors: Vec<(PatchId, RgbMoments)>,
    pub lost: LostPower,
}

impl CornerRow {
    /// Was anything seen?
    pub fn looked(&self) -> bool {
        !self.patches.is_empty() || !self.by_mirrors.is_empty() || self.lost.any()
    }

    /// `H`, W/m², when each patch sends this light beside what it reflected once.
    pub fn irradiance(&self, of_patches: &[Slopes]) -> Rgb {
        let straight = self.patches.iter().map(|(k, m)| sent(&of_patches[*k], m));
        let by_mirrors = self.by_mirrors.iter().map(|(k, m)| {
            let b = &of_patches[*k];
            b.iter().zip(m).map(|(b, m)| b * m).sum()
        });
        self.known + straight.chain(by_mirrors).sum::<Rgb>()
    }
}

/// The linear system; the unknown is the reflected light at the corners of the patches.
pub(super) struct System<'a> {
    pub patches: SmoothPatches<'a>,
    pub direct: &'a Direct<'a>,
    first: FirstBounce,
    specular: SpecularTransport<'a>,
    /// `c`, W/m², of each patch: the mean of what it reflects more than once, above that of
    /// the linear light from its corners.
    mean_correction: Vec<Rgb>,
    /// T-vertices see nothing.
    pub rows: Vec<CornerRow>,
}

impl<'a> System<'a> {
    /// The system, given the direct light at the vertices of the elements.
    pub fn new<'r: 'a>(
        room: &'a Room<'r>,
        levels: &'a TwoLevels<'a>,
        light: &[Rgb],
        hemicube: u32,
    ) -> System<'a> {
        let (scene, direct) = (room.scene, room.lamps());
        let followed = SpecularTransport::followed(scene, levels.patches());
        let hemicubes = Linear::new(levels, hemicube).following(followed);
        let patches = SmoothPatches::of(scene, levels, hemicubes);
        System {
            first: FirstBounce::of(scene, &patches, light),
            specular: SpecularTransport::new(room, levels.elements()),
            mean_correction: vec![Rgb::ZERO; patches.enclosure.len()],
            rows: Vec::new(),
            patches,
            direct,
        }
    }

    /// The mesh whose elements are the patches.
    pub fn mesh(&self) -> &'a Mesh {
        self.patches.levels.patches()
    }

    /// From where the corners look.
    pub fn places(&self) -> Vec<DVec3> {
        let places = self.mesh().places(INSIDE).into_iter();
        places.map(|place| place.map_or(DVec3::NAN, |place| place.at)).collect()
    }

    /// What a point with this unit normal sees.
    pub fn seen_from(&self, point: DVec3, normal: DVec3) -> CornerRow {
        let mut view = self.patches.hemicubes.seen_from(point, normal);
        self.specular.close_cracks(point, &mut view.sky);
        let first = self.first.irradiance(&view);
        let sky = self.specular.sky(&view.sky);
        let onwards = match view.followed.is_empty() {
            true => SpecularView::default(),
            false => {
                let (patches, first) = (&self.patches, &self.first);
                self.specular.seen_through(point, &view.followed, patches, first)
            }
        };
        let mut lost = onwards.lost;
        lost.add(Rgb::ONE, view.lost);
        lost.escaped += Rgb::splat(view.sky.iter().map(|cell| cell.1).sum());
        CornerRow {
            known: first + sky + onwards.known,
            sky: sky + onwards.sky,
            patches: view.patches,
            by_mirrors: onwards.patches,
            lost,
        }
    }

    /// Looks from all corners, or from those of emitters only, which tell what escapes; how
    /// many that are.
    pub fn look(&mut self, from_all: bool, progress: Progress) -> usize {
        let places = self.mesh().places(INSIDE);
        let (all, done) = (places.len(), AtomicUsize::new(0));
        let wanted = |place: &&Place| {
            let k = place.element as usize;
            from_all || self.patches.enclosure.emission[k] != Rgb::ZERO
        };
        let looks = places.iter().flatten().filter(wanted).count();
        let look = |place: &Option<Place>| {
            progress("hemicubes", done.fetch_add(1, Ordering::Relaxed) + 1, all);
            place.as_ref().filter(wanted).map_or_else(CornerRow::default, |place| {
                let element = &self.mesh().elements[place.element as usize];
                self.seen_from(place.at, element.polygon.normal())
            })
        };
        self.rows = places.par_iter().map(look).collect();
        looks
    }

    /// What each patch sends of light that was reflected more than once, from the reflected
    /// light at the corners.
    pub fn reflected_slopes(&self, reflected: &[Rgb]) -> Vec<Slopes> {
        let at_corners = self.patches.both_sides(reflected);
        let of_patch = |k| {
            let mut b = self.patches.slopes(k, &at_corners);
            b[0] += self.mean_correction[k];
            b
        };
        self.patches.ids().map(of_patch).collect()
    }

    /// Corrects the means of what patches send, from the reflected `light` at the vertices
    /// of elements that follow it more closely.
    pub fn correct_means(&mut self, scene: &Scene, finer: &TwoLevels, light: &[Rgb]) {
        let at_corners = self.patches.both_sides(finer.at_patch_corners(light));
        let mesh = finer.elements();
        let lit = BothSides::new(light, &Backs::of(scene, mesh));
        let [front, back] = lit.element_means(mesh).map(|h| finer.patch_means(&h));
        let of_patch = |k| {
            let b = self.patches.slopes(k, &at_corners);
            self.patches.scattered(k, [front[k], back[k]])
                - self.patches.hemicubes.mean(k, &b)
        };
        self.mean_correction = self.patches.ids().map(of_patch).collect();
    }

    /// `B`, W/m², mean over each patch.
    pub fn mean_radiosity(&self, reflected: &[Rgb]) -> Vec<Rgb> {
        let slopes = self.reflected_slopes(reflected);
        let mean = |k| self.first.means[k] + self.patches.hemicubes.mean(k, &slopes[k]);
        self.patches.ids().map(mean).collect()
    }

    /// `‖B − E‖²`.
    pub fn reflected_light(&self, reflected: &[Rgb]) -> Rgb {
        let enclosure = &self.patches.enclosure;
        let b = self.mean_radiosity(reflected).into_iter().zip(&enclosure.emission);
        enclosure.norm_squared(b.map(|(b, &e)| b - e))
    }

    /// The reflected light at the corners, the solver's residual and its rounds.
    pub fn solve(
        &self,
        enough: f64,
        start: &[Rgb],
        progress: Progress,
    ) -> (Vec<Rgb>, f64, usize) {
        let mut anderson = Anderson::default();
        let mut reflected = start.to_vec();
        let rho = self.patches.contraction();
        let mut residual = f64::INFINITY;
        for round in 0..MOST_ROUNDS {
            progress("solving", round, MOST_ROUNDS);
            let slopes = self.reflected_slopes(&reflected);
            let gather = |row: &CornerRow| row.irradiance(&slopes);
            let mut next: Vec<Rgb> = self.rows.par_iter().map(gather).collect();
            self.mesh().anchor(&mut next);
            let (old, new) =
                (self.mean_radiosity(&reflected), self.mean_radiosity(&next));
            let change: Vec<Rgb> = new.iter().zip(&old).map(|(n, o)| n - o).collect();
            residual = self.patches.enclosure.relative_residual(&change, &old);
            if residual <= enough * (1.0 - rho) {
                return (reflected, residual, round);
            }
            reflected = anderson.next(&reflected, &next);
        }
        (reflected, residual, MOST_ROUNDS)
    }
}
