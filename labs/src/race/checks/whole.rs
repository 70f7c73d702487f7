//! Task 5: what was written, read by what was written.

use super::factors::{midpoint, opposite};
use crate::check::Verdict;
use crate::race::Work;
use crate::race::given::Pair;
use radiosity::random::Stream;

/// Facing squares, evaluations for time: the student's frontier and slopes of the
/// student's method and the midpoint rule.
pub fn chart(work: &Work, stream: &mut Stream) -> Verdict {
    let known = opposite(stream, [1.0, 1.0, 1.0]);
    let trial = |method: &dyn Fn(&Pair, u32) -> f64, effort: u32| {
        let pair = known.pair();
        let off = (work.off)(&[method(&pair, effort)], known.factor);
        (f64::from(pair.asked()), off)
    };
    let line = |method: &dyn Fn(&Pair, u32) -> f64| -> Vec<(f64, f64)> {
        [1296, 4096, 10_000].iter().map(|&effort| trial(method, effort)).collect()
    };
    let (yours, rule) = (line(&work.factor), line(&midpoint));
    let [ours, theirs] = [&yours, &rule].map(|line| (work.slope)(line));
    // Of second order in four variables: −1/2.
    if theirs.is_nan() || (theirs + 0.5).abs() > 0.03 {
        let told = format!("the midpoint rule's slope: got {theirs:.3}, due −1/2");
        return Verdict::fail(told, None);
    }
    if ours.is_nan() || ours > -0.75 {
        let told = format!("your slope is {ours:.3}, −0.75 or less is due");
        return Verdict::fail(told, None);
    }
    let all = [yours, rule].concat();
    let stand = (work.frontier)(&all);
    if stand.is_empty() || stand.iter().any(|&k| k >= 3) {
        let told = format!("of {all:?}, yours first, the frontier has {stand:?}");
        return Verdict::fail(told, None);
    }
    Verdict::pass(0.0, 0.0)
}
