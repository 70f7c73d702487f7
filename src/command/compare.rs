//! `radiosity compare`: one scene by several methods, side by side.

use super::compare_page::page;
use super::methods::classes_json;
use super::output::{Refusal, Terminal, write};
use super::report::percent;
use super::sky::Lit;
use super::solve::checked;
use super::values::{self, Size};
use clap::Args;
use cpu_time::ProcessTime;
use radiosity::chart::{Comparison, Effort, Panel};
use radiosity::film::{FalseColour, Shot, png};
use serde_json::json;
use std::path::{Path, PathBuf};

/// Compares methods on a scene: pictures side by side, their differences, errors and times
#[derive(Args)]
#[command(after_help = "Examples:
  radiosity compare gallery
  radiosity compare cornell-mirror --size 512x512 --samples 1024
  radiosity compare room.obj --tolerance 2% --json

Writes a page, index.html, with its pictures and a table into out/compare/. The reference
traces random paths; its noise is told, and what the others are off by is told without it.
Times are processor seconds of all threads.")]
pub struct Compare {
    #[command(flatten)]
    source: Lit,
    /// Width and height of the pictures in pixels
    #[arg(long, value_name = "WxH", default_value = "320x320")]
    #[arg(value_parser = values::size)]
    size: Size,
    /// Random paths through each pixel of the reference
    #[arg(long, value_name = "N", default_value_t = 256)]
    samples: usize,
    /// The largest relative error of pass 1, as 0.01 or 1%
    #[arg(long, default_value = "1%", value_parser = values::tolerance)]
    #[arg(allow_hyphen_values = true)]
    tolerance: f64,
}

/// Where the files go.
const FOLDER: &str = "out/compare";

/// More paths through a pixel are a slip of the keyboard.
const MOST_SAMPLES: usize = 1 << 20;

/// Samples along each side of a pixel, of all methods but the reference.
const SIDE: u32 = 3;

/// Differences relative to the mean of the reference.
pub const DIFFERENCES: FalseColour = FalseColour { low: 0.01, high: 1.0 };

impl Compare {
    /// Makes all pictures and writes them.
    pub fn run(&self, seed: u64, terminal: &Terminal) -> Result<(), Refusal> {
        let tolerance = values::positive("--tolerance", self.tolerance)?;
        let (width, height) = self.size.checked()?;
        if !(2..=MOST_SAMPLES).contains(&self.samples) {
            return Err(Refusal(format!(
                "--samples {} is not possible; choose 2 to {MOST_SAMPLES}",
                self.samples
            )));
        }
        let scene = self.source.load(terminal)?;
        checked(&scene)?;
        let shot = Shot { camera: scene.camera, width, height, samples: SIDE };
        let effort = Effort { tolerance, paths: self.samples, seed };
        let clock = || ProcessTime::now().as_duration().as_secs_f64();
        let progress =
            |what: &'static str, done, all| terminal.progress(what, done, all);
        let found = Comparison::of(&scene, &shot, &effort, &clock, &progress);
        let origin = format!(
            "{} in {width}x{height} pixels, by `radiosity compare`, version {}.\n\
             Pass 1 asked for {tolerance}; {} paths through each pixel of the reference.\n\
             Processor seconds of all threads. Errors: root mean square luminance,\n\
             relative to the mean of the reference; `error` is without its noise.",
            scene.name,
            env!("CARGO_PKG_VERSION"),
            self.samples,
        );
        let files = files(&found, &scene.name, &origin)?;
        let mut text = format!("{origin}\n\n{}", table(&found));
        files.iter().for_each(|file| text += &format!("{}\n", file.display()));
        terminal.report(&text, || {
            json!({
                "scene": scene.name,
                "size": [width, height],
                "tolerance": tolerance,
                "samples": self.samples,
                "noise": found.noise,
                "methods": found.panels.iter().map(|panel| json!({
                    "method": panel.name,
                    "cpu_seconds": panel.seconds,
                    "rms": panel.rms,
                    "error": panel.error,
                    "brightness": panel.brightness,
                    "paths_cpu_seconds": found.paths_seconds(panel),
                })).collect::<Vec<_>>(),
                "paths": classes_json(&found.classes),
                "files": files,
            })
        })
    }
}

/// The table for people.
fn table(found: &Comparison) -> String {
    let mut text = format!(
        "{:<20}{:>12}{:>12}{:>12}{:>22}\n",
        "method", "CPU s", "error", "brightness", "paths need, CPU s"
    );
    for panel in &found.panels {
        let Panel { name, seconds, brightness, .. } = panel;
        let error = error_of(found, panel);
        let paths = paths_of(found, panel);
        text += &format!(
            "{name:<20}{seconds:>12.2}{error:>12}{brightness:>12.3}{paths:>22}\n"
        );
    }
    text
}

/// The error of a panel, in words; of the reference, its noise. What is lost in the noise is
/// told to be below it: it is not zero.
pub fn error_of(found: &Comparison, panel: &Panel) -> String {
    match found.paths_seconds(panel) {
        _ if panel.name == found.reference().name => percent(found.noise),
        Some(_) => percent(panel.error),
        None => format!("< {}", percent(0.5 * found.noise)),
    }
}

/// What paths would take for the same error, in words.
pub fn paths_of(found: &Comparison, panel: &Panel) -> String {
    match found.paths_seconds(panel) {
        _ if panel.name == found.reference().name => "-".into(),
        Some(seconds) if seconds < 0.01 => "less than 0.01".into(),
        Some(seconds) => format!("{seconds:.2}"),
        None => "more than were traced".into(),
    }
}

fn files(
    found: &Comparison,
    scene: &str,
    origin: &str,
) -> Result<Vec<PathBuf>, Refusal> {
    std::fs::create_dir_all(FOLDER).map_err(|error| {
        Refusal(format!("{FOLDER} cannot be made ({error}); work in another folder"))
    })?;
    let mut files = vec![
        ("index.html".to_string(), page(found, scene, origin).into_bytes()),
        ("compare.csv".to_string(), found.csv(origin).into_bytes()),
    ];
    for panel in &found.panels {
        let name = panel.name;
        files.push((
            format!("{name}.png"),
            png(&panel.picture.display(found.exposure))?,
        ));
        if name != found.reference().name {
            let difference = DIFFERENCES.draw(&found.difference(panel));
            files.push((format!("{name}-difference.png"), png(&difference)?));
        }
    }
    let write_one = |(name, bytes): (String, Vec<u8>)| {
        let path = Path::new(FOLDER).join(name);
        write(&path, &bytes)?;
        Ok(path)
    };
    files.into_iter().map(write_one).collect()
}
