//! Many levels at one point: beams through windows, joined where they fill one.
//!
//! ```text
//! beam = (eye, window): what the point sees through it, the point mirrored instead of the world
//! ```
//! Chains of mirrors multiply, `m (m − 1)^(L − 1)` of them. But light that has come to one
//! mirror by different chains may well seem to come from one image: two mirrors at a right
//! angle give one, whichever is met first, and each order shows its part. Such parts are
//! joined as soon as together they fill their window. Four mirrors about a room then have
//! some `4 L` images of level `L`, as many as new cells of a chequerboard, and not
//! `4 · 3^(L − 1)`. Hundreds of levels become possible.
//!
//! Sources: Heckbert & Hanrahan 1984 (beam tracing).

use super::image::pyramid;
use super::{Reflects, VirtualWorld};
use crate::geometry::{Outline, Plane, Polygon, Rgb, newell};
use crate::occlusion::{Blocker, inside, visible_parts};
use crate::radiometry::projected_solid_angle;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// What the point sees through one window.
struct Beam {
    /// Where the point is seen itself, by all mirrors so far.
    eye: DVec3,
    normal: DVec3,
    /// The last mirror, and the part of it that is looked through.
    window: Option<(usize, Outline)>,
    weight: Rgb,
}

impl VirtualWorld {
    /// Form factors from a differential area at `x` with unit normal `n` to the front of
    /// `target` by exactly `0, 1, …, levels` reflections, times the mirrors' shares.
    ///
    /// For mirrors alone: panes neither mirror nor weaken here. Same result, to rounding, as
    /// the sum of [`VirtualWorld::sights`], for any number of levels.
    pub fn factors_by_level(
        &self,
        x: DVec3,
        n: DVec3,
        target: &Polygon,
        levels: u32,
    ) -> Vec<Rgb> {
        let all = self.blockers.all();
        let mut beams =
            vec![Beam { eye: x, normal: n, window: None, weight: Rgb::ONE }];
        let blockers: Vec<Vec<Blocker>> = (self.mirrors.iter())
            .map(|m| {
                let plane = m.outline.plane();
                all.iter().flat_map(|b| b.in_front(plane, self.margin)).collect()
            })
            .collect();
        let past = |beam: &Beam| -> Vec<&Blocker> {
            match &beam.window {
                None => all.iter().collect(),
                Some((k, _)) => blockers[*k].iter().collect(),
            }
        };
        let mut found = Vec::new();
        for level in 0..=levels {
            let seen = |beam: &Beam| -> Rgb {
                let parts = self.seen(beam, target, &past(beam));
                let factor =
                    |part: &Outline| projected_solid_angle(beam.eye, beam.normal, part);
                beam.weight * parts.iter().map(factor).sum::<f64>() / PI
            };
            found.push(beams.iter().map(seen).sum());
            if level == levels {
                break;
            }
            beams = self.joined(beams.iter().flat_map(|b| self.next(b, &past(b))));
        }
        found
    }

    /// The parts of a polygon that a beam reaches.
    fn seen(&self, beam: &Beam, polygon: &Polygon, past: &[&Blocker]) -> Vec<Outline> {
        if polygon.plane().height(beam.eye) <= self.margin {
            return Vec::new();
        }
        let mut outline = Outline::from(polygon.vertices());
        if let Some((k, window)) = &beam.window {
            let front = self.mirrors[*k].outline.plane();
            let high = |v: &DVec3| front.height(*v) > self.margin;
            if !outline.iter().any(high) {
                return Vec::new();
            }
            // Seen from behind, the window runs the other way round.
            let window: Outline = window.iter().rev().copied().collect();
            let planes: Vec<Plane> =
                pyramid(beam.eye, &window).chain([front]).collect();
            outline = inside(&outline, &planes);
        }
        let Some(rest) = Polygon::piece(outline.to_vec(), polygon.normal()) else {
            return Vec::new();
        };
        // What lies in its plane, itself among it, hides nothing of it.
        let plane = polygon.plane();
        let above =
            |b: &&Blocker| b.corners().iter().any(|&v| plane.height(v) > self.margin);
        let past: Vec<&Blocker> = past.iter().copied().filter(above).collect();
        visible_parts(beam.eye, &rest, &past)
    }

    /// The beams after one more mirror.
    fn next(&self, beam: &Beam, past: &[&Blocker]) -> Vec<Beam> {
        let mut next = Vec::new();
        for (k, mirror) in self.mirrors.iter().enumerate() {
            let Reflects::Always(share) = mirror.reflects else { continue };
            if beam.window.as_ref().is_some_and(|w| w.0 == k) {
                continue;
            }
            let turn = mirror.outline.plane().mirror();
            next.extend(self.seen(beam, &mirror.outline, past).into_iter().map(
                |part| Beam {
                    eye: turn.transform_point3(beam.eye),
                    normal: turn.transform_vector3(beam.normal),
                    window: Some((k, part)),
                    weight: share * beam.weight,
                },
            ));
        }
        next
    }

    /// Beams of one eye that together fill a mirror become one.
    fn joined(&self, beams: impl Iterator<Item = Beam>) -> Vec<Beam> {
        let mut groups: BTreeMap<[i64; 7], Vec<Beam>> = BTreeMap::new();
        for beam in beams {
            let place = (beam.eye / (1e3 * self.margin)).to_array();
            let weight = (beam.weight * 1e12).to_array();
            let [x, y, z] = place.map(|v| v.round() as i64);
            let [r, g, b] = weight.map(|v| v.round() as i64);
            let mirror = beam.window.as_ref().map_or(-1, |w| w.0 as i64);
            groups.entry([mirror, x, y, z, r, g, b]).or_default().push(beam);
        }
        let join = |mut group: Vec<Beam>| {
            let area = |(_, part): &(usize, Outline)| newell(part).length();
            let filled: f64 =
                group.iter().filter_map(|b| b.window.as_ref()).map(area).sum();
            if let Some((k, part)) = group[0].window.as_mut() {
                let whole = &self.mirrors[*k].outline;
                if filled >= (1.0 - 1e-9) * whole.area() {
                    *part = Outline::from(whole.vertices());
                    group.truncate(1);
                }
            }
            group
        };
        groups.into_values().flat_map(join).collect()
    }
}
