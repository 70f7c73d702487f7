//! Gathers light at points, independently of any form factor.

use super::strata::{NONE, Piece, Strata};
use super::{Judged, Sampling};
use crate::form_factor::ray_from;
use crate::geometry::{Frame, Polygon, Rgb};
use crate::material::Material;
use crate::mesh::{ElementId, Locator, Mesh};
use crate::random::Stream;
use crate::room::Direct;
use crate::scene::Scene;
use crate::visibility::Visibility;
use crate::ways::{Arrival, Met, Specular};
use glam::DVec3;
use rayon::prelude::*;
use std::borrow::Cow;
use std::f64::consts::PI;

/// Of an emission: what interpolation rounds by.
const ROUNDING: f64 = 1e-14;

/// What is known at one point.
pub(super) struct Point {
    pub stratum: u32,
    pub element: u32,
    /// `r` by each of the two gathers.
    pub residual: [Rgb; 2],
    /// `B − E`.
    pub reflected: Rgb,
    /// Of each gather: the strata that rays met, and what `B` there counts here.
    pub met: [Vec<(u32, Rgb)>; 2],
}

impl Point {
    // ANCHOR: arriving
    /// `ρ H`, as gather `set` has it, of what is `of_strata`.
    pub fn arriving(&self, set: usize, of_strata: &[Rgb]) -> Rgb {
        self.met[set].iter().map(|&(h, share)| share * of_strata[h as usize]).sum()
    }
    // ANCHOR_END: arriving
}

/// The scene, ready for gathers.
pub(super) struct Gathering<'a> {
    scene: &'a Scene,
    mesh: &'a Mesh,
    strata: &'a Strata,
    field: &'a Judged<'a>,
    sampling: Sampling,
    rays: Specular<'a>,
    locator: Locator,
    direct: &'a Direct<'a>,
}

/// A side of a surface on which light is gathered.
struct ScatteringSide<'p> {
    polygon: Cow<'p, Polygon>,
    /// `ρ` of a front, `τ` of a back.
    share: Rgb,
}

/// What one gather finds.
#[derive(Default)]
struct GatheredLight {
    /// `ρ H`, W/m².
    light: Rgb,
    met: Vec<(u32, Rgb)>,
}

impl<'a> Gathering<'a> {
    pub fn new(
        (scene, visibility, direct): (&'a Scene, &'a Visibility, &'a Direct<'a>),
        strata: &'a Strata,
        field: &'a Judged<'a>,
        sampling: Sampling,
    ) -> Gathering<'a> {
        let mesh = field.mesh;
        let surface = |p: &Piece| mesh.surface_of(&mesh.elements[p.element as usize]);
        let pieces = strata.pieces.iter().map(|p| (surface(p), &p.polygon));
        let locator = Locator::of(scene, pieces);
        let rays = Specular::within(scene, visibility);
        Gathering { scene, mesh, strata, field, sampling, rays, locator, direct }
    }

    /// The points of all strata, in order.
    pub fn all(&self) -> Vec<Point> {
        let strata = (0..self.strata.len()).into_par_iter();
        strata.flat_map_iter(|h| self.points(h)).collect()
    }

    fn points(&self, h: usize) -> Vec<Point> {
        let mut random = Stream::named(self.sampling.seed, &[h as u64]);
        let places = random.points(self.strata.points[h]);
        places.enumerate().map(|(k, place)| self.point(h, k, place)).collect()
    }

    fn material(&self, piece: u32) -> &Material {
        let element = self.strata.pieces[piece as usize].element;
        let patch = self.mesh.patch_of(&self.mesh.elements[element as usize]);
        &self.scene.materials[patch.material]
    }

    /// `B` of the field at a point that emits `e`. Interpolated between equal corners it may
    /// differ from that by rounding: no light was reflected there.
    fn radiosity(&self, id: ElementId, x: DVec3, e: Rgb) -> Rgb {
        let b = (self.field.radiosity)(id, x);
        if (b - e).abs().cmple(ROUNDING * e).all() { e } else { b }
    }

    fn point(&self, h: usize, k: usize, place: [f64; 2]) -> Point {
        let (which, x) = self.strata.point_at(h, place);
        let piece = &self.strata.pieces[which as usize];
        let material = self.material(which);
        let front = Cow::Borrowed(&piece.polygon);
        let front = ScatteringSide { polygon: front, share: material.diffuse() };
        // A sheet that lets light through diffusely gathers on both its sides.
        let behind = Some(material.translucence()).filter(|tau| *tau != Rgb::ZERO);
        let behind = behind.map(|share| {
            let polygon = Cow::Owned(piece.polygon.flipped());
            ScatteringSide { polygon, share }
        });
        let sides = || [&front].into_iter().chain(&behind);
        let direct = |side: &ScatteringSide| {
            side.share * self.direct.on(&side.polygon).irradiance(x)
        };
        let direct: Rgb = sides().map(direct).sum();
        let e = material.emission();
        let b = self.radiosity(ElementId(piece.element), x, e);
        // ANCHOR: residual
        let gather = |set: u64| {
            let name = [h as u64, k as u64, set];
            let mut random = Stream::named(self.sampling.seed, &name);
            let mut found = GatheredLight::default();
            for side in sides() {
                self.indirect(side, x, &mut random, &mut found);
            }
            found
        };
        let [first, second] = [gather(1), gather(2)];
        let residual = |found: &GatheredLight| e + direct + found.light - b;
        // ANCHOR_END: residual
        Point {
            stratum: h as u32,
            element: piece.element,
            residual: [residual(&first), residual(&second)],
            reflected: b - e,
            met: [first.met, second.met],
        }
    }

    /// Light that arrives at `x` on this side, times what the side scatters of it, but for
    /// what is summed as direct; and from which strata.
    fn indirect(
        &self,
        side: &ScatteringSide,
        x: DVec3,
        random: &mut Stream,
        found: &mut GatheredLight,
    ) {
        let frame = Frame::about(side.polygon.normal());
        let share = side.share / self.sampling.rays as f64;
        let directions: Vec<[f64; 2]> = random.points(self.sampling.rays).collect();
        for [c, d] in directions {
            let mut ray = ray_from(&side.polygon, &frame, [0.0, 0.0, c, d]);
            ray.origin = x;
            self.rays.follow((ray, None), random, &mut |arrival| {
                self.arrive(arrival, share, found);
            });
        }
    }

    /// Adds what leaves where a ray has arrived, but for what is summed as direct.
    fn arrive(&self, arrival: &Arrival, share: Rgb, found: &mut GatheredLight) {
        let Arrival { met, weight, chain } = arrival;
        let share = share * weight;
        match *met {
            Met::Surface { surface, point, front: true } => {
                let outline = |k: u32| &self.strata.pieces[k as usize].polygon;
                let Some(piece) = self.locator.piece(surface, point, outline) else {
                    return;
                };
                let emission = self.material(piece).emission();
                let summed =
                    if self.direct.follows(chain) { emission } else { Rgb::ZERO };
                // Of a black surface the truth is known.
                let h = self.strata.of_piece[piece as usize];
                let element = ElementId(self.strata.pieces[piece as usize].element);
                let light = if h == NONE {
                    emission
                } else {
                    self.radiosity(element, point, emission)
                };
                found.light += share * (light - summed);
                if h != NONE {
                    found.met.push((h, share));
                }
            }
            Met::Sky(direction) => {
                found.light += share * PI * self.direct.other_sky(direction, chain);
            }
            _ => {}
        }
    }
}
