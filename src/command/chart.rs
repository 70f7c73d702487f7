//! `radiosity chart`: speed against accuracy, measured on this machine.

use super::output::{Refusal, Terminal, write};
use clap::{Args, ValueEnum};
use cpu_time::ThreadTime;
use radiosity::chart::patches::{self, Patches, Trial};
use radiosity::chart::race::{self, Finish, Race, contestants};
use radiosity::scene::built_in;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Measures speed against accuracy on this machine
#[derive(Args)]
#[command(after_help = "Examples:
  radiosity chart
  radiosity chart solvers --json

Writes tables (.csv) and pictures (.svg) into out/chart/. Times are processor seconds of
one thread; work counts how often light is sent from one element to another, which is the
same on any machine.")]
pub struct Chart {
    /// What to measure
    #[arg(value_enum, default_value_t = Suite::Solvers)]
    suite: Suite,
}

/// What can be measured.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Suite {
    /// The race of the solvers, over reflectances 0.5 to 0.999
    Solvers,
}

/// The longest edge of an element in the race, m.
const EDGE: f64 = 0.6;

/// What the solvers are to reach.
const ACCURACY: f64 = 1e-4;

const REFLECTANCES: [f64; 4] = [0.5, 0.9, 0.99, 0.999];

/// Where the files go.
const FOLDER: &str = "out/chart";

impl Chart {
    /// Runs the verb.
    pub fn run(&self, terminal: &Terminal) -> Result<(), Refusal> {
        match self.suite {
            Suite::Solvers => solvers(terminal),
        }
    }
}

fn solvers(terminal: &Terminal) -> Result<(), Refusal> {
    // One thread: what is compared is work, and processor time is told of one thread.
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let (race, finishes) = alone.install(|| run_race(terminal));
    let origin = format!(
        "The race of the solvers, by `radiosity chart solvers`, version {}.\n\
         The L-shaped room, closed, in {} elements, all of one reflectance; reciprocal,\n\
         closed form factors, which are not part of the time.\n\
         Until the error is at most {ACCURACY:e} of the reflected light.",
        env!("CARGO_PKG_VERSION"),
        race.elements(),
    );
    let files = [
        ("solvers.csv", race::csv(&origin, &finishes)),
        ("solvers-time.svg", time_chart(&finishes)),
        ("solvers-work.svg", work_chart(&finishes)),
    ];
    let (trials, patches, about) = alone.install(|| run_patches(terminal))?;
    let mut files = files.to_vec();
    files.push(("patches.csv", patches::csv(&about, &trials)));
    files.push(("patches.svg", patches::chart(&trials).svg()));
    let files = write_all(&files)?;
    let mut text = origin + "\n";
    for (what, number) in TABLES {
        let columns = REFLECTANCES.map(|rho| format!("{:>12}", format!("ρ = {rho}")));
        text += &format!("\n{what:<22}{}\n", columns.concat());
        text += &race::table(&finishes, number);
    }
    text += &format!("\n{about}\n\n{}\n", patches::table(&trials));
    files.iter().for_each(|file| text += &format!("{}\n", file.display()));
    terminal.report(&text, || {
        let finishes: Vec<Value> = finishes.iter().map(object).collect();
        json!({ "elements": race.elements(), "accuracy": ACCURACY,
                "solvers": finishes, "patches": patches,
                "trials": trials.iter().map(trial).collect::<Vec<_>>(), "files": files })
    })
}

/// Patches of the Cornell box: eight along each wall, m.
const PATCH: f64 = 0.07;

/// Errors of the field that smooth light is asked for.
const TOLERANCES: [f64; 6] = [0.1, 0.05, 0.03, 0.02, 0.014, 0.01];

/// Walks from each patch.
const WALKS: [usize; 5] = [16, 64, 256, 1024, 4096];

fn run_patches(terminal: &Terminal) -> Result<(Vec<Trial>, usize, String), Refusal> {
    let scene = built_in("cornell")?;
    terminal.progress("finding the truth", 0, 1);
    let patches = Patches::new(&scene, PATCH);
    let start = ThreadTime::now();
    let clock = || start.elapsed().as_secs_f64();
    let all = TOLERANCES.len() + WALKS.len();
    let mut trials = Vec::new();
    for tolerance in TOLERANCES {
        terminal.progress("comparing", trials.len(), all);
        trials.push(patches.by_smooth(tolerance, &clock));
    }
    for walks in WALKS {
        terminal.progress("comparing", trials.len(), all);
        trials.push(patches.by_walks(walks, &clock));
    }
    let about = format!(
        "The mean irradiance of {} patches of the Cornell box, 8 x 8 a wall: smooth light\n\
         from coarse to fine (settings are its patches), and random walks (settings are\n\
         walks a patch; their error is what their spread tells).",
        patches.len()
    );
    Ok((trials, patches.len(), about))
}

fn trial(t: &Trial) -> Value {
    json!({ "method": t.method, "setting": t.setting, "error": t.error,
            "seconds": t.seconds })
}

/// A title, and a number of a run.
type Table = (&'static str, fn(&Finish) -> String);

const TABLES: [Table; 3] = [
    ("sweeps or shots", |f| f.steps.to_string()),
    ("transfers, millions", |f| format!("{:.2}", f.transfers as f64 / 1e6)),
    ("CPU milliseconds", |f| format!("{:.2}", 1e3 * f.seconds)),
];

fn run_race(terminal: &Terminal) -> (Race, Vec<Finish>) {
    let race = Race::new(EDGE, ACCURACY);
    let (mut finishes, runs) = (vec![], contestants().len() * REFLECTANCES.len());
    for contestant in contestants() {
        for rho in REFLECTANCES {
            terminal.progress("racing", finishes.len(), runs);
            let start = ThreadTime::now();
            let clock = || start.elapsed().as_secs_f64();
            finishes.push(race.run(&contestant, rho, &clock));
        }
    }
    (race, finishes)
}

fn time_chart(finishes: &[Finish]) -> String {
    let title = "Processor time of each solver against the number of bounces";
    race::chart(title, "CPU seconds", finishes, |f| f.seconds).svg()
}

fn work_chart(finishes: &[Finish]) -> String {
    let title = "Transfers between elements against the number of bounces";
    race::chart(title, "transfers", finishes, |f| f.transfers as f64).svg()
}

fn object(f: &Finish) -> Value {
    json!({ "solver": f.solver, "reflectance": f.reflectance, "steps": f.steps,
            "transfers": f.transfers, "seconds": f.seconds, "bound": f.bound,
            "converged": f.converged })
}

fn write_all(files: &[(&str, String)]) -> Result<Vec<PathBuf>, Refusal> {
    std::fs::create_dir_all(FOLDER).map_err(|error| {
        Refusal(format!("{FOLDER} cannot be made ({error}); work in another folder"))
    })?;
    let write_one = |(name, text): &(&str, String)| {
        let path = Path::new(FOLDER).join(name);
        write(&path, text.as_bytes())?;
        Ok(path)
    };
    files.iter().map(write_one).collect()
}
