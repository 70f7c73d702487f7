//! What leaves the scene or falls on black backs: counted by rays, since links know only
//! fronts.

use crate::form_factor::ray_from;
use crate::geometry::{Frame, Rgb};
use crate::mesh::Mesh;
use crate::random::Stream;
use crate::scene::Scene;
use crate::solve::ledger::LostPower;
use crate::visibility::Visibility;
use rayon::prelude::*;

/// Rays in all; each element sends its share by power, and one at least.
const RAYS: f64 = 262_144.0;

/// The power that reaches no front, W. Its standard error is `1/512` of all power or less;
/// in a closed room nothing is lost, exactly.
pub(super) fn by_rays(
    scene: &Scene,
    mesh: &Mesh,
    radiosity: &[Rgb],
    seed: u64,
) -> LostPower {
    let surfaces = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
    let power: Vec<Rgb> =
        mesh.polygons().zip(radiosity).map(|(p, &b)| p.area() * b).collect();
    let all: f64 = power.iter().map(|p| p.max_element()).sum();
    let of_element = |k: usize| {
        let element = &mesh.elements[k];
        let share = if all > 0.0 { power[k].max_element() / all } else { 0.0 };
        let rays = (share * RAYS).ceil().max(1.0) as usize;
        let frame = Frame::about(element.polygon.normal());
        let mut lost = LostPower::default();
        for u in Stream::named(seed, &[k as u64]).points(rays) {
            let ray = ray_from(&element.polygon, &frame, u);
            let carried = power[k] / rays as f64;
            match surfaces.closest(&ray, Some(mesh.surface_of(element))) {
                None => lost.escaped += carried,
                Some(hit) if !hit.front => lost.absorbed += carried,
                Some(_) => {}
            }
        }
        lost
    };
    let all: Vec<LostPower> =
        (0..power.len()).into_par_iter().map(of_element).collect();
    let mut sum = LostPower::default();
    for lost in all {
        sum.escaped += lost.escaped;
        sum.absorbed += lost.absorbed;
    }
    sum
}
