//! Gathers light at points: the residual of a field, by rays and nothing else.

use super::guide::{Guide, square_of};
use super::lights::{FromHere, Lights};
use super::outlook::{Outlook, allotted};
use super::strata::Strata;
use super::{Judged, Sampling};
use crate::geometry::{Frame, Ray, Rgb};
use crate::material::Material;
use crate::mesh::{ElementId, Locator};
use crate::radiometry::cosine_direction;
use crate::random::Stream;
use crate::scene::Scene;
use crate::ways::{Arrival, Met, Specular};
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use std::f64::consts::PI;

/// What is known at one point.
pub(super) struct Point {
    pub stratum: u32,
    pub element: u32,
    sides: [LitSide; 2],
}

/// A side of a surface at a point: the front, and behind it, where light is let through.
#[derive(Default)]
struct LitSide {
    /// `ρ` of a front, `τ` of a back.
    share: Rgb,
    /// `H` of the field, W/m².
    stored: Rgb,
    /// What each of two gathers finds of it.
    gathered: [GatheredLight; 2],
}

/// What one gather finds.
#[derive(Default)]
struct GatheredLight {
    /// `H`, W/m².
    light: Rgb,
    /// The strata that rays met, and what `B` there counts here.
    met: Vec<(u32, Rgb)>,
}

impl Point {
    // ANCHOR: residual
    /// `H(B) − H` on the front, by gather `set`: what the field lacks there.
    pub fn lacks(&self, set: usize) -> Rgb {
        self.sides[0].gathered[set].light - self.sides[0].stored
    }

    /// `r = E + ρ H(B) + τ H_behind(B) − B`, by gather `set`.
    pub fn residual(&self, set: usize) -> Rgb {
        let of = |side: &LitSide| side.share * (side.gathered[set].light - side.stored);
        self.sides.iter().map(of).sum()
    }
    // ANCHOR_END: residual

    /// `H` of the field on the front.
    pub fn stored(&self) -> Rgb {
        self.sides[0].stored
    }

    /// `B − E` of the field.
    pub fn reflected(&self) -> Rgb {
        self.sides.iter().map(|side| side.share * side.stored).sum()
    }

    // ANCHOR: arriving
    /// `H` on the front, as gather `set` has it, of what leaves the strata.
    pub fn arriving(&self, set: usize, of_strata: &[Rgb]) -> Rgb {
        arriving(&self.sides[0].gathered[set], of_strata)
    }

    /// `ρ H + τ H_behind` of the same.
    pub fn returned(&self, set: usize, of_strata: &[Rgb]) -> Rgb {
        let of = |side: &LitSide| side.share * arriving(&side.gathered[set], of_strata);
        self.sides.iter().map(of).sum()
    }
    // ANCHOR_END: arriving

    /// All strata that rays met from the front, or with `behind` from the back.
    pub fn met(&self, behind: bool) -> impl Iterator<Item = &(u32, Rgb)> {
        self.sides[usize::from(behind)].gathered.iter().flat_map(|g| &g.met)
    }
}

fn arriving(gathered: &GatheredLight, of_strata: &[Rgb]) -> Rgb {
    gathered.met.iter().map(|&(h, share)| share * of_strata[h as usize]).sum()
}

/// The scene, ready for gathers.
pub(super) struct Gathering<'a> {
    pub scene: &'a Scene,
    pub rays: &'a Specular<'a>,
    pub lights: &'a Lights<'a>,
    pub strata: &'a Strata,
    pub field: &'a Judged<'a>,
    pub locator: Locator,
    pub sampling: Sampling,
    /// Of one landing, W.
    pub power: f64,
}

/// A place on a side of a surface, where light is gathered.
pub(super) struct GatherPlace {
    x: DVec3,
    surface: u32,
    pub frame: Frame,
}

impl GatherPlace {
    /// A ray from here, and the surface that it leaves.
    fn ray(&self, direction: DVec3) -> (Ray, Option<u32>) {
        (Ray { origin: self.x, direction }, Some(self.surface))
    }
}

/// How rays are drawn, and how many.
#[derive(Clone, Copy)]
pub(super) struct Aim<'g> {
    pub guide: &'g Guide,
    pub rays: usize,
}

impl Aim<'_> {
    /// So many go towards lights besides; few, if that is only the sky: what it sends comes
    /// by openings, of which nothing is known here.
    fn towards(&self, lights: &FromHere) -> usize {
        let share = if lights.has_lamps() { 2 } else { 8 };
        (self.rays / share).max(4)
    }
}

