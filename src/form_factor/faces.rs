//! The matrix of form factors between the faces of a scene, and how far it may be off.
//!
//! ```text
//! A_I F_IJ = Σ A_i F_ij     over the pieces i of face I and j of face J
//! ```
//!
//! | method   | a factor is found by                      | its error is estimated by       |
//! |----------|-------------------------------------------|---------------------------------|
//! | analytic | adaptive integration of visible parts     | the last refinement's change    |
//! | hemicube | hemicubes at points all over i            | a quarter of them, half as fine |
//! | sampling | rays from random points of i              | the scatter of sixteen batches  |
//!
//! Pure geometry: every face is an opaque blocker with two sides that sends and receives on
//! its front only.

use super::FormFactors;
use super::analytic::Analytic;
use super::cast::Cast;
use super::face_matrix::{FaceMatrix, SparseRow};
use super::hemicube::Hemicube;
use crate::geometry::Polygon;
use crate::mesh::{ElementId, Mesh};
use crate::scene::Scene;
use crate::work::Work;
use rayon::prelude::*;
use std::f64::consts::PI;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How factors between faces are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FaceFactors {
    /// Lambert's formula and cut blockers, until the error is what is asked for.
    Analytic,
    /// Hemicubes, more of them until the factors settle.
    Hemicube,
    /// Rays, more of them until their scatter is small enough.
    Sampling,
    /// So many rays from each face, whatever the error.
    Rays(usize),
}

/// The factors between the faces of `scene`, in order of the file.
///
/// `error`, positive, is the absolute error of a factor that is aimed at;
/// [`FaceMatrix::error`] tells what was reached. A face that is several surfaces is summed.
///
/// ```
/// use radiosity::form_factor::{FaceFactors, between_faces};
/// use radiosity::{scene::built_in, work::Work};
/// let cube = built_in("furnace").unwrap();
/// let matrix = between_faces(&cube, FaceFactors::Analytic, 1e-6, 0, &Work::quiet());
/// assert!(!matrix.open && matrix.error <= 1e-6 && matrix.closure() < 1e-6);
/// let of_first: Vec<f64> = (1..6).map(|j| matrix.factor(0, j)).collect();
/// assert!(of_first.iter().all(|f| (0.1998..0.2001).contains(f)));
/// ```
pub fn between_faces(
    scene: &Scene,
    how: FaceFactors,
    error: f64,
    seed: u64,
    work: &Work,
) -> FaceMatrix {
    assert!(error > 0.0, "the error must be positive: {error}");
    let scene = &scene.bare_geometry();
    let (mesh, areas) = (Mesh::whole(scene), scene.face_areas());
    let faces = Faces { scene, mesh, areas, error, seed, work };
    let (rows, estimate) = match how {
        FaceFactors::Analytic => faces.analytic(),
        FaceFactors::Hemicube => faces.hemicube(),
        FaceFactors::Sampling => faces.sampling(),
        FaceFactors::Rays(rays) => faces.sampling_by(rays),
    };
    let open = faces.is_open();
    let mut matrix = FaceMatrix { rows, areas: faces.areas, open, error: estimate };
    if !open {
        matrix.error = matrix.error.max(matrix.closure());
    }
    matrix
}

/// A scene whose surfaces are the elements, and whose faces are what is asked about.
struct Faces<'a> {
    scene: &'a Scene,
    /// One element for each surface.
    mesh: Mesh,
    /// The area of each face.
    areas: Vec<f64>,
    /// What is aimed at.
    error: f64,
    seed: u64,
    work: &'a Work<'a>,
}

/// Rows, and how far a factor may be off.
type Found = (Vec<SparseRow>, f64);

/// An error that the closed forms are known to stay below, relative.
const CLOSED_FORMS: f64 = 1e-9;

