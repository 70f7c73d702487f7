//! Pass 1 as it is asked for by an error: resolve, certify, and finer until it suffices.

use super::Solution;
use crate::certificate::{Certificate, Sampling, certify};
use crate::field::{Resolution, Smooth, smooth};
use crate::geometry::Rgb;
use crate::mesh::ElementId;
use crate::scene::Scene;
use crate::work::Progress;
use glam::DVec3;

/// What a solution must reach, and what it may cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ask {
    /// The largest certified error asked for, relative; see [`Certificate`].
    pub tolerance: f64,
    /// Names the random streams.
    pub seed: u64,
    /// The most patches: the work grows as their square.
    pub most_patches: usize,
    /// The most elements.
    pub most_elements: usize,
}

impl Default for Ask {
    fn default() -> Ask {
        Ask { tolerance: 0.01, seed: 0, most_patches: 4000, most_elements: 60_000 }
    }
}

/// One attempt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// How finely it resolved light.
    pub resolution: Resolution,
    /// What shines on what.
    pub patches: usize,
    /// What light is shown on.
    pub elements: usize,
    /// How many hemicubes were drawn.
    pub hemicubes: usize,
    /// What came out.
    pub certificate: Certificate,
}

/// Patches of a scene that is to be 1 % right.
const PATCHES: f64 = 400.0;

/// The resolution with which a first attempt is likely to suffice.
///
/// The error of linear elements falls with the square of their size: as one over the
/// number of patches. The shares are those that served the built-in scenes best: direct
/// and reflected light together may take 0.4² + 0.5² = 0.41 of the square of the tolerance;
/// the rest is for patches, hemicubes and the certificate's own doubt.
pub fn resolution_for(scene: &Scene, tolerance: f64) -> Resolution {
    let area: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
    let patches = (PATCHES * 0.01 / tolerance).clamp(60.0, 2000.0);
    Resolution {
        patch: (area / patches).sqrt(),
        hemicube: if tolerance < 0.008 { 64 } else { 32 },
        direct: 0.4 * tolerance,
        reflected: 0.5 * tolerance,
        solver: 0.02 * tolerance,
        most_elements: Ask::default().most_elements,
    }
}

/// Attempts at the most.
const MOST_PASSES: usize = 6;

/// Solves a scene, from the resolution `first` on to finer ones, until the certificate
/// says that the tolerance is met, more patches would be needed than are allowed, or finer
/// ones gain nothing.
///
/// Deterministic: the same at any number of threads.
pub fn automatic(
    scene: &Scene,
    first: Resolution,
    ask: &Ask,
    progress: Progress,
) -> (Solution, Vec<Pass>) {
    let mut how = Resolution { most_elements: ask.most_elements, ..first };
    let mut passes = Vec::new();
    loop {
        let light = smooth(scene, &how, progress);
        let certificate = certified(scene, &light, ask, progress);
        passes.push(Pass {
            resolution: how,
            patches: light.patches,
            elements: light.mesh.elements.len(),
            hemicubes: light.hemicubes,
            certificate,
        });
        let converged = certificate.high <= ask.tolerance;
        let finer = (0.75 * ask.tolerance / certificate.high).clamp(0.4, 0.8);
        let patches = light.patches as f64 / finer;
        let refined = light.mesh.elements.len() < ask.most_elements;
        let possible = patches <= ask.most_patches as f64 && refined && gains(&passes);
        if converged || !possible || passes.len() == MOST_PASSES {
            return (solution(scene, light, certificate, converged), passes);
        }
        how = Resolution {
            patch: finer.sqrt() * how.patch,
            direct: finer * how.direct,
            reflected: finer * how.reflected,
            hemicube: (how.hemicube as f64 * finer.sqrt().recip()) as u32 / 2 * 2,
            ..how
        };
    }
}

/// A finer attempt that leaves more than this share of the error found noise, which stays.
const NO_GAIN: f64 = 0.8;

/// Did the last attempt gain enough on the one before?
fn gains(passes: &[Pass]) -> bool {
    match passes {
        [.., before, last] => {
            last.certificate.error <= NO_GAIN * before.certificate.error
        }
        _ => true,
    }
}

/// Points and rays of a certificate: its doubt is about a quarter of one per cent.
const POINTS: usize = 1600;
const RAYS: usize = 256;

/// A larger error may be in more doubt: the square of what noise adds falls with the rays.
const FEWEST_RAYS: usize = 32;

/// So many times as many are cast when only chance is in doubt.
const MORE: usize = 4;

/// The points and rays that tell whether an error meets the tolerance.
pub fn sampling_for(tolerance: f64) -> Sampling {
    let rays = (RAYS as f64 * 0.01 / tolerance) as usize;
    Sampling { points: POINTS, rays: rays.clamp(FEWEST_RAYS, RAYS), seed: 0 }
}

fn certified(
    scene: &Scene,
    light: &Smooth,
    ask: &Ask,
    progress: Progress,
) -> Certificate {
    let field = |id: ElementId, x: DVec3| {
        let element = light.mesh.element(id);
        let h = [&light.irradiance, &light.behind];
        light.radiosity(scene, element, h.map(|h| light.mesh.value_at(element, x, h)))
    };
    let usual = Sampling { seed: ask.seed, ..sampling_for(ask.tolerance) };
    let with = |sampling| certify(scene, &light.mesh, &field, sampling);
    progress("certifying", 0, 1);
    let mut certificate = with(usual);
    let likely = certificate.error <= 0.75 * ask.tolerance;
    if likely && certificate.high > ask.tolerance {
        certificate = with(Sampling { rays: MORE * usual.rays, ..usual });
    }
    progress("certifying", 1, 1);
    certificate
}

fn solution(
    scene: &Scene,
    light: Smooth,
    certificate: Certificate,
    converged: bool,
) -> Solution {
    let mesh = &light.mesh;
    let (front, behind) = (&light.irradiance, &light.behind);
    let mut vertex_radiosity = vec![Rgb::ZERO; mesh.vertices.len()];
    for element in &mesh.elements {
        for corner in element.corners.iter().map(|c| c.0 as usize) {
            let h = [front[corner], behind[corner]];
            vertex_radiosity[corner] = light.radiosity(scene, element, h);
        }
    }
    let irradiance = mesh.element_means(front);
    let through = mesh.element_means(behind);
    let of_element =
        |(k, element)| light.radiosity(scene, element, [irradiance[k], through[k]]);
    let radiosity: Vec<Rgb> =
        mesh.elements.iter().enumerate().map(of_element).collect();
    let Smooth { mesh, patches, ledger, solver_residual, rounds, .. } = light;
    Solution {
        patches,
        displayed: radiosity.clone(),
        radiosity,
        irradiance,
        vertex_radiosity,
        mesh,
        ledger,
        solver_residual,
        steps: rounds,
        certificate,
        converged,
    }
}
