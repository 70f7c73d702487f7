//! Task 4: a small lamp behind a clear pane.

use super::super::Work;
use super::super::bugs::*;
use super::super::given::{Lamp, crossing, plane};
use super::faces::pane;
use super::{Suspects, suspects};
use crate::check::{Verdict, Within, compare};
use crate::draw::{direction, uniform};
use crate::shapes::{Place, convex};
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;
use std::f64::consts::PI;

/// Who looks at what through which pane.
struct Scene {
    p: DVec3,
    n: DVec3,
    window: Vec<DVec3>,
    index: f64,
    lamp: Lamp,
    what: &'static str,
}

impl Scene {
    /// A line that meets the window's plane so far on the way from its middle to a
    /// corner; point and lamp see each other at these cosines.
    fn draw(stream: &mut Stream, reach: f64, cosines: [f64; 2]) -> Scene {
        let place = Place::draw(stream);
        let mut window = convex(stream);
        let middle = window.iter().sum::<DVec3>() / window.len() as f64;
        let hit = middle.lerp(window[0], reach);
        let mut across = || uniform(stream, -1.5, 1.5);
        let (x, y) = (across(), across());
        let p = hit + dvec3(x, y, uniform(stream, 0.3, 1.5));
        let at = hit + (hit - p) * uniform(stream, 0.5, 2.0);
        if stream.next() < 0.5 {
            window.reverse();
        }
        let (p, at) = (place.of(p), place.of(at));
        let d = (at - p).normalize();
        let mut tilted = |d: DVec3, cosine: f64| {
            let across = direction(stream).reject_from_normalized(d).normalize();
            cosine * d + (1.0 - cosine * cosine).sqrt() * across
        };
        let (n, normal) = (tilted(d, cosines[0]), tilted(-d, cosines[1]));
        let area = 1e-4;
        let index = uniform(stream, 1.3, 2.0);
        let lamp = Lamp { at, normal, area };
        Scene { p, n, window: place.all(&window), index, lamp, what: "a lamp" }
    }

    /// The cosines at the point, at the lamp and at the pane.
    fn cosines(&self) -> [f64; 3] {
        let d = (self.lamp.at - self.p).normalize();
        [self.n.dot(d), -self.lamp.normal.dot(d), plane(&self.window).normal.dot(d)]
    }

    fn is_seen(&self) -> bool {
        crossing(self.p, self.lamp.at, &self.window).is_some()
    }

    /// What arrives when the pane passes `t`, and both cosines are as given.
    fn factor(&self, t: f64, [at_p, at_lamp]: [f64; 2]) -> f64 {
        let r2 = self.p.distance_squared(self.lamp.at);
        t * at_p.max(0.0) * at_lamp.max(0.0) * self.lamp.area / (PI * r2)
    }

    /// That with the pane's cosine `c`.
    fn through(&self, c: f64) -> f64 {
        let [at_p, at_lamp, _] = self.cosines();
        let seen = self.is_seen() && c > 0.0;
        if seen { self.factor(pane(&(c, self.index)), [at_p, at_lamp]) } else { 0.0 }
    }

    fn right(&self) -> f64 {
        self.through(self.cosines()[2].abs())
    }
}

const WRONG: &Suspects<Scene, f64> = &[
    (NO_GLASS, |s| {
        let [at_p, at_lamp, _] = s.cosines();
        if s.is_seen() { s.factor(1.0, [at_p, at_lamp]) } else { 0.0 }
    }),
    (STRAIGHT_ON, |s| s.through(1.0)),
    (OTHER_ANGLE, |s| s.through(s.cosines()[0])),
    (OTHER_ANGLE, |s| s.through(s.cosines()[1])),
    (ONE_WAY_PANE, |s| s.through(s.cosines()[2])),
    (ONE_WAY_PANE, |s| s.through(-s.cosines()[2])),
    (NO_LAMP_COSINE, |s| s.right() / s.cosines()[1]),
    (NO_LAMP_COSINE, |s| s.right() / s.cosines()[0]),
    (NO_PI, |s| PI * s.right()),
    (NO_WALL, |s| {
        let [at_p, at_lamp, c] = s.cosines();
        s.factor(pane(&(c.abs(), s.index)), [at_p, at_lamp])
    }),
    (FROM_BEHIND, |s| {
        let [at_p, at_lamp, c] = s.cosines();
        let t = if s.is_seen() { pane(&(c.abs(), s.index)) } else { 0.0 };
        s.factor(t, [at_p.abs(), at_lamp.abs()])
    }),
    (FROM_BEHIND, |s| {
        let [at_p, at_lamp, c] = s.cosines();
        let t = if s.is_seen() { pane(&(c.abs(), s.index)) } else { 0.0 };
        s.factor(t, [1.0, 1.0]) * at_p * at_lamp
    }),
];

fn judge(work: &Work, scenes: &[Scene]) -> Verdict {
    let of = |s: &Scene| (work.clear)(s.p, s.n, &s.window, s.index, s.lamp);
    let got: Vec<f64> = scenes.iter().map(of).collect();
    let expected: Vec<f64> = scenes.iter().map(Scene::right).collect();
    let place = |k: usize| {
        let (what, degrees) = (scenes[k].what, scenes[k].cosines()[2].abs().acos());
        format!("{what}, {:.1}° to the pane's normal", degrees.to_degrees())
    };
    // Factors of a lamp of 1 cm² are near 1e-5.
    compare(&got, &expected, Within::Absolute(1e-13), &suspects(WRONG, scenes), place)
}

/// Two cosines above the horizon.
fn facing(stream: &mut Stream) -> [f64; 2] {
    [0; 2].map(|_| uniform(stream, 0.3, 0.9))
}

pub(super) fn clear(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || {
        let (reach, cosines) = (uniform(stream, 0.0, 0.8), facing(stream));
        Scene::draw(stream, reach, cosines)
    };
    let scenes: Vec<Scene> = (0..20).map(|_| draw()).collect();
    judge(work, &scenes)
}

/// Lamps beside the pane.
pub(super) fn wall(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || {
        let (reach, cosines) = (uniform(stream, 1.2, 2.0), facing(stream));
        Scene { what: "a lamp beside the pane", ..Scene::draw(stream, reach, cosines) }
    };
    let scenes: Vec<Scene> = (0..10).map(|_| draw()).collect();
    judge(work, &scenes)
}

/// Lamps seen from behind, points that look away, and both.
pub(super) fn sides(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |k: usize| {
        let [a, b] = facing(stream);
        let (cosines, what) = [
            ([-a, b], "a lamp below the horizon of the point"),
            ([a, -b], "a lamp from behind"),
            ([-a, -b], "a lamp from behind, below the horizon"),
        ][k % 3];
        let reach = uniform(stream, 0.0, 0.8);
        Scene { what, ..Scene::draw(stream, reach, cosines) }
    };
    let scenes: Vec<Scene> = (0..9).map(&mut draw).collect();
    judge(work, &scenes)
}
