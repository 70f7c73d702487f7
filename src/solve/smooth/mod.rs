//! Smooth light: what comes straight from the emitters exactly, and on small elements;
//! what was reflected from large patches, and linear across them.
//!
//! ```text
//! H(x) = Σ_k E_k F(x → emitter k)  +  Σ_patches Σ_k b_k m_k(x)        direct + reflected
//! B_p = E_p + ρ_p (mean of H over the elements of p)                  as seen from outside
//! ```
//! Direct light has edges, but a formula. Reflected light has none, but is smooth. So
//! they get a mesh each:
//!
//! 1. Patches of even size; the direct light on them, on elements split where it is not
//!    linear ([`Refinement`]), gives their means.
//! 2. At every corner of a patch a hemicube tells what it sees of all patches and where
//!    ([`Linear`]): `O(m)` hemicubes instead of `O(n)`. These rows make the linear system;
//!    it is solved by fixed-point rounds that learn from one another ([`Anderson`]).
//! 3. Patches are split where the reflected light is not linear between their corners, and
//!    hemicubes at the new corners ask the patches.
//! 4. On that mesh once more the direct light, as finely as was asked for.
//!
//! Sources: Cohen, Greenberg, Immel & Brock 1986 (patches and elements); Max & Allison
//! 1992 (linear elements); Lischinski, Tampieri & Greenberg 1993 (a last gather at the
//! vertices).

mod anderson;

use super::ledger::LostPower;
use super::refine::{Ask, Refinement};
use super::{Direct, Enclosure, Ledger, Progress};
use crate::form_factor::Lost;
use crate::form_factor::linear::{Linear, Moments, Sight, Slopes, sent};
use crate::geometry::Rgb;
use crate::mesh::{Element, Mesh, Place};
use crate::scene::Scene;
use anderson::Anderson;
use glam::DVec3;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How finely light is resolved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolution {
    /// The longest edge of a patch, in scene units.
    pub patch: f64,
    /// Cells along the edge of a hemicube.
    pub hemicube: u32,
    /// The error that interpolating direct light may make, relative to the reflected
    /// light of the scene.
    pub direct: f64,
    /// The same for reflected light; infinite when light that was reflected twice is left
    /// out.
    pub reflected: f64,
    /// The error that the solver may leave.
    pub solver: f64,
    /// The most elements.
    pub most_elements: usize,
}

/// The light of a scene, linear across each element.
pub struct Smooth {
    /// The elements.
    pub mesh: Mesh,
    /// How many patches they were split from: what shines on what.
    pub patches: usize,
    /// `H`, W/m², per vertex of the mesh.
    pub irradiance: Vec<Rgb>,
    /// Where the light went.
    pub ledger: Ledger,
    /// `‖r‖/‖B − E‖` of the linear system of the patches.
    pub solver_residual: f64,
    /// Rounds of the solver.
    pub rounds: usize,
    /// How many hemicubes were drawn.
    pub hemicubes: usize,
}

/// Corners at the rim of a surface see the cusp that light has there. This share of an
/// element inside, reflected light is what a linear function best goes through.
const INSIDE: f64 = 0.2;

/// For direct light it suffices not to lie on the rim itself.
const JUST_INSIDE: f64 = 1e-4;

/// Reflected light is smooth: more elements than this for each patch would resolve what
/// hemicubes get wrong.
const MOST_SPLIT: usize = 8;

/// Rounds of the solver at the most.
const MOST_ROUNDS: usize = 1000;

