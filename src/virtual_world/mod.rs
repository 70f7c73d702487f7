//! Mirrors and windows in pass 1: the images of the world that a surface sees in them.
//!
//! ```text
//! x' = x − 2 (n·x − offset) n                     a mirror's image of a point
//! F_ij = Σ_images k_s1 … k_sk F(i → image of j, through the windows)        extended factors
//! ```
//! A mirror is a window into a reflected world. Light that comes by mirrors `m₁ … m_k`, in
//! the order in which it is met from the receiver, comes straight from the image
//! `R₁ R₂ … R_k y` of where it started, if it passes all the windows: the outline of `m₁`,
//! that of `m₂` reflected in `m₁`, and so on. What stands in the way on a later leg is
//! reflected with it. So everything that is known about straight light serves again.
//!
//! | part                    | use it when                            | it fails when         |
//! |-------------------------|----------------------------------------|-----------------------|
//! | [`VirtualWorld::sights`]| light from some places to many points  | mirrors are curved    |
//! | [`VirtualWorld::exchange`] | factors between areas             | panes: 1e-4 at best   |
//! | [`VirtualWorld::factors_by_level`] | many levels at one point  | there are panes       |
//! | [`ExtendedAnalytic`]    | factors must be right                  | elements are many     |
//! | [`ExtendedHemicube`]    | rows are due, quickly                  | mirrors are many      |
//! | [`ExtendedCast`]        | nothing may be assumed                 | never; 1/√rays        |
//! | [`Image`]               | one chain of mirrors is to be looked at| the same              |
//!
//! A pane is a mirror on both sides, and a veil that weakens what passes: by angle.
//!
//! ```
//! use radiosity::glam::{DVec3, dvec3};
//! use radiosity::geometry::Rgb;
//! use radiosity::material::{Coefficients, Material, Shine};
//! use radiosity::scene::{Face, MaterialId, Scene};
//! use radiosity::virtual_world::VirtualWorld;
//! let shine = Shine::Mirror { reflectance: Rgb::splat(0.9) };
//! let mirror = Material::new("mirror", Coefficients { shine, ..Coefficients::default() });
//! let outline = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
//! let face = Face { outline, material: MaterialId(0) };
//! let scene = Scene::assemble("mirror", vec![mirror.unwrap()], vec![face], None).unwrap().0;
//! let world = VirtualWorld::of(&scene, 5);
//! assert_eq!(world.images().len(), 2); // the world itself, and what the mirror shows
//! let seen = world.images()[1].of_point(dvec3(0.5, 0.5, 3.0));
//! assert!(seen.distance(dvec3(0.5, 0.5, -3.0)) < 1e-12); // as far behind as it is before
//! ```
//!
//! **Not here:** curved mirrors and solids of glass, which have no image: rays carry their
//! light ([`crate::ways`]). Chapter *Mirrors and windows* (L17, L18). Sources:
//! Rushmeier & Torrance 1990 and Wallace, Cohen & Greenberg 1987 (extended form factors,
//! the virtual world); Heckbert & Hanrahan 1984 (beams through windows).

mod books;
mod cast;
mod deep;
mod exact;
mod exchange;
mod hemicube;
mod image;
mod sight;

pub use cast::ExtendedCast;
pub use exact::ExtendedAnalytic;
pub use exchange::Exchange;
pub use hemicube::ExtendedHemicube;
pub use image::Image;
pub use sight::Sight;

use crate::geometry::{Polygon, Rgb};
use crate::material::optics::pane;
use crate::occlusion::{Blockers, joined_tiles};
use crate::scene::{Scene, Side};
use std::sync::Arc;

/// A flat mirror, or one side of a pane.
#[derive(Clone, Debug)]
pub struct Mirror {
    /// Its outline; the front mirrors.
    pub outline: Polygon,
    /// The surfaces that it is made of: tiles of one plane and material are one mirror.
    pub surfaces: Vec<u32>,
    reflects: Reflects,
    /// Which pane it is a side of.
    pane: Option<usize>,
}

/// How much of the light a mirror or pane sends on.
#[derive(Clone, Copy, Debug)]
enum Reflects {
    Always(Rgb),
    Fresnel { share: Rgb, index: f64 },
}

