//! Paths through mirrors, panes and glass: nothing is lost, nothing is made.

use crate::common::paths::{by_chance, dull, glow, mirror, pane, shine, shiny};
use crate::common::rooms::rectangle;
use glam::{DVec3, dvec3};
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::material::optics::pane as pane_shares;
use radiosity::material::{Coefficients, Shine};
use radiosity::random::Stream;
use radiosity::room::Room;
use radiosity::scene::Scene;
use radiosity::trace::{Look, PathTracer, Whitted};
use std::f64::consts::PI;

/// A lamp behind panes, seen straight on: of N of them, with the reflections between all
/// faces, (1 − R)/(1 + (2N − 1) R) passes. Rows 69 and 73: what is summed by chance has no
/// last bounce; cut after one pass, N = 6 lacks the tenth part.
#[test]
fn stacks_of_panes_pass_what_stokes_says() {
    let r = 0.04;
    let mut all = vec![];
    for n in [1_usize, 2, 6] {
        let slab = |k: usize| {
            let corner = dvec3(-1.0, -1.0, 0.1 * (k + 1) as f64);
            (rectangle(corner, 2.0 * DVec3::X, 2.0 * DVec3::Y), pane())
        };
        let lamp = rectangle(dvec3(-1.0, -1.0, 2.0), 2.0 * DVec3::Y, 2.0 * DVec3::X);
        let scene = shiny((0..n).map(slab).chain([(lamp, dull(PI, 0.0))]));
        let tracer = PathTracer::of(&Room::of(&scene));
        let ray = Ray { origin: DVec3::ZERO, direction: DVec3::Z };
        let mut random = Stream::named(n as u64, &[]);
        let mean =
            |f: &mut dyn FnMut() -> f64| (0..40_000).map(|_| f()).sum::<f64>() / 4e4;
        let got = mean(&mut || tracer.radiance(ray, &mut random).x);
        let right = (1.0 - r) / (1.0 + (2 * n - 1) as f64 * r);
        let error = (right * (1.0 - right) / 4e4).sqrt();
        all.push((n, got, error, right));
        // Rays that are followed to the lamp and no further have one pass, and lack that.
        let look = Look::following(n as u32, 0.0);
        let once = Whitted::of(&Room::of(&scene), look).along(&ray).radiance.x;
        let straight = pane_shares(1.0, 1.5).1.powi(n as i32);
        assert!((once - straight).abs() < 1e-12, "{n}: {once}, not {straight}");
        let lacks = 1.0 - once / got;
        let least = if n == 6 { 0.05 } else { -4.0 * error };
        assert!((least..0.15).contains(&lacks), "{n}: {once} of {got}");
    }
    by_chance(&all);
}

/// A diffuse floor below a pane: lamps are asked through the pane, or found; each alone and
/// both together find the same, and the integral of T(θ) over the lamp.
#[test]
fn a_pane_before_a_lamp_lets_its_share_through() {
    let lamp = rectangle(dvec3(-0.5, -0.5, 1.0), DVec3::Y, DVec3::X);
    let ground = rectangle(dvec3(-1.0, -1.0, 0.0), 2.0 * DVec3::X, 2.0 * DVec3::Y);
    let window = rectangle(dvec3(-1.0, -1.0, 0.5), 2.0 * DVec3::X, 2.0 * DVec3::Y);
    let scene = shiny([
        (ground, dull(0.0, 0.0)),
        (lamp.clone(), dull(PI, 0.0)),
        (window, pane()),
    ]);
    // H = ∫ T(θ) cosθ cosθ'/r² dA, midpoint rule
    let n = 400;
    let cell = |k: usize| {
        let at = |k: usize| (k as f64 + 0.5) / n as f64 - 0.5;
        let y = dvec3(at(k % n), at(k / n), 1.0);
        let cosine = 1.0 / y.length();
        pane_shares(cosine, 1.5).1 * cosine.powi(4) / (n * n) as f64
    };
    let right: f64 = (0..n * n).map(cell).sum();
    use radiosity::trace::Strategy::{Both, Lamps, Lobes};
    let found = [Lamps, Lobes, Both].map(|strategy| {
        let tracer = PathTracer::of(&Room::of(&scene)).by(strategy);
        let found = tracer.irradiance(0, DVec3::ZERO, 100_000, 4);
        (format!("{strategy:?}"), found.mean.x, found.error.x, right)
    });
    by_chance(&found);
}

