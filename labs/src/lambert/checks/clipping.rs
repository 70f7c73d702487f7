//! Task 3: outlines cut by the horizon, told apart by two moments of what is left.
//!
//! ```text
//! Σ vₖ × vₖ₊₁       Σ (vₖ × vₖ₊₁) n·(vₖ + vₖ₊₁)
//! ```
//! They do not change when a corner is added on an edge, nor with the first corner.

use super::View;
use crate::check::{Bug, Suspect, Verdict, Within, compare};
use crate::lambert::Work;
use crate::lambert::bugs::*;
use radiosity::geometry::{self, Plane};
use radiosity::prelude::DVec3;
use radiosity::random::Stream;

/// How an outline may be clipped.
type Clip = fn(DVec3, &[DVec3]) -> Vec<DVec3>;

/// The right way: the library's.
pub fn right(n: DVec3, v: &[DVec3]) -> Vec<DVec3> {
    geometry::clip(v, Plane::through(DVec3::ZERO, n)).to_vec()
}

/// Walks round, and keeps what `keep` makes of each edge's ends and heights.
fn walk(
    n: DVec3,
    v: &[DVec3],
    mut keep: impl FnMut([DVec3; 2], [f64; 2]) -> Vec<DVec3>,
) -> Vec<DVec3> {
    let edge = |k: usize| {
        let (a, b) = (v[k], v[(k + 1) % v.len()]);
        keep([a, b], [n.dot(a), n.dot(b)])
    };
    (0..v.len()).flat_map(edge).collect()
}

/// The upper end, and a new corner where `at` puts it on an edge that crosses.
fn cut_at(n: DVec3, v: &[DVec3], at: fn(f64, f64) -> f64) -> Vec<DVec3> {
    walk(n, v, |[a, b], [ha, hb]| {
        let mut kept = Vec::new();
        kept.extend((ha >= 0.0).then_some(a));
        kept.extend((ha * hb < 0.0).then(|| a.lerp(b, at(ha, hb))));
        kept
    })
}

/// Wrong ways to clip.
pub const WRONG: &[(Bug, Clip)] = &[
    (KEPT_BELOW, |n, v| right(-n, v)),
    (DROPPED, |n, v| v.iter().copied().filter(|c| n.dot(*c) >= 0.0).collect()),
    (DROPPED, |n, v| {
        walk(n, v, |[a, b], [ha, hb]| {
            let mut kept = Vec::new();
            kept.extend((ha >= 0.0).then_some(a));
            kept.extend((ha > 0.0 && hb < 0.0).then(|| a.lerp(b, ha / (ha - hb))));
            kept
        })
    }),
    (DROPPED, |n, v| {
        walk(n, v, |[a, b], [ha, hb]| {
            let mut kept = Vec::new();
            kept.extend((ha >= 0.0).then_some(a));
            kept.extend((ha < 0.0 && hb > 0.0).then(|| a.lerp(b, ha / (ha - hb))));
            kept
        })
    }),
    (LIFTED, |n, v| v.iter().map(|&c| c - n * n.dot(c).min(0.0)).collect()),
    (WRONG_PLACE, |n, v| cut_at(n, v, |_, _| 0.5)),
    (WRONG_PLACE, |n, v| cut_at(n, v, |a, b| b / (b - a))),
    (WRONG_PLACE, |n, v| cut_at(n, v, |a, b| a / (a + b))),
    (GAP, |n, v| {
        let mut kept = Vec::new();
        for (k, &a) in v.iter().enumerate() {
            kept.extend((n.dot(a) >= 0.0).then_some(a));
            let Some(&b) = v.get(k + 1) else { break };
            let (ha, hb) = (n.dot(a), n.dot(b));
            kept.extend((ha * hb < 0.0).then(|| a.lerp(b, ha / (ha - hb))));
        }
        kept
    }),
    (NOT_CLIPPED, |_, v| v.to_vec()),
    (ALL_OR_NOTHING, |n, v| {
        let middle = v.iter().sum::<DVec3>();
        if n.dot(middle) > 0.0 { v.to_vec() } else { vec![] }
    }),
    (ALL_OR_NOTHING, |n, v| {
        if v.iter().all(|c| n.dot(*c) >= 0.0) { v.to_vec() } else { vec![] }
    }),
];

fn moments(n: DVec3, v: &[DVec3]) -> [f64; 6] {
    let (mut first, mut second) = (DVec3::ZERO, DVec3::ZERO);
    for (k, &a) in v.iter().enumerate() {
        let b = v[(k + 1) % v.len()];
        first += a.cross(b);
        second += a.cross(b) * n.dot(a + b);
    }
    [first.x, first.y, first.z, second.x, second.y, second.z]
}

fn judge(work: &Work, views: &[View]) -> Verdict {
    let all = |clip: &dyn Fn(DVec3, &[DVec3]) -> Vec<DVec3>| {
        let each =
            views.iter().flat_map(|view| moments(view.n, &clip(view.n, &view.corners)));
        each.collect::<Vec<f64>>()
    };
    let suspects: Vec<Suspect> =
        WRONG.iter().map(|(bug, clip)| (*bug, all(clip))).collect();
    let place = |k: usize| {
        let view = &views[k / 6];
        let heights: Vec<String> =
            view.heights().iter().map(|h| format!("{h:.3}")).collect();
        let kept = (work.clip)(view.n, &view.corners).len();
        let due = right(view.n, &view.corners).len();
        format!(
            "corners at heights {}: {kept} corners are left, {due} are due; a moment of \
             the outline",
            heights.join(", ")
        )
    };
    let within = Within::Absolute(1e-9);
    compare(&all(&work.clip), &all(&right), within, &suspects, place)
}

/// Outlines that the horizon cuts.
pub fn cut(work: &Work, stream: &mut Stream) -> Verdict {
    let views: Vec<View> =
        (0..20).map(|_| View::draw_cut(stream).at_origin()).collect();
    judge(work, &views)
}

/// Outlines wholly above, or wholly below.
pub fn whole(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |k: usize| {
        let mut view = View::draw(stream).at_origin();
        let heights = view.heights();
        let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        // Up or down until it keeps clear of the horizon.
        let by = if k.is_multiple_of(2) { 0.1 - low } else { -0.1 - high };
        view.corners.iter_mut().for_each(|corner| *corner += view.n * by);
        view
    };
    let views: Vec<View> = (0..10).map(&mut draw).collect();
    judge(work, &views)
}
