//! Task 2: the frontier.

use crate::check::{Bug, Verdict};
use crate::draw::{decades, whole_number};
use crate::race::Work;
use crate::race::bugs::*;
use radiosity::random::Stream;

type Trial = (f64, f64);

/// Which trials stand when this beats.
fn unbeaten(trials: &[Trial], beats: fn(Trial, Trial) -> bool) -> Vec<usize> {
    let stands = |&k: &usize| !trials.iter().any(|&other| beats(other, trials[k]));
    (0..trials.len()).filter(stands).collect()
}

fn right(trials: &[Trial]) -> Vec<usize> {
    unbeaten(trials, |a, b| a.0 <= b.0 && a.1 <= b.1 && a != b)
}

/// The ends: least time, and least error.
fn ends(trials: &[Trial]) -> Vec<usize> {
    let frontier = right(trials);
    let least = |of: fn(&Trial) -> f64| {
        frontier
            .iter()
            .copied()
            .min_by(|&a, &b| of(&trials[a]).total_cmp(&of(&trials[b])))
    };
    let mut both: Vec<usize> =
        [least(|t| t.0), least(|t| t.1)].into_iter().flatten().collect();
    both.sort_unstable();
    both.dedup();
    both
}

/// The corners of the convex hull, from below; on logarithmic axes or not.
fn hull(trials: &[Trial], axis: fn(f64) -> f64) -> Vec<usize> {
    let p = |k: usize| (axis(trials[k].0), axis(trials[k].1));
    let below = |k: usize, i: usize, j: usize| {
        let (a, b, c) = (p(i), p(j), p(k));
        (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0) < 0.0
    };
    let frontier = right(trials);
    let corner = |&k: &usize| {
        let fast = frontier.iter().filter(|&&i| trials[i].0 < trials[k].0);
        let mut slow = frontier.iter().filter(|&&j| trials[j].0 > trials[k].0);
        fast.clone().all(|&i| slow.clone().all(|&j| below(k, i, j)))
            || slow.next().is_none()
    };
    frontier.iter().copied().filter(corner).collect()
}

type Wrong = (Bug, fn(&[Trial]) -> Vec<usize>);

const WRONG: &[Wrong] = &[
    (ITSELF, |t| unbeaten(t, |a, b| a.0 <= b.0 && a.1 <= b.1)),
    (ITSELF, |t| {
        let beaten = |k: usize| {
            let mut others = (0..t.len()).filter(|&i| i != k);
            others.any(|i| t[i].0 <= t[k].0 && t[i].1 <= t[k].1)
        };
        (0..t.len()).filter(|&k| !beaten(k)).collect()
    }),
    (EITHER, |t| unbeaten(t, |a, b| a.0 < b.0 || a.1 < b.1)),
    (STRICT, |t| unbeaten(t, |a, b| a.0 < b.0 && a.1 < b.1)),
    (ONE_OF_EQUALS, |t| {
        let first = |&k: &usize| !t[..k].contains(&t[k]);
        right(t).into_iter().filter(first).collect()
    }),
    (ONE_OF_EQUALS, |t| {
        let last = |&k: &usize| !t[k + 1..].contains(&t[k]);
        right(t).into_iter().filter(last).collect()
    }),
    (UNSORTED, |t| {
        let new = |&k: &usize| t[..k].iter().all(|earlier| t[k].1 < earlier.1);
        (0..t.len()).filter(new).collect()
    }),
    (UNSORTED, |t| {
        let beats = |a: Trial, b: Trial| a.0 <= b.0 && a.1 <= b.1 && a != b;
        let stands = |&k: &usize| !t[..k].iter().any(|&earlier| beats(earlier, t[k]));
        (0..t.len()).filter(stands).collect()
    }),
    (LARGER, |t| unbeaten(t, |a, b| a.0 >= b.0 && a.1 >= b.1 && a != b)),
    (ENDS, ends),
    (HULL, |t| hull(t, |x| x)),
    (HULL, |t| hull(t, f64::ln)),
    (BEATEN, |t| {
        let stand = right(t);
        (0..t.len()).filter(|k| !stand.contains(k)).collect()
    }),
];

/// The first list where they differ, and the mistake that explains all lists.
fn judge(work: &Work, lists: &[Vec<Trial>]) -> Verdict {
    let found = |list: &Vec<Trial>| {
        let mut found = (work.frontier)(list);
        found.sort_unstable();
        found
    };
    let got: Vec<Vec<usize>> = lists.iter().map(found).collect();
    let all = |f: &dyn Fn(&[Trial]) -> Vec<usize>| -> Vec<Vec<usize>> {
        lists.iter().map(|list| f(list)).collect()
    };
    let due = all(&right);
    let Some(k) = (0..lists.len()).find(|&k| got[k] != due[k]) else {
        return Verdict::pass(0.0, 0.0);
    };
    let bug = WRONG.iter().find(|(_, wrong)| all(wrong) == got).map(|&(bug, _)| bug);
    let trial = |(t, e): &Trial| format!("({t:.3}, {e:.3})");
    let list: Vec<String> = lists[k].iter().map(trial).collect();
    let message =
        format!("of [{}]: got {:?}, expected {:?}", list.join(", "), got[k], due[k]);
    Verdict::fail(message, bug)
}

/// Trials along a falling line, and some behind it: no two times or errors are equal.
pub fn apart(work: &Work, stream: &mut Stream) -> Verdict {
    let mut list = |_| {
        let n = whole_number(stream, 8, 13);
        let mut one = |_| {
            let time = decades(stream, 0.01, 1.0);
            (time, 0.02 / time * decades(stream, 0.5, 10.0))
        };
        (0..n).map(&mut one).collect::<Vec<Trial>>()
    };
    let mut lists: Vec<Vec<Trial>> = (0..8).map(&mut list).collect();
    // One that beats all others, in the middle of its list.
    lists[0].insert(4, (0.001, 0.001));
    // And one without error.
    lists[1].insert(2, (0.5, 0.0));
    judge(work, &lists)
}

/// Times and errors of few values, and each list with two trials that are equal.
pub fn equals(work: &Work, stream: &mut Stream) -> Verdict {
    let mut list = |_| {
        let mut step = || whole_number(stream, 1, 5) as f64;
        let mut list: Vec<Trial> = (0..9).map(|_| (step(), step())).collect();
        list.extend([(0.5, 6.0), (6.0, 0.5), (0.5, 7.0), (0.5, 6.0), (7.0, 0.5)]);
        // Not beaten, and on no hull.
        list.push((0.75, 5.9));
        list
    };
    let mut lists: Vec<Vec<Trial>> = (0..6).map(&mut list).collect();
    // One that beats all others.
    lists[0].insert(3, (0.25, 0.25));
    judge(work, &lists)
}
