//! Task 5: are the error bars to be believed?

use super::scenes::{hidden, open};
use super::sums::Method;
use crate::check::{Verdict, Within, compare};
use crate::draw::uniform;
use crate::sampling::Work;
use crate::sampling::given::{Estimate, Pair};
use crate::shapes::rectangle;
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;

/// Two hundred runs of four hundred samples each: the root mean square of
/// (mean − F)/error is 1, give or take 1/√400 and what a skewed sample adds.
pub fn honest(work: &Work, stream: &mut Stream) -> Verdict {
    const RUNS: usize = 200;
    const SAMPLES: usize = 400;
    let pairs = [open(stream).swap_remove(0), hidden(stream).swap_remove(0)];
    let cases: Vec<_> = [Method::Rays, Method::Points]
        .into_iter()
        .flat_map(|method| pairs.iter().map(move |known| (method, known)))
        .collect();
    let mut rms = Vec::new();
    for (method, known) in &cases {
        let mut off = || {
            let Estimate { mean, error } =
                method.run(work, &known.pair, SAMPLES, stream);
            ((mean - known.factor) / error).powi(2)
        };
        let sum: f64 = (0..RUNS).map(|_| off()).sum();
        rms.push((sum / RUNS as f64).sqrt());
    }
    let place = |k: usize| {
        let (method, known) = &cases[k];
        let by = if *method == Method::Rays { "rays" } else { "points" };
        format!("{} by {by}, {RUNS} runs: rms of (mean − F)/error", known.name)
    };
    let within = Within::Absolute(5.0 / (2.0 * RUNS as f64).sqrt());
    compare(&rms, &[1.0; 4], within, &[], place)
}

/// A pair with blockers anywhere, for which nobody knows the factor: two methods that share
/// nothing agree within five of their error bars.
pub fn agree(work: &Work, stream: &mut Stream) -> Verdict {
    let mut off = Vec::new();
    for _ in 0..4 {
        let mut card = |height: f64| {
            let mut place = || uniform(stream, 0.0, 0.7);
            let corner = dvec3(place(), place(), height);
            rectangle(corner, DVec3::X * (0.1 + place()), DVec3::Y * (0.1 + place()))
        };
        let blockers = vec![card(0.3), card(0.6)];
        let pair = Pair {
            from: rectangle(DVec3::ZERO, DVec3::X, DVec3::Y),
            to: rectangle(DVec3::Z, DVec3::Y, DVec3::X),
            blockers,
        };
        let rays = (work.by_rays)(&pair, 10_000, stream);
        let points = (work.by_points)(&pair, 10_000, stream);
        off.push((rays.mean - points.mean) / rays.error.hypot(points.error));
    }
    let place = |_| "rays less points, over the error of both".to_string();
    compare(&off, &[0.0; 4], Within::Absolute(5.0), &[], place)
}