/// Finds the light of a scene.
pub fn smooth(scene: &Scene, how: &Resolution, progress: Progress) -> Smooth {
    let patches = Mesh::patched(scene, how.patch);
    let direct = Direct::of(scene);
    let rho = |mesh: &Mesh, e: &Element| {
        scene.materials[mesh.patch_of(e).material.0 as usize].diffuse()
    };
    let direct_light = |mesh: &Mesh, target: f64, scale: Rgb| {
        let on: Vec<_> =
            mesh.elements.par_iter().map(|e| direct.on(&e.polygon)).collect();
        Refinement {
            light: &|e, at| on[e.patch.0 as usize].irradiance(at),
            reflectance: &|e| rho(mesh, e),
            ask: Ask::All,
            inside: JUST_INSIDE,
            scale,
            target,
            most: how.most_elements,
        }
        .run(mesh.clone())
    };
    progress("direct light", 0, 2);
    let scale = direct_scale(scene, &patches, &direct);
    let (fine, light) = direct_light(&patches, 2.0 * how.direct, scale);
    let mut system =
        System::new(scene, &patches, (&fine, &light), &direct, how.hemicube);
    let bounces = how.reflected.is_finite();
    let counter = AtomicUsize::new(system.look(bounces, progress));
    let dark = vec![Rgb::ZERO; system.corners.len()];
    let (reflected, _, rounds) = system.solve(how.solver, &dark, progress);
    let shone = system.reflected_slopes(&reflected);
    let scale = system.reflected_light(&reflected);

    progress("reflected light", 0, 1);
    let finer = Refinement {
        light: &|e, at| {
            counter.fetch_add(1, Ordering::Relaxed);
            system.seen_from(at, e.polygon.normal()).irradiance(&shone)
        },
        reflectance: &|e| rho(&patches, e),
        ask: Ask::Centre,
        inside: INSIDE,
        scale,
        target: how.reflected,
        most: how.most_elements.min(MOST_SPLIT * patches.elements.len()),
    };
    let (coarse, mut reflected_fine) = match bounces {
        true => finer.run_from(patches.clone(), system.places(), reflected.clone()),
        false => (patches.clone(), reflected.clone()),
    };

    // What patches send is corrected by how their light bulges between the corners.
    let before = reflected;
    system.bulge_of(&coarse, &reflected_fine);
    let (reflected, solver_residual, again) =
        system.solve(how.solver, &before, progress);
    let change: Vec<Rgb> = reflected.iter().zip(&before).map(|(a, b)| a - b).collect();
    for (k, place) in coarse.places(0.0).iter().enumerate() {
        let Some(Place { element, .. }) = place else { continue };
        let patch = coarse.elements[*element as usize].patch;
        let patch = &patches.elements[patch.0 as usize];
        reflected_fine[k] += patches.value_at(patch, coarse.vertices[k], &change);
    }
    coarse.anchor(&mut reflected_fine);
    let rounds = rounds + again;

    progress("direct light", 1, 2);
    let receivers = coarse.with_elements_as_patches();
    let (mesh, mut irradiance) = direct_light(&receivers, how.direct, scale);
    for place in mesh.places(0.0).iter().enumerate() {
        let (k, Some(Place { element, .. })) = place else { continue };
        let whole = mesh.elements[*element as usize].patch;
        let whole = &coarse.elements[whole.0 as usize];
        irradiance[k] += coarse.value_at(whole, mesh.vertices[k], &reflected_fine);
    }
    mesh.anchor(&mut irradiance);
    let ledger = {
        let source = |e: &Element| {
            let patch = coarse.elements[e.patch.0 as usize].patch;
            patch.0 as usize
        };
        system.ledger(scene, &mesh, &irradiance, &reflected, &source)
    };
    progress("direct light", 2, 2);
    Smooth {
        patches: patches.elements.len(),
        mesh,
        irradiance,
        ledger,
        solver_residual,
        rounds,
        hemicubes: counter.into_inner(),
    }
}

/// `‖ρ H_direct‖²` by the centres of the patches.
fn direct_scale(scene: &Scene, patches: &Mesh, direct: &Direct) -> Rgb {
    let enclosure = Enclosure::of(scene, patches);
    let light: Vec<Rgb> = patches
        .elements
        .par_iter()
        .map(|e| direct.on(&e.polygon).irradiance(e.polygon.centroid()))
        .collect();
    let reflected = enclosure.reflectance.iter().zip(light).map(|(&rho, h)| rho * h);
    enclosure.norm_squared(reflected)
}

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
struct Corner {
    /// `H`, W/m², of light that was reflected once.
    once: Rgb,
    /// How it sees the patches, which send light that was reflected more often.
    patches: Vec<(u32, Moments)>,
    lost: Lost,
}

impl Corner {
    /// `H`, W/m², when patch `k` sends the light `of[k]` beside what it reflected once.
    fn irradiance(&self, of: &[Slopes]) -> Rgb {
        let more: Rgb =
            self.patches.iter().map(|(k, m)| sent(&of[*k as usize], m)).sum();
        self.once + more
    }
}

/// The linear system of the patches; the unknown is the reflected light at their corners.
struct System<'a> {
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
    corners: Vec<Corner>,
}

impl<'a> System<'a> {
    /// The system, given `light`, the direct light at the vertices of `fine`, the patches
    /// split.
    fn new(
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

    fn places(&self) -> Vec<DVec3> {
        let places = self.patches.places(INSIDE).into_iter();
        places.map(|place| place.map_or(DVec3::NAN, |place| place.at)).collect()
    }

    /// What a point with this unit normal sees.
    fn seen_from(&self, point: DVec3, normal: DVec3) -> Corner {
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
    fn look(&mut self, from_all: bool, progress: Progress) -> usize {
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
    fn reflected_slopes(&self, reflected: &[Rgb]) -> Vec<Slopes> {
        let of_patch = |(k, &rho): (usize, &Rgb)| {
            let mut b = self.linear.of_patch(k, reflected);
            b[0] += self.bulge[k];
            b.map(|b| rho * b)
        };
        self.enclosure.reflectance.iter().enumerate().map(of_patch).collect()
    }

    /// Finds the bulges from `light` at the vertices of `mesh`, the patches split.
    fn bulge_of(&mut self, mesh: &Mesh, light: &[Rgb]) {
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
    fn reflected_light(&self, reflected: &[Rgb]) -> Rgb {
        let b = self.mean_radiosity(reflected).into_iter();
        self.enclosure
            .norm_squared(b.zip(&self.enclosure.emission).map(|(b, &e)| b - e))
    }

    /// The reflected light at the corners, the solver's residual and its rounds.
    fn solve(
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
    fn ledger(
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
