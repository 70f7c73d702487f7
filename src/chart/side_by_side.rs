//! One scene, one camera, several methods: what each shows, misses and costs.
//!
//! ```text
//! rms   = √ mean (L − L*)² / mean L*         luminance, over the pixels that count
//! noise = √ mean σ² / mean L*                σ: standard errors of the reference L*
//! error = √ max(0, rms² − noise²)            what the method itself is off by
//! paths' seconds for the same error = seconds · (noise/error)²
//! ```
//! Pixels that are twice as bright as white in the picture of two passes, which has no
//! noise, and their neighbours do not count: the edge of a lamp, half a pixel off, would
//! outweigh all else.

use crate::film::{Picture, Shot, luminance};
use crate::geometry::Rgb;
use crate::plan::Plan;
use crate::room::Room;
use crate::scene::Scene;
use crate::solution::{Goal, Solution};
use crate::trace::{Look, PathTracer, Table, Traced, TwoPass, Whitted};
use crate::work::{Progress, Work};
use std::fmt::Write;

/// What each method may spend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// The error that pass 1 is asked for.
    pub tolerance: f64,
    /// Random paths through each pixel of the reference.
    pub paths: usize,
    /// Names the random streams.
    pub seed: u64,
}

/// What one method made of the scene.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Its name, fit for a file.
    pub name: &'static str,
    /// What it does, in a few words.
    pub about: &'static str,
    /// What it shows.
    pub picture: Picture,
    /// Processor seconds, of all threads.
    pub seconds: f64,
    /// Off from the reference, relative.
    pub rms: f64,
    /// The same, less the noise of the reference.
    pub error: f64,
    /// Mean luminance, relative to the reference's.
    pub brightness: f64,
}

/// All methods' pictures of a scene.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The reference is the last.
    pub panels: Vec<Panel>,
    /// Which pixels count.
    pub counts: Vec<bool>,
    /// Standard error of the reference's pixels, relative.
    pub noise: f64,
    /// Whose light the reference shows.
    pub classes: Table,
    /// The factor on radiance with which all are shown.
    pub exposure: f64,
    /// Pass 1 of the scene.
    pub solution: Solution,
}

/// A picture and what it cost.
type Made = (Picture, f64);

impl Comparison {
    /// Makes all pictures of `shot`. `clock` tells processor seconds.
    pub fn of(
        scene: &Scene,
        shot: &Shot,
        effort: &Effort,
        clock: &dyn Fn() -> f64,
        progress: Progress,
    ) -> Comparison {
        let dull = scene.dulled();
        let (plain, seconds) = timed(clock, || solved(&dull, effort, progress));
        let classical = smooth(&plain, shot, clock, seconds);
        let (solution, first) = timed(clock, || solved(scene, effort, progress));
        let one = smooth(&solution, shot, clock, first);
        // ANCHOR: two_pass
        let (two, second) = timed(clock, || {
            let (mesh, light) = (&solution.field.mesh, &solution.vertex_radiosity);
            let options = Look { seed: effort.seed, ..Look::default() };
            TwoPass::showing(&Room::of(scene), mesh, light, options)
                .picture(shot, progress)
                .picture
        });
        // ANCHOR_END: two_pass
        let rays = timed(clock, || {
            Whitted::of(&Room::of(scene), Look::default())
                .picture(shot, progress)
                .picture
        });
        let (reference, seconds) = timed(clock, || {
            PathTracer::of(&Room::of(scene)).picture(
                shot,
                effort.paths,
                effort.seed,
                progress,
            )
        });
        let made = [classical, rays, one, (two, first + second)];
        Comparison::compared(made, reference, seconds, solution)
    }

    fn compared(
        made: [Made; 4],
        reference: Traced,
        seconds: f64,
        solution: Solution,
    ) -> Comparison {
        let Traced { picture, error, classes, .. } = reference;
        let sure = &made[3].0;
        let exposure = sure.auto_exposure();
        let counts = not_white(sure, exposure);
        let zero = Picture::new(picture.width, picture.height);
        let sigma = Picture { pixels: error, ..zero };
        let noise = rms(&sigma, None, &counts) / mean(&picture, &counts);
        let panel = |(name, about): (_, _), (shown, seconds): Made| {
            let truth = mean(&picture, &counts);
            // ANCHOR: error
            let rms = rms(&shown, Some(&picture), &counts) / truth;
            let error = (rms * rms - noise * noise).max(0.0).sqrt();
            let brightness = mean(&shown, &counts) / truth;
            // ANCHOR_END: error
            Panel { name, about, picture: shown, seconds, rms, error, brightness }
        };
        let mut panels: Vec<Panel> =
            NAMES.into_iter().zip(made).map(|(name, made)| panel(name, made)).collect();
        panels.push(panel(REFERENCE, (picture.clone(), seconds)));
        Comparison { panels, counts, noise, classes, exposure, solution }
    }

    /// The panel of this name.
    pub fn panel(&self, name: &str) -> Option<&Panel> {
        self.panels.iter().find(|panel| panel.name == name)
    }

