//! The engine: methods × settings on one scene, each timed, counted and held against the
//! best truth there is.

#![allow(missing_debug_implementations)] // they hold functions: what is run, how it is judged

use super::{Trial, WorkDone};
use std::hint::black_box;

/// Tells time and memory. The library has no clock: who runs a contest brings it.
pub trait Meter {
    /// Processor time of the calling thread so far, s.
    fn seconds(&self) -> f64;
    /// From here on the peak of memory is watched.
    fn watch_memory(&self);
    /// The most that was held since then, above what was held at that moment, bytes.
    fn peak(&self) -> u64;
}

/// Times nothing: work and errors are the same without.
pub struct Unmetered;

impl Meter for Unmetered {
    fn seconds(&self) -> f64 {
        0.0
    }
    fn watch_memory(&self) {}
    fn peak(&self) -> u64 {
        0
    }
}

/// What a contest runs on: the instruments, and somebody to tell how far it is.
pub struct Bench<'a> {
    /// Time and memory.
    pub meter: &'a dyn Meter,
    /// What is being run, how many trials are done.
    pub progress: &'a dyn Fn(&str, usize),
}

impl Bench<'_> {
    /// Without instruments, and silent.
    pub const SILENT: Bench<'static> =
        Bench { meter: &Unmetered, progress: &|_, _| {} };
}

// ANCHOR: method
/// One way to find an `A`: name, settings from coarse to fine, and what it does for a
/// setting and a seed.
pub struct Method<'a, A> {
    name: String,
    settings: Vec<f64>,
    seeds: u64,
    run: Box<dyn Fn(f64, u64) -> (A, WorkDone) + 'a>,
}
// ANCHOR_END: method

/// A function of a setting and a seed: an answer, and the work that it took.
pub trait Run<A>: Fn(f64, u64) -> (A, WorkDone) {}
impl<A, F: Fn(f64, u64) -> (A, WorkDone)> Run<A> for F {}

impl<'a, A> Method<'a, A> {
    /// Gives the same answer each time; its seed is 0.
    pub fn new(name: &str, settings: &[f64], run: impl Run<A> + 'a) -> Method<'a, A> {
        debug_assert!(
            !name.contains(','),
            "{name}: a comma would split the table's cell"
        );
        let run = Box::new(run);
        let (name, settings) = (name.into(), settings.into());
        Method { name, settings, seeds: 1, run }
    }

    /// Gives another answer for each seed: its error is that of 16.
    pub fn random(
        name: &str,
        settings: &[f64],
        run: impl Run<A> + 'a,
    ) -> Method<'a, A> {
        Method { seeds: SEEDS, ..Method::new(name, settings, run) }
    }

    /// With so many seeds: more where it is wrong seldom, and then by much; fewer where
    /// one answer has many numbers in it.
    pub fn seeds(self, seeds: u64) -> Method<'a, A> {
        Method { seeds, ..self }
    }
}

/// What an answer is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// How far it is off.
    pub error: f64,
    /// Light made or lost, relative to what is emitted.
    pub energy: Option<f64>,
}

impl Verdict {
    /// Where energy is no question.
    pub fn of(error: f64) -> Verdict {
        Verdict { error, energy: None }
    }
}

/// One task for all methods: what to find, and how an answer is judged.
pub struct Contest<'a, A> {
    scene: String,
    uncertainty: f64,
    judge: Box<dyn Fn(&A) -> Verdict + 'a>,
    methods: Vec<Method<'a, A>>,
}

/// Seeds of a random method: the error of a single run is luck; of 16 it is known to a
/// sixth, `1/√(2·16)`.
pub const SEEDS: u64 = 16;

/// A time is the median of at least so many runs,
const RUNS: u64 = 3;

/// unless they took more seconds than this. No clock decides an error: all seeds run.
const ENOUGH: f64 = 1.5;

/// Shorter calls, in s, are repeated until they last so long: a clock has its grain.
const GRAIN: f64 = 0.002;

impl<'a, A> Contest<'a, A> {
    /// On this scene; `judge` knows the truth, which may itself be off by `uncertainty`.
    pub fn new(
        scene: &str,
        uncertainty: f64,
        judge: impl Fn(&A) -> Verdict + 'a,
    ) -> Contest<'a, A> {
        let judge = Box::new(judge);
        Contest { scene: scene.into(), uncertainty, judge, methods: vec![] }
    }

    /// One more takes part.
    pub fn with(mut self, method: Method<'a, A>) -> Contest<'a, A> {
        self.methods.push(method);
        self
    }

    /// Runs all methods at all their settings; `suite` is what the table calls it.
    pub fn run(&self, suite: &str, bench: &Bench) -> Vec<Trial> {
        let mut trials = vec![];
        for method in &self.methods {
            for &setting in &method.settings {
                let what =
                    format!("{suite}: {}, {} {setting}", self.scene, method.name);
                (bench.progress)(&what, trials.len());
                trials.push(self.trial(suite, method, setting, bench.meter));
            }
        }
        trials
    }

    fn trial(
        &self,
        suite: &str,
        m: &Method<A>,
        setting: f64,
        meter: &dyn Meter,
    ) -> Trial {
        let (mut times, mut squares, mut last) = (vec![], 0.0, None);
        // ANCHOR: trial
        for run in 0..m.seeds.max(RUNS) {
            if run >= m.seeds && times.iter().sum::<f64>() > ENOUGH {
                break;
            }
            let find = || (m.run)(setting, run % m.seeds);
            let ((answer, work), seconds, memory) = timed(&find, meter);
            let verdict = (self.judge)(&answer);
            times.push(seconds);
            squares += verdict.error.powi(2);
            last = Some((verdict, work, memory));
        }
        // ANCHOR_END: trial
        let (runs, (verdict, work, memory)) = (times.len(), last.expect("it ran"));
        Trial {
            suite: suite.into(),
            scene: self.scene.clone(),
            method: m.name.clone(),
            setting,
            seconds: median(times),
            runs: runs as u64,
            work,
            memory,
            error: (squares / runs as f64).sqrt(),
            uncertainty: self.uncertainty,
            energy: verdict.energy,
        }
    }
}

/// What `run` gives, its processor time, and the most memory that it held.
fn timed<T>(run: &dyn Fn() -> T, meter: &dyn Meter) -> (T, f64, u64) {
    meter.watch_memory();
    let start = meter.seconds();
    let answer = black_box(run());
    let mut seconds = meter.seconds() - start;
    let memory = meter.peak();
    if 0.0 < seconds && seconds < GRAIN {
        let calls = (GRAIN / seconds).ceil();
        let start = meter.seconds();
        (0..calls as u64).for_each(|_| drop(black_box(run())));
        seconds = (meter.seconds() - start) / calls;
    }
    (answer, seconds, memory)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
