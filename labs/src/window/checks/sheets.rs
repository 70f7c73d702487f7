//! Tasks 5 and 6: translucent sheets.

use super::super::Work;
use super::super::bugs::*;
use super::super::given::lambert;
use super::{Suspects, suspects};
use crate::check::{Suspect, Verdict, Within, compare};
use crate::draw::{direction, uniform};
use crate::shapes::{Place, convex};
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;
use std::f64::consts::PI;

/// What falls on both faces, ρ and τ.
type Lit = ([f64; 2], f64, f64);

const WRONG_SHEETS: &Suspects<Lit, [f64; 2]> = &[
    (RHO_FOR_TAU, |&([a, b], rho, tau)| [tau * a + rho * b, tau * b + rho * a]),
    (ONE_WAY_SHEET, |&([a, b], rho, tau)| [rho * a, rho * b + tau * a]),
    (ONE_WAY_SHEET, |&([a, b], rho, tau)| [rho * a + tau * b, rho * b]),
    (NO_REFLECTANCE, |&([a, b], _, tau)| [tau * b, tau * a]),
    (NOTHING_PASSES, |&([a, b], rho, _)| [rho * a, rho * b]),
    (SAME_FACE, |&([a, b], rho, tau)| [(rho + tau) * a, (rho + tau) * b]),
];

pub(super) fn sheet(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = || {
        let (rho, tau) = (uniform(stream, 0.1, 0.5), uniform(stream, 0.1, 0.5));
        ([uniform(stream, 0.5, 3.0), uniform(stream, 0.5, 3.0)], rho, tau)
    };
    let drawn: Vec<Lit> = (0..10).map(|_| draw()).collect();
    let all =
        |f: &dyn Fn(&Lit) -> [f64; 2]| drawn.iter().flat_map(f).collect::<Vec<f64>>();
    let suspects: Vec<Suspect> =
        WRONG_SHEETS.iter().map(|(bug, f)| (*bug, all(f))).collect();
    let place = |k: usize| {
        let ([a, b], rho, tau) = drawn[k / 2];
        let face = ["front", "back"][k % 2];
        format!("H = [{a:.3}, {b:.3}], ρ = {rho:.3}, τ = {tau:.3}: B of the {face}")
    };
    let expected = all(&|&([a, b], rho, tau)| [rho * a + tau * b, rho * b + tau * a]);
    let got = all(&|&(h, rho, tau)| (work.sheet)(h, rho, tau));
    compare(&got, &expected, Within::Absolute(1e-9), &suspects, place)
}

/// A point before a sheet, or behind it, and how it is lit.
struct Scene {
    p: DVec3,
    n: DVec3,
    window: Vec<DVec3>,
    outside: f64,
    tau: f64,
}

impl Scene {
    fn draw(stream: &mut Stream, side: f64) -> Scene {
        let place = Place::draw(stream);
        let window = place.all(&convex(stream));
        let mut across = || uniform(stream, -1.5, 1.5);
        let (x, y) = (across(), across());
        let p = place.of(dvec3(x, y, side * uniform(stream, 0.3, 1.5)));
        let (outside, tau) = (uniform(stream, 1.0, 5.0), uniform(stream, 0.2, 0.6));
        Scene { p, n: direction(stream), window, outside, tau }
    }

    fn factor(&self) -> f64 {
        lambert(self.p, self.n, &self.window)
    }
}

const WRONG_LIGHT: &Suspects<Scene, f64> = &[
    (NO_TAU, |s| s.outside * s.factor()),
    (NO_FACTOR, |s| s.outside * s.tau),
    (PI_AGAIN, |s| s.outside * s.tau * s.factor() / PI),
    (PI_AGAIN, |s| s.outside * s.tau * s.factor() * PI),
];

/// Points in the room, and two outside: their side of the sheet sends nothing, for
/// nothing falls on the other.
pub(super) fn frosted(work: &Work, stream: &mut Stream) -> Verdict {
    let mut draw = |k: usize| loop {
        let scene = Scene::draw(stream, if k < 8 { 1.0 } else { -1.0 });
        if k >= 8 || scene.factor() > 0.01 {
            return scene;
        }
    };
    let scenes: Vec<Scene> = (0..10).map(&mut draw).collect();
    let of = |s: &Scene| (work.frosted)(s.p, s.n, &s.window, s.outside, s.tau);
    let got: Vec<f64> = scenes.iter().map(of).collect();
    let expected: Vec<f64> =
        scenes.iter().map(|s| s.outside * s.tau * s.factor()).collect();
    let place = |k: usize| {
        let Scene { outside, tau, .. } = scenes[k];
        let where_ = if k < 8 { "in the room" } else { "outside" };
        format!("{where_}, H = {outside:.3}, τ = {tau:.3}")
    };
    let suspects = suspects(WRONG_LIGHT, &scenes);
    compare(&got, &expected, Within::Absolute(1e-9), &suspects, place)
}
