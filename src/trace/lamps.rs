//! The lamps as points of surfaces see them: exactly, with what hides them cut away.

use crate::geometry::{Outline, Polygon, Rgb};
use crate::material::{Coefficients, Material};
use crate::occlusion::{Blocker, Blockers, lambert_visible, visible_parts};
use crate::scene::Scene;
use glam::DVec3;
use smallvec::SmallVec;
use std::f64::consts::PI;

/// Scenes with more emitting surfaces have their light found by rays.
const MOST_LAMPS: usize = 32;

/// What light does at panes on its straight way from a lamp.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Panes {
    /// It ends: rays bring what comes through.
    Block,
    /// It goes through as if there were none.
    Pass,
}

/// All lamps, and for each surface those that may shine on it.
#[derive(Debug)]
pub(super) struct Lamps {
    lamps: Vec<(Polygon, Rgb)>,
    blockers: Blockers,
    on: Vec<Vec<Shining>>,
}

/// A lamp before a surface.
#[derive(Debug)]
struct Shining {
    lamp: u32,
    /// Which of the blockers may stand between.
    past: Vec<u32>,
}

impl Lamps {
    /// Those of a scene, for its surfaces that are `wanted`.
    pub(super) fn of(
        scene: &Scene,
        panes: Panes,
        wanted: impl Fn(&Material) -> bool,
    ) -> Lamps {
        let emitting = scene.surfaces.iter().filter(|s| scene.material(s).emits());
        let mut lamps: Vec<(Polygon, Rgb)> = emitting
            .map(|s| (s.polygon.clone(), scene.material(s).emission()))
            .collect();
        if lamps.len() > MOST_LAMPS {
            lamps.clear();
        }
        let blockers = match panes {
            Panes::Pass => Blockers::of(scene),
            Panes::Block => Blockers::of(&with_dull_panes(scene)),
        };
        let indices = |past: Vec<&Blocker>| {
            let index = |b: &&Blocker| {
                blockers.all().iter().position(|all| std::ptr::eq(all, *b))
            };
            past.iter().filter_map(index).map(|k| k as u32).collect()
        };
        let before = |surface: &Polygon| {
            let all = (0u32..).zip(&lamps).filter(|(_, lamp)| faces(surface, &lamp.0));
            let shining = |(k, lamp): (u32, &(Polygon, Rgb))| Shining {
                lamp: k,
                past: indices(blockers.between(surface, &lamp.0)),
            };
            all.map(shining).collect()
        };
        let on = scene.surfaces.iter().map(|s| match wanted(scene.material(s)) {
            true => before(&s.polygon),
            false => Vec::new(),
        });
        let on = on.collect();
        Lamps { lamps, blockers, on }
    }

    /// Are there any whose light is found here?
    pub(super) fn are_counted(&self) -> bool {
        !self.lamps.is_empty()
    }

    fn before(
        &self,
        surface: u32,
    ) -> impl Iterator<Item = (&(Polygon, Rgb), SmallVec<[&Blocker; 8]>)> {
        self.on[surface as usize].iter().map(|shining| {
            let past = shining.past.iter().map(|&k| &self.blockers.all()[k as usize]);
            (&self.lamps[shining.lamp as usize], past.collect())
        })
    }

    /// Irradiance, W/m², at the point `x` of a surface with this `normal`, each lamp's
    /// times what `passes(lamp)` says.
    // ANCHOR: irradiance
    pub(super) fn irradiance(
        &self,
        (surface, x, normal): (u32, DVec3, DVec3),
        passes: impl Fn(&Polygon) -> Rgb,
    ) -> Rgb {
        let from = |((lamp, e), past): (&(Polygon, Rgb), SmallVec<[&Blocker; 8]>)| {
            let factor = lambert_visible(x, normal, lamp, &past);
            if factor > 0.0 { *e * factor * passes(lamp) } else { Rgb::ZERO }
        };
        self.before(surface).map(from).sum()
    }
    // ANCHOR_END: irradiance

    /// What the point `x` of a surface sees of each lamp: its radiance, W/(m² sr), and the
    /// pieces.
    pub(super) fn seen_from(
        &self,
        surface: u32,
        x: DVec3,
    ) -> impl Iterator<Item = (Rgb, Vec<Outline>)> {
        let fronts = self
            .before(surface)
            .filter(move |((lamp, _), _)| lamp.plane().height(x) > 0.0);
        fronts.map(move |((lamp, e), past)| (*e / PI, visible_parts(x, lamp, &past)))
    }
}

/// Is some of each before the other?
fn faces(a: &Polygon, b: &Polygon) -> bool {
    let before = |a: &Polygon, b: &Polygon| {
        b.vertices().iter().any(|&v| a.plane().height(v) > 0.0)
    };
    before(a, b) && before(b, a)
}

/// The same scene with panes that let nothing through.
fn with_dull_panes(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    for material in &mut scene.materials {
        let none = Coefficients::default();
        if let (Some(_), Ok(dull)) =
            (material.shine().pane(), Material::new(material.name(), none))
        {
            *material = dull;
        }
    }
    scene
}
