//! The lamps as points of surfaces see them: with what hides them cut away.

use super::Room;
use super::lamps::{Lamp, LampChoice, Lamps, Receiver};
use crate::geometry::{Outline, Polygon, Rgb};
use crate::occlusion::{Blocker, Blockers, lambert_visible, visible_parts};
use crate::scene::Scene;
use glam::{DAffine3, DVec3};
use smallvec::SmallVec;
use std::f64::consts::PI;
use std::sync::{Arc, OnceLock};

/// Of the lamps before a surface so many are asked at a point.
const ASKED: LampChoice = LampChoice { strongest: 24, drawn: 16 };

/// What light does at panes on its straight way from a lamp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Panes {
    /// It ends: rays bring what comes through.
    Block,
    /// It goes through as if there were none.
    Pass,
}

/// All lamps, and for each surface those that may shine on it.
#[derive(Debug)]
pub struct LampsSeen<'s> {
    scene: &'s Scene,
    lamps: Arc<Lamps>,
    blockers: Arc<Blockers>,
    /// For each surface, once it is asked.
    on: Vec<OnceLock<Vec<Shining>>>,
}

/// A lamp before a surface.
#[derive(Debug)]
struct Shining {
    lamp: u32,
    /// Which of the blockers may stand between.
    past: Vec<u32>,
}

impl<'s> LampsSeen<'s> {
    /// Those of a room.
    pub fn of(room: &Room<'s>, panes: Panes) -> LampsSeen<'s> {
        let scene = room.scene;
        let has_pane = || scene.materials.iter().any(|m| m.shine().pane().is_some());
        let blockers = match panes {
            Panes::Block if has_pane() => Arc::new(Blockers::with_panes(scene)),
            _ => room.images().blockers().clone(),
        };
        let on = scene.surfaces.iter().map(|_| OnceLock::new()).collect();
        LampsSeen { scene, lamps: room.lamps().lamps().clone(), blockers, on }
    }

    /// Are there any?
    pub fn is_empty(&self) -> bool {
        self.lamps.all().is_empty()
    }

    /// Are all of them asked at each point?
    pub fn are_few(&self) -> bool {
        ASKED.takes_all(self.lamps.all().len())
    }

    fn before(&self, surface: u32) -> &[Shining] {
        self.on[surface as usize].get_or_init(|| {
            let outline = &self.scene.surfaces[surface as usize].polygon;
            let index = |b: &Blocker| {
                self.blockers.all().iter().position(|all| std::ptr::eq(all, b))
            };
            let shining = |(lamp, of): (u32, &Lamp)| {
                let past = self.blockers.between(outline, &of.outline).into_iter();
                let past = past.filter_map(index).map(|k| k as u32).collect();
                Shining { lamp, past }
            };
            let all = (0u32..).zip(self.lamps.all());
            all.filter(|(_, lamp)| faces(outline, &lamp.outline)).map(shining).collect()
        })
    }

    /// The lamps that are asked at a point of a surface: what each counts, and what may
    /// stand between.
    fn asked(&self, surface: u32, x: DVec3) -> Vec<(f64, &Lamp, Past<'_>)> {
        let before = self.before(surface);
        let normal = self.scene.surfaces[surface as usize].polygon.normal();
        let chosen = match ASKED.takes_all(before.len()) {
            true => (0..before.len()).map(|k| (k, 1.0)).collect(),
            false => {
                let place = Receiver { middle: x, normal, radius: 0.0 };
                let weight = |shining: &Shining| {
                    let lamp = &self.lamps.all()[shining.lamp as usize];
                    lamp.estimate(&place, &DAffine3::IDENTITY)
                };
                let weights: Vec<f64> = before.iter().map(weight).collect();
                ASKED.choose(&weights, &x.to_array().map(f64::to_bits))
            }
        };
        let lamp = |(k, counts): (usize, f64)| {
            let Shining { lamp, past } = &before[k];
            let past = past.iter().map(|&k| &self.blockers.all()[k as usize]).collect();
            (counts, &self.lamps.all()[*lamp as usize], past)
        };
        chosen.into_iter().map(lamp).collect()
    }

    /// Irradiance, W/m², at the point `x` of a surface, each lamp's times what
    /// `passes(lamp)` says.
    // ANCHOR: irradiance
    pub fn irradiance(
        &self,
        (surface, x): (u32, DVec3),
        passes: impl Fn(&Polygon) -> Rgb,
    ) -> Rgb {
        let normal = self.scene.surfaces[surface as usize].polygon.normal();
        let from = |(counts, lamp, past): (f64, &Lamp, Past)| {
            let factor = lambert_visible(x, normal, &lamp.outline, &past);
            match factor > 0.0 {
                true => counts * lamp.emission * factor * passes(&lamp.outline),
                false => Rgb::ZERO,
            }
        };
        self.asked(surface, x).into_iter().map(from).sum()
    }
    // ANCHOR_END: irradiance

    /// What the point `x` of a surface sees of lamps: their radiance, W/(m² sr), times what
    /// it counts, and the pieces.
    pub fn seen_from(&self, surface: u32, x: DVec3) -> Vec<(Rgb, Vec<Outline>)> {
        let asked = self.asked(surface, x).into_iter();
        let fronts = asked.filter(|(_, l, _)| l.outline.plane().height(x) > 0.0);
        let seen = fronts.map(|(counts, lamp, past)| {
            (counts * lamp.emission / PI, visible_parts(x, &lamp.outline, &past))
        });
        seen.collect()
    }
}

/// What may stand between.
type Past<'a> = SmallVec<[&'a Blocker; 8]>;

/// Is some of each before the other?
fn faces(a: &Polygon, b: &Polygon) -> bool {
    let before = |a: &Polygon, b: &Polygon| {
        b.vertices().iter().any(|&v| a.plane().height(v) > 0.0)
    };
    before(a, b) && before(b, a)
}
