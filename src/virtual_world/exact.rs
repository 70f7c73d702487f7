//! Extended form factors by Lambert's formula and exact images.

use super::VirtualWorld;
use super::cast::ExtendedCast;
use crate::form_factor::analytic::Analytic;
use crate::form_factor::{FormFactors, Lost, Matrix, Row};
use crate::mesh::{ElementId, Mesh};
use rayon::prelude::*;

/// Exact factors by all images; otherwise as [`Analytic`].
///
/// In a matrix one number serves both directions of a pair, so that reciprocity holds to
/// rounding. Where there are no panes, what mirrors send on is booked exactly; only what
/// escapes, or falls on black backs, is counted by rays.
#[derive(Debug)]
pub struct ExtendedAnalytic<'a> {
    direct: Analytic,
    rays: ExtendedCast<'a>,
    mesh: &'a Mesh,
    world: &'a VirtualWorld,
    tolerance: f64,
    channel: usize,
}

/// How many rays count what is lost.
const LOST_RAYS: usize = 2048;

/// A factor, in scene units squared: by all images, and by those of the last level.
type ExactPair = (u32, f64, f64);

impl<'a> ExtendedAnalytic<'a> {
    /// Factors of this `channel` (0, 1 or 2) between the elements of `mesh`: as right as
    /// those of `direct`, which know neither mirrors nor panes.
    pub fn of(
        direct: Analytic,
        mesh: &'a Mesh,
        world: &'a VirtualWorld,
        channel: usize,
    ) -> ExtendedAnalytic<'a> {
        let (tolerance, seed) = (direct.tolerance(), direct.seed());
        let rays = ExtendedCast::new(mesh, world, channel, LOST_RAYS, seed);
        let direct = direct.sharp().without_losses();
        ExtendedAnalytic { direct, rays, mesh, world, tolerance, channel }
    }

    /// What element `i` exchanges with the elements of `range`.
    fn exchanges(&self, i: ElementId, range: std::ops::Range<usize>) -> Vec<ExactPair> {
        let mut direct = vec![0.0; range.len()];
        // Panes weaken the direct light, too; else it is done faster.
        let first = u32::from(self.world.panes.is_empty());
        if first == 1 {
            let start = range.start;
            self.direct.exchanges(i, range.clone(), |j, exchange, _| {
                direct[j.0 as usize - start] = exchange;
            });
        }
        let a = &self.mesh.element(i).polygon;
        let of = |(j, direct): (usize, f64)| {
            let b = &self.mesh.elements[j].polygon;
            let images = self.world.exchange(a, b, first, self.tolerance);
            let last = match self.world.levels() {
                0 if first == 1 => direct,
                _ => images.last[self.channel],
            };
            (j as u32, direct + images.all[self.channel], last)
        };
        let all = range.zip(direct).map(of);
        all.filter(|(_, all, _)| *all != 0.0).collect()
    }

    /// A row, and what it loses, from what element `i` exchanges with all others.
    fn finished(&self, i: ElementId, mut pairs: Vec<ExactPair>) -> Row {
        pairs.sort_unstable_by_key(|p| p.0);
        let area = self.mesh.element(i).polygon.area();
        let mut counted = vec![0.0; self.mesh.elements.len()];
        let mut lost = self.rays.row(i, &mut counted);
        if self.world.panes.is_empty() {
            // Rays know what escapes and what black backs absorb; mirrors are known exactly.
            let credit = |j: usize| {
                let surface = self.mesh.surface_of(&self.mesh.elements[j]);
                let mirror = self.world.mirror_of(surface);
                mirror.map_or(0.0, |m| m.most()[self.channel])
            };
            let by_rays: f64 = (0..counted.len()).map(|j| credit(j) * counted[j]).sum();
            lost.absorbed += by_rays;
            lost.cut = 0.0;
            for &(j, all, last) in &pairs {
                lost.absorbed -= credit(j as usize) * all / area;
                lost.cut += credit(j as usize) * last / area;
            }
        }
        Row::new(pairs.into_iter().map(|(j, all, _)| (j, all / area)).collect(), lost)
    }
}

impl FormFactors for ExtendedAnalytic<'_> {
    fn len(&self) -> usize {
        self.mesh.elements.len()
    }

    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost {
        let found = self.finished(from, self.exchanges(from, 0..row.len()));
        row.fill(0.0);
        found.factors().iter().for_each(|&(j, f)| row[j as usize] = f);
        found.lost()
    }

    /// Each pair once, for both directions.
    fn matrix(&self, done: &(dyn Fn() + Sync)) -> Matrix {
        let n = self.len();
        let upper = |i: usize| {
            let found = self.exchanges(ElementId(i as u32), i..n);
            done();
            found
        };
        let upper: Vec<Vec<ExactPair>> = (0..n).into_par_iter().map(upper).collect();
        let mut rows = upper.clone();
        for (i, pairs) in (0u32..).zip(&upper) {
            for &(j, all, last) in pairs.iter().filter(|p| p.0 != i) {
                rows[j as usize].push((i, all, last));
            }
        }
        let finish = |(i, pairs)| self.finished(ElementId(i as u32), pairs);
        Matrix::from_rows(rows.into_par_iter().enumerate().map(finish).collect())
    }
}
