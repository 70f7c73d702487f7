//! The linear system of the patches: what their corners see, and what light that makes.

use super::anderson::Anderson;
use super::{INSIDE, MOST_ROUNDS};
use crate::form_factor::Lost;
use crate::form_factor::linear::{Linear, Moments, Sight, Slopes, sent};
use crate::geometry::Rgb;
use crate::mesh::{Element, Mesh, Place};
use crate::scene::Scene;
use crate::solve::ledger::LostPower;
use crate::solve::{Direct, Enclosure, Ledger, Progress};
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
    /// `H`, W/m², of light that was reflected once.
    once: Rgb,
    /// How it sees the patches, which send light that was reflected more often.
    patches: Vec<(u32, Moments)>,
    lost: Lost,
}

impl Corner {
    /// `H`, W/m², when patch `k` sends the light `of[k]` beside what it reflected once.
    pub(super) fn irradiance(&self, of: &[Slopes]) -> Rgb {
        let more: Rgb =
            self.patches.iter().map(|(k, m)| sent(&of[*k as usize], m)).sum();
        self.once + more
    }
}

/// The linear system of the patches; the unknown is the reflected light at their corners.
pub(super) struct System<'a> {
    patches: &'a Mesh,
    enclosure: Enclosure,
    linear: Linear<'a>,
    /// `ρ H_direct`, and the emission if it is not summed exactly: of patches.
    once: Vec<Slopes>,
    /// The same of elements.
    once_by_element: Vec<Slopes>,
    /// `E + ρ H_direct`, mean of each patch.
    first: Vec<Rgb>,
    /// Reflected light, mean of each patch above that of its corners.
    bulge: Vec<Rgb>,
    /// T-vertices see nothing.
    pub(super) corners: Vec<Corner>,
}

impl<'a> System<'a> {
    /// The system, given `light`, the direct light at the vertices of `fine`, the patches
    /// split.
    pub(super) fn new(
        scene: &Scene,
        patches: &'a Mesh,
        (fine, light): (&'a Mesh, &[Rgb]),
        direct: &Direct,
        hemicube: u32,
    ) -> System<'a> {
        let linear = Linear::new(patches, fine, hemicube);
        let enclosure = Enclosure::of(scene, patches);
        let Enclosure { emission, reflectance, .. } = &enclosure;
        let mut at_corners = light[..patches.vertices.len()].to_vec();
        patches.anchor(&mut at_corners);
        let arriving = means(fine, &fine.element_means(light), patches.elements.len());
        let seen = |k: usize| match direct.sums_emitters() {
            true => Rgb::ZERO,
            false => emission[k],
        };
        let scaled = |b: Slopes, k: usize| b.map(|b| reflectance[k] * b);
        let of_patch = |k: usize| {
            let mut b = linear.of_patch(k, &at_corners);
            b[0] += arriving[k] - linear.mean(k, &b);
            let mut b = scaled(b, k);
            b[0] += seen(k);
            b
        };
        let of_element = |(e, element): (usize, &Element)| {
            let k = element.patch.0 as usize;
            let mut b = scaled(linear.of_element(e, light), k);
            b[0] += seen(k);
            b
        };
        let all = 0..patches.elements.len();
        System {
            once: all.clone().map(of_patch).collect(),
            once_by_element: fine.elements.iter().enumerate().map(of_element).collect(),
            first: all.map(|k| emission[k] + reflectance[k] * arriving[k]).collect(),
            bulge: vec![Rgb::ZERO; patches.elements.len()],
            corners: Vec::new(),
            patches,
            enclosure,
            linear,
        }
    }

    pub(super) fn places(&self) -> Vec<DVec3> {
        let places = self.patches.places(INSIDE).into_iter();
        places.map(|place| place.map_or(DVec3::NAN, |place| place.at)).collect()
    }

    /// What a point with this unit normal sees.
    pub(super) fn seen_from(&self, point: DVec3, normal: DVec3) -> Corner {
        let Sight { patches, whole, elements, lost } =
            self.linear.seen_from(point, normal);
        let of_patch = |place: &u32| {
            let (k, m) = &patches[*place as usize];
            sent(&self.once[*k as usize], m)
        };
        let of_element =
            |(e, m): &(u32, Moments)| sent(&self.once_by_element[*e as usize], m);
        let once = whole.iter().map(of_patch).sum::<Rgb>()
            + elements.iter().map(of_element).sum::<Rgb>();
        Corner { once, patches, lost }
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
        let of_patch = |(k, &rho): (usize, &Rgb)| {
            let mut b = self.linear.of_patch(k, reflected);
            b[0] += self.bulge[k];
            b.map(|b| rho * b)
        };
        self.enclosure.reflectance.iter().enumerate().map(of_patch).collect()
    }

    /// Finds the bulges from `light` at the vertices of `mesh`, the patches split.
    pub(super) fn bulge_of(&mut self, mesh: &Mesh, light: &[Rgb]) {
        let means = means(mesh, &mesh.element_means(light), self.bulge.len());
        let of_patch = |(k, mean): (usize, Rgb)| {
            mean - self.linear.mean(k, &self.linear.of_patch(k, light))
        };
        self.bulge = means.into_iter().enumerate().map(of_patch).collect();
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
        let rho = self.enclosure.largest_reflectance().max_element();
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

    /// Where the light of the field on `mesh` went; `source` tells the patch of an
    /// element. Unshot is by how much the field differs from what the patches sent.
    pub(super) fn ledger(
        &self,
        scene: &Scene,
        mesh: &Mesh,
        irradiance: &[Rgb],
        reflected: &[Rgb],
        source: &dyn Fn(&Element) -> usize,
    ) -> Ledger {
        let sent = self.mean_radiosity(reflected);
        let fine = Enclosure::of(scene, mesh);
        let irradiance = mesh.element_means(irradiance);
        let unshot = |(k, e): (usize, &Element)| {
            fine.emission[k] + fine.reflectance[k] * irradiance[k] - sent[source(e)]
        };
        let unshot: Vec<Rgb> = mesh.elements.iter().enumerate().map(unshot).collect();
        let mut power = LostPower::default();
        for (k, element) in self.patches.elements.iter().enumerate() {
            let corners = element.corners.iter().map(|c| &self.corners[c.0 as usize]);
            let looks =
                corners.filter(|c| !c.patches.is_empty() || c.lost != Lost::default());
            let seen: Vec<Lost> = looks.map(|c| c.lost).collect();
            for lost in &seen {
                let share = self.enclosure.area[k] / seen.len() as f64;
                power.add(share * sent[k], *lost);
            }
        }
        Ledger::draw_up(&fine, &irradiance, &unshot, power)
    }
}
