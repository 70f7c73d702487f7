//! `radiosity form-factors`: the matrix between the faces of a scene.

use super::face_matrix::{FaceMatrix, Wanted, compute, is_open};
use super::output::{Refusal, Terminal, check_writable, extension, write};
use super::solve::{FactorMethod, samples};
use super::{Source, values};
use clap::Args;
use radiosity::scene::Scene;
use serde_json::json;
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Instant;

/// Computes the form factors between the faces of a scene
#[derive(Args)]
#[command(after_help = "Examples:
  radiosity form-factors cornell-regular -o cornell.npy
  radiosity form-factors room.obj -o room.csv --tolerance 1e-6
  radiosity form-factors room.obj -o room.npy --method sampling --samples 100000 --json

Row i holds the factors from face i, in order of the file. Materials do not matter: every
face sends and receives on its front, and blocks from both sides. `open` says whether
some of what leaves a front reaches no front.")]
pub struct FormFactors {
    #[command(flatten)]
    source: Source,
    /// Where to write: .npy (n x n, f64) or .csv (lines i,j,F of what is not zero)
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// How they are computed
    #[arg(long, value_enum, default_value_t = FactorMethod::Analytic)]
    method: FactorMethod,
    /// The absolute error of a factor that is aimed at, as 1e-4 or 0.01%
    #[arg(long, default_value = "1e-4", value_parser = values::tolerance)]
    #[arg(allow_hyphen_values = true)]
    tolerance: f64,
    /// Rays from each face, with `--method sampling` [default: as the tolerance needs]
    #[arg(long, value_name = "N")]
    samples: Option<usize>,
}

/// The matrix of more faces would not fit: three times the square of this, 8 bytes each.
const MOST_FACES: usize = 10_000;

/// What a matrix says of itself.
struct Check {
    /// `max |1 − ΣF|` over the faces that have an area.
    closure: f64,
    /// `max |A_i F_ij − A_j F_ji| / max(A_i, A_j)`.
    reciprocity: f64,
}

impl FormFactors {
    /// Computes and writes.
    pub fn run(&self, seed: u64, terminal: &Terminal) -> Result<(), Refusal> {
        let file = match &self.output {
            Some(path) => {
                let kind = extension(path, &["npy", "csv"])?;
                check_writable(path)?;
                Some((path, kind))
            }
            None => None,
        };
        let tolerance = values::positive("--tolerance", self.tolerance)?;
        let samples = samples(self.samples, self.method)?;
        let scene = self.source.load(terminal)?;
        let faces = scene.faces.len().max(scene.surfaces.len());
        if faces > MOST_FACES {
            return Err(Refusal(format!(
                "{} has {faces} faces, and their matrix is kept for {MOST_FACES} at the \
                 most; use fewer, larger faces",
                scene.name
            )));
        }
        let start = Instant::now();
        let wanted = Wanted { method: self.method, tolerance, samples, seed };
        let matrix = compute(&scene, &wanted, terminal);
        let seconds = start.elapsed().as_secs_f64();
        let open = is_open(&scene, seed);
        let Check { closure, reciprocity } = check(&scene, &matrix);
        // In a closed scene the rows must sum to one: what they miss, factors are off.
        let error = if open { matrix.error } else { matrix.error.max(closure) };

        let n = matrix.n;
        let mut text = format!(
            "{}: {n} x {n} form factors, {}, {seconds:.1} s\n\
             rows sum to one but for {closure:.3e}{}\n\
             reciprocal but for {reciprocity:.3e}\n\
             a factor is off by {error:.1e} at the most, as estimated; asked for: \
             {tolerance:.1e}\n",
            scene.name,
            if open { "open" } else { "closed" },
            if open { ", the most that escapes a face" } else { "" },
        );
        if let Some((path, kind)) = file {
            match kind {
                "npy" => write(path, &npy(&matrix))?,
                _ => write(path, csv(&matrix).as_bytes())?,
            }
            text += &format!("written: {}\n", path.display());
        }
        terminal.report(&text, || {
            json!({
                "n": n,
                "seconds": seconds,
                "open": open,
                "closure_max": closure,
                "reciprocity_max": reciprocity,
                "error_estimate": error,
            })
        })
    }
}

fn check(scene: &Scene, matrix: &FaceMatrix) -> Check {
    let (n, areas) = (matrix.n, scene.face_areas());
    let mut check = Check { closure: 0.0, reciprocity: 0.0 };
    for i in (0..n).filter(|&i| areas[i] > 0.0) {
        let row = &matrix.factors[i * n..(i + 1) * n];
        check.closure = check.closure.max((1.0 - row.iter().sum::<f64>()).abs());
        for j in (0..i).filter(|&j| areas[j] > 0.0) {
            let (there, back) =
                (areas[i] * row[j], areas[j] * matrix.factors[j * n + i]);
            let apart = (there - back).abs() / areas[i].max(areas[j]);
            check.reciprocity = check.reciprocity.max(apart);
        }
    }
    check
}

/// NumPy's format, version 1.0: a header that fills up 64 bytes, then the numbers.
fn npy(matrix: &FaceMatrix) -> Vec<u8> {
    let n = matrix.n;
    let header =
        format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({n}, {n}), }}");
    let before = 10; // magic, version, length
    let length = (before + header.len() + 1).next_multiple_of(64) - before;
    let mut bytes = Vec::with_capacity(before + length + 8 * matrix.factors.len());
    bytes.extend(b"\x93NUMPY\x01\x00");
    bytes.extend((length as u16).to_le_bytes());
    bytes.extend(format!("{header:<width$}\n", width = length - 1).into_bytes());
    bytes.extend(matrix.factors.iter().flat_map(|factor| factor.to_le_bytes()));
    bytes
}

/// `i,j,F`, one line for each factor that is not zero.
fn csv(matrix: &FaceMatrix) -> String {
    let mut text = String::from("i,j,F\n");
    for (k, factor) in matrix.factors.iter().enumerate().filter(|(_, f)| **f != 0.0) {
        let _ = writeln!(text, "{},{},{factor}", k / matrix.n, k % matrix.n);
    }
    text
}
