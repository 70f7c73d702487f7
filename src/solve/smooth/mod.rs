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
//!    ([`Linear`](crate::form_factor::linear::Linear)): `O(m)` hemicubes instead of `O(n)`. These rows make the linear system;
//!    it is solved by fixed-point rounds that learn from one another.
//! 3. Patches are split where the reflected light is not linear between their corners, and
//!    hemicubes at the new corners ask the patches.
//! 4. On that mesh once more the direct light, as finely as was asked for.
//!
//! Sources: Cohen, Greenberg, Immel & Brock 1986 (patches and elements); Max & Allison
//! 1992 (linear elements); Lischinski, Tampieri & Greenberg 1993 (a last gather at the
//! vertices).

mod anderson;
mod system;

use super::refine::{Ask, Refinement};
use super::{Direct, Enclosure, Ledger, Progress};
use crate::geometry::Rgb;
use crate::mesh::{Element, Mesh, Place};
use crate::scene::Scene;
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
