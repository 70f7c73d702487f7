//! Task 4: form factors by a mirror.

use super::super::Work;
use super::super::bugs::*;
use super::super::given::{clip, lambert, plane};
use super::{Suspects, above, outline};
use crate::check::{Suspect, Verdict, Within, compare};
use crate::draw::direction;
use crate::shapes::{Place, convex};
use radiosity::prelude::{DVec3, Plane, dvec3};
use radiosity::random::Stream;

/// A point, a mirror and a lamp.
struct Scene {
    name: &'static str,
    p: DVec3,
    n: DVec3,
    mirror: Vec<DVec3>,
    lamp: Vec<DVec3>,
}

impl Scene {
    fn placed(self, place: &Place) -> Scene {
        Scene {
            p: place.of(self.p),
            n: place.direction(self.n),
            mirror: place.all(&self.mirror),
            lamp: place.all(&self.lamp),
            ..self
        }
    }

    /// Point and lamp at heights of these signs over the mirror.
    fn draw(stream: &mut Stream, name: &'static str, signs: [f64; 2]) -> Scene {
        let mut above = |sign: f64, low, high| {
            let at = above(stream, low, high);
            dvec3(at.x, at.y, sign * at.z)
        };
        let p = above(signs[0], 0.3, 1.5);
        let centre = above(signs[1], 0.8, 2.0);
        let lamp = outline(stream, centre, 0.5);
        let n = direction(stream);
        let mirror = convex(stream);
        Scene { name, p, n, mirror, lamp }.placed(&Place::draw(stream))
    }

    fn image(&self, x: DVec3) -> DVec3 {
        let mirror = plane(&self.mirror);
        x - mirror.normal * (2.0 * mirror.height(x))
    }

    /// From the virtual eye: the image of the point looks out of the mirror at the lamp
    /// itself. So nothing of it goes the student's way.
    fn right(&self) -> f64 {
        let mirror = plane(&self.mirror);
        if mirror.height(self.p) <= 0.0 {
            return 0.0;
        }
        let (eye, seen) = (self.image(self.p), clip(mirror, &self.lamp));
        let n = self.mirror.len();
        let middle = self.mirror.iter().sum::<DVec3>() / n as f64;
        let side = |k: usize| {
            let side = plane(&[eye, self.mirror[k], self.mirror[(k + 1) % n]]);
            if side.height(middle) > 0.0 { side } else { side.flipped() }
        };
        let seen = (0..n).map(side).fold(seen, |left, side: Plane| clip(side, &left));
        let normal = self.image(self.p + self.n) - eye;
        lambert(eye, normal.normalize(), &seen)
    }

    /// The image as far as it is in front of nothing: no window.
    fn unclipped(&self) -> f64 {
        let seen = clip(plane(&self.mirror), &self.lamp);
        let image: Vec<DVec3> = seen.iter().rev().map(|&c| self.image(c)).collect();
        lambert(self.p, self.n, &image)
    }

    fn direct(&self) -> f64 {
        lambert(self.p, self.n, &self.lamp)
    }

    fn two_sided(&self) -> f64 {
        let mirror: Vec<DVec3> = self.mirror.iter().rev().copied().collect();
        let back = Scene { mirror, lamp: self.lamp.clone(), ..*self };
        self.right() + back.right()
    }
}

const WRONG: &Suspects<Scene, f64> = &[
    (NOT_CLIPPED, Scene::unclipped),
    (DIRECT, Scene::direct),
    (BOTH_WAYS, |s| s.right() + s.direct()),
    (DARK, |_| 0.0),
    (FROM_BEHIND, Scene::two_sided),
];

fn judge(work: &Work, scenes: &[Scene], expected: &[f64]) -> Verdict {
    let all = |f: fn(&Scene) -> f64| scenes.iter().map(f).collect::<Vec<f64>>();
    let suspects: Vec<Suspect> = WRONG.iter().map(|&(bug, f)| (bug, all(f))).collect();
    let got: Vec<f64> =
        scenes.iter().map(|s| (work.by_mirror)(s.p, s.n, &s.mirror, &s.lamp)).collect();
    let place = |k: usize| format!("{}, turned", scenes[k].name);
    compare(&got, expected, Within::Absolute(1e-9), &suspects, place)
}

/// A rectangle in a plane, from two opposite corners.
fn flat(at: impl Fn(f64, f64) -> DVec3, low: [f64; 2], high: [f64; 2]) -> Vec<DVec3> {
    let corners =
        [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])];
    corners.map(|(u, v)| at(u, v)).to_vec()
}

pub(super) fn known(work: &Work, stream: &mut Stream) -> Verdict {
    let lamp = |x: f64, z: f64| {
        // Looks down: counter-clockwise from below.
        flat(|y, x| dvec3(x, y, z), [-0.5, x], [0.5, x + 1.0])
    };
    let right = |low, high| flat(|z, y| dvec3(1.0, y, z), low, high); // looks to −x
    let left = |low, high| flat(|y, z| dvec3(0.0, y, z), low, high); // looks to +x
    let scene = |name, p, mirror, lamp| Scene { name, p, n: DVec3::Z, mirror, lamp };
    let cases = [
        (
            scene(
                "mirror x = 1, z ≤ 0.6",
                DVec3::ZERO,
                right([-1.0, -9.0], [0.6, 9.0]),
                lamp(-0.5, 1.0),
            ),
            0.009_785_756_793,
        ),
        (
            scene(
                "mirror x = 1 without end",
                DVec3::ZERO,
                right([-50.0; 2], [50.0; 2]),
                lamp(-0.5, 1.0),
            ),
            0.013_923_717_407,
        ),
        (
            scene(
                "G7-mirror-point-wall-inf",
                dvec3(1.2, 0.0, 0.0),
                left([-50.0; 2], [50.0; 2]),
                lamp(1.0, 2.0),
            ),
            0.010_259_879_599_414,
        ),
        (
            scene(
                "G7-mirror-point-wall-finite",
                dvec3(1.2, 0.1, 0.0),
                left([-0.4, 0.2], [0.4, 1.2]),
                lamp(1.0, 2.0),
            ),
            0.010_241_837_520_474,
        ),
    ];
    let place = Place::draw(stream);
    let (scenes, expected): (Vec<Scene>, Vec<f64>) =
        cases.into_iter().map(|(scene, f)| (scene.placed(&place), f)).unzip();
    judge(work, &scenes, &expected)
}

/// Lamps of which a mirror shows a part, past the horizon too.
pub(super) fn any(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || loop {
        let scene = Scene::draw(stream, "some mirror", [1.0, 1.0]);
        let (right, whole) = (scene.right(), scene.unclipped());
        if right > 1e-3 && right < 0.9 * whole {
            return scene;
        }
    };
    let scenes: Vec<Scene> = (0..12).map(|_| draw()).collect();
    let expected: Vec<f64> = scenes.iter().map(Scene::right).collect();
    judge(work, &scenes, &expected)
}

/// Points and lamps behind: nothing, though a mirror with two sides would show a lamp.
pub(super) fn one_side(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |k: usize| loop {
        let signs = [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0]][k % 3];
        let scene = Scene::draw(stream, "behind a mirror", signs);
        // A lamp behind is not seen past the mirror either.
        let fits = match k % 3 {
            0 => scene.two_sided() > 1e-3,
            1 => true,
            _ => scene.direct() == 0.0,
        };
        if fits {
            return scene;
        }
    };
    let scenes: Vec<Scene> = (0..9).map(&mut draw).collect();
    let expected: Vec<f64> = scenes.iter().map(Scene::right).collect();
    judge(work, &scenes, &expected)
}