impl Mirror {
    /// The share of the light that it mirrors, at this cosine to its normal.
    pub fn reflectance(&self, cosine: f64) -> Rgb {
        match self.reflects {
            Reflects::Always(share) => share,
            Reflects::Fresnel { share, index } => share * pane(cosine, index).0,
        }
    }

    /// An upper bound of [`Mirror::reflectance`] over all angles.
    pub fn most(&self) -> Rgb {
        match self.reflects {
            Reflects::Always(share) | Reflects::Fresnel { share, .. } => share,
        }
    }
}

/// A pane as what light passes through.
#[derive(Clone, Debug)]
struct Pane {
    outline: Polygon,
    index: f64,
    /// What is left of what Fresnel's law lets through, per channel.
    passes: Rgb,
}

impl Pane {
    /// The share of the light that passes, at this cosine to its normal.
    fn transmittance(&self, cosine: f64) -> Rgb {
        self.passes * pane(cosine, self.index).1
    }
}

/// The images of a scene in its flat mirrors and panes.
#[derive(Debug)]
pub struct VirtualWorld {
    mirrors: Vec<Mirror>,
    panes: Vec<Pane>,
    images: Vec<Image>,
    /// For each surface the mirror that its front is (part of).
    mirror_of: Vec<Option<u32>>,
    blockers: Arc<Blockers>,
    margin: f64,
    levels: u32,
}

/// No more images than this are kept: with six mirrors, five levels.
const MOST_IMAGES: usize = 20_000;

impl VirtualWorld {
    /// All chains of at most `levels` reflections by which anything may be seen.
    ///
    /// Of `m` mirrors that all see each other there are `m (m − 1)^(L − 1)` chains of `L`
    /// reflections. A level that would need more than 20 000 images is left out:
    /// [`VirtualWorld::levels`] tells how many there are.
    pub fn of(scene: &Scene, levels: u32) -> VirtualWorld {
        let margin = scene.rounding();
        let (mirrors, panes) = mirrors_of(scene, margin);
        let mut mirror_of = vec![None; scene.surfaces.len()];
        for (k, mirror) in (0u32..).zip(&mirrors) {
            let front = |id: &&u32| {
                let normal = scene.surfaces[**id as usize].polygon.normal();
                normal.dot(mirror.outline.normal()) > 0.0
            };
            let surfaces = mirror.surfaces.iter();
            let backs =
                surfaces.clone().filter_map(|&s| scene.surfaces[s as usize].back);
            let backs: Vec<u32> = backs.filter(|_| mirror.pane.is_some()).collect();
            for &id in surfaces.chain(&backs).filter(front) {
                mirror_of[id as usize] = Some(k);
            }
        }
        let mut world = VirtualWorld {
            mirror_of,
            mirrors,
            panes,
            images: vec![Image::identity()],
            blockers: Arc::new(Blockers::of(scene)),
            margin,
            levels: 0,
        };
        let mut first = 0;
        while world.levels < levels {
            let more = world.next_level(&world.images[first..]);
            if more.is_empty() {
                world.levels = levels; // no chain is longer
                break;
            }
            if world.images.len() + more.len() > MOST_IMAGES {
                break;
            }
            first = world.images.len();
            world.levels += 1;
            world.images.extend(more);
        }
        world
    }

    /// All continuations of these chains by one more mirror.
    fn next_level(&self, images: &[Image]) -> Vec<Image> {
        let next = |image: &Image, k: usize| image.then(&self.mirrors, k, self.margin);
        let all = |image| (0..self.mirrors.len()).filter_map(move |k| next(image, k));
        images.iter().flat_map(all).collect()
    }

    /// The mirrors, and each pane twice: a mirror on either side.
    pub fn mirrors(&self) -> &[Mirror] {
        &self.mirrors
    }

    /// All images, by level; the first is the world itself.
    pub fn images(&self) -> &[Image] {
        &self.images
    }

    /// How many reflections are followed.
    pub fn levels(&self) -> u32 {
        self.levels
    }

    /// The mirror that the front of a surface is (part of).
    pub fn mirror_of(&self, surface: u32) -> Option<&Mirror> {
        Some(&self.mirrors[self.mirror_of[surface as usize]? as usize])
    }

