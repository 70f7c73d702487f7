//! The linear system of the patches: what their corners see, and what light that makes.

use super::anderson::Anderson;
use super::onward::{Beyond, Coloured, Onward};
use super::{INSIDE, MOST_ROUNDS, Smooth};
use crate::form_factor::linear::{Linear, Moments, Sight, Slopes, sent};
use crate::geometry::Rgb;
use crate::mesh::{Backs, Element, Mesh, Place};
use crate::room::Direct;
use crate::scene::Scene;
use crate::solve::LostPower;
use crate::solve::{Enclosure, Ledger};
use crate::work::Progress;
use glam::DVec3;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The mean over each patch of what its elements have.
fn means(mesh: &Mesh, of_elements: &[Rgb], patches: usize) -> Vec<Rgb> {
    let mut sums = vec![(Rgb::ZERO, 0.0); patches];
    for (element, &value) in mesh.elements.iter().zip(of_elements) {
        let (sum, area) = &mut sums[element.patch.0 as usize];
        *sum += element.polygon.area() * value;
        *area += element.polygon.area();
    }
    sums.into_iter().map(|(sum, area)| sum / area).collect()
}

/// What is seen from a corner of a patch.
#[derive(Clone, Debug, Default)]
pub(super) struct Corner {
    /// `H`, W/m², of light that was reflected once, and of the sky.
    once: Rgb,
    /// What of it is the sky's.
    sky: Rgb,
    /// How it sees the patches, which send light that was reflected more often.
    patches: Vec<(u32, Moments)>,
    /// How it sees them by mirrors and through panes.
    beyond: Vec<(u32, Coloured)>,
    lost: LostPower,
}

impl Corner {
    /// Was anything seen?
    fn looked(&self) -> bool {
        !self.patches.is_empty() || !self.beyond.is_empty() || self.lost.any()
    }

    /// `H`, W/m², when patch `k` sends the light `of[k]` beside what it reflected once.
    pub(super) fn irradiance(&self, of: &[Slopes]) -> Rgb {
        let straight = self.patches.iter().map(|(k, m)| sent(&of[*k as usize], m));
        let beyond = self.beyond.iter().map(|(k, m)| {
            let b = &of[*k as usize];
            b.iter().zip(m).map(|(b, m)| b * m).sum()
        });
        self.once + straight.chain(beyond).sum::<Rgb>()
    }
}

/// Irradiance at the vertices of a mesh, and that of the other sides in the same places.
pub(super) struct Lit {
    pub front: Vec<Rgb>,
    pub back: Vec<Rgb>,
}

impl Lit {
    pub fn new(front: &[Rgb], backs: &Backs) -> Lit {
        Lit { front: front.to_vec(), back: backs.apply(front) }
    }
}

/// What patches do with light.
struct Scattering {
    reflectance: Vec<Rgb>,
    translucence: Vec<Rgb>,
}

impl Scattering {
    /// `ρ H + τ H_back` on patch `k`, of what `of` makes of the values of either side.
    fn slopes(&self, k: usize, lit: &Lit, of: impl Fn(&[Rgb]) -> Slopes) -> Slopes {
        let mut b = of(&lit.front).map(|h| self.reflectance[k] * h);
        if self.translucence[k] != Rgb::ZERO {
            let through = of(&lit.back).map(|h| self.translucence[k] * h);
            b.iter_mut().zip(through).for_each(|(b, t)| *b += t);
        }
        b
    }

    /// The same of single values.
    fn of(&self, k: usize, front: Rgb, back: Rgb) -> Rgb {
        self.reflectance[k] * front + self.translucence[k] * back
    }
}

