//! The matrix of form factors between the faces of a scene, and how far it may be off.
//!
//! ```text
//! A_I F_IJ = Σ A_i F_ij     over the pieces i of face I and j of face J
//! ```
//!
//! | method   | a factor is found by                      | its error is estimated by       |
//! |----------|-------------------------------------------|---------------------------------|
//! | analytic | adaptive integration of visible parts     | the last refinement's change    |
//! | hemicube | hemicubes at points all over i            | points half as dense a side     |
//! | sampling | rays from random points of i              | the scatter of sixteen batches  |

use super::output::Terminal;
use super::solve::FactorMethod;
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::scene::Scene;
use rayon::prelude::*;

/// Form factors between faces.
pub struct FaceMatrix {
    /// How many faces.
    pub n: usize,
    /// Row by row; `n` times `n`.
    pub factors: Vec<f64>,
    /// How far a factor may be off, absolute.
    pub error: f64,
}

/// What is asked for.
pub struct Wanted {
    /// How.
    pub method: FactorMethod,
    /// The absolute error of a factor that is aimed at.
    pub tolerance: f64,
    /// Rays from each face, where they are drawn; else chosen by the tolerance.
    pub samples: Option<usize>,
    /// Names the random streams.
    pub seed: u64,
}

/// A scene whose surfaces are the elements, and whose faces are what is asked about.
struct Faces<'a> {
    scene: &'a Scene,
    /// One element for each surface.
    mesh: Mesh,
    /// The area of each face.
    areas: Vec<f64>,
    terminal: &'a Terminal,
}

/// Computes the matrix.
pub fn compute(scene: &Scene, wanted: &Wanted, terminal: &Terminal) -> FaceMatrix {
    let (mesh, areas) = (Mesh::whole(scene), scene.face_areas());
    let faces = Faces { scene, mesh, areas, terminal };
    match wanted.method {
        FactorMethod::Analytic => faces.analytic(wanted),
        FactorMethod::Hemicube => faces.hemicube(wanted),
        FactorMethod::Sampling => faces.sampling(wanted),
    }
}

/// Does any light that leaves a front reach no front? By rays, some from each surface.
pub fn is_open(scene: &Scene, seed: u64) -> bool {
    let cast = Cast::new(&Mesh::whole(scene), 1024, seed);
    (0..cast.len()).into_par_iter().any(|i| {
        let lost = cast.row(ElementId(i as u32), &mut vec![0.0; cast.len()]);
        lost.escaped + lost.absorbed > 0.0
    })
}

/// Rows that are computed in parallel before they are summed, in order.
const BLOCK: usize = 64;

/// An error that the closed forms are known to stay below, relative.
const CLOSED_FORMS: f64 = 1e-9;

