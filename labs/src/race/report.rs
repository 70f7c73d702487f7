//! The experiment of the report question: your method in the crate's own contest.
//!
//! `cargo run --release -p labs --example race` runs it on the student's work.

use super::Work;
use super::given::Pair;
use cpu_time::ThreadTime;
use radiosity::chart::suites::form_factors::{self, FAR, HIDDEN, NEAR, TOUCHING};
use radiosity::chart::{Bench, Meter, Method, Trial, WorkDone as Done};

/// What your line is called.
pub const YOURS: &str = "yours";

/// The pairs of the contest.
pub const PAIRS: [&str; 4] = [FAR, NEAR, TOUCHING, HIDDEN];

/// Evaluations: the fourth powers of 1, 2, 3, 4, 6, 8 and 16.
pub const EFFORTS: [f64; 7] = [1.0, 16.0, 81.0, 256.0, 1296.0, 4096.0, 65_536.0];

/// Processor time of this thread; memory is not watched.
pub struct Clock(ThreadTime);

impl Clock {
    /// Starts now.
    pub fn start() -> Clock {
        Clock(ThreadTime::now())
    }
}

impl Meter for Clock {
    fn seconds(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
    fn watch_memory(&self) {}
    fn peak(&self) -> u64 {
        0
    }
}

// ANCHOR: enter
/// Your method, ready for a contest.
pub fn yours<'a>(work: &'a Work, ours: &'a form_factors::Pair) -> Method<'a, f64> {
    Method::new(YOURS, &EFFORTS, |effort, _| {
        let pair = Pair::of(ours);
        let found = (work.factor)(&pair, effort as u32);
        (found, Done { rays: pair.asked().into(), ..Done::default() })
    })
}
// ANCHOR_END: enter

/// Runs a pair's contest with one method more; yours comes first.
pub fn race(work: &Work, name: &str, bench: &Bench) -> Vec<Trial> {
    let ours = form_factors::Pair::named(name).expect("it is one of `PAIRS`");
    let mut trials = ours.contest(name).with(yours(work, &ours)).run("race", bench);
    trials.sort_by_key(|trial| trial.method != YOURS);
    trials
}
