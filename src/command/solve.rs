//! `radiosity solve`: pass 1, into a table, a mesh or all of it.

use super::output::{Refusal, Terminal, check_writable, extension, write};
use super::sky::Lit;
use super::{report, values};
use clap::{Args, ValueEnum};
use radiosity::field::{Classical, Factors, Links, MatrixSolver, Pass1};
use radiosity::plan::Plan;
use radiosity::room::Room;
use radiosity::scene::Scene;
use radiosity::solution::{self, Goal, Solution};
use radiosity::tables;
use radiosity::work::Work;
use std::path::PathBuf;
use std::time::Instant;

/// Solves the radiosity equation of a scene
#[derive(Args)]
#[command(after_help = "Examples:
  radiosity solve cornell -o cornell.csv
  radiosity solve room.obj -o room.ply --tolerance 2%
  radiosity solve furnace:0.9 -o furnace.json --method gather --json

The error is that of the smooth field relative to the reflected light; face means are
usually far better. A tolerance out of reach is told by `converged: false`, not refused.")]
pub struct Solve {
    #[command(flatten)]
    source: Lit,
    /// Where to write: .csv (means of faces), .ply (elements) or .json (all of it)
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    how: How,
}

/// How pass 1 is done.
#[derive(Args)]
pub struct How {
    /// The largest relative error of the field asked for, as 0.01 or 1%
    #[arg(long, default_value = "1%", value_parser = values::tolerance)]
    #[arg(allow_hyphen_values = true)]
    pub tolerance: f64,
    /// How form factors are computed [default: auto]
    #[arg(long, value_enum, default_value_t = FactorMethod::Auto, hide_default_value = true)]
    pub form_factors: FactorMethod,
    /// Rays from each element, with `--form-factors sampling` [default: 4096]
    #[arg(long, value_name = "N")]
    pub samples: Option<usize>,
    /// Reflections in flat mirrors that are followed, with gather or shoot [default: 1]
    #[arg(long, value_name = "N")]
    pub levels: Option<u32>,
    /// How the equation is solved
    #[arg(long, value_enum, default_value_t = SolverMethod::Auto)]
    pub method: SolverMethod,
}

/// The methods for form factors.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
pub enum FactorMethod {
    /// What suits the scene
    Auto,
    /// Lambert's formula, with what stands between cut out
    Analytic,
    /// Rays from random points in cosine-weighted directions
    Sampling,
    /// Pictures of what an element sees
    Hemicube,
}

/// The solvers.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
pub enum SolverMethod {
    /// What the scene needs, until the certificate says that it suffices
    Auto,
    /// Gauss-Seidel over the whole matrix
    Gather,
    /// Progressive refinement: the brightest first
    Shoot,
    /// Links between pieces of any size, with form factors of their own
    Hierarchy,
}

/// Rays from an element: a factor of 0.1 is then good to 0.005.
const RAYS: usize = 4096;

/// More rays than this from one element are a slip of the keyboard.
const MOST_RAYS: usize = 1 << 30;

/// Cells along the edge of a hemicube.
const RESOLUTION: u32 = 256;

/// A solution keeps up to the square of this many form factors, 8 bytes each.
const MOST_SURFACES: usize = 16_000;

/// What is to be done, when all options make sense.
pub enum Way {
    /// What the scene needs.
    Planned(Goal),
    /// By the method that was asked for.
    By(Box<dyn Pass1>, Goal),
}

impl How {
    /// The way that the options describe, if they make sense.
    pub fn way(&self, seed: u64) -> Result<Way, Refusal> {
        let tolerance = values::positive("--tolerance", self.tolerance)?;
        let own = self.form_factors != FactorMethod::Auto || self.samples.is_some();
        if self.method == SolverMethod::Hierarchy && own {
            return Err(Refusal(
                "--method hierarchy has form factors of its own, one for each link, and \
                 takes no --form-factors and no --samples; leave these out, or choose \
                 gather or shoot"
                    .into(),
            ));
        }
        let rays = samples(self.samples, self.form_factors)?.unwrap_or(RAYS);
        let goal = Goal { seed, ..Goal::within(tolerance) };
        let solver = match (self.method, self.form_factors) {
            (SolverMethod::Auto, FactorMethod::Auto) => {
                self.no_levels()?;
                return Ok(Way::Planned(goal));
            }
            (SolverMethod::Hierarchy, _) => {
                self.no_levels()?;
                return Ok(Way::By(Box::new(Links), goal));
            }
            (SolverMethod::Gather, _) => MatrixSolver::Gather,
            (SolverMethod::Auto | SolverMethod::Shoot, _) => MatrixSolver::Shoot,
        };
        let factors = match self.form_factors {
            FactorMethod::Analytic => Factors::Analytic,
            FactorMethod::Sampling => Factors::Sampling(rays),
            FactorMethod::Auto | FactorMethod::Hemicube => {
                Factors::Hemicube(RESOLUTION)
            }
        };
        let levels = self.levels.unwrap_or(Classical::default().levels);
        Ok(Way::By(Box::new(Classical { solver, factors, levels }), goal))
    }

