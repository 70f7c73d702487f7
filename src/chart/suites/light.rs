//! What one point sees, and what one lobe reflects: integrals over directions by their
//! closed forms, by pieces, on grids, and by rays.

use crate::chart::{
    Bench, ChartView, Column, Contest, Method, Suite, Trial, Verdict, WorkDone,
};
use crate::geometry::Polygon;
use crate::material::Lobe;
use crate::radiometry::{cosine_direction, projected_solid_angle, solid_angle};
use crate::random::Stream;
use glam::{DVec2, DVec3, dvec2, dvec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::hint::black_box;

/// This suite.
pub const SUITE: Suite = Suite {
    name: "light",
    about: "solid angles, irradiances and albedos",
    measure,
    views: &[
        view(
            "solid-angle",
            "Relative error of a solid angle against the time to find it",
            |t| t.scene == SOLID_ANGLE,
        ),
        view(
            "irradiance",
            "Relative error of an irradiance against the time to find it",
            |t| t.scene == IRRADIANCE,
        ),
        view(
            "reflection",
            "Relative error of the reflected light against the time to find it",
            |t| t.scene == ALBEDO && t.method.starts_with("drawn"),
        ),
        view(
            "albedo",
            "Relative error of a directional albedo against the time to find it",
            |t| t.scene == ALBEDO && !matches!(&*t.method, DRAWN_EVEN | DRAWN_COSINE),
        ),
    ],
};

const fn view(
    file: &'static str,
    title: &'static str,
    shows: fn(&Trial) -> bool,
) -> ChartView {
    ChartView {
        file,
        title,
        across: (Column::Seconds, "CPU seconds"),
        upward: (Column::Error, "relative error"),
        least: 1e-7,
        shows,
    }
}

/// Scenes of the suite.
pub const SOLID_ANGLE: &str = "solid angle of a square";
/// See [`SOLID_ANGLE`].
pub const IRRADIANCE: &str = "irradiance above a square";
/// See [`SOLID_ANGLE`].
pub const ALBEDO: &str = "albedo of a lobe";

const DRAWN_EVEN: &str = "drawn evenly";
const DRAWN_COSINE: &str = "drawn by the cosine";

const RAYS: [f64; 4] = [100.0, 1_000.0, 10_000.0, 100_000.0];

fn measure(bench: &Bench) -> Vec<Trial> {
    let all = [of_solid_angle(), of_irradiance(), of_albedo()];
    all.iter().flat_map(|contest| contest.run(SUITE.name, bench)).collect()
}

/// The eye: 1 below the middle of the unit square.
const EYE: DVec3 = dvec3(0.0, 0.0, -1.0);

/// The unit square about the origin.
fn square() -> Polygon {
    let corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)];
    let corners = corners.map(|(x, y)| dvec3(x, y, 0.0)).to_vec();
    Polygon::new(corners).expect("a square is a polygon")
}

/// How far from this, relatively.
fn off(exact: f64) -> impl Fn(&f64) -> Verdict {
    move |found| Verdict::of((found / exact - 1.0).abs())
}

fn evaluations(n: f64) -> WorkDone {
    WorkDone { rays: n as u64, ..WorkDone::default() }
}

fn exactly<'a>(find: impl Fn() -> f64 + 'a) -> Method<'a, f64> {
    Method::new("closed form", &[1.0], move |_, _| (find(), evaluations(1.0)))
}

fn of_solid_angle() -> Contest<'static, f64> {
    let square = square();
    let exact = solid_angle(EYE, &square);
    let cuts = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];
    Contest::new(SOLID_ANGLE, 0.0, off(exact))
        .with(exactly(move || solid_angle(black_box(EYE), &square)))
        .with(Method::new("k × k pieces", &cuts, |k, _| {
            (by_pieces(black_box(EYE), k as u32), evaluations(k * k))
        }))
        .with(rays("rays", even, |_| TAU))
}

fn of_irradiance() -> Contest<'static, f64> {
    let square = square();
    let exact = projected_solid_angle(EYE, DVec3::Z, square.vertices());
    let closed =
        move || projected_solid_angle(black_box(EYE), DVec3::Z, square.vertices());
    Contest::new(IRRADIANCE, 0.0, off(exact))
        .with(exactly(closed))
        .with(rays("even rays", even, |w| TAU * w.z))
        .with(rays("rays by the cosine", cosine_direction, |_| PI))
}

