//! Tasks 1 and 2: images of points and of outlines.

use super::super::Work;
use super::super::bugs::*;
use super::super::given::clip;
use super::{Suspects, above, moments, outline};
use crate::check::{Suspect, Verdict, Within, compare};
use crate::draw::{direction, uniform};
use crate::shapes::Place;
use radiosity::prelude::{DVec3, Plane};
use radiosity::random::Stream;

/// A mirror and a point.
type Shown = (Plane, DVec3);

fn foot(&(mirror, x): &Shown) -> DVec3 {
    x - mirror.height(x) * mirror.normal
}

fn right(mirror: Plane, x: DVec3) -> DVec3 {
    2.0 * foot(&(mirror, x)) - x
}

const WRONG_POINTS: &Suspects<Shown, DVec3> = &[
    (ON_THE_MIRROR, foot),
    (AWAY, |&(mirror, x)| x + 2.0 * mirror.height(x) * mirror.normal),
    (AWAY, |&(mirror, x)| x + mirror.height(x) * mirror.normal),
    (THROUGH_ORIGIN, |&(mirror, x)| x - 2.0 * x.dot(mirror.normal) * mirror.normal),
    (IN_A_POINT, |&(_, x)| -x),
    (IN_A_POINT, |&(mirror, x)| 2.0 * mirror.offset * mirror.normal - x),
];

pub(super) fn point(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || {
        let x = direction(stream) * uniform(stream, 0.5, 3.0);
        let offset = uniform(stream, 0.3, 2.0);
        (Plane { normal: direction(stream), offset }, x)
    };
    let drawn: Vec<Shown> = (0..20).map(|_| draw()).collect();
    let all = |f: &dyn Fn(&Shown) -> DVec3| {
        drawn.iter().flat_map(|shown| f(shown).to_array()).collect::<Vec<f64>>()
    };
    let suspects: Vec<Suspect> =
        WRONG_POINTS.iter().map(|(bug, f)| (*bug, all(f))).collect();
    let place = |k: usize| {
        let (mirror, x) = drawn[k / 3];
        let Plane { normal: n, offset } = mirror;
        let axis = ["x", "y", "z"][k % 3];
        format!(
            "mirror n = {n:.3}, offset {offset:.3}, point {x:.3}: {axis} of the image"
        )
    };
    let got = all(&|&(mirror, x)| (work.image)(mirror, x));
    let expected = all(&|&(mirror, x)| right(mirror, x));
    compare(&got, &expected, Within::Absolute(1e-9), &suspects, place)
}

/// A mirror and an outline.
struct Scene {
    mirror: Plane,
    corners: Vec<DVec3>,
}

impl Scene {
    /// An outline wholly in front.
    fn in_front(stream: &mut Stream) -> Scene {
        Scene::draw(stream, [1.0, 3.0], |least, _| least > 0.1)
    }

    /// One whose heights satisfy `fits`.
    fn draw(
        stream: &mut Stream,
        [low, high]: [f64; 2],
        fits: fn(f64, f64) -> bool,
    ) -> Scene {
        let place = Place::draw(stream);
        let normal = place.direction(DVec3::Z);
        let mirror = Plane::through(place.of(DVec3::ZERO), normal);
        loop {
            let centre = above(stream, low, high);
            let corners = place.all(&outline(stream, centre, 0.7));
            let heights = corners.iter().map(|&c| mirror.height(c));
            let (least, most) = heights
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), h| {
                    (l.min(h), m.max(h))
                });
            if fits(least, most) {
                return Scene { mirror, corners };
            }
        }
    }

    fn images(&self, of: &[DVec3]) -> Vec<DVec3> {
        of.iter().map(|&c| right(self.mirror, c)).collect()
    }
}

fn reversed(mut corners: Vec<DVec3>) -> Vec<DVec3> {
    corners.reverse();
    corners
}

fn image_of(scene: &Scene) -> Vec<DVec3> {
    reversed(scene.images(&clip(scene.mirror, &scene.corners)))
}

const WRONG_IMAGES: &Suspects<Scene, Vec<DVec3>> = &[
    (TURNED, |s| s.images(&clip(s.mirror, &s.corners))),
    (TURNED, |s| s.images(&s.corners)),
    (BEHIND, |s| reversed(s.images(&s.corners))),
    (WRONG_HALF, |s| reversed(s.images(&clip(s.mirror.flipped(), &s.corners)))),
    (WRONG_HALF, |s| {
        // The image clipped to the front: it lies behind.
        clip(s.mirror, &reversed(s.images(&s.corners)))
    }),
    (ON_THE_MIRROR, |s| {
        clip(s.mirror, &s.corners).iter().map(|&c| foot(&(s.mirror, c))).collect()
    }),
];

fn judge(work: &Work, scenes: &[Scene]) -> Verdict {
    let all = |f: &dyn Fn(&Scene) -> Vec<DVec3>| {
        scenes.iter().flat_map(|s| moments(&f(s))).collect::<Vec<f64>>()
    };
    let suspects: Vec<Suspect> =
        WRONG_IMAGES.iter().map(|(bug, f)| (*bug, all(f))).collect();
    let place = |k: usize| {
        let s = &scenes[k / 6];
        let heights: Vec<String> =
            s.corners.iter().map(|&c| format!("{:.3}", s.mirror.height(c))).collect();
        format!(
            "corners at heights {}: {} corners in the image, {} are due; a moment",
            heights.join(", "),
            (work.image_of)(s.mirror, &s.corners).len(),
            image_of(s).len()
        )
    };
    let got = all(&|s| (work.image_of)(s.mirror, &s.corners));
    compare(&got, &all(&image_of), Within::Absolute(1e-8), &suspects, place)
}

pub(super) fn front(work: &Work, stream: &mut Stream) -> Verdict {
    let scenes: Vec<Scene> = (0..10).map(|_| Scene::in_front(stream)).collect();
    judge(work, &scenes)
}

/// Outlines that the mirror's plane cuts, and such as lie behind.
pub(super) fn behind(work: &Work, stream: &mut Stream) -> Verdict {
    let cut = |s: &mut Stream| {
        Scene::draw(s, [-0.5, 0.5], |low, high| low < -0.1 && high > 0.1)
    };
    let behind = |s: &mut Stream| Scene::draw(s, [-3.0, -1.0], |_, high| high < -0.1);
    let scenes: Vec<Scene> =
        (0..10).map(|k| if k < 7 { cut(stream) } else { behind(stream) }).collect();
    judge(work, &scenes)
}