    /// The last.
    pub fn reference(&self) -> &Panel {
        &self.panels[self.panels.len() - 1]
    }

    /// Processor seconds that random paths would need for the error of `panel`; `None`
    /// where that is lost in the noise.
    // ANCHOR: paths_seconds
    pub fn paths_seconds(&self, panel: &Panel) -> Option<f64> {
        let seconds = self.reference().seconds * (self.noise / panel.error).powi(2);
        (panel.error > 0.5 * self.noise).then_some(seconds)
    }
    // ANCHOR_END: paths_seconds

    /// The difference of a panel from the reference, per pixel: luminance, relative to the
    /// mean of the reference; as a picture.
    pub fn difference(&self, panel: &Panel) -> Picture {
        let truth = &self.reference().picture;
        let mean = mean(truth, &self.counts);
        let apart = |(a, b): (&Rgb, &Rgb)| {
            Rgb::splat((luminance(*a) - luminance(*b)).abs() / mean)
        };
        let pixels =
            panel.picture.pixels.iter().zip(&truth.pixels).map(apart).collect();
        Picture { pixels, ..Picture::new(truth.width, truth.height) }
    }

    /// One line for each panel, below `origin`, which is commented out.
    pub fn csv(&self, origin: &str) -> String {
        let mut text: String =
            origin.lines().map(|line| format!("# {line}\n")).collect();
        text += "method,cpu_seconds,rms,error,brightness,paths_cpu_seconds\n";
        for panel in &self.panels {
            let Panel { name, seconds, rms, error, brightness, .. } = panel;
            let paths = self.paths_seconds(panel).map(|s| format!("{s:.2}"));
            let _ = writeln!(
                text,
                "{name},{seconds:.2},{rms:.5},{error:.5},{brightness:.4},{}",
                paths.unwrap_or_default()
            );
        }
        let _ = writeln!(text, "# noise of the reference: {:.5}", self.noise);
        text
    }
}

/// Names of the methods, and what they do.
const NAMES: [(&str, &str); 4] = [
    ("classical-radiosity", "all that shines scatters evenly"),
    ("ray-tracing", "lamps, mirrors and glass; no light between diffuse surfaces"),
    ("radiosity", "pass 1 alone: right light, but what shines is not seen"),
    ("two-pass", "pass 1 brings diffuse light, pass 2 follows what shines"),
];

const REFERENCE: (&str, &str) = ("reference", "random paths of all kinds");

fn timed<T>(clock: &dyn Fn() -> f64, work: impl FnOnce() -> T) -> (T, f64) {
    let start = clock();
    let done = work();
    (done, clock() - start)
}

fn solved(scene: &Scene, effort: &Effort, progress: Progress) -> Solution {
    let goal = Goal { seed: effort.seed, ..Goal::within(effort.tolerance) };
    let (room, work) = (Room::of(scene), Work::told(progress));
    let done = Plan::of(&room, effort.tolerance).run(&room, &goal, &work);
    done.expect("the scene has faces").solution
}

fn smooth(
    solution: &Solution,
    shot: &Shot,
    clock: &dyn Fn() -> f64,
    before: f64,
) -> Made {
    let (mesh, light) = (&solution.field.mesh, &solution.vertex_radiosity);
    let (picture, seconds) = timed(clock, || shot.smooth(mesh, light));
    (picture, before + seconds)
}

/// Pixels that are not twice as bright as white, and have no neighbour that is.
fn not_white(picture: &Picture, exposure: f64) -> Vec<bool> {
    let (width, height) = (picture.width as usize, picture.height as usize);
    let white = |x: usize, y: usize| {
        picture.pixels[y * width + x].max_element() * exposure > 2.0
    };
    let about = |k: usize, most: usize| k.saturating_sub(1)..(k + 2).min(most);
    let counts = |k: usize| {
        let (x, y) = (k % width, k / width);
        !about(y, height).any(|y| about(x, width).any(|x| white(x, y)))
    };
    (0..width * height).map(counts).collect()
}

/// Mean luminance of the pixels that count; 1 where none does or all are black.
fn mean(picture: &Picture, counts: &[bool]) -> f64 {
    let all = picture.pixels.iter().zip(counts).filter(|(_, counts)| **counts);
    let (sum, n) = all.fold((0.0, 0), |(sum, n), (l, _)| (sum + luminance(*l), n + 1));
    if sum > 0.0 { sum / n as f64 } else { 1.0 }
}

/// Root of the mean square of the luminance, or of its difference from another.
fn rms(picture: &Picture, from: Option<&Picture>, counts: &[bool]) -> f64 {
    let (mut sum, mut n) = (0.0, 0_usize);
    for (k, l) in picture.pixels.iter().enumerate().filter(|(k, _)| counts[*k]) {
        let other = from.map_or(0.0, |from| luminance(from.pixels[k]));
        sum += (luminance(*l) - other).powi(2);
        n += 1;
    }
    (sum / n.max(1) as f64).sqrt()
}