    // ANCHOR: divided
    /// What becomes of light that meets a surface at this cosine to its normal: the shares
    /// that are mirrored and that go straight on, per channel.
    fn divided(&self, surface: u32, front: bool, cosine: f64) -> [Rgb; 2] {
        let Some(mirror) = self.mirror_of(surface) else { return [Rgb::ZERO; 2] };
        match mirror.pane {
            Some(id) => {
                let passed = self.panes[id].transmittance(cosine);
                [mirror.reflectance(cosine), passed]
            }
            None if front => [mirror.reflectance(cosine), Rgb::ZERO],
            None => [Rgb::ZERO; 2],
        }
    }
    // ANCHOR_END: divided

    /// Is there no mirror and no pane?
    pub fn is_empty(&self) -> bool {
        self.mirrors.is_empty()
    }

    /// An upper bound of the irradiance, W/m², that all levels which are left out would add
    /// anywhere, per channel: `brightest` is the largest radiosity of any surface.
    ///
    /// ```text
    /// ΔH ≤ B_max F_window (k^(L+1) + k^(L+2) + …) = B_max F_window k^(L+1)/(1 − k)
    /// ```
    /// with `k` the largest share of a mirror and `F_window` how much of a view mirrors can
    /// fill: 1 unless one mirror is alone, which never sees itself, and cuts nothing off
    /// from level 1 on. Perfect mirrors that face each other have no bound: infinite.
    pub fn cut_bound(&self, brightest: Rgb) -> Rgb {
        let share = self.mirrors.iter().fold(Rgb::ZERO, |m, x| m.max(x.most()));
        let faces = |a: &Mirror, b: &Mirror| {
            let plane = a.outline.plane();
            b.outline.vertices().iter().any(|&v| plane.height(v) > self.margin)
        };
        let meet = |a: &Mirror| self.mirrors.iter().any(|b| faces(a, b) && faces(b, a));
        if self.mirrors.is_empty() || self.levels > 0 && !self.mirrors.iter().any(meet)
        {
            return Rgb::ZERO;
        }
        let rest = |k: f64| match k {
            k if k < 1.0 => k.powi(self.levels as i32 + 1) / (1.0 - k),
            _ => f64::INFINITY,
        };
        let scale = |b: f64, k: f64| if b > 0.0 { b * rest(k) } else { 0.0 };
        Rgb::new(
            scale(brightest.x, share.x),
            scale(brightest.y, share.y),
            scale(brightest.z, share.z),
        )
    }

    /// Do all mirrors and panes treat the three channels alike?
    pub fn is_grey(&self) -> bool {
        let grey = |c: Rgb| c.x == c.y && c.y == c.z;
        self.mirrors.iter().all(|m| grey(m.most()))
            && self.panes.iter().all(|p| grey(p.passes))
    }

    /// What stands in the way of straight light.
    pub fn blockers(&self) -> &Arc<Blockers> {
        &self.blockers
    }
}

/// Flat mirrors whose share is not 0, and panes.
fn mirrors_of(scene: &Scene, margin: f64) -> (Vec<Mirror>, Vec<Pane>) {
    let shining = scene.surfaces.iter().enumerate().filter(|(_, s)| {
        let shine = scene.material(s).shine();
        shine.mirror().is_some() || shine.pane().is_some() && s.side == Side::Front
    });
    let shining: Vec<usize> = shining.map(|(k, _)| k).collect();
    let outlines: Vec<&Polygon> =
        shining.iter().map(|&k| &scene.surfaces[k].polygon).collect();
    let material = |k: usize| i64::from(scene.surfaces[shining[k]].material.0);
    let (mut mirrors, mut panes) = (Vec::new(), Vec::new());
    for (outline, tiles) in joined_tiles(&outlines, margin, material) {
        let surfaces: Vec<u32> = tiles.iter().map(|&t| shining[t] as u32).collect();
        let material = scene.material(&scene.surfaces[surfaces[0] as usize]);
        let mut add = |outline, reflects, pane| {
            let surfaces = surfaces.clone();
            mirrors.push(Mirror { outline, surfaces, reflects, pane });
        };
        match material.shine().pane() {
            Some((index, tint)) => {
                let (share, id) = (material.smooth_share(), Some(panes.len()));
                let reflects = Reflects::Fresnel { share, index };
                add(outline.clone(), reflects, id);
                add(outline.flipped(), reflects, id);
                panes.push(Pane { outline, index, passes: share * tint });
            }
            None => {
                let reflects = Reflects::Always(material.shine().reflectance());
                add(outline, reflects, None);
            }
        }
    }
    (mirrors, panes)
}