impl Faces<'_> {
    fn len(&self) -> usize {
        self.areas.len()
    }

    /// The face that a surface is part of.
    fn face(&self, surface: usize) -> usize {
        self.mesh.patches[surface].face.0 as usize
    }

    /// Divides row `I` of `A_I F_IJ` by `A_I`; a face without area has a row of zeros.
    fn per_area(&self, exchanges: &mut [f64]) {
        for (row, &area) in exchanges.chunks_mut(self.len()).zip(&self.areas) {
            let scale = if area > 0.0 { 1.0 / area } else { 0.0 };
            row.iter_mut().for_each(|x| *x *= scale);
        }
    }

    fn analytic(&self, wanted: &Wanted) -> FaceMatrix {
        let mut tolerance = wanted.tolerance;
        loop {
            let found = self.analytic_to(tolerance, wanted.seed);
            tolerance *= 0.1;
            if found.error <= wanted.tolerance || tolerance < 1e-3 * wanted.tolerance {
                return found;
            }
        }
    }

    /// One number serves both directions of a pair.
    fn analytic_to(&self, tolerance: f64, seed: u64) -> FaceMatrix {
        let (n, surfaces) = (self.len(), self.mesh.elements.len());
        let method = Analytic::new(self.scene, &self.mesh, tolerance, seed).sharp();
        let mut factors = vec![0.0; n * n];
        let mut errors = vec![0.0; n * n];
        for first in (0..surfaces).step_by(BLOCK) {
            let block = first..(first + BLOCK).min(surfaces);
            self.terminal.progress("form factors", first, surfaces);
            let pairs = |i: usize| {
                let mut found = Vec::new();
                method.exchanges(
                    ElementId(i as u32),
                    i + 1..surfaces,
                    |j, x, error| {
                        found.push((j.0 as usize, (x, error)));
                    },
                );
                found
            };
            let rows: Vec<_> = block.clone().into_par_iter().map(pairs).collect();
            for (i, (j, (exchange, error))) in block
                .zip(rows)
                .flat_map(|(i, row)| row.into_iter().map(move |pair| (i, pair)))
            {
                let (i, j) = (self.face(i), self.face(j));
                for at in [i * n + j, j * n + i] {
                    factors[at] += exchange;
                    errors[at] += error;
                }
            }
        }
        self.per_area(&mut factors);
        self.per_area(&mut errors);
        let off = factors.iter().zip(&errors).map(|(f, e)| e + CLOSED_FORMS * f);
        FaceMatrix { n, error: off.fold(0.0, f64::max), factors }
    }

    /// Cells along the edge of a hemicube. Each hemicube is turned by an angle of its own,
    /// so that what cells cannot resolve averages out.
    const RESOLUTION: u32 = 256;

    /// About so many hemicubes are drawn at the most: half a minute's work.
    const MOST_HEMICUBES: f64 = 65_536.0;

    fn hemicube(&self, wanted: &Wanted) -> FaceMatrix {
        let mut edge = 0.25 * self.scene.diagonal();
        let mut before = self.hemicube_at(edge, wanted.seed);
        loop {
            edge *= 0.5;
            let factors = self.hemicube_at(edge, wanted.seed);
            let apart = before.iter().zip(&factors).map(|(a, b)| (a - b).abs());
            let error = apart.fold(0.0, f64::max);
            let next = 4.0 * Mesh::count_uniform(self.scene, 0.5 * edge);
            if error <= wanted.tolerance || next > Faces::MOST_HEMICUBES {
                return FaceMatrix { n: self.len(), factors, error };
            }
            before = factors;
        }
    }

    /// The mean over each surface of hemicubes, some on each of its cells, whose edges are
    /// `edge` at the most and which end where another surface stands on it.
    ///
    /// A cell is cut into triangles about its middle, and each has a hemicube at its
    /// centroid: exact for light that changes linearly, whatever the outline.
    fn hemicube_at(&self, edge: f64, seed: u64) -> Vec<f64> {
        let cells = Mesh::uniform(self.scene, edge);
        let method = Hemicube::new(&self.mesh, Faces::RESOLUTION).turned(seed);
        self.by_rows(|surface, row| {
            let range = cells.patches[surface].elements.clone();
            let cells = range.into_par_iter().map(|k| {
                let cell = &cells.elements[k as usize].polygon;
                let middle = cell.centroid();
                let (mut sum, mut seen) = (vec![0.0; row.len()], vec![0.0; row.len()]);
                for (a, b) in cell.edges() {
                    let area = 0.5 * (a - middle).cross(b - middle).length();
                    method.at((a + b + middle) / 3.0, cell.normal(), &mut seen);
                    sum.iter_mut().zip(&seen).for_each(|(sum, f)| *sum += area * f);
                }
                sum
            });
            let cells: Vec<Vec<f64>> = cells.collect();
            let area = self.mesh.elements[surface].polygon.area();
            for (j, factor) in row.iter_mut().enumerate() {
                *factor = cells.iter().map(|cell| cell[j]).sum::<f64>() / area;
            }
        })
    }

    /// Independent batches of rays.
    const BATCHES: usize = 16;

    /// About so many rays are drawn at the most: half a minute's work.
    const MOST_RAYS: usize = 1 << 25;

    fn sampling(&self, wanted: &Wanted) -> FaceMatrix {
        let surfaces = self.mesh.elements.len();
        let mut rays = wanted.samples.unwrap_or(4096);
        loop {
            let found = self.sampling_by(rays, wanted.seed);
            let enough = found.error <= wanted.tolerance || wanted.samples.is_some();
            if enough || 4 * rays * surfaces > Faces::MOST_RAYS {
                return found;
            }
            rays *= 4;
        }
    }

    /// The mean of sixteen batches. Its error is taken as four of its standard errors:
    /// among ten thousand factors none is likely to be off by more.
    fn sampling_by(&self, rays: usize, seed: u64) -> FaceMatrix {
        let n = self.len();
        let batches = Faces::BATCHES as f64;
        let (mut sum, mut squares) = (vec![0.0; n * n], vec![0.0; n * n]);
        for batch in 0..Faces::BATCHES as u64 {
            let seed = seed.wrapping_mul(Faces::BATCHES as u64).wrapping_add(batch);
            let cast = Cast::new(&self.mesh, rays.div_ceil(Faces::BATCHES), seed);
            let rows = self.by_rows(|surface, row| {
                cast.row(ElementId(surface as u32), row);
            });
            for (k, factor) in rows.into_iter().enumerate() {
                sum[k] += factor;
                squares[k] += factor * factor;
            }
        }
        sum.iter_mut().for_each(|x| *x /= batches);
        let variance = sum.iter().zip(&squares).map(|(mean, squares)| {
            (squares / batches - mean * mean).max(0.0) * batches / (batches - 1.0)
        });
        let error = 4.0 * (variance.fold(0.0, f64::max) / batches).sqrt();
        FaceMatrix { n, factors: sum, error }
    }

    /// Sums rows of factors between surfaces up to a matrix between faces.
    fn by_rows(&self, row: impl Fn(usize, &mut [f64]) + Sync) -> Vec<f64> {
        let (n, surfaces) = (self.len(), self.mesh.elements.len());
        let mut factors = vec![0.0; n * n];
        for first in (0..surfaces).step_by(BLOCK) {
            let block = first..(first + BLOCK).min(surfaces);
            self.terminal.progress("form factors", first, surfaces);
            let computed = block.clone().into_par_iter().map(|i| {
                let mut computed = vec![0.0; surfaces];
                row(i, &mut computed);
                computed
            });
            let rows: Vec<Vec<f64>> = computed.collect();
            for (i, row) in block.zip(rows) {
                let area = self.mesh.elements[i].polygon.area();
                for (j, factor) in row.into_iter().enumerate() {
                    factors[self.face(i) * n + self.face(j)] += area * factor;
                }
            }
        }
        self.per_area(&mut factors);
        factors
    }
}
