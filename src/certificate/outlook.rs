//! A first look around from each stratum: where light comes from, and how much rays differ.

use super::gathering::{Aim, Gathering};
use super::guide::{BrightCells, Guide, square_of};
use crate::geometry::Rgb;
use crate::random::Stream;
use glam::DVec3;

/// What the first look from a stratum has shown. Its rays are not counted later: whatever it
/// has shown, the answer stays right on average.
pub(super) struct Outlook {
    /// The points, in the unit square.
    pub places: Vec<[f64; 2]>,
    /// In which directions to look, from the front, and behind if light comes through.
    pub guides: Vec<Guide>,
    /// How much gathers differ, times the area: the square root of W² or so.
    noise: f64,
}

/// The first look takes as many rays as are to follow, for a guide that few have made is a bad
/// one; where none is needed it takes this share, but some.
const SHARE: usize = 4;
const FEWEST: usize = 8;

/// What gathers a stratum differ by counts at least as if it scattered this much: what
/// arrives on black fronts is judged, too.
const BLACK: f64 = 0.3;

impl Gathering<'_> {
    // ANCHOR: outlook
    /// Looks around from the points of a stratum.
    pub fn outlook(&self, h: usize) -> Outlook {
        let seed = self.sampling.seed;
        let places: Vec<[f64; 2]> =
            Stream::named(seed, &[h as u64]).points(self.strata.points[h]).collect();
        let material = self.material(h);
        let shares = [material.diffuse(), material.translucence()];
        let sides = 1 + usize::from(shares[1] != Rgb::ZERO);
        let share = if self.is_plain() { SHARE } else { 1 };
        let rays = (self.sampling.rays / share).max(FEWEST);
        let (mut guides, mut noise) = (Vec::new(), 0.0);
        for (side, share) in shares.into_iter().enumerate().take(sides) {
            let behind = side == 1;
            let landed = self.landed(h, places.len(), behind);
            let first = Guide::by(&landed);
            let mut found = landed;
            let mut random = Stream::named(seed, &[h as u64, side as u64, u64::MAX]);
            for &place in &places {
                let place = self.place(h, self.strata.point_at(h, place).1, behind);
                let mut look = || {
                    let aim = Aim { guide: &first, rays };
                    self.gather(&place, aim, &mut random, &mut |at, on| {
                        let [bright, even] =
                            [on.bright, on.reflected].map(Rgb::element_sum);
                        found.add(at, 0.5 * bright, 0.5 * even);
                    })
                };
                let differ = share.max(Rgb::splat(BLACK)) * (look() - look());
                noise += differ.length_squared() / places.len() as f64;
            }
            guides.push(if self.is_plain() { first } else { Guide::by(&found) });
        }
        Outlook { places, guides, noise: noise * self.strata.area[h] }
    }
    // ANCHOR_END: outlook

    /// Are all lights seen straight, so that rays towards them find them?
    fn is_plain(&self) -> bool {
        !self.rays.shines() && self.lights.sky().is_none()
    }

    /// From where light has landed on a stratum, as so many points have seen it.
    fn landed(&self, h: usize, points: usize, behind: bool) -> BrightCells {
        let mut landed = BrightCells::default();
        let frame = self.place(h, DVec3::ZERO, behind).frame;
        let each = self.power * points as f64 / self.strata.area[h];
        for &from in &self.strata.from[h] {
            let local = frame.local_from_world(from);
            if local.z > 0.0 {
                landed.add(square_of(local), each, 0.0);
            }
        }
        landed
    }
}

/// No stratum has fewer or more than so many times the usual rays.
const RAYS: [f64; 2] = [0.5, 16.0];

// ANCHOR: allotted
/// How many rays each stratum gets, so that as many in all as if each had `rays` leave the
/// least doubt: `Σ (A v/m)²` is least for `m ~ (A v)^⅔`, for `v/m` the variance of a gather of
/// `m` rays.
pub(super) fn allotted(seen: &[Outlook], rays: usize) -> Vec<usize> {
    let worth = |seen: &Outlook| seen.noise.powf(2.0 / 3.0);
    let points: f64 = seen.iter().map(|s| s.places.len() as f64).sum();
    let all: f64 = seen.iter().map(|s| worth(s) * s.places.len() as f64).sum();
    let of = |seen: &Outlook| {
        let times = if all > 0.0 { worth(seen) * points / all } else { 1.0 };
        (rays as f64 * times.clamp(RAYS[0], RAYS[1])).ceil() as usize
    };
    seen.iter().map(of).collect()
}
// ANCHOR_END: allotted
