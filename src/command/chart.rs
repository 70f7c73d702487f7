//! `radiosity chart`: methods side by side, time and work beside error.

use super::output::{Refusal, Terminal, write};
#[cfg(feature = "memory")]
use crate::MEMORY;
use clap::Args;
use cpu_time::ThreadTime;
use radiosity::chart::{self, Bench, ChartView, Column, Meter, SUITES, Suite, Trial};
use serde_json::{Value, json};
use std::cell::Cell;
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};

/// Runs methods against each other, and writes tables and charts
///
/// On one thread. Each trial tells processor time (the median of several runs), work that is
/// the same on any machine, memory (counted by a build with `--features memory` alone, since
/// all else would pay for it, too), and how far it is off from the best truth there is.
#[derive(Args)]
#[command(after_help = "Examples:
  radiosity chart                          every suite, some ten minutes
  radiosity chart form-factors scaling     two of them
  radiosity chart solvers --png            pictures for slides, too (--features png)
  radiosity chart -o book/data             makes the charts of the book anew
                                           (--features memory)")]
pub struct Chart {
    /// What is compared [default: everything]
    #[arg(value_name = "SUITE", value_parser = suite_names())]
    suites: Vec<String>,
    /// Where tables and charts go
    #[arg(short, long, value_name = "DIR", default_value = "out/chart")]
    output: PathBuf,
    /// Write each chart as PNG, too; for a build with `--features png`
    #[arg(long)]
    png: bool,
}

fn suite_names() -> clap::builder::PossibleValuesParser {
    let named = |s: &Suite| clap::builder::PossibleValue::new(s.name).help(s.about);
    SUITES.iter().map(named).collect::<Vec<_>>().into()
}

/// Time of this thread, memory of the command.
struct Instruments {
    time: ThreadTime,
    /// Bytes that were held when the watch began.
    held: Cell<usize>,
}

impl Meter for Instruments {
    fn seconds(&self) -> f64 {
        self.time.elapsed().as_secs_f64()
    }
    #[cfg(feature = "memory")]
    fn watch_memory(&self) {
        MEMORY.reset_peak_usage();
        self.held.set(MEMORY.current_usage());
    }
    #[cfg(feature = "memory")]
    fn peak(&self) -> u64 {
        MEMORY.peak_usage().saturating_sub(self.held.get()) as u64
    }
    #[cfg(not(feature = "memory"))]
    fn watch_memory(&self) {}
    #[cfg(not(feature = "memory"))]
    fn peak(&self) -> u64 {
        self.held.get() as u64 // nothing
    }
}

/// Which charts can be drawn: those of memory where it is counted.
fn is_measured(view: &&ChartView) -> bool {
    cfg!(feature = "memory")
        || ![view.across.0, view.upward.0].contains(&Column::Memory)
}

/// Why there are no pictures in pixels.
const NO_PNG: &str = "this build draws charts as SVG alone; build it with \
    `cargo run --release --features png -- chart --png`, or convert the SVG, for \
    instance with `rsvg-convert`";

impl Chart {
    /// Runs the verb.
    pub fn run(&self, terminal: &Terminal) -> Result<(), Refusal> {
        let chosen = |s: &&Suite| {
            self.suites.is_empty() || self.suites.iter().any(|name| name == s.name)
        };
        let suites: Vec<&Suite> = SUITES.iter().filter(chosen).collect();
        if self.png && cfg!(not(feature = "png")) {
            return Err(Refusal(NO_PNG.into()));
        }
        std::fs::create_dir_all(&self.output).map_err(|error| {
            let folder = self.output.display();
            Refusal(format!(
                "{folder} cannot be made ({error}); choose another with -o"
            ))
        })?;
        // One thread: what is compared is work, and time is told of one thread.
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
        let (mut text, mut objects) = (String::new(), vec![]);
        for (k, suite) in suites.iter().enumerate() {
            let trials = alone.install(|| {
                let held = Cell::new(0);
                let meter = Instruments { time: ThreadTime::now(), held };
                let progress =
                    |_: &str, _| terminal.progress(suite.name, k, suites.len());
                (suite.measure)(&Bench { meter: &meter, progress: &progress })
            });
            let files = self.write(suite, &trials)?;
            text += &format!("\n{}: {}\n", suite.name, suite.about);
            text += &table(&trials);
            files.iter().for_each(|file| text += &format!("{}\n", file.display()));
            objects.push(json!({ "suite": suite.name, "files": files,
                "trials": trials.iter().map(object).collect::<Vec<_>>() }));
        }
        terminal.report(text.trim_start(), || json!({ "suites": objects }))
    }

