//! Unbiased gathering: random walks, with direct light exactly at every step.
//!
//! ```text
//! H(x₀) = H_direct(x₀) + ρ₁ (H_direct(x₁) + ρ₂ (H_direct(x₂) + …))     on the average
//! σ_mean = σ/√walks                                                    its standard error
//! ```
//! Each step goes where light would come from, with the density of the cosine; a walk
//! ends by chance, with the share of light that a surface keeps for itself. No mesh, no
//! factors, no bias: what is wrong is told by the spread of the walks. The yardstick for
//! all that is faster.
//!
//! Sources: Kajiya 1986; Ward, Rubinstein & Clear 1988 (gathering backwards).

use super::Direct;
use crate::form_factor::ray_from;
use crate::geometry::{Frame, Rgb};
use crate::mesh::Mesh;
use crate::random::Stream;
use crate::scene::Scene;
use crate::visibility::Visibility;
use rayon::prelude::*;

/// The mean irradiance of an element, by walks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gathered {
    /// `H`, W/m².
    pub irradiance: Rgb,
    /// Its standard error, W/m².
    pub error: Rgb,
}

/// The mean irradiance of each element of `mesh`, by so many `walks` (two at least) each.
///
/// # Accuracy
/// Unbiased; the standard error is told, and falls as one over the root of the walks.
pub fn gather_unbiased(
    scene: &Scene,
    mesh: &Mesh,
    walks: usize,
    seed: u64,
) -> Vec<Gathered> {
    let direct = Direct::of(scene);
    let surfaces = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
    let on: Vec<_> = scene.surfaces.iter().map(|s| direct.on(&s.polygon)).collect();
    let gathered = !direct.sums_emitters();
    // ANCHOR: walk
    let walk = |k: usize, random: &mut Stream| {
        let mut surface = mesh.surface_of(&mesh.elements[k]) as usize;
        let mut x = mesh.elements[k].polygon.point_at([random.next(), random.next()]);
        let mut share = Rgb::ONE;
        let mut sum = on[surface].irradiance(x);
        loop {
            let polygon = &scene.surfaces[surface].polygon;
            let [c, d] = [random.next(), random.next()];
            let frame = Frame::about(polygon.normal());
            let mut ray = ray_from(polygon, &frame, [0.0, 0.0, c, d]);
            ray.origin = x;
            let hit = surfaces.closest(&ray, Some(surface as u32));
            let Some(hit) = hit.filter(|hit| hit.front) else { return sum };
            surface = hit.item as usize;
            let material = scene.material(&scene.surfaces[surface]);
            if gathered {
                sum += share * material.emission();
            }
            share *= material.diffuse();
            let goes_on = share.max_element().min(1.0);
            if random.next() >= goes_on {
                return sum;
            }
            share /= goes_on;
            x = ray.origin + hit.distance * ray.direction;
            sum += share * on[surface].irradiance(x);
        }
    };
    // ANCHOR_END: walk
    let of_element = |k: usize| {
        let mut random = Stream::named(seed, &[k as u64]);
        let (mut sum, mut squares) = (Rgb::ZERO, Rgb::ZERO);
        for _ in 0..walks {
            let h = walk(k, &mut random);
            sum += h;
            squares += h * h;
        }
        let n = walks as f64;
        let mean = sum / n;
        let variance = (squares / n - mean * mean).max(Rgb::ZERO) / (n - 1.0);
        Gathered { irradiance: mean, error: variance.map(f64::sqrt) }
    };
    (0..mesh.elements.len()).into_par_iter().map(of_element).collect()
}
