//! The checks of this lab.
//!
//! Values are closed forms, so that tolerances are those of rounding: 1e-9 where nothing is
//! small, 1e-6 of something small, which leaves room for a × b as it stands (a relative ε/γ
//! for an angle γ), and none for `acos` (ε/γ²).

mod cases;
mod clipping;
mod edges;
mod factors;
mod whole;

use super::Work;
use crate::check::{Bug, Verdict};
use crate::draw::{direction, uniform};
use crate::lab::{Check, check};
use crate::shapes::{Place, convex};
use radiosity::prelude::DVec3;
use radiosity::radiometry::projected_solid_angle;
use radiosity::random::Stream;
use std::f64::consts::PI;

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "edge", "an edge adds γ n·Γ", 2, edges::any),
    check(1, "short", "a short edge keeps its digits", 1, edges::short),
    check(1, "aligned", "an edge seen end on adds 0", 1, edges::aligned),
    check(2, "known", "known polygons above the horizon are right", 2, factors::known),
    check(2, "sides", "fronts count and backs do not", 1, factors::sides),
    check(2, "small", "a small square keeps its digits", 1, factors::small),
    check(3, "cut", "what lies above the horizon is kept", 2, clipping::cut),
    check(3, "whole", "all above is kept, all below is dropped", 1, clipping::whole),
    check(4, "tables", "polygons cut by the horizon are right", 2, factors::tables),
    check(4, "any", "any polygon from anywhere is right", 2, factors::any),
    check(5, "closed", "a closed room is seen whole", 1, whole::closed),
    check(5, "squares", "the mean over a square is its form factor", 1, whole::squares),
];

/// What a point sees.
struct View {
    p: DVec3,
    n: DVec3,
    corners: Vec<DVec3>,
}

impl View {
    /// A polygon within reach of a point that looks anywhere.
    fn draw(stream: &mut Stream) -> View {
        let place = Place::draw(stream);
        let p = place.of(direction(stream) * uniform(stream, 0.5, 2.0));
        View { p, n: direction(stream), corners: place.all(&convex(stream)) }
    }

    /// One that the horizon cuts.
    fn draw_cut(stream: &mut Stream) -> View {
        loop {
            let view = View::draw(stream);
            let above = view.heights().iter().filter(|&&h| h > 0.0).count();
            if (1..view.corners.len()).contains(&above) {
                return view;
            }
        }
    }

    /// The corners, seen from the point.
    fn seen(&self) -> Vec<DVec3> {
        self.corners.iter().map(|&corner| corner - self.p).collect()
    }

    /// The heights of the corners over the horizon.
    fn heights(&self) -> Vec<f64> {
        self.seen().iter().map(|corner| self.n.dot(*corner)).collect()
    }

    /// The same seen from the origin: all moved by −p.
    fn at_origin(self) -> View {
        View { corners: self.seen(), p: DVec3::ZERO, ..self }
    }

    /// The form factor, by the library.
    fn factor(&self) -> f64 {
        let v = &self.corners;
        let fan = |k: usize| (v[k] - v[0]).cross(v[k + 1] - v[0]);
        let front: DVec3 = (1..v.len() - 1).map(fan).sum();
        if front.dot(self.p - v[0]) <= 0.0 {
            return 0.0;
        }
        projected_solid_angle(self.p, self.n, v) / PI
    }
}

/// This verdict, with `lost` named when nothing is wrong but the digits of what is small:
/// when the `other` check passes, which looks at nothing small.
fn digits_of(verdict: Verdict, lost: Bug, other: impl FnOnce() -> Verdict) -> Verdict {
    if verdict.passed() || verdict.bug.is_some() {
        return verdict;
    }
    let other = other();
    let bug = if other.passed() { Some(lost) } else { other.bug };
    Verdict { bug, ..verdict }
}
