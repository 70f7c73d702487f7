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
//! 1. SmoothPatches of even size; the direct light on them, on elements split where it is not
//!    linear ([`Refinement`]), gives their means.
//! 2. At every corner of a patch a hemicube tells what it sees of all patches and where
//!    ([`Linear`](crate::form_factor::linear::Linear)): `O(m)` hemicubes instead of
//!    `O(n)`. Cells that show a mirror or a pane send rays onwards. These rows make the
//!    linear system; it is solved by fixed-point rounds that learn from one another.
//! 3. SmoothPatches are split where the reflected light is not linear between their corners, and
//!    hemicubes at the new corners ask the patches.
//! 4. On that mesh once more the direct light, as finely as was asked for.
//!
//! Sources: Cohen, Greenberg, Immel & Brock 1986 (patches and elements); Max & Allison
//! 1992 (linear elements); Lischinski, Tampieri & Greenberg 1993 (a last gather at the
//! vertices).

mod account;
mod anderson;
mod first_bounce;
mod patches;
mod specular;
mod system;

use super::refine::{Asked, LightScale, Refinement};
use super::{Cannot, Field, Fineness, Pass1};
use crate::geometry::Rgb;
use crate::mesh::{Element, Mesh, TwoLevels};
use crate::room::{Direct, Room};
use crate::scene::Scene;
use crate::work::{Progress, Work};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};
use system::System;

/// Smooth light: direct light exactly, reflected light linear across patches.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Smooth;

/// SmoothPatches of a scene that is to be 1 % right.
const PATCHES: f64 = 400.0;

/// The most patches: the work grows as their square.
const MOST_PATCHES: usize = 4000;

/// The most elements.
const MOST_ELEMENTS: usize = 60_000;

impl Smooth {
    /// The light at the fineness of a first attempt at this error, whatever comes of it.
    pub fn once(room: &Room, error: f64) -> Field {
        Smooth.field(room, &Smooth.first(room, error), &Work::quiet())
    }
}

impl Pass1 for Smooth {
    /// All that a room may have.
    fn knows(&self, _: &Room) -> Result<(), Cannot> {
        Ok(())
    }

    /// The fineness with which a first attempt is likely to suffice.
    ///
    /// The error of linear elements falls with the square of their size: as one over the
    /// number of patches. The shares are those that served the built-in scenes best: direct
    /// and reflected light together may take 0.4² + 0.5² = 0.41 of the square of the
    /// tolerance; the rest is for patches, hemicubes and the certificate's own doubt.
    fn first(&self, room: &Room, tolerance: f64) -> Fineness {
        let area = Mesh::area_in_scale(room.scene);
        let patches = (PATCHES * 0.01 / tolerance).clamp(60.0, 2000.0);
        Fineness {
            patch: (area / patches).sqrt(),
            hemicube: if tolerance < 0.008 { 64 } else { 32 },
            direct: 0.4 * tolerance,
            reflected: 0.5 * tolerance,
            solver: 0.02 * tolerance,
            most_patches: MOST_PATCHES,
            most_elements: MOST_ELEMENTS,
            seed: 0,
        }
    }

    fn finer(&self, room: &Room, last: &Fineness, share: f64) -> Option<Fineness> {
        let next = Fineness {
            patch: share.sqrt() * last.patch,
            direct: share * last.direct,
            reflected: share * last.reflected,
            hemicube: (last.hemicube as f64 * share.sqrt().recip()) as u32 / 2 * 2,
            ..*last
        };
        let patches = Mesh::count_uniform(room.scene, next.patch);
        (patches <= last.most_patches as f64).then_some(next)
    }

    fn field(&self, room: &Room, how: &Fineness, work: &Work) -> Field {
        smooth(room, how, work)
    }
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
fn smooth(room: &Room, how: &Fineness, work: &Work) -> Field {
    let (scene, direct, progress) = (room.scene, room.lamps(), work.progress());
    let summed = DirectLight { scene, direct, how };
    let patches = Mesh::patched(scene, how.patch);
    progress("direct light", 0, 2);
    let scale = summed.scale(&patches);
    let (levels, light) = summed.on(&patches, 2.0 * how.direct, scale);
    let mut system = System::new(room, &levels, &light, how.hemicube);
    let looks = AtomicUsize::new(system.look(how.reflected.is_finite(), progress));
    let light = reflected_light(&summed, scale, &mut system, &looks, progress);

    progress("direct light", 1, 2);
    // What reflected light was split into are patches to the direct light.
    let smooth_pieces = light.levels.elements();
    let (levels, mut irradiance) = summed.on(smooth_pieces, how.direct, light.scale);
    let reflected = levels.interpolated(&light.on_elements);
    irradiance.iter_mut().zip(reflected).for_each(|(h, reflected)| *h += reflected);
    // No light is negative: what linear patches undershoot is nearer to the truth at 0.
    irradiance.iter_mut().for_each(|h| *h = h.max(Rgb::ZERO));
    levels.elements().anchor(&mut irradiance);
    let patch_of = |e: &Element| levels.patch(e.patch).patch;
    let patch_of = levels.elements().elements.iter().map(patch_of).collect::<Vec<_>>();
    let field = Field::linear(scene, levels.into_elements(), irradiance);
    let ledger = system.ledger(scene, &field, &light.on_patches, &patch_of);
    let rows = looks.into_inner();
    work.count(rows);
    progress("direct light", 2, 2);
    Field {
        patches: patches.elements.len(),
        ledger,
        solver_residual: light.residual,
        steps: light.rounds,
        rows,
        ..field
    }
}

/// Light straight from the emitters, and how finely it is asked for.
struct DirectLight<'a> {
    scene: &'a Scene,
    direct: &'a Direct<'a>,
    how: &'a Fineness,
}

