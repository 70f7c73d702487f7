//! Gathers light at points, independently of any form factor.

use super::strata::{NONE, Strata};
use super::{Field, Sampling};
use crate::form_factor::ray_from;
use crate::geometry::{Frame, Polygon, Rgb};
use crate::mesh::ElementId;
use crate::random::Stream;
use crate::scene::Scene;
use crate::solve::{Direct, Enclosure};
use crate::visibility::Visibility;
use glam::DVec3;
use rayon::prelude::*;

/// What is known at one point.
pub(super) struct Point {
    pub stratum: u32,
    pub element: u32,
    pub reflectance: Rgb,
    /// `r` by each of the two gathers.
    pub residual: [Rgb; 2],
    /// `B − E`.
    pub reflected: Rgb,
    /// For each ray of each gather: the stratum that it meets, or [`NONE`].
    pub met: [Vec<u32>; 2],
}

impl Point {
    // ANCHOR: arriving
    /// `ρ H`, as gather `set` has it, of what is `of_strata`.
    pub fn arriving(&self, set: usize, of_strata: &[Rgb]) -> Rgb {
        let met = self.met[set].iter().filter(|&&h| h != NONE);
        let sum: Rgb = met.map(|&h| of_strata[h as usize]).sum();
        self.reflectance * sum / self.met[set].len() as f64
    }
    // ANCHOR_END: arriving
}

/// The scene, ready for gathers.
pub(super) struct Gathering<'a> {
    enclosure: &'a Enclosure,
    strata: &'a Strata,
    field: Field<'a>,
    sampling: Sampling,
    pieces: Visibility,
    direct: Direct<'a>,
}

impl<'a> Gathering<'a> {
    pub fn new(
        scene: &'a Scene,
        enclosure: &'a Enclosure,
        strata: &'a Strata,
        field: Field<'a>,
        sampling: Sampling,
    ) -> Gathering<'a> {
        let pieces = Visibility::new(strata.pieces.iter().map(|p| &p.polygon));
        let direct = Direct::of(scene);
        Gathering { enclosure, strata, field, sampling, pieces, direct }
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

    fn point(&self, h: usize, k: usize, place: [f64; 2]) -> Point {
        let (piece, x) = self.strata.point_at(h, place);
        let element = piece.element as usize;
        let (e, rho) =
            (self.enclosure.emission[element], self.enclosure.reflectance[element]);
        let direct = self.direct.on(&piece.polygon).irradiance(x);
        let b = (self.field)(ElementId(piece.element), x);
        // ANCHOR: residual
        let gather = |set: u64| {
            let name = [h as u64, k as u64, set];
            self.indirect(&piece.polygon, x, Stream::named(self.sampling.seed, &name))
        };
        let [(first, met_first), (second, met_second)] = [gather(1), gather(2)];
        let residual = |indirect: Rgb| e + rho * (direct + indirect) - b;
        // ANCHOR_END: residual
        Point {
            stratum: h as u32,
            element: piece.element,
            reflectance: rho,
            residual: [residual(first), residual(second)],
            reflected: b - e,
            met: [met_first, met_second],
        }
    }

    /// Light that arrives at `x`, but for what is summed as direct; and from which strata.
    fn indirect(
        &self,
        from: &Polygon,
        x: DVec3,
        mut random: Stream,
    ) -> (Rgb, Vec<u32>) {
        let frame = Frame::about(from.normal());
        let mut sum = Rgb::ZERO;
        let mut met = Vec::with_capacity(self.sampling.rays);
        for [c, d] in random.points(self.sampling.rays) {
            let mut ray = ray_from(from, &frame, [0.0, 0.0, c, d]);
            ray.origin = x;
            let hit = self.pieces.closest(&ray, None).filter(|hit| hit.front);
            met.push(hit.map_or(NONE, |hit| self.strata.of_piece[hit.item as usize]));
            if let Some(hit) = hit {
                let y = ray.origin + hit.distance * ray.direction;
                sum += self.leaving(hit.item as usize, y);
            }
        }
        (sum / self.sampling.rays as f64, met)
    }

    /// What leaves piece `at` at `y`, but for what is summed as direct.
    fn leaving(&self, at: usize, y: DVec3) -> Rgb {
        let element = self.strata.pieces[at].element;
        let emission = self.enclosure.emission[element as usize];
        let summed = if self.direct.sums_emitters() { emission } else { Rgb::ZERO };
        // Of a black surface the truth is known.
        let black = self.strata.of_piece[at] == NONE;
        let light = if black { emission } else { (self.field)(ElementId(element), y) };
        light - summed
    }
}