impl Faces<'_> {
    fn len(&self) -> usize {
        self.areas.len()
    }

    /// The face that a surface is part of.
    fn face(&self, surface: usize) -> u32 {
        self.mesh.patches[surface].face.0
    }

    /// Does any light that leaves a front reach no front? By rays, a million in all.
    fn is_open(&self) -> bool {
        let n = self.mesh.elements.len();
        let rays = ((1 << 20) / n.max(1)).clamp(16, 1024);
        let cast = Cast::new(&self.mesh, rays, self.seed);
        (0..n).into_par_iter().any(|i| {
            let lost = cast.row(ElementId(i as u32), &mut vec![0.0; n]);
            lost.escaped + lost.absorbed > 0.0
        })
    }

    fn analytic(&self) -> Found {
        let mut tolerance = self.error;
        loop {
            let found = self.analytic_to(tolerance);
            tolerance *= 0.1;
            if found.1 <= self.error || tolerance < 1e-3 * self.error {
                return found;
            }
        }
    }

    /// One number serves both directions of a pair.
    fn analytic_to(&self, tolerance: f64) -> Found {
        let surfaces = self.mesh.elements.len();
        let method =
            Analytic::new(self.scene, &self.mesh, tolerance, self.seed).sharp();
        let done = AtomicUsize::new(0);
        let pairs = |i: usize| {
            let mut found = Vec::new();
            method.exchanges(
                ElementId(i as u32),
                i + 1..surfaces,
                |j, exchange, error| {
                    found.push((self.face(j.0 as usize), exchange, error));
                },
            );
            self.tick(&done, surfaces);
            found
        };
        let upper: Vec<Vec<(u32, f64, f64)>> =
            (0..surfaces).into_par_iter().map(pairs).collect();
        let mut rows: Vec<Vec<(u32, f64, f64)>> = vec![Vec::new(); self.len()];
        for (i, pairs) in upper.into_iter().enumerate() {
            let i = self.face(i);
            for (j, exchange, error) in pairs {
                rows[i as usize].push((j, exchange, error));
                rows[j as usize].push((i, exchange, error));
            }
        }
        let mut error = 0.0_f64;
        let sparse = |(row, &area): (Vec<(u32, f64, f64)>, &f64)| {
            let summed = summed(row);
            let off = summed.iter().map(|(_, x, e)| (e + CLOSED_FORMS * x) / area);
            error = off.fold(error, f64::max);
            let factors = summed.iter().filter(|e| e.1 != 0.0);
            factors.map(|&(j, exchange, _)| (j, exchange / area)).collect()
        };
        let rows = rows.into_iter().zip(&self.areas).map(sparse).collect();
        (rows, error)
    }

    /// Cells along the edge of a hemicube, at the end.
    const RESOLUTION: u32 = 256;

    /// About so many hemicubes are drawn at the most: half a minute's work.
    const MOST_HEMICUBES: usize = 1 << 16;

    /// Hemicubes four times as many in each round, until the factors settle.
    ///
    /// The first round has half the resolution, so that it counts what that changes, too.
    /// No factor is known better than by one cell, the largest of which has `4/(π R²)`.
    /// Pairs that all but touch settle on a wrong value: their points are too few.
    fn hemicube(&self) -> Found {
        let cell = 4.0 / (PI * (Faces::RESOLUTION as f64).powi(2));
        let mut triangles = self.triangles();
        let coarse = Faces::RESOLUTION / 2;
        let mut before = self.hemicubes_at(&triangles, coarse);
        let mut round = 1;
        loop {
            let fours = |parts: &Vec<Polygon>| {
                parts.iter().flat_map(Polygon::quarters).collect()
            };
            triangles = triangles.iter().map(fours).collect();
            let rows = self.hemicubes_at(&triangles, Faces::RESOLUTION);
            let error = largest_difference(&before, &rows).max(cell);
            let next = 4 * triangles.iter().map(Vec::len).sum::<usize>();
            // Two rounds agree by chance more often than three.
            if (round > 1 && error <= self.error) || next > Faces::MOST_HEMICUBES {
                return (rows, error);
            }
            (before, round) = (rows, round + 1);
        }
    }

    /// Each surface as triangles, none of which another surface stands on, and large
    /// surfaces as more of them.
    fn triangles(&self) -> Vec<Vec<Polygon>> {
        let cells = Mesh::uniform(self.scene, 0.125 * self.scene.diagonal());
        let about_middle = |k: u32| {
            let cell = &cells.elements[k as usize].polygon;
            let middle = cell.centroid();
            let triangle = move |(a, b)| Polygon::new(vec![a, b, middle]).ok();
            cell.edges().filter_map(triangle)
        };
        let patches = cells.patches.iter();
        patches.map(|p| p.elements.clone().flat_map(about_middle).collect()).collect()
    }

    /// The mean over each surface of hemicubes at the centroids of its triangles: exact for
    /// light that changes linearly. Each hemicube is turned by an angle of its own, so that
    /// what its cells cannot resolve averages out.
    fn hemicubes_at(
        &self,
        triangles: &[Vec<Polygon>],
        resolution: u32,
    ) -> Vec<SparseRow> {
        let method = Hemicube::new(&self.mesh, resolution).turned(self.seed);
        self.by_rows(|surface, add| {
            let polygon = &self.mesh.elements[surface].polygon;
            let mut seen = vec![0.0; self.mesh.elements.len()];
            for triangle in &triangles[surface] {
                method.at(triangle.centroid(), polygon.normal(), &mut seen);
                add(&seen, triangle.area() / polygon.area());
            }
        })
    }

    /// Independent batches of rays.
    const BATCHES: usize = 16;

    /// About so many rays are drawn at the most: half a minute's work.
    const MOST_RAYS: usize = 1 << 25;

    fn sampling(&self) -> Found {
        let mut rays = 4096;
        loop {
            let found = self.sampling_by(rays);
            let next = 4 * rays * self.mesh.elements.len();
            if found.1 <= self.error || next > Faces::MOST_RAYS {
                return found;
            }
            rays *= 4;
        }
    }

    /// The mean of sixteen batches. Its error is taken as four of its standard errors:
    /// among ten thousand factors none is likely to be off by more.
    fn sampling_by(&self, rays: usize) -> Found {
        let batches = Faces::BATCHES as f64;
        let per_batch = rays.div_ceil(Faces::BATCHES);
        let mut sum: Vec<Vec<(u32, f64, f64)>> = vec![Vec::new(); self.len()];
        for batch in 0..Faces::BATCHES as u64 {
            let seed =
                self.seed.wrapping_mul(Faces::BATCHES as u64).wrapping_add(batch);
            let cast = Cast::new(&self.mesh, per_batch, seed);
            let rows = self.by_rows(|surface, add| {
                let mut row = vec![0.0; self.mesh.elements.len()];
                cast.row(ElementId(surface as u32), &mut row);
                add(&row, 1.0);
            });
            for (sum, row) in sum.iter_mut().zip(rows) {
                sum.extend(row.into_iter().map(|(j, f)| (j, f, f * f)));
                *sum = summed(std::mem::take(sum));
            }
        }
        let mut variance = 0.0_f64;
        let mean = |row: Vec<(u32, f64, f64)>| {
            let mean = |(j, sum, squares): (u32, f64, f64)| {
                let mean = sum / batches;
                let own = (squares / batches - mean * mean) * batches / (batches - 1.0);
                variance = variance.max(own);
                (j, mean)
            };
            row.into_iter().map(mean).collect()
        };
        let rows = sum.into_iter().map(mean).collect();
        // What no ray has met may be as large as what a few would have shown.
        let unseen = 4.0 / (batches * per_batch as f64);
        (rows, unseen.max(4.0 * (variance / batches).sqrt()))
    }

    /// Rows between faces from rows between surfaces: `row(surface, add)` calls
    /// `add(row, share)` once or more.
    fn by_rows(
        &self,
        row: impl Fn(usize, &mut dyn FnMut(&[f64], f64)) + Sync,
    ) -> Vec<SparseRow> {
        let n = self.len();
        let mut surfaces: Vec<Vec<usize>> = vec![Vec::new(); n];
        (0..self.mesh.elements.len())
            .for_each(|i| surfaces[self.face(i) as usize].push(i));
        let done = AtomicUsize::new(0);
        let of_face = |sum: &mut Vec<f64>, face: usize| {
            sum.fill(0.0);
            for &i in &surfaces[face] {
                let part = self.mesh.elements[i].polygon.area() / self.areas[face];
                row(i, &mut |factors, share| {
                    for (j, factor) in factors.iter().enumerate() {
                        sum[self.face(j) as usize] += part * share * factor;
                    }
                });
            }
            self.tick(&done, n);
            let all = (0u32..).zip(sum.iter().copied());
            all.filter(|(_, factor)| *factor != 0.0).collect()
        };
        (0..n).into_par_iter().map_init(|| vec![0.0; n], of_face).collect()
    }

    /// One more row is done.
    fn tick(&self, done: &AtomicUsize, all: usize) {
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        self.work.tell("form factors", done, all);
    }
}

/// Sums the entries of equal columns; in order of columns.
fn summed(mut row: Vec<(u32, f64, f64)>) -> Vec<(u32, f64, f64)> {
    row.sort_by_key(|e| e.0); // stable: sums keep their order
    row.dedup_by(|b, a| {
        let same = a.0 == b.0;
        if same {
            *a = (a.0, a.1 + b.1, a.2 + b.2);
        }
        same
    });
    row
}

/// The largest absolute difference of two matrices.
fn largest_difference(a: &[SparseRow], b: &[SparseRow]) -> f64 {
    let of_row = |(a, b): (&SparseRow, &SparseRow)| {
        let entry = |&(j, x): &(u32, f64)| (j, x, 0.0);
        let minus = |&(j, x): &(u32, f64)| (j, -x, 0.0);
        let both = a.iter().map(entry).chain(b.iter().map(minus)).collect();
        summed(both).iter().map(|e| e.1.abs()).fold(0.0, f64::max)
    };
    a.iter().zip(b).map(of_row).fold(0.0, f64::max)
}
