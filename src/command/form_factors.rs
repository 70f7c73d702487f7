//! `radiosity form-factors`: the matrix between the faces of a scene.

use super::face_matrix::{FaceMatrix, Wanted, compute, is_open};
use super::output::{Refusal, Terminal, check_writable, extension, write_by};
use super::solve::{FactorMethod, samples};
use super::{Source, values};
use clap::Args;
use radiosity::form_factor::{Closing, close};
use radiosity::scene::Scene;
use serde_json::json;
use std::io::{self, Write};
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
    #[arg(long, value_enum, default_value_t = FactorMethod::Auto)]
    method: FactorMethod,
    /// The absolute error of a factor that is aimed at, as 1e-4 or 0.01%
    #[arg(long, default_value = "1e-4", value_parser = values::tolerance)]
    #[arg(allow_hyphen_values = true)]
    tolerance: f64,
    /// Rays from each face, with `--method sampling` [default: as the tolerance needs]
    #[arg(long, value_name = "N")]
    samples: Option<usize>,
    /// Scales the rows of a closed scene to sums of one, and reports what that changed; it
    /// hides errors, it does not mend them
    #[arg(long)]
    close: bool,
}

/// The matrix of more faces would not fit: up to 40 bytes for each pair that see each other.
const MOST_FACES: usize = 20_000;

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
        let scene = self.source.load(terminal)?.bare_geometry();
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
        let mut matrix = compute(&scene, &wanted, terminal);
        let seconds = start.elapsed().as_secs_f64();
        let open = is_open(&scene, seed);
        let closing = self.closed(&scene, &mut matrix, open)?;
        let Check { closure, reciprocity } = check(&scene, &matrix);
        // In a closed scene the rows must sum to one: what they miss, factors are off.
        let missed = closing.map_or(closure, |closing| closing.before);
        let error = if open { matrix.error } else { matrix.error.max(missed) };

        let n = matrix.rows.len();
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
        if let Some(Closing { before, change, .. }) = closing {
            text += &format!(
                "--close: rows summed to one but for {before:.3e}; the largest change of a \
                 factor is {change:.3e}\n"
            );
        }
        if let Some((path, kind)) = file {
            match kind {
                "npy" => write_by(path, |file| npy(&matrix, file))?,
                _ => write_by(path, |file| csv(&matrix, file))?,
            }
            text += &format!("written: {}\n", path.display());
        }
        terminal.report(&text, || {
            let mut object = json!({
                "n": n,
                "seconds": seconds,
                "open": open,
                "closure_max": closure,
                "reciprocity_max": reciprocity,
                "error_estimate": error,
            });
            if let Some(Closing { before, after, change }) = closing {
                object["close"] = json!({
                    "closure_before": before,
                    "closure_after": after,
                    "largest_change": change,
                });
            }
            object
        })
    }

    /// The repair, where it was asked for and the scene is closed.
    fn closed(
        &self,
        scene: &Scene,
        matrix: &mut FaceMatrix,
        open: bool,
    ) -> Result<Option<Closing>, Refusal> {
        match (self.close, open) {
            (false, _) => Ok(None),
            (true, false) => Ok(Some(close(&mut matrix.rows, &scene.face_areas()))),
            (true, true) => Err(Refusal(format!(
                "{} is open, so rows may sum to less than one, and --close would invent \
                 light; leave --close out",
                scene.name
            ))),
        }
    }
}

fn check(scene: &Scene, matrix: &FaceMatrix) -> Check {
    let areas = scene.face_areas();
    let mut check = Check { closure: 0.0, reciprocity: 0.0 };
    for (i, row) in matrix.rows.iter().enumerate().filter(|&(i, _)| areas[i] > 0.0) {
        let sum = row.iter().map(|e| e.1).sum::<f64>();
        check.closure = check.closure.max((1.0 - sum).abs());
        for &(j, factor) in row {
            let other = &matrix.rows[j as usize];
            let back = other.binary_search_by_key(&(i as u32), |e| e.0);
            let back = back.map_or(0.0, |k| other[k].1);
            let (there, back) = (areas[i] * factor, areas[j as usize] * back);
            let apart = (there - back).abs() / areas[i].max(areas[j as usize]);
            check.reciprocity = check.reciprocity.max(apart);
        }
    }
    check
}

/// NumPy's format, version 1.0: a header that fills up 64 bytes, then the numbers.
fn npy(matrix: &FaceMatrix, file: &mut dyn Write) -> io::Result<()> {
    let n = matrix.rows.len();
    let header =
        format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({n}, {n}), }}");
    let before = 10; // magic, version, length
    let length = (before + header.len() + 1).next_multiple_of(64) - before;
    file.write_all(b"\x93NUMPY\x01\x00")?;
    file.write_all(&(length as u16).to_le_bytes())?;
    writeln!(file, "{header:<width$}", width = length - 1)?;
    let mut dense = vec![0.0; n];
    for row in &matrix.rows {
        row.iter().for_each(|&(j, factor)| dense[j as usize] = factor);
        dense.iter().try_for_each(|f: &f64| file.write_all(&f.to_le_bytes()))?;
        row.iter().for_each(|&(j, _)| dense[j as usize] = 0.0);
    }
    Ok(())
}

/// `i,j,F`, one line for each factor that is not zero.
fn csv(matrix: &FaceMatrix, file: &mut dyn Write) -> io::Result<()> {
    writeln!(file, "i,j,F")?;
    for (i, row) in matrix.rows.iter().enumerate() {
        row.iter().try_for_each(|(j, factor)| writeln!(file, "{i},{j},{factor}"))?;
    }
    Ok(())
}