    /// Refuses `--levels` where nobody counts them.
    fn no_levels(&self) -> Result<(), Refusal> {
        match self.levels {
            None => Ok(()),
            Some(_) => Err(Refusal(
                "--levels counts reflections for --method gather or shoot; other methods \
                 follow rays; choose one of these two, or leave it out"
                    .into(),
            )),
        }
    }
}

/// The number of rays asked for, if it makes sense.
pub fn samples(
    given: Option<usize>,
    method: FactorMethod,
) -> Result<Option<usize>, Refusal> {
    match given {
        Some(_) if method != FactorMethod::Sampling => Err(Refusal(
            "--samples counts rays, and this method draws none; choose sampling".into(),
        )),
        Some(rays) if !(1..=MOST_RAYS).contains(&rays) => Err(Refusal(format!(
            "--samples {rays} is not possible; choose 1 to {MOST_RAYS}"
        ))),
        given => Ok(given),
    }
}

/// Refuses a scene that has no light to be solved for, or is too large.
pub fn checked(scene: &Scene) -> Result<(), Refusal> {
    lit(scene)?;
    sized(scene)
}

/// Refuses a scene that has no light.
pub fn lit(scene: &Scene) -> Result<(), Refusal> {
    if scene.has_emitter() {
        return Ok(());
    }
    Err(Refusal(format!(
        "{} has neither emitter nor sky, so all of it is dark; give a material that is \
         used a `Ke` above 0, or a --sky that shines",
        scene.name
    )))
}

/// Refuses a scene that is too large.
pub fn sized(scene: &Scene) -> Result<(), Refusal> {
    let (name, surfaces) = (&scene.name, scene.surfaces.len());
    if surfaces > MOST_SURFACES {
        return Err(Refusal(format!(
            "{name} has {surfaces} surfaces, and this solver takes {MOST_SURFACES}; use \
             fewer, larger faces"
        )));
    }
    Ok(())
}

/// Solves the room, if it can be solved; and what was decided on the way, one line each.
pub fn solved(
    room: &Room,
    way: &Way,
    terminal: &Terminal,
) -> Result<(Solution, Vec<String>), Refusal> {
    checked(room.scene)?;
    let progress = |what: &'static str, done, all| terminal.progress(what, done, all);
    let work = Work::told(&progress);
    Ok(match way {
        Way::Planned(goal) => {
            let done = Plan::of(room, goal.tolerance).run(room, goal, &work)?;
            (done.solution, done.decisions)
        }
        Way::By(method, goal) => {
            let solution = solution::solve(room, &**method, goal, &work)?;
            if let Some(dropped) = &solution.dropped {
                terminal.warn(&dropped.to_string());
            }
            (solution, Vec::new())
        }
    })
}

impl Solve {
    /// Solves and writes.
    pub fn run(&self, seed: u64, terminal: &Terminal) -> Result<(), Refusal> {
        let file = match &self.output {
            Some(path) => {
                let kind = extension(path, &["csv", "ply", "json"])?;
                check_writable(path)?;
                Some((path, kind))
            }
            None => None,
        };
        let way = self.how.way(seed)?;
        let scene = self.source.load(terminal)?;
        let start = Instant::now();
        let (solution, plan) = solved(&Room::of(&scene), &way, terminal)?;
        let seconds = start.elapsed().as_secs_f64();
        let mut text = report::text(&scene, &solution, self.how.tolerance, seconds);
        if let Some((path, kind)) = file {
            let content = match kind {
                "csv" => tables::csv(&scene, &solution),
                "ply" => tables::ply(&solution),
                _ => tables::json(&scene, &solution, &plan, self.how.tolerance),
            };
            write(path, content.as_bytes())?;
            text += &format!("written: {}\n", path.display());
        }
        terminal.report(&text, || {
            report::json_timed(&solution, &plan, self.how.tolerance, seconds)
        })
    }
}
