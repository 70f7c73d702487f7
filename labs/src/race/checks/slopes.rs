//! Task 3: the slope.

use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::draw::{decades, uniform, whole_number};
use crate::race::Work;
use crate::race::bugs::*;
use radiosity::random::Stream;

type Trial = (f64, f64);

/// Σ of products about the means, over that of `x` squared.
fn fit(points: &[Trial]) -> f64 {
    let n = points.len() as f64;
    let mean = |of: fn(&Trial) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let over: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    over / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}

/// The same of what `f` makes of each trial.
fn fit_of(trials: &[Trial], f: impl Fn(Trial) -> Trial) -> f64 {
    fit(&trials.iter().map(|&trial| f(trial)).collect::<Vec<_>>())
}

fn logs((t, e): Trial) -> Trial {
    (t.ln(), e.ln())
}

/// Those with a logarithm.
fn positive(trials: &[Trial]) -> Vec<Trial> {
    trials.iter().copied().filter(|&(t, e)| t > 0.0 && e > 0.0).collect()
}

/// From the first trial to the last.
fn two_points(trials: &[Trial]) -> f64 {
    let (a, b) = (logs(trials[0]), logs(trials[trials.len() - 1]));
    (b.1 - a.1) / (b.0 - a.0)
}

fn no_means(trials: &[Trial]) -> f64 {
    let p: Vec<Trial> = trials.iter().map(|&trial| logs(trial)).collect();
    let over: f64 = p.iter().map(|(x, y)| x * y).sum();
    over / p.iter().map(|(x, _)| x * x).sum::<f64>()
}

type Wrong = (Bug, fn(&[Trial]) -> f64);

const WRONG: &[Wrong] = &[
    (LINEAR, fit),
    (ONE_LOG, |t| fit_of(t, |(t, e)| (t, e.ln()))),
    (ONE_LOG, |t| fit_of(t, |(t, e)| (t.ln(), e))),
    (ONE_LOG, |t| fit_of(t, |(t, e)| (t, e.log10()))),
    (ONE_LOG, |t| fit_of(t, |(t, e)| (t.log10(), e))),
    (SWAPPED, |t| fit_of(t, |(t, e)| (e.ln(), t.ln()))),
    (SWAPPED, |t| 1.0 / fit_of(t, logs)),
    (SIGN, |t| -fit_of(t, logs)),
    (TWO_POINTS, two_points),
    (NO_MEANS, no_means),
];

/// A power of the time, and some noise.
fn line(stream: &mut Stream) -> Vec<Trial> {
    let (power, scale) = (uniform(stream, -3.0, -0.2), decades(stream, 1e-4, 1e-2));
    let first = decades(stream, 1e-6, 1e-2);
    let n = whole_number(stream, 5, 9);
    let one = |k: usize| {
        let time = first * 3.0_f64.powi(k as i32) * decades(stream, 0.8, 1.2);
        (time, scale * time.powf(power) * decades(stream, 0.5, 2.0))
    };
    (0..n).map(one).collect()
}

fn judge(work: &Work, lines: &[Vec<Trial>], suspects: &[Suspect]) -> Verdict {
    let got: Vec<f64> = lines.iter().map(|line| (work.slope)(line)).collect();
    let due: Vec<f64> =
        lines.iter().map(|line| fit_of(&positive(line), logs)).collect();
    let place = |k: usize| format!("line {}, {} trials", k + 1, lines[k].len());
    compare(&got, &due, Within::Relative(1e-6), suspects, place)
}

/// Lines with noise.
pub fn slope(work: &Work, stream: &mut Stream) -> Verdict {
    let lines: Vec<Vec<Trial>> = (0..5).map(|_| line(stream)).collect();
    let of = |wrong: fn(&[Trial]) -> f64| lines.iter().map(|l| wrong(l)).collect();
    let suspects: Vec<Suspect> =
        WRONG.iter().map(|&(bug, wrong)| (bug, of(wrong))).collect();
    judge(work, &lines, &suspects)
}

/// What a 0 may have been replaced by.
const MADE_UP_FOR_ZERO: [f64; 14] = [
    1.0,
    1e-6,
    1e-8,
    1e-9,
    1e-10,
    1e-12,
    1e-15,
    1e-16,
    1e-20,
    1e-30,
    1e-100,
    1e-300,
    f64::EPSILON,
    f64::MIN_POSITIVE,
];

/// Lines with trials of which the error, or the time, is 0.
pub fn zeros(work: &Work, stream: &mut Stream) -> Verdict {
    let mut with_zeros = |k: usize| {
        let mut line = line(stream);
        let last = line[line.len() - 1].0;
        line.push((3.0 * last, 0.0));
        if k > 0 {
            // Faster than the clock can tell.
            line.insert(0, (0.0, line[0].1 * 2.0));
        }
        line
    };
    let lines: Vec<Vec<Trial>> = (0..3).map(&mut with_zeros).collect();
    let mut suspects: Vec<Suspect> = MADE_UP_FOR_ZERO
        .iter()
        .map(|tiny| {
            let up = |x: f64| if x > 0.0 { x } else { *tiny };
            let of = |line: &Vec<Trial>| fit_of(line, |(t, e)| logs((up(t), up(e))));
            (MADE_UP, lines.iter().map(of).collect())
        })
        .collect();
    suspects.push((COUNTED, lines.iter().map(|line| counted(line)).collect()));
    let verdict = judge(work, &lines, &suspects);
    let infinite = lines.iter().any(|line| !(work.slope)(line).is_finite());
    let bug = verdict.bug.or((infinite && !verdict.passed()).then_some(NO_LOGARITHM));
    Verdict { bug, ..verdict }
}

/// n Σxy − Σx Σy over n Σx² − (Σx)², with n of all trials.
fn counted(line: &[Trial]) -> f64 {
    let logs: Vec<Trial> = positive(line).into_iter().map(logs).collect();
    let sum = |of: fn(&Trial) -> f64| logs.iter().map(of).sum::<f64>();
    let (x, y) = (sum(|p| p.0), sum(|p| p.1));
    let n = line.len() as f64;
    (n * sum(|p| p.0 * p.1) - x * y) / (n * sum(|p| p.0 * p.0) - x * x)
}
