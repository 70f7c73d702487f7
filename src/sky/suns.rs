//! Texels so bright that they are lamps of their own.
//!
//! A sun in one texel sends as much as all the sky, from next to nowhere: whoever looks for
//! it by cells or by even rays misses it, or finds it and takes it for larger. So it is
//! handed out apart.

use super::{Panorama, Sky, SkyLight};
use crate::geometry::Rgb;
use glam::DVec3;
use std::sync::Arc;

/// A texel as a distant lamp.
#[derive(Clone, Debug, PartialEq)]
pub struct Sun {
    /// The directions of its corners, of unit length, counter-clockwise seen from here; three
    /// at the poles.
    pub corners: Vec<DVec3>,
    /// In W/(m² sr).
    pub radiance: Rgb,
    /// In sr.
    pub solid_angle: f64,
}

/// A texel larger than this, in sr, is no sun: its edges are not straight.
const LARGEST: f64 = 0.01;

impl Sky {
    /// The texels that alone send more than `share` of all light, `most` at the most, and the
    /// sky without them. `None` when there is no such texel, as in all skies but panoramas.
    pub fn without_suns(&self, share: f64, most: usize) -> Option<(Vec<Sun>, Sky)> {
        let SkyLight::Panorama(panorama) = &self.light else { return None };
        let width = panorama.width();
        let sends = |k: usize| {
            panorama.texels()[k].element_sum() * panorama.solid_angle(k / width)
        };
        let enough = share * panorama.total().element_sum();
        let is_sun = |k: &usize| {
            sends(*k) > enough && panorama.solid_angle(k / width) <= LARGEST
        };
        let mut found: Vec<usize> =
            (0..panorama.texels().len()).filter(is_sun).collect();
        found.sort_by(|&a, &b| sends(b).total_cmp(&sends(a)).then(a.cmp(&b)));
        found.truncate(most);
        if found.is_empty() {
            return None;
        }
        let mut rest = panorama.texels().to_vec();
        let suns = found.iter().map(|&k| {
            let (column, row) = (k % width, k / width);
            let corner = |(x, y): (usize, usize)| {
                self.world_from_sky * panorama.direction(x as f64, y as f64)
            };
            let around = [
                (column, row),
                (column, row + 1),
                (column + 1, row + 1),
                (column + 1, row),
            ];
            let mut corners: Vec<DVec3> = around.into_iter().map(corner).collect();
            corners.dedup_by(|a, b| a.distance(*b) < 1e-9);
            if corners[0].distance(corners[corners.len() - 1]) < 1e-9 {
                corners.pop();
            }
            let (radiance, solid_angle) = (rest[k], panorama.solid_angle(row));
            rest[k] = Rgb::ZERO;
            Sun { corners, radiance, solid_angle }
        });
        let suns = suns.collect();
        let rest = Panorama::new(width, rest).ok()?;
        let light = SkyLight::Panorama(Arc::new(rest));
        Some((suns, Sky { world_from_sky: self.world_from_sky, light }))
    }
}
