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
//!    ([`Linear`](crate::form_factor::linear::Linear)): `O(m)` hemicubes instead of
//!    `O(n)`. Cells that show a mirror or a pane send rays onwards. These rows make the
//!    linear system; it is solved by fixed-point rounds that learn from one another.
//! 3. Patches are split where the reflected light is not linear between their corners, and
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

use super::refine::{Ask, Refinement};
use crate::geometry::Rgb;
use crate::mesh::{Backs, Element, Mesh, TwoLevels};
use crate::room::Direct;
use crate::scene::Scene;
use crate::solve::Ledger;
use crate::work::Progress;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};
use system::System;

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
    /// `H` of the other side in the same place, where there is one.
    pub behind: Vec<Rgb>,
    /// Where the light went.
    pub ledger: Ledger,
    /// `‖r‖/‖B − E‖` of the linear system of the patches.
    pub solver_residual: f64,
    /// Rounds of the solver.
    pub rounds: usize,
    /// How many hemicubes were drawn.
    pub hemicubes: usize,
}

impl Smooth {
    /// `B = E + ρ H + τ H_behind`, W/m², of `element` for these two.
    pub fn radiosity(&self, scene: &Scene, element: &Element, h: [Rgb; 2]) -> Rgb {
        let material = self.mesh.material(scene, element);
        let through = material.translucence() * h[1];
        material.emission() + material.diffuse() * h[0] + through
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
pub fn smooth(scene: &Scene, how: &Resolution, progress: Progress) -> Smooth {
    let direct = Direct::of(scene);
    let summed = DirectLight { scene, direct: &direct, how };
    let patches = Mesh::patched(scene, how.patch);
    progress("direct light", 0, 2);
    let scale = summed.scale(&patches);
    let (levels, light) = summed.on(&patches, 2.0 * how.direct, scale);
    let mut system = System::new(scene, &levels, &light, &direct, how.hemicube);
    let looks = AtomicUsize::new(system.look(how.reflected.is_finite(), progress));
    let light = reflected_light(scene, &mut system, how, &looks, progress);

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
    let mesh = levels.into_elements();
    let mut found = Smooth {
        behind: Backs::of(scene, &mesh).apply(&irradiance),
        patches: patches.elements.len(),
        mesh,
        irradiance,
        ledger: Ledger::default(),
        solver_residual: light.residual,
        rounds: light.rounds,
        hemicubes: looks.into_inner(),
    };
    found.ledger = system.ledger(scene, &found, &light.on_patches, &patch_of);
    progress("direct light", 2, 2);
    found
}

/// Light straight from the emitters, and how finely it is asked for.
struct DirectLight<'a> {
    scene: &'a Scene,
    direct: &'a Direct<'a>,
    how: &'a Resolution,
}

impl DirectLight<'_> {
    /// The direct light at the vertices of the elements into which the patches are split
    /// until it is right to `target`.
    fn on<'m>(
        &self,
        patches: &'m Mesh,
        target: f64,
        scale: Rgb,
    ) -> (TwoLevels<'m>, Vec<Rgb>) {
        let on: Vec<_> =
            patches.elements.par_iter().map(|e| self.direct.on(&e.polygon)).collect();
        let scattered = scattered(self.scene, patches);
        Refinement {
            scene: self.scene,
            light: &|e, at| on[e.patch].irradiance(at),
            reflectance: &|e| scattered[e.patch],
            ask: Ask::All,
            peaks: &|e| self.direct.peaks(&e.polygon),
            inside: JUST_INSIDE,
            scale,
            target,
            most: self.how.most_elements,
        }
        .run(patches)
    }

    /// `‖ρ H_direct‖²` by the centres of the patches, and by the spots next to lamps.
    fn scale(&self, patches: &Mesh) -> Rgb {
        let reflected = |(e, scattered): (&Element, Rgb)| {
            let light = self.direct.on(&e.polygon);
            let centre = e.polygon.centroid();
            let all = (centre, e.polygon.area());
            let places = self.direct.peaks(&e.polygon).into_iter().chain([all]);
            let squares = places.map(|(at, area)| {
                area * light.irradiance(at.lerp(centre, JUST_INSIDE)).powf(2.0)
            });
            scattered.powf(2.0) * squares.sum::<Rgb>()
        };
        // In order, so that the sum is the same at any number of threads.
        let scattered = scattered(self.scene, patches);
        let pieces = patches.elements.par_iter().zip(scattered);
        let squares: Vec<Rgb> = pieces.map(reflected).collect();
        squares.into_iter().sum()
    }
}

/// What each of these patches scatters diffusely, to either side.
fn scattered(scene: &Scene, patches: &Mesh) -> Vec<Rgb> {
    patches.elements.iter().map(|e| patches.material(scene, e).scattered()).collect()
}

/// Reflected light, in `H`, W/m².
struct Reflected<'a> {
    /// At the corners of the patches.
    on_patches: Vec<Rgb>,
    /// The patches, split where this light bends.
    levels: TwoLevels<'a>,
    /// At the vertices of their elements.
    on_elements: Vec<Rgb>,
    /// `‖B − E‖²`.
    scale: Rgb,
    residual: f64,
    rounds: usize,
}

/// Solves for the light at the corners of the patches, splits them where it bends, and
/// corrects by that what they send.
fn reflected_light<'a>(
    scene: &Scene,
    system: &mut System<'a>,
    how: &Resolution,
    looks: &AtomicUsize,
    progress: Progress,
) -> Reflected<'a> {
    let patches = system.mesh();
    let dark = vec![Rgb::ZERO; patches.vertices.len()];
    let (before, residual, rounds) = system.solve(how.solver, &dark, progress);
    let scale = system.reflected_light(&before);
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
    let scattered = scattered(scene, patches);
    let finer = Refinement {
        scene,
        light: &|e, at| {
            looks.fetch_add(1, Ordering::Relaxed);
            system.seen_from(at, e.polygon.normal()).irradiance(&shone)
        },
        reflectance: &|e| scattered[e.patch],
        ask: Ask::Centre,
        peaks: &|_| Vec::new(),
        inside: INSIDE,
        scale,
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
