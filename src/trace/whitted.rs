//! Classical ray tracing: mirrors, glass, and lamps; no light between diffuse surfaces.

use super::expose::{Along, First, Looked, Shown, expose, followed};
use super::gloss::Glossy;
use super::look::Look;
use super::tree::{Tally, Tree};
use crate::film::Shot;
use crate::geometry::{Polygon, Ray, Rgb};
use crate::material::Material;
use crate::mesh::Mesh;
use crate::room::{LampsSeen, Panes, Room};
use crate::ways::{Media, Meeting, straight};
use crate::work::Progress;
use glam::DVec3;
use std::f64::consts::PI;

/// A scene, ready for classical ray tracing.
///
/// ```text
/// L = E/π + ρ (H_lamps + A)/π  +  R L(reflected)  +  T L(refracted)
/// ```
/// Light reaches a diffuse surface straight from lamps and no other way; `A` is a constant
/// that stands for all other light. A translucent surface gets the light of both its
/// sides. Gloss shows the lamps, and `A` in place of all else.
#[derive(Debug)]
pub struct Whitted<'s> {
    tree: Tree<'s>,
    /// One element for each surface: what the eye sees first is looked up.
    mesh: Mesh,
    lamps: LampsSeen<'s>,
    has_panes: bool,
    /// `A`, W/m²: irradiance that is the same everywhere; 0 unless it is set.
    pub ambient: Rgb,
}

impl<'s> Whitted<'s> {
    /// Of a scene.
    pub fn of(room: &Room<'s>, look: Look) -> Whitted<'s> {
        let scene = room.scene;
        let has_panes = scene.surfaces.iter().any(|s| is_pane(scene.material(s)));
        let mesh = Mesh::whole(scene);
        let lamps = LampsSeen::of(room, Panes::Pass);
        let tree = Tree::of(room, look);
        Whitted { tree, mesh, lamps, has_panes, ambient: Rgb::ZERO }
    }

    /// What a camera sees. Deterministic: the same at any number of threads.
    pub fn picture(&self, shot: &Shot, progress: Progress) -> Shown {
        let shade = |at: &Meeting, _: &_, tally: &mut Tally| self.shade(at, tally);
        let radiance = |first: &First, tally: &mut Tally| {
            followed(&self.tree, first, tally, &shade)
        };
        let looked = Looked { tree: &self.tree, mesh: &self.mesh, seed: 0 };
        expose(shot, &looked, &radiance, progress)
    }

    /// What comes against a ray.
    pub fn along(&self, ray: &Ray) -> Along {
        Along::of(&self.tree, ray, 0, &|at, _, tally| self.shade(at, tally))
    }

    // ANCHOR: shade
    fn shade(&self, at: &Meeting, tally: &Tally) -> Rgb {
        if !at.front {
            return Rgb::ZERO;
        }
        let surface = &self.tree.scene.surfaces[at.surface as usize];
        let material = at.material;
        let front = material.diffuse() * self.light_on(at.surface, at.point);
        let back = surface.back.map_or(Rgb::ZERO, |back| {
            material.translucence() * self.light_on(back, at.point)
        });
        (material.emission() + front + back) / PI + self.gloss(at, tally)
    }
    // ANCHOR_END: shade

    /// Irradiance, W/m², straight from the lamps, and `A`.
    // ANCHOR: light_on
    fn light_on(&self, surface: u32, x: DVec3) -> Rgb {
        let through = |lamp: &Polygon| self.through_panes(x, lamp.centroid());
        self.ambient + self.lamps.irradiance((surface, x), through)
    }
    // ANCHOR_END: light_on

    /// What panes let pass straight from `y` to `x`.
    fn through_panes(&self, x: DVec3, y: DVec3) -> Rgb {
        let (mut share, mut leaving) = (Rgb::ONE, None);
        let mut ray = Ray { origin: x, direction: (y - x).normalize() };
        let (mut left, mut media) = (x.distance(y), Media::default());
        while self.has_panes
            && let Some(hit) = self.tree.visibility.closest(&ray, leaving)
        {
            left -= hit.distance;
            if left <= 0.0 {
                break;
            }
            let met = Meeting::of(self.tree.scene, &self.tree.solids, &ray, &hit);
            if is_pane(met.material) {
                share *= straight(&met, &mut media).map_or(Rgb::ZERO, |(t, _)| t);
            } // what else hides a part of the lamp is cut out of it
            (ray.origin, leaving) = (met.point, Some(hit.item));
        }
        share
    }

    fn gloss(&self, at: &Meeting, tally: &Tally) -> Rgb {
        let Some(glossy) = Glossy::of(at, self.tree.look) else { return Rgb::ZERO };
        let lamps = glossy.of_lamps(&self.lamps, tally.offset());
        lamps + glossy.albedo() * self.ambient / PI
    }
}

fn is_pane(material: &Material) -> bool {
    material.shine().pane().is_some()
}