impl DirectLight<'_> {
    /// The direct light at the vertices of the elements into which the patches are split
    /// until it is right to `target`.
    fn on<'m>(
        &self,
        patches: &'m Mesh,
        target: f64,
        scale: LightScale,
    ) -> (TwoLevels<'m>, Vec<Rgb>) {
        let on: Vec<_> =
            patches.elements.par_iter().map(|e| self.direct.on(&e.polygon)).collect();
        let counts = counts(self.scene, patches, scale);
        Refinement {
            scene: self.scene,
            light: &|e, at| on[e.patch].irradiance(at),
            counts: &|e| counts[e.patch],
            ask: Asked::All,
            near_lamps: &|e| self.direct.near_lamps(&e.polygon),
            inside: JUST_INSIDE,
            target,
            most: self.how.most_elements,
        }
        .run(patches)
    }

    /// `‖H_direct‖²` and `‖ρ H_direct‖²` by the centres of the patches, and by the spots next
    /// to lamps.
    fn scale(&self, patches: &Mesh) -> LightScale {
        let squares = |e: &Element| {
            let light = self.direct.on(&e.polygon);
            let centre = e.polygon.centroid();
            let all = (centre, e.polygon.area());
            let places = self.direct.near_lamps(&e.polygon).into_iter().chain([all]);
            let squares = places.map(|(at, area)| {
                area * light.irradiance(at.lerp(centre, JUST_INSIDE)).powf(2.0)
            });
            squares.sum::<Rgb>()
        };
        // In order, so that the sum is the same at any number of threads.
        let squares: Vec<Rgb> = patches.elements.par_iter().map(squares).collect();
        let scattered = scattered(self.scene, patches);
        let reflected = scattered.iter().zip(&squares).map(|(s, h)| s * s * h).sum();
        LightScale { reflected, arriving: squares.into_iter().sum() }
    }
}

/// What each of these patches scatters diffusely, to either side.
fn scattered(scene: &Scene, patches: &Mesh) -> Vec<Rgb> {
    patches.elements.iter().map(|e| patches.material(scene, e).scattered()).collect()
}

/// What an error in `H` of each of these patches counts.
fn counts(scene: &Scene, patches: &Mesh, scale: LightScale) -> Vec<Rgb> {
    scattered(scene, patches).into_iter().map(|s| scale.counts(s)).collect()
}

/// Reflected light, in `H`, W/m².
struct Reflected<'a> {
    /// At the corners of the patches.
    on_patches: Vec<Rgb>,
    /// The patches, split where this light bends.
    levels: TwoLevels<'a>,
    /// At the vertices of their elements.
    on_elements: Vec<Rgb>,
    scale: LightScale,
    residual: f64,
    rounds: usize,
}

/// `∫ H² dA` of light that is linear between vertices, by the means of the elements.
fn square(mesh: &Mesh, of_vertices: &[Rgb]) -> Rgb {
    let means = mesh.element_means(of_vertices);
    mesh.polygons().zip(means).map(|(p, h)| p.area() * h * h).sum()
}

/// Solves for the light at the corners of the patches, splits them where it bends, and
/// corrects by that what they send.
fn reflected_light<'a>(
    summed: &DirectLight,
    direct: LightScale,
    system: &mut System<'a>,
    looks: &AtomicUsize,
    progress: Progress,
) -> Reflected<'a> {
    let (scene, how, patches) = (summed.scene, summed.how, system.mesh());
    let dark = vec![Rgb::ZERO; patches.vertices.len()];
    let (before, residual, rounds) = system.solve(how.solver, &dark, progress);
    let reflected = system.reflected_light(&before);
    let arriving = direct.arriving + square(patches, &before);
    let scale = LightScale { reflected, arriving };
    progress("reflected light", 0, 1);
    if how.reflected.is_infinite() {
        let (levels, on_elements) = (TwoLevels::undivided(patches), before.clone());
        return Reflected {
            on_patches: before,
            levels,
            on_elements,
            scale,
            residual,
            rounds,
        };
    }
    let shone = system.reflected_slopes(&before);
    let counts = counts(scene, patches, scale);
    let finer = Refinement {
        scene,
        light: &|e, at| {
            looks.fetch_add(1, Ordering::Relaxed);
            system.seen_from(at, e.polygon.normal()).irradiance(&shone)
        },
        counts: &|e| counts[e.patch],
        ask: Asked::Centre,
        near_lamps: &|_| Vec::new(),
        inside: INSIDE,
        target: how.reflected,
        most: how.most_elements.min(MOST_SPLIT * patches.elements.len()),
    };
    let (levels, mut on_elements) =
        finer.run_from(patches, system.places(), before.clone());

    // What patches send is corrected by how their light bends between the corners.
    system.correct_means(scene, &levels, &on_elements);
    let (on_patches, residual, again) = system.solve(how.solver, &before, progress);
    let change: Vec<Rgb> = on_patches.iter().zip(&before).map(|(a, b)| a - b).collect();
    let change = levels.interpolated(&change);
    on_elements.iter_mut().zip(change).for_each(|(h, change)| *h += change);
    levels.elements().anchor(&mut on_elements);
    let rounds = rounds + again;
    Reflected { on_patches, levels, on_elements, scale, residual, rounds }
}