/// `Σ ΔA cosθ/r²` over the middles of `cuts × cuts` pieces of the unit square about the
/// origin, sr; no more than a rule of thumb from close by.
pub fn by_pieces(p: DVec3, cuts: u32) -> f64 {
    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(cuts) - 0.5;
    let piece = |k: u32| {
        let r = p - dvec3(at(k % cuts), at(k / cuts), 0.0);
        r.z.abs() / r.length().powi(3)
    };
    let pieces = cuts * cuts;
    (0..pieces).map(piece).sum::<f64>() / f64::from(pieces)
}

/// The mean of `value` over directions that `direction` makes of two uniform numbers, and
/// that meet the square.
fn rays(
    name: &str,
    direction: fn(DVec2) -> DVec3,
    value: fn(DVec3) -> f64,
) -> Method<'static, f64> {
    let square = square();
    Method::random(name, &RAYS, move |n, seed| {
        let points = Stream::named(seed, &[n as u64]).points(n as usize);
        let of_ray = |[u, v]: [f64; 2]| {
            let w = direction(dvec2(u, v));
            let meets = w.z > 0.0 && square.contains(EYE - w * (EYE.z / w.z), 0.0);
            if meets { value(w) } else { 0.0 }
        };
        (points.map(of_ray).sum::<f64>() / n, evaluations(n))
    })
}

/// A direction of the upper hemisphere, all equally likely: Archimedes' map.
fn even(u: DVec2) -> DVec3 {
    let (sine, cosine) = (TAU * u.x).sin_cos();
    let across = (1.0 - u.y * u.y).sqrt();
    dvec3(across * cosine, across * sine, u.y)
}

/// A Phong lobe, narrow enough that it matters where one looks.
const LOBE: Lobe = Lobe::Phong { exponent: 50.0 };

/// Where it is looked at from: 45° to the normal.
fn eye() -> DVec3 {
    dvec3(0.5, 0.5, 0.5f64.sqrt())
}

fn of_albedo() -> Contest<'static, f64> {
    let reflected = |w: DVec3| LOBE.value(w, eye()) * w.z;
    Contest::new(ALBEDO, 0.0, off(LOBE.albedo(eye().z)))
        .with(exactly(|| LOBE.albedo(black_box(eye()).z)))
        .with(Method::new("grid", &[4.0, 8.0, 16.0, 32.0], |rings, _| {
            (on_a_grid(rings as u32), evaluations(4.0 * rings * rings))
        }))
        .with(drawn(DRAWN_EVEN, even, move |w| TAU * reflected(w)))
        .with(drawn(DRAWN_COSINE, cosine_direction, move |w| PI * reflected(w) / w.z))
        .with(drawn(
            "drawn from the lobe",
            |u| LOBE.sample(eye(), u),
            move |w| reflected(w) / LOBE.pdf(w, eye()),
        ))
}

/// The albedo from directions that are drawn each by itself.
fn drawn(
    name: &str,
    direction: fn(DVec2) -> DVec3,
    value: impl Fn(DVec3) -> f64 + 'static,
) -> Method<'static, f64> {
    Method::random(name, &RAYS, move |n, seed| {
        let mut stream = Stream::named(seed, &[n as u64]);
        let mut one = || {
            let w = direction(dvec2(stream.next(), stream.next()));
            if w.z > 0.0 { value(w) } else { 0.0 }
        };
        ((0..n as usize).map(|_| one()).sum::<f64>() / n, evaluations(n))
    })
}

/// The albedo from a grid of `rings` × 4·`rings` directions, even in θ and φ.
fn on_a_grid(rings: u32) -> f64 {
    let step = FRAC_PI_2 / f64::from(rings);
    let mut sum = 0.0;
    for k in 0..4 * rings * rings {
        let theta = step * (f64::from(k / (4 * rings)) + 0.5);
        let (y, x) = (step * (f64::from(k % (4 * rings)) + 0.5)).sin_cos();
        let (sine, cosine) = theta.sin_cos();
        sum += LOBE.value(dvec3(sine * x, sine * y, cosine), eye()) * cosine * sine;
    }
    sum * step * step
}
