//! `radiosity form-factors`: the matrix between the faces of a scene.

use super::output::{Refusal, Terminal, check_writable, extension, write_by};
use super::solve::{FactorMethod, samples};
use super::{Source, values};
use clap::Args;
use radiosity::form_factor::{Closing, FaceFactors, FaceMatrix, between_faces};
use radiosity::scene::Scene;
use radiosity::tables;
use radiosity::work::Work;
use serde_json::{Value, json};
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
        let error = values::positive("--tolerance", self.tolerance)?;
        let how = match (self.method, samples(self.samples, self.method)?) {
            (FactorMethod::Auto | FactorMethod::Analytic, _) => FaceFactors::Analytic,
            (FactorMethod::Hemicube, _) => FaceFactors::Hemicube,
            (FactorMethod::Sampling, None) => FaceFactors::Sampling,
            (FactorMethod::Sampling, Some(rays)) => FaceFactors::Rays(rays),
        };
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
        let progress = |what, done, all| terminal.progress(what, done, all);
        let mut matrix =
            between_faces(&scene, how, error, seed, &Work::told(&progress));
        let seconds = start.elapsed().as_secs_f64();
        let closing = self.closed(&scene, &mut matrix)?;
        let mut text = self.text(&scene, &matrix, closing.as_ref(), seconds);
        if let Some((path, kind)) = file {
            match kind {
                "npy" => write_by(path, |file| tables::matrix_npy(&matrix, file))?,
                _ => write_by(path, |file| tables::matrix_csv(&matrix, file))?,
            }
            text += &format!("written: {}\n", path.display());
        }
        terminal.report(&text, || json_of(&matrix, closing.as_ref(), seconds))
    }

    /// The repair, where it was asked for and the scene is closed.
    fn closed(
        &self,
        scene: &Scene,
        matrix: &mut FaceMatrix,
    ) -> Result<Option<Closing>, Refusal> {
        match (self.close, matrix.open) {
            (false, _) => Ok(None),
            (true, false) => Ok(matrix.close()),
            (true, true) => Err(Refusal(format!(
                "{} is open, so rows may sum to less than one, and --close would invent \
                 light; leave --close out",
                scene.name
            ))),
        }
    }

    /// For people.
    fn text(
        &self,
        scene: &Scene,
        matrix: &FaceMatrix,
        closing: Option<&Closing>,
        seconds: f64,
    ) -> String {
        let n = matrix.rows.len();
        let (kind, escapes) = match matrix.open {
            true => ("open", ", the most that escapes a face"),
            false => ("closed", ""),
        };
        let mut text = format!(
            "{}: {n} x {n} form factors, {kind}, {seconds:.1} s\n\
             rows sum to one but for {:.3e}{escapes}\n\
             reciprocal but for {:.3e}\n\
             a factor is off by {:.1e} at the most, as estimated; asked for: {:.1e}\n",
            scene.name,
            matrix.closure(),
            matrix.reciprocity(),
            matrix.error,
            self.tolerance,
        );
        if let Some(Closing { before, change, .. }) = closing {
            text += &format!(
                "--close: rows summed to one but for {before:.3e}; the largest change of a \
                 factor is {change:.3e}\n"
            );
        }
        text
    }
}

/// For other programs.
fn json_of(matrix: &FaceMatrix, closing: Option<&Closing>, seconds: f64) -> Value {
    let mut object = json!({
        "n": matrix.rows.len(),
        "seconds": seconds,
        "open": matrix.open,
        "closure_max": matrix.closure(),
        "reciprocity_max": matrix.reciprocity(),
        "error_estimate": matrix.error,
    });
    if let Some(Closing { before, after, change }) = closing {
        object["close"] = json!({
            "closure_before": before,
            "closure_after": after,
            "largest_change": change,
        });
    }
    object
}