impl Gathering<'_> {
    /// The points of all strata, in order.
    pub fn all(&self) -> Vec<Point> {
        let strata = (0..self.strata.len()).into_par_iter();
        let seen: Vec<Outlook> = strata.map(|h| self.outlook(h)).collect();
        let rays = allotted(&seen, self.sampling.rays);
        let seen = seen.par_iter().zip(rays).enumerate();
        let points = seen.map(|(h, (seen, rays))| {
            let place = |(k, &place)| self.point([h, k], place, seen, rays);
            seen.places.iter().enumerate().map(place).collect::<Vec<Point>>()
        });
        points.flatten_iter().collect()
    }

    pub fn material(&self, h: usize) -> &Material {
        self.strata.material(h, self.scene, self.field.mesh)
    }

    /// The place `x` of a stratum, on its front or behind.
    pub fn place(&self, h: usize, x: DVec3, behind: bool) -> GatherPlace {
        let mesh = self.field.mesh;
        let piece = &self.strata.pieces[self.strata.members[h].start];
        let surface = mesh.surface_of(&mesh.elements[piece.element as usize]);
        let side = &self.scene.surfaces[surface as usize];
        let (surface, towards) = match behind {
            true => (side.back.unwrap_or(surface), -1.0),
            false => (surface, 1.0),
        };
        let frame = Frame::about(towards * side.polygon.normal());
        GatherPlace { x, surface, frame }
    }

    fn point(
        &self,
        [h, k]: [usize; 2],
        place: [f64; 2],
        seen: &Outlook,
        rays: usize,
    ) -> Point {
        let (piece, x) = self.strata.point_at(h, place);
        let element = self.strata.pieces[piece as usize].element;
        let material = self.material(h);
        let stored = (self.field.irradiance)(ElementId(element), x);
        let mut sides = [LitSide::default(), LitSide::default()];
        for (behind, guide) in seen.guides.iter().enumerate() {
            let place = self.place(h, x, behind == 1);
            let gather = |set: u64| {
                let name = [h as u64, k as u64, set, behind as u64];
                let mut random = Stream::named(self.sampling.seed, &name);
                let mut met = Vec::new();
                let aim = Aim { guide, rays };
                let light = self.gather(&place, aim, &mut random, &mut |_, on| {
                    met.extend(on.stratum.map(|h| (h, on.share)));
                });
                GatheredLight { light, met }
            };
            sides[behind] = LitSide {
                share: [material.diffuse(), material.translucence()][behind],
                stored: stored[behind],
                gathered: [gather(1), gather(2)],
            };
        }
        Point { stratum: h as u32, element, sides }
    }

    /// Light that arrives at a place, W/m², from the field and from all that emits: by rays
    /// in all directions, and by rays towards the lights. Of what both may find each counts
    /// the share with which it finds it (Veach & Guibas 1995).
    ///
    /// `find` is told what each ray by direction finds, and at which point of the square.
    // ANCHOR: gather
    pub fn gather(
        &self,
        place: &GatherPlace,
        aim: Aim,
        random: &mut Stream,
        find: &mut dyn FnMut(DVec2, &Arriving),
    ) -> Rgb {
        let lights = self.lights.from(place.x, place.frame.z);
        let mut sum = Rgb::ZERO;
        let count = aim.towards(&lights);
        let (rays, towards) = (aim.rays as f64, count as f64);
        let all: Vec<[f64; 2]> = random.points(aim.rays).collect();
        for even in all {
            let at = aim.guide.draw(even);
            let local = cosine_direction(at);
            let by_direction = rays * aim.guide.pdf(at, local);
            let share = local.z / (PI * by_direction);
            let ray = place.ray(place.frame.world_from_local(local));
            self.rays.follow(ray, random, &mut |arrival| {
                let densities = [by_direction, towards];
                if let Some(on) = self.arrive(arrival, share, &lights, densities) {
                    sum += on.bright + on.reflected;
                    find(at, &on);
                }
            });
        }
        if lights.is_dark() {
            return sum;
        }
        for choice in random.points::<3>(count) {
            let Some(drawn) = lights.draw(choice) else { continue };
            let local = place.frame.local_from_world(drawn.direction);
            if local.z <= 0.0 {
                continue;
            }
            let by_direction = rays * aim.guide.pdf(square_of(local), local);
            let clear = self.rays.clear(place.ray(drawn.direction), drawn.surface);
            let density = towards * drawn.pdf + by_direction;
            sum += clear * drawn.radiance * local.z / density;
        }
        sum
    }
    // ANCHOR_END: gather

    /// What comes from where a ray has arrived; `densities`: of rays by direction, and how
    /// many go towards lights.
    fn arrive(
        &self,
        arrival: &Arrival,
        share: f64,
        lights: &FromHere,
        [by_direction, towards]: [f64; 2],
    ) -> Option<Arriving> {
        let Arrival { met, weight, chain, .. } = arrival;
        let share = share * weight;
        // Only what is seen straight, or through panes, may be drawn as a light.
        let straight = chain.bounces == 0 && !chain.bent;
        let counts = |pdf: f64| match straight {
            true => by_direction / (by_direction + towards * pdf),
            false => 1.0,
        };
        match *met {
            Met::Surface { surface, point, front: true } => {
                let outline = |k: u32| &self.strata.pieces[k as usize].polygon;
                let piece = self.locator.piece(surface, point, outline)?;
                let h = self.strata.of_piece[piece as usize];
                let element = ElementId(self.strata.pieces[piece as usize].element);
                let material = self.material(h as usize);
                let [front, behind] = (self.field.irradiance)(element, point);
                let reflected = material.radiosity(front, behind) - material.emission();
                let bright = match material.emits() {
                    true => {
                        counts(lights.pdf_of_lamp(surface, point)) * material.emission()
                    }
                    false => Rgb::ZERO,
                };
                Some(Arriving {
                    share,
                    bright: share * bright,
                    reflected: share * reflected,
                    stratum: Some(h),
                })
            }
            Met::Sky(direction) => {
                let sky = self.lights.sky()?;
                let counts = counts(lights.pdf_of_sky(direction));
                let bright = share * counts * PI * sky.radiance(direction);
                Some(Arriving { share, bright, reflected: Rgb::ZERO, stratum: None })
            }
            _ => None,
        }
    }
}

/// What comes along a ray from where it has arrived, W/m² of `H`.
pub(super) struct Arriving {
    /// What `B` there counts here.
    pub share: Rgb,
    /// Of a lamp's own light and the sky's, as far as rays by direction count it.
    pub bright: Rgb,
    pub reflected: Rgb,
    pub stratum: Option<u32>,
}
