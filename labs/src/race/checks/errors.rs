//! Task 1: how far answers are off.

use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{decades, uniform, whole_number};
use crate::race::Work;
use crate::race::bugs::*;
use radiosity::random::Stream;

/// Answers of some seeds, and what is exact.
struct Runs {
    answers: Vec<f64>,
    exact: f64,
}

impl Runs {
    /// Off by a few percent to one side, and scattered by more.
    fn draw(stream: &mut Stream) -> Runs {
        let exact = decades(stream, 0.01, 10.0);
        let side = uniform(stream, 0.02, 0.05);
        let n = whole_number(stream, 3, 17);
        let one = |_| exact * (1.0 + side + uniform(stream, -0.1, 0.1));
        Runs { answers: (0..n).map(one).collect(), exact }
    }

    fn n(&self) -> f64 {
        self.answers.len() as f64
    }

    fn mean(&self, of: impl Fn(f64) -> f64) -> f64 {
        self.answers.iter().map(|&a| of(a)).sum::<f64>() / self.n()
    }

    /// The mean of squared relative errors.
    fn square(&self) -> f64 {
        self.mean(|a| (a / self.exact - 1.0).powi(2))
    }

    fn scatter(&self) -> f64 {
        let mean = self.mean(|a| a);
        self.mean(|a| ((a - mean) / self.exact).powi(2)).sqrt()
    }

    fn worst(&self) -> f64 {
        let off = self.answers.iter().map(|a| (a / self.exact - 1.0).abs());
        off.fold(0.0, f64::max)
    }
}

type Wrong = (Bug, fn(&Runs) -> f64);

const WRONG: &[Wrong] = &[
    (ABSOLUTE, |r| r.exact * r.square().sqrt()),
    (BY_THE_ANSWER, |r| r.mean(|a| (1.0 - r.exact / a).powi(2)).sqrt()),
    (OF_THE_MEAN, |r| (r.mean(|a| a) / r.exact - 1.0).abs()),
    (OF_THE_MEAN, |r| r.mean(|a| a) / r.exact - 1.0),
    (NO_SQUARES, |r| r.mean(|a| (a / r.exact - 1.0).abs())),
    (NO_ROOT, Runs::square),
    (NOT_A_MEAN, |r| (r.n() * r.square()).sqrt()),
    (OVER_N, |r| (r.square() / r.n()).sqrt()),
    (SCATTER, Runs::scatter),
    (SCATTER, |r| r.scatter() * (r.n() / (r.n() - 1.0)).sqrt()),
    (WORST, Runs::worst),
];

/// Several lists, and a single answer, as of a method that is not random.
pub fn off(work: &Work, stream: &mut Stream) -> Verdict {
    let mut runs: Vec<Runs> = (0..5).map(|_| Runs::draw(stream)).collect();
    // Below the exact value: an error is positive.
    runs.push(Runs { answers: vec![0.9], exact: 1.0 + stream.next() });
    let all = |f: &dyn Fn(&Runs) -> f64| runs.iter().map(f).collect::<Vec<f64>>();
    let suspects: Vec<Suspect> =
        WRONG.iter().map(|(bug, wrong)| (*bug, all(wrong))).collect();
    let got = all(&|r| (work.off)(&r.answers, r.exact));
    let place = |k: usize| format!("{} answers, list {}", runs[k].n(), k + 1);
    let expected = all(&|r| r.square().sqrt());
    let verdict = compare(&got, &expected, Within::Relative(1e-9), &suspects, place);
    // A single answer has no scatter of n − 1: 0/0.
    let lone = got.last().is_some_and(|x| x.is_nan()) && got[0].is_finite();
    let bug = verdict.bug.or((lone && !verdict.passed()).then_some(SCATTER));
    Verdict { bug, ..verdict }
}