    fn write(&self, suite: &Suite, trials: &[Trial]) -> Result<Vec<PathBuf>, Refusal> {
        let mut files = vec![];
        let mut add = |name: String, bytes: &[u8]| -> Result<(), Refusal> {
            let path = self.output.join(name);
            write(&path, bytes)?;
            files.push(path);
            Ok(())
        };
        let csv = chart::csv(&origin(suite), trials);
        add(format!("{}.csv", suite.name), csv.as_bytes())?;
        // Drawn from the table and not from the trials: its numbers are rounded, and who
        // draws the charts from it must find the same.
        let trials = chart::read(&csv).map_err(Refusal)?;
        for view in suite.views.iter().filter(is_measured) {
            let svg = view.chart(&trials).svg();
            add(format!("{}.svg", view.file), svg.as_bytes())?;
            if self.png {
                add(format!("{}.png", view.file), &png(&svg)?)?;
            }
        }
        Ok(files)
    }
}

/// Command, date, version and machine.
fn origin(suite: &Suite) -> String {
    let cores = std::thread::available_parallelism().map_or(1, |n| n.get());
    format!(
        "{}: {}.\nBy `radiosity chart {}`, version {}, on {}; {}, {}, {cores} cores.\n\
         Processor seconds of one thread, the median of `runs`; bytes.",
        suite.name,
        suite.about,
        suite.name,
        env!("CARGO_PKG_VERSION"),
        today(),
        std::env::consts::ARCH,
        std::env::consts::OS,
    )
}

/// The date, UTC, as YYYY-MM-DD: of the record, not of any result.
fn today() -> String {
    let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    // Years of March to February, so that the day that leap years add is their last.
    let day = (since.as_secs() / 86_400) as i64 + 719_468;
    let era = day / 146_097;
    let of_era = day % 146_097;
    let year = (of_era - of_era / 1_460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let date = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = 400 * era + year + i64::from(month <= 2);
    format!("{year:04}-{month:02}-{date:02}")
}

/// The chart in pixels, twice as many as it has units; black on white.
#[cfg(feature = "png")]
fn png(svg: &str) -> Result<Vec<u8>, Refusal> {
    use resvg::{tiny_skia::Pixmap, tiny_skia::Transform, usvg};
    const SCALE: f32 = 2.0;
    // A page knows its colours, a picture does not.
    let svg = svg.replace("var(--bg, white)", "white");
    let mut options =
        usvg::Options { font_family: "DejaVu Sans".into(), ..Default::default() };
    options.fontdb_mut().load_system_fonts();
    let tree = usvg::Tree::from_str(&svg, &options)?;
    let size = tree.size();
    let [width, height] =
        [size.width(), size.height()].map(|v| (SCALE * v).ceil() as u32);
    let mut pixels = Pixmap::new(width, height).ok_or_else(|| {
        Refusal("a chart is too large for a PNG; leave out --png".into())
    })?;
    pixels.fill(resvg::tiny_skia::Color::WHITE);
    resvg::render(&tree, Transform::from_scale(SCALE, SCALE), &mut pixels.as_mut());
    Ok(pixels.encode_png()?)
}

#[cfg(not(feature = "png"))]
fn png(_: &str) -> Result<Vec<u8>, Refusal> {
    Err(Refusal(NO_PNG.into()))
}

/// The trials for people.
fn table(trials: &[Trial]) -> String {
    let mut text = String::new();
    for of_scene in trials.chunk_by(|a, b| a.scene == b.scene) {
        let columns =
            ["setting", "CPU s", "error", "energy"].map(|c| format!("{c:>12}"));
        text += &format!("{:<36}{}\n", of_scene[0].scene, columns.concat());
        for t in of_scene {
            let energy = t.energy.map_or(String::new(), |e| format!("{e:.1e}"));
            text += &format!(
                "  {:<34}{:>12}{:>12.3e}{:>12.2e}{energy:>12}\n",
                t.method,
                chart::number(t.setting),
                t.seconds,
                t.error
            );
        }
    }
    text
}

fn object(t: &Trial) -> Value {
    json!({ "scene": t.scene, "method": t.method, "setting": t.setting,
        "seconds": t.seconds, "runs": t.runs, "factors": t.work.factors,
        "rays": t.work.rays, "pixels": t.work.pixels, "steps": t.work.steps,
        "bytes": t.work.bytes, "memory": t.memory, "error": t.error,
        "uncertainty": t.uncertainty, "energy": t.energy })
}

#[cfg(test)]
mod tests {
    use super::today;

    #[test]
    fn a_date_has_its_signs() {
        let [year, month, day] = [0..4, 5..7, 8..10].map(|r| today()[r].parse::<u32>());
        assert!(year.unwrap() >= 2025 && (1..13).contains(&month.unwrap()));
        assert!((1..32).contains(&day.unwrap()));
    }
}
