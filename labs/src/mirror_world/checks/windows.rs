//! Task 3: what is seen through a window.

use super::super::Work;
use super::super::bugs::*;
use super::super::given::{clip, plane};
use super::{Suspects, above, moments, outline};
use crate::check::{Suspect, Verdict, Within, compare};
use crate::shapes::{Place, convex};
use radiosity::prelude::{DVec3, Plane};
use radiosity::random::Stream;

/// Who looks through what at what.
struct View {
    eye: DVec3,
    window: Vec<DVec3>,
    corners: Vec<DVec3>,
}

impl View {
    /// An eye and an outline at these heights over the window.
    fn draw(stream: &mut Stream, eye: [f64; 2], seen: [f64; 2], size: f64) -> View {
        let place = Place::draw(stream);
        let window = place.all(&convex(stream));
        let eye = place.of(above(stream, eye[0], eye[1]));
        let centre = above(stream, seen[0], seen[1]);
        let corners = place.all(&outline(stream, centre, size));
        View { eye, window, corners }
    }

    /// One that `fits`.
    fn that(
        stream: &mut Stream,
        draw: fn(&mut Stream) -> View,
        fits: fn(&View) -> bool,
    ) -> View {
        loop {
            let view = draw(stream);
            if fits(&view) {
                return view;
            }
        }
    }

    fn heights(&self) -> impl Iterator<Item = f64> + '_ {
        let base = plane(&self.window);
        self.corners.iter().map(move |&c| base.height(c))
    }

    /// The sides of the pyramid; their fronts look at the window's middle.
    fn sides(&self) -> impl DoubleEndedIterator<Item = Plane> + '_ {
        let n = self.window.len();
        let middle = self.window.iter().sum::<DVec3>() / n as f64;
        (0..n).map(move |k| {
            let side = plane(&[self.eye, self.window[k], self.window[(k + 1) % n]]);
            if side.height(middle) > 0.0 { side } else { side.flipped() }
        })
    }

    /// Nothing, when the eye is behind the window.
    fn if_before(&self, seen: Vec<DVec3>) -> Vec<DVec3> {
        let before = plane(&self.window).height(self.eye) > 0.0;
        if before { seen } else { Vec::new() }
    }

    fn beyond(&self) -> Vec<DVec3> {
        clip(plane(&self.window).flipped(), &self.corners)
    }
}

/// Cut by each of the planes.
fn cut(by: impl Iterator<Item = Plane>, corners: Vec<DVec3>) -> Vec<DVec3> {
    by.fold(corners, |left, side| clip(side, &left))
}

fn right(view: &View) -> Vec<DVec3> {
    view.if_before(cut(view.sides(), view.beyond()))
}

const WRONG: &Suspects<View, Vec<DVec3>> = &[
    (NOT_CLIPPED, |v| v.corners.clone()),
    (NOT_CLIPPED, |v| v.beyond()),
    (OUTSIDE, |v| cut(v.sides().map(|side| side.flipped()), v.beyond())),
    (GAP, |v| cut(v.sides().rev().skip(1), v.beyond())),
    (GAP, |v| cut(v.sides().skip(1), v.beyond())),
    (BEFORE, |v| v.if_before(cut(v.sides(), v.corners.clone()))),
    (BEFORE, |v| v.if_before(cut(v.sides(), clip(plane(&v.window), &v.corners)))),
    (FROM_BEHIND, |v| {
        let base = plane(&v.window);
        let far = if base.height(v.eye) > 0.0 { base.flipped() } else { base };
        cut(v.sides(), clip(far, &v.corners))
    }),
    (FROM_BEHIND, |v| cut(v.sides(), v.beyond())),
];

fn judge(work: &Work, views: &[View]) -> Verdict {
    let all = |f: &dyn Fn(&View) -> Vec<DVec3>| {
        views.iter().flat_map(|v| moments(&f(v))).collect::<Vec<f64>>()
    };
    let suspects: Vec<Suspect> = WRONG.iter().map(|(bug, f)| (*bug, all(f))).collect();
    let place = |k: usize| {
        let v = &views[k / 6];
        format!(
            "eye {:.3} before the window, {} corners beyond: {} corners are seen, {} \
             are due; a moment of the outline",
            plane(&v.window).height(v.eye),
            v.heights().filter(|&h| h < 0.0).count(),
            (work.through)(v.eye, &v.window, &v.corners).len(),
            right(v).len()
        )
    };
    let got = all(&|v| (work.through)(v.eye, &v.window, &v.corners));
    compare(&got, &all(&right), Within::Absolute(1e-8), &suspects, place)
}

/// Area times normal, twice.
fn size(corners: &[DVec3]) -> f64 {
    let [x, y, z, ..] = moments(corners);
    DVec3::new(x, y, z).length()
}

/// Does the window cut off a part, and leave one?
fn is_cut(view: &View) -> bool {
    let (left, whole) = (right(view), view.beyond());
    let spread = |v: &[DVec3]| {
        let at_first: Vec<DVec3> = v.iter().map(|&c| c - v[0]).collect();
        size(&at_first)
    };
    !left.is_empty() && (0.05..0.95).contains(&(spread(&left) / spread(&whole)))
}

/// Outlines beyond, of which the window shows a part.
pub(super) fn seen(work: &Work, stream: &mut Stream) -> Verdict {
    let draw = |s: &mut Stream| View::draw(s, [0.5, 2.0], [-3.0, -1.0], 1.0);
    let fits = |v: &View| v.heights().all(|h| h < -0.05) && is_cut(v);
    let views: Vec<View> = (0..15).map(|_| View::that(stream, draw, fits)).collect();
    judge(work, &views)
}

/// Outlines that stick through the window.
pub(super) fn before(work: &Work, stream: &mut Stream) -> Verdict {
    let draw = |s: &mut Stream| View::draw(s, [1.0, 2.0], [-0.4, 0.4], 0.5);
    let fits = |v: &View| {
        let both = v.heights().any(|h| h > 0.1) && v.heights().any(|h| h < -0.1);
        both && is_cut(v)
    };
    let views: Vec<View> = (0..15).map(|_| View::that(stream, draw, fits)).collect();
    judge(work, &views)
}

/// Eyes behind the window, and outlines on either side.
pub(super) fn back(work: &Work, stream: &mut Stream) -> Verdict {
    let draw = |s: &mut Stream| View::draw(s, [-2.0, -0.5], [1.0, 3.0], 1.0);
    let near = |s: &mut Stream| View::draw(s, [-2.0, -0.5], [-6.0, -4.0], 4.0);
    let views: Vec<View> =
        (0..20).map(|k| if k < 10 { draw(stream) } else { near(stream) }).collect();
    judge(work, &views)
}