/// The linear system of the patches; the unknown is the reflected light at their corners.
pub(super) struct System<'a> {
    patches: &'a Mesh,
    enclosure: Enclosure,
    scattering: Scattering,
    backs: Backs,
    linear: Linear<'a>,
    onward: Onward<'a>,
    direct: &'a Direct<'a>,
    /// The direct light on the elements of the patches.
    fine: (&'a Mesh, Lit),
    /// `ρ H_direct`, and the emission if it is not summed exactly: of patches.
    once: Vec<Slopes>,
    /// The same of elements.
    once_by_element: Vec<Slopes>,
    /// `E + ρ H_direct`, mean of each patch.
    first: Vec<Rgb>,
    /// Reflected light, mean of each patch above that of its corners; of the light that it
    /// sends.
    bulge: Vec<Rgb>,
    /// T-vertices see nothing.
    pub(super) corners: Vec<Corner>,
}

impl<'a> System<'a> {
    /// The system, given `light`, the direct light at the vertices of `fine`, the patches
    /// split.
    pub(super) fn new(
        scene: &'a Scene,
        patches: &'a Mesh,
        (fine, light): (&'a Mesh, &[Rgb]),
        direct: &'a Direct<'a>,
        hemicube: u32,
    ) -> System<'a> {
        let linear = Linear::new(patches, fine, hemicube);
        let linear = linear.telling(Onward::marks(scene, patches));
        let enclosure = Enclosure::of(scene, patches);
        let translucence = |e: &Element| {
            let material = patches.patch_of(e).material.0 as usize;
            scene.materials[material].translucence()
        };
        let scattering = Scattering {
            reflectance: enclosure.reflectance.clone(),
            translucence: patches.elements.iter().map(translucence).collect(),
        };
        let lit = Lit::new(light, &Backs::of(scene, fine));
        let backs = Backs::of(scene, patches);
        let mut at_corners = light[..patches.vertices.len()].to_vec();
        patches.anchor(&mut at_corners);
        let at_corners = Lit::new(&at_corners, &backs);
        let mean =
            |of: &[Rgb]| means(fine, &fine.element_means(of), patches.elements.len());
        let arriving = [mean(&lit.front), mean(&lit.back)];
        let reflected = |k: usize| scattering.of(k, arriving[0][k], arriving[1][k]);
        let emission = &enclosure.emission;
        let seen = |k: usize| match direct.sums_emitters() {
            true => Rgb::ZERO,
            false => emission[k],
        };
        let of_patch = |k: usize| {
            let mut b = scattering.slopes(k, &at_corners, |h| linear.of_patch(k, h));
            b[0] += reflected(k) - linear.mean(k, &b) + seen(k);
            b
        };
        let of_element = |(e, element): (usize, &Element)| {
            let k = element.patch.0 as usize;
            let mut b = scattering.slopes(k, &lit, |h| linear.of_element(e, h));
            b[0] += seen(k);
            b
        };
        let all = 0..patches.elements.len();
        System {
            once: all.clone().map(of_patch).collect(),
            once_by_element: fine.elements.iter().enumerate().map(of_element).collect(),
            first: all.map(|k| emission[k] + reflected(k)).collect(),
            bulge: vec![Rgb::ZERO; patches.elements.len()],
            corners: Vec::new(),
            onward: Onward::new(scene, fine),
            fine: (fine, lit),
            patches,
            enclosure,
            scattering,
            backs,
            linear,
            direct,
        }
    }

