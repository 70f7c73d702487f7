//! From beam to beam: what each patch sees of each other one, bin by bin.

use super::Bins;
use crate::form_factor::{Closing, Lost, Matrix, Row, close};
use crate::geometry::{Frame, Polygon, Ray, Rgb};
use crate::mesh::Mesh;
use crate::random::Stream;
use crate::visibility::Visibility;
use glam::{DVec3, dvec2};
use rayon::prelude::*;

/// For each beam, the beams that end in it, with their shares.
///
/// Beam `i m + a` is bin `a` of patch `i`. Seen from the patch, what arrives in a bin came
/// along the direction that the bin's own light would take, the other way.
#[derive(Debug)]
pub struct Transport {
    bins: Bins,
    areas: Vec<f64>,
    frames: Vec<Frame>,
    /// `T_ia,jc` of row `i m + a`, in order of `j m + c`.
    rows: Vec<Vec<(u32, f64)>>,
    lost: Vec<Lost>,
}

/// What the rays of a beam start from and meet, and how many they are.
struct BeamRays<'m> {
    polygons: Vec<&'m Polygon>,
    surfaces: Visibility,
    rays: usize,
    seed: u64,
}

impl Transport {
    /// By so many rays (positive) from each beam of each element of `mesh`.
    ///
    /// # Accuracy
    /// A share `t` has at most the standard error `√(t(1 − t)/rays)`. Rows sum to one, with
    /// what is lost; reciprocity holds within the error, and exactly after
    /// [`Transport::close`].
    pub fn sampled(mesh: &Mesh, bins: Bins, rays: usize, seed: u64) -> Transport {
        assert!(rays > 0, "rays must be positive");
        let polygons: Vec<&Polygon> = mesh.polygons().collect();
        let frames: Vec<_> =
            polygons.iter().map(|p| Frame::about(p.normal())).collect();
        let areas = polygons.iter().map(|p| p.area()).collect();
        let (rows, lost) = (Vec::new(), Vec::new());
        let mut transport = Transport { bins, areas, frames, rows, lost };
        let surfaces = Visibility::new(polygons.iter().copied());
        let beams = 0..(polygons.len() * bins.len()) as u32;
        let how = BeamRays { polygons, surfaces, rays, seed };
        let row = |beam| transport.row(beam, &how);
        (transport.rows, transport.lost) = beams.into_par_iter().map(row).unzip();
        transport
    }

    /// What a beam sends to others, and what of it reaches no front.
    fn row(&self, beam: u32, how: &BeamRays) -> (Vec<(u32, f64)>, Lost) {
        let &BeamRays { ref polygons, ref surfaces, rays, seed } = how;
        let m = self.bins.len() as u32;
        let (patch, bin) = (beam / m, beam % m);
        let from = polygons[patch as usize];
        let (mut met, mut lost) = (Vec::new(), Lost::default());
        let share = 1.0 / rays as f64;
        // ANCHOR: rays
        for [u, v, a, b] in Stream::named(seed, &[u64::from(beam)]).points(rays) {
            let local = self.bins.direction(bin, dvec2(a, b));
            let direction = self.frames[patch as usize].world_from_local(local);
            let ray = Ray { origin: from.point_at([u, v]), direction };
            match surfaces.closest(&ray, Some(patch)) {
                None => lost.escaped += share,
                Some(hit) => match self.beam(hit.item, -direction) {
                    Some(beam) => met.push(beam),
                    None => lost.absorbed += share,
                },
            }
        }
        // ANCHOR_END: rays
        met.sort_unstable();
        let runs = met.chunk_by(|a, b| a == b);
        (runs.map(|run| (run[0], run.len() as f64 * share)).collect(), lost)
    }

    /// Makes a closed scene reciprocal, its rows summing to one: a repair by [`close`],
    /// which says what it changed. Does nothing to a scene that loses light.
    pub fn close(&mut self) -> Option<Closing> {
        if self.lost.iter().any(|&lost| lost != Lost::default()) {
            return None;
        }
        let m = self.bins.len();
        let areas: Vec<f64> =
            self.areas.iter().flat_map(|&area| vec![area; m]).collect();
        Some(close(&mut self.rows, &areas))
    }

    /// The directions.
    pub fn bins(&self) -> Bins {
        self.bins
    }

    /// How many patches.
    pub fn patches(&self) -> usize {
        self.areas.len()
    }

    /// How many pairs of beams are stored.
    pub fn pairs(&self) -> usize {
        self.rows.iter().map(Vec::len).sum()
    }

    /// The form factors that these shares add up to: `F_ij = 1/m Σ_a Σ_c T_ia,jc`.
    pub fn form_factors(&self) -> Matrix {
        let m = self.bins.len();
        let row = |i: usize| {
            let mut factors = vec![0.0; self.patches()];
            let mut lost = Lost::default();
            for beam in i * m..(i + 1) * m {
                for &(from, share) in &self.rows[beam] {
                    factors[from as usize / m] += share / m as f64;
                }
                lost.escaped += self.lost[beam].escaped / m as f64;
                lost.absorbed += self.lost[beam].absorbed / m as f64;
            }
            Row::of(&factors, lost)
        };
        Matrix::from_rows((0..self.patches()).map(row).collect())
    }

    /// `A_i`, scene units squared.
    pub(super) fn area(&self, patch: usize) -> f64 {
        self.areas[patch]
    }

    /// What of a beam's light reaches no front.
    pub(super) fn lost(&self, beam: usize) -> Lost {
        self.lost[beam]
    }

    /// The beam in which `patch` sends along a direction of unit length.
    pub(super) fn beam(&self, patch: u32, direction: DVec3) -> Option<u32> {
        let local = self.frames[patch as usize].local_from_world(direction);
        Some(patch * self.bins.len() as u32 + self.bins.bin_of(local)?)
    }

    // ANCHOR: incoming
    /// The radiance that arrives in each bin of each patch, when each beam has this one.
    pub(super) fn incoming(&self, radiance: &[Rgb]) -> Vec<Rgb> {
        let sum = |row: &Vec<(u32, f64)>| {
            row.iter().map(|&(beam, share)| share * radiance[beam as usize]).sum()
        };
        self.rows.par_iter().map(sum).collect()
    }
    // ANCHOR_END: incoming
}
