//! The verbs of the command, one file each, and what they share.
//!
//! | exit code | meaning                                                               |
//! |-----------|-----------------------------------------------------------------------|
//! | 0         | done; a solution that did not converge says so by a value             |
//! | 1         | understood, but cannot be done: one sentence on standard error        |
//! | 2         | not understood                                                        |
//! | 130       | interrupted; no file is half written                                  |

mod chart;
mod compare;
mod compare_page;
mod explain;
mod form_factors;
mod methods;
mod output;
mod report;
mod render;
mod scenes;
mod sky;
mod solve;
mod told;
mod values;

use clap::{Args, Parser, Subcommand};
use output::{Refusal, Terminal};
use radiosity::scene::{BuiltInError, Camera, Scene, built_in};
use radiosity::{glam::DVec3, obj};
use std::path::Path;
use std::process::ExitCode;

/// Light in scenes of diffuse surfaces, with an account of where it went.
///
/// Without a verb: solves the Cornell box and draws it into out/cornell.png.
#[derive(Parser)]
#[command(
    version,
    after_help = "Examples:
  radiosity
  radiosity scenes
  radiosity render l-room -o l-room.png --tolerance 5%
  radiosity solve room.obj -o room.csv --json
  radiosity compare gallery
  radiosity explain cornell --tolerance 1%
  radiosity form-factors room.obj -o room.npy

SCENE is the name of a built-in scene or the path of an .obj file.
Exit codes: 0 done, 1 cannot be done, 2 not understood, 130 interrupted."
)]
struct Arguments {
    #[command(subcommand)]
    verb: Option<Verb>,
    #[command(flatten)]
    common: Common,
}

#[derive(Subcommand)]
enum Verb {
    Scenes(scenes::Scenes),
    Solve(solve::Solve),
    FormFactors(form_factors::FormFactors),
    Render(Box<render::Render>),
    Compare(compare::Compare),
    Explain(explain::Explain),
    Chart(chart::Chart),
}

/// What every verb understands.
#[derive(Args)]
struct Common {
    /// How many threads to use; the result does not depend on it [default: all cores]
    #[arg(long, global = true, value_name = "N")]
    threads: Option<usize>,
    /// Names the random numbers: another seed is another, equally good, answer
    #[arg(long, global = true, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// No progress, no warnings, no summary
    #[arg(long, global = true)]
    quiet: bool,
    /// Print one JSON object on standard output, and nothing else there
    #[arg(long, global = true)]
    json: bool,
}

/// No machine has more threads than this.
const MOST_THREADS: usize = 1024;

/// Runs the command.
pub fn run() -> ExitCode {
    let arguments = Arguments::parse(); // exits with 2 when it cannot
    let terminal = Terminal::new(arguments.common.quiet, arguments.common.json);
    match perform(&arguments, &terminal) {
        Ok(()) => ExitCode::SUCCESS,
        Err(refusal) => {
            terminal.refuse(&refusal);
            ExitCode::from(1)
        }
    }
}

fn perform(arguments: &Arguments, terminal: &Terminal) -> Result<(), Refusal> {
    output::watch_for_interrupts()?;
    if let Some(threads) = arguments.common.threads {
        if !(1..=MOST_THREADS).contains(&threads) {
            return Err(Refusal(format!(
                "--threads {threads} is not possible; choose 1 to {MOST_THREADS}"
            )));
        }
        rayon::ThreadPoolBuilder::new().num_threads(threads).build_global()?;
    }
    let seed = arguments.common.seed;
    match &arguments.verb {
        Some(Verb::Scenes(scenes)) => scenes.run(terminal),
        Some(Verb::Solve(solve)) => solve.run(seed, terminal),
        Some(Verb::FormFactors(matrix)) => matrix.run(seed, terminal),
        Some(Verb::Render(render)) => render.run(seed, terminal),
        Some(Verb::Compare(compare)) => compare.run(seed, terminal),
        Some(Verb::Explain(explain)) => explain.run(seed, terminal),
        Some(Verb::Chart(chart)) => chart.run(terminal),
        None => render::Render::cornell()?.run(seed, terminal),
    }
}

/// Which scene, and which way is up in it.
#[derive(Args, Clone)]
struct Source {
    /// A built-in scene (`radiosity scenes` lists them) or the path of an .obj file
    scene: String,
    /// The world's up [default: 0,1,0, or what the scene says]
    #[arg(long, value_name = "X,Y,Z", value_parser = values::vector)]
    #[arg(allow_hyphen_values = true)]
    up: Option<DVec3>,
}

impl Source {
    /// Reads the scene; what was repaired in it is told as warnings.
    ///
    /// A path has a separator or ends in `.obj`; anything else is the name of a built-in
    /// scene first, and a file if there is none.
    fn load(&self, terminal: &Terminal) -> Result<Scene, Refusal> {
        let up = self.up.map(|up| values::direction("--up", up)).transpose()?;
        let path = Path::new(&self.scene);
        let obj = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("obj"));
        let mut scene = if obj || path.components().count() > 1 || path.is_file() {
            let (scene, warnings) = obj::load(path)?;
            warnings.iter().for_each(|warning| terminal.warn(&warning.to_string()));
            scene
        } else {
            built_in(&self.scene).map_err(|error| match error {
                BuiltInError::Unknown(_) => {
                    Refusal(format!("{error}, or give the path of an .obj file"))
                }
                _ => error.into(),
            })?
        };
        if let Some(up) = up {
            // A view that was made for the scene is made anew; one that it brings is kept.
            let made = Camera::showing(&scene.surfaces, DVec3::Y);
            scene.camera = if scene.camera == made {
                Camera::showing(&scene.surfaces, up)
            } else {
                Camera { up, ..scene.camera }
            };
        }
        Ok(scene)
    }
}