    pub(super) fn patches(&self) -> &'a Mesh {
        self.patches
    }

    pub(super) fn places(&self) -> Vec<DVec3> {
        let places = self.patches.places(INSIDE).into_iter();
        places.map(|place| place.map_or(DVec3::NAN, |place| place.at)).collect()
    }

    /// What a point with this unit normal sees.
    pub(super) fn seen_from(&self, point: DVec3, normal: DVec3) -> Corner {
        let Sight { patches, whole, elements, onwards, sky, lost } =
            self.linear.seen_from(point, normal);
        let of_patch = |place: &u32| {
            let (k, m) = &patches[*place as usize];
            sent(&self.once[*k as usize], m)
        };
        let of_element =
            |(e, m): &(u32, Moments)| sent(&self.once_by_element[*e as usize], m);
        let once = whole.iter().map(of_patch).sum::<Rgb>()
            + elements.iter().map(of_element).sum::<Rgb>();
        let sky_light = self.onward.sky(self.direct, &sky);
        let beyond = match onwards.is_empty() {
            true => Beyond::default(),
            false => self.beyond(point, &onwards),
        };
        let mut all_lost = beyond.lost;
        all_lost.add(Rgb::ONE, lost);
        all_lost.escaped += Rgb::splat(sky.iter().map(|cell| cell.1).sum());
        Corner {
            once: once + sky_light + beyond.once,
            sky: sky_light + beyond.sky,
            patches,
            beyond: beyond.patches,
            lost: all_lost,
        }
    }

    fn beyond(&self, point: DVec3, cells: &[(DVec3, f64)]) -> Beyond {
        let (fine, lit) = &self.fine;
        let once = |element: u32, at: DVec3| {
            let element = &fine.elements[element as usize];
            let value = |h: &[Rgb]| fine.value_at(element, at, h);
            let k = element.patch.0 as usize;
            self.scattering.of(k, value(&lit.front), value(&lit.back))
        };
        self.onward.beyond(point, cells, &self.linear, self.direct, &once)
    }

    /// Looks from all corners, or from those of emitters only, which tell what escapes; how
    /// many that are.
    pub(super) fn look(&mut self, from_all: bool, progress: Progress) -> usize {
        let places = self.patches.places(INSIDE);
        let (all, done) = (places.len(), AtomicUsize::new(0));
        let wanted = |place: &&Place| {
            let k = place.element as usize;
            from_all || self.enclosure.emission[k] != Rgb::ZERO
        };
        let looks = places.iter().flatten().filter(wanted).count();
        let look = |place: &Option<Place>| {
            progress("hemicubes", done.fetch_add(1, Ordering::Relaxed) + 1, all);
            place.as_ref().filter(wanted).map_or_else(Corner::default, |place| {
                let element = &self.patches.elements[place.element as usize];
                self.seen_from(place.at, element.polygon.normal())
            })
        };
        self.corners = places.par_iter().map(look).collect();
        looks
    }

    /// What each patch sends of light that was reflected more than once, from the reflected
    /// light at the corners.
    pub(super) fn reflected_slopes(&self, reflected: &[Rgb]) -> Vec<Slopes> {
        let lit = Lit::new(reflected, &self.backs);
        let of_patch = |(k, &bulge): (usize, &Rgb)| {
            let mut b = self.scattering.slopes(k, &lit, |h| self.linear.of_patch(k, h));
            b[0] += bulge;
            b
        };
        self.bulge.iter().enumerate().map(of_patch).collect()
    }

    /// Finds the bulges from `light` at the vertices of `mesh`, the patches split.
    pub(super) fn bulge_of(&mut self, scene: &Scene, mesh: &Mesh, light: &[Rgb]) {
        let corners = Lit::new(&light[..self.patches.vertices.len()], &self.backs);
        let lit = Lit::new(light, &Backs::of(scene, mesh));
        let mean = |of| means(mesh, &mesh.element_means(of), self.bulge.len());
        let (front, back) = (mean(&lit.front), mean(&lit.back));
        let of_patch = |k: usize| {
            let linear = |h: &[Rgb]| self.linear.of_patch(k, h);
            let b = self.scattering.slopes(k, &corners, linear);
            self.scattering.of(k, front[k], back[k]) - self.linear.mean(k, &b)
        };
        self.bulge = (0..self.bulge.len()).map(of_patch).collect();
    }

    /// `B`, W/m², mean over each patch.
    fn mean_radiosity(&self, reflected: &[Rgb]) -> Vec<Rgb> {
        let slopes = self.reflected_slopes(reflected).into_iter().zip(&self.first);
        slopes
            .enumerate()
            .map(|(k, (b, &first))| first + self.linear.mean(k, &b))
            .collect()
    }

    /// `‖B − E‖²`.
    pub(super) fn reflected_light(&self, reflected: &[Rgb]) -> Rgb {
        let b = self.mean_radiosity(reflected).into_iter();
        self.enclosure
            .norm_squared(b.zip(&self.enclosure.emission).map(|(b, &e)| b - e))
    }

    /// The reflected light at the corners, the solver's residual and its rounds.
    pub(super) fn solve(
        &self,
        enough: f64,
        start: &[Rgb],
        progress: Progress,
    ) -> (Vec<Rgb>, f64, usize) {
        let mut anderson = Anderson::default();
        let mut reflected = start.to_vec();
        let rho = self.contraction();
        let mut residual = f64::INFINITY;
        for round in 0..MOST_ROUNDS {
            progress("solving", round, MOST_ROUNDS);
            let slopes = self.reflected_slopes(&reflected);
            let gather = |corner: &Corner| corner.irradiance(&slopes);
            let mut next: Vec<Rgb> = self.corners.par_iter().map(gather).collect();
            self.patches.anchor(&mut next);
            let (old, new) =
                (self.mean_radiosity(&reflected), self.mean_radiosity(&next));
            let change: Vec<Rgb> = new.iter().zip(&old).map(|(n, o)| n - o).collect();
            residual = self.enclosure.relative_residual(&change, &old);
            if residual <= enough * (1.0 - rho) {
                return (reflected, residual, round);
            }
            reflected = anderson.next(&reflected, &next);
        }
        (reflected, residual, MOST_ROUNDS)
    }

    /// `max (ρ + τ)`.
    fn contraction(&self) -> f64 {
        let Scattering { reflectance, translucence } = &self.scattering;
        let both = reflectance.iter().zip(translucence).map(|(r, t)| r + t);
        both.fold(Rgb::ZERO, Rgb::max).max_element()
    }

    /// Where the light of the field on `mesh` went; `source` tells the patch of an
    /// element. Unshot is by how much the field differs from what the patches sent.
    ///
    /// What mirrors and panes send on is counted by who sent it.
    pub(super) fn ledger(
        &self,
        scene: &Scene,
        field: &Smooth,
        reflected: &[Rgb],
        source: &dyn Fn(&Element) -> usize,
    ) -> Ledger {
        let sent = self.mean_radiosity(reflected);
        let mesh = &field.mesh;
        let fine = Enclosure::of(scene, mesh);
        let irradiance = mesh.element_means(&field.irradiance);
        let behind = mesh.element_means(&field.behind);
        let unshot = |(k, e): (usize, &Element)| {
            field.radiosity(scene, e, [irradiance[k], behind[k]]) - sent[source(e)]
        };
        let unshot: Vec<Rgb> = mesh.elements.iter().enumerate().map(unshot).collect();
        let mut power = LostPower::default();
        let mut sky = Rgb::ZERO;
        for (k, element) in self.patches.elements.iter().enumerate() {
            let corners = element.corners.iter().map(|c| &self.corners[c.0 as usize]);
            let looks: Vec<&Corner> = corners.filter(|c| c.looked()).collect();
            for corner in &looks {
                let share = self.enclosure.area[k] / looks.len() as f64;
                power.escaped += share * sent[k] * corner.lost.escaped;
                power.absorbed += share * sent[k] * corner.lost.absorbed;
                sky += share * corner.sky;
            }
        }
        for (k, element) in mesh.elements.iter().enumerate() {
            sky += fine.area[k] * self.direct.of_sky(&element.polygon);
        }
        let mut ledger = Ledger::draw_up(&fine, &irradiance, &unshot, power);
        ledger.emitted += sky;
        ledger.imbalance += sky;
        ledger
    }
}