/// Sheets that let light through diffusely act alike on both sides: a lamp before the sheet
/// lights the floor behind as much as when they are exchanged, and as τ H says.
#[test]
fn translucent_sheets_are_the_same_from_both_sides() {
    let tau = 0.4;
    let sheet = Coefficients { translucence: Rgb::splat(tau), ..Default::default() };
    let plane = rectangle(dvec3(-0.5, -0.5, 0.0), DVec3::X, DVec3::Y);
    let scene = |sheet_plane: Polygon| {
        let mut scene = shiny([(sheet_plane, sheet)]);
        let sky = radiosity::sky::Sky::uniform(Rgb::ONE, DVec3::Z);
        scene.sky = Some(sky);
        scene
    };
    let below = Ray { origin: dvec3(0.1, 0.1, -1.0), direction: DVec3::Z };
    for scene in [scene(plane.clone()), scene(plane.flipped())] {
        let tracer = PathTracer::of(&Room::of(&scene));
        let mut random = Stream::named(5, &[]);
        let l = (0..2000).map(|_| tracer.radiance(below, &mut random).x);
        // the upper side sees the whole sky, H = π, and radiance is τ H/π
        let l: f64 = l.sum::<f64>() / 2000.0;
        assert!((l - tau).abs() < 0.005, "{l}"); // some 4 σ of 2000 paths
        let above = Ray { origin: dvec3(0.1, 0.1, 1.0), direction: DVec3::NEG_Z };
        assert_eq!(tracer.radiance(above, &mut random), Rgb::ZERO);
    }
}

/// The back of a mirror is black, of a two-sided one it mirrors; seen from behind a diffuse
/// wall is black, whatever it shows in front.
#[test]
fn backs_are_black() {
    let plane = rectangle(dvec3(-0.5, -0.5, 0.0), DVec3::X, DVec3::Y);
    let eye = |z: f64| Ray {
        origin: dvec3(0.1, 0.2, z),
        direction: dvec3(0.1, 0.1, -z).normalize(),
    };
    let seen = |scene: &Scene, z: f64| {
        let mut random = Stream::named(6, &[]);
        PathTracer::of(&Room::of(scene)).radiance(eye(z), &mut random).x
    };
    let silver = shiny(glow().chain([(plane.clone(), mirror(0.9))]));
    assert!((seen(&silver, 1.0) - 0.9).abs() < 1e-12);
    assert_eq!(seen(&silver, -1.0), 0.0);
    let both = silver.two_sided();
    assert!((seen(&both, 1.0) - 0.9).abs() < 1e-12);
    assert!((seen(&both, -1.0) - 0.9).abs() < 1e-12);
    let lamp = shiny([(plane, dull(PI, 0.5))]);
    assert_eq!((seen(&lamp, 1.0), seen(&lamp, -1.0)), (1.0, 0.0));
}

/// In an even glow a glossy floor shows its directional albedo.
#[test]
fn gloss_shows_its_albedo() {
    let mut all = vec![];
    for (exponent, slope) in [(3.0, 0.2_f64), (50.0, 0.9), (400.0, 0.5)] {
        let gloss = Shine::Gloss { reflectance: Rgb::splat(0.8), exponent };
        let material = Coefficients { diffuse: Rgb::splat(0.1), ..shine(gloss) };
        let plane = rectangle(dvec3(-2.0, -2.0, 0.0), 4.0 * DVec3::X, 4.0 * DVec3::Y);
        let scene = shiny(glow().chain([(plane, material)]));
        let direction = dvec3((1.0 - slope * slope).sqrt(), 0.0, -slope);
        let ray = Ray { origin: -0.5 * direction / slope, direction };
        let tracer = PathTracer::of(&Room::of(&scene));
        let mut random = Stream::named(7, &[]);
        let all_samples: Vec<f64> =
            (0..20_000).map(|_| tracer.radiance(ray, &mut random).x).collect();
        let mean = all_samples.iter().sum::<f64>() / 2e4;
        let spread = all_samples.iter().map(|l| (l - mean).powi(2)).sum::<f64>();
        let right = scene.materials[6].brdf().albedo(slope).x;
        let error = (spread / 2e4 / 2e4).sqrt();
        all.push((format!("n = {exponent}, cos {slope}"), mean, error, right));
    }
    by_chance(&all);
}

/// A frosted pane, which also scatters, lets the same through both ways; light that is
/// scattered on its front, its black back absorbs.
#[test]
fn frosted_panes_pass_the_same_both_ways() {
    let frosted = Coefficients {
        diffuse: Rgb::splat(0.3),
        translucence: Rgb::splat(0.2),
        ..pane()
    };
    let plane = rectangle(dvec3(-0.5, -0.5, 0.0), DVec3::X, DVec3::Y);
    let lamp = rectangle(dvec3(-0.01, -0.01, 5.0), 0.02 * DVec3::Y, 0.02 * DVec3::X);
    let through = |plane: Polygon| {
        let scene = shiny([(plane, frosted), (lamp.clone(), dull(PI, 0.0))]);
        let tracer = PathTracer::of(&Room::of(&scene));
        let mut random = Stream::named(8, &[]);
        let ray = Ray { origin: dvec3(0.0, 0.0, -5.0), direction: DVec3::Z };
        (0..20_000).map(|_| tracer.radiance(ray, &mut random).x).sum::<f64>() / 2e4
    };
    let right = 0.5 * pane_shares(1.0, 1.5).1;
    let error = (0.25_f64 / 2e4).sqrt();
    by_chance(&[
        ("front", through(plane.clone()), error, right),
        ("back", through(plane.flipped()), error, right),
    ]);
}
