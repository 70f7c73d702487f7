//! The second pass: a box with a mirror and one without, gloss in a room, and a lamp in one
//! lobe.

use super::look::{Onlooker, solved};
use super::truth::PictureTruth;
use crate::chart::{
    Bench, ChartView, Column, Contest, Method, Suite, Trial, Verdict, WorkDone,
};
use crate::film::{Picture, Shot};
use crate::geometry::Polygon;
use crate::material::Lobe;
use crate::random::Stream;
use crate::raster::Seen;
use crate::room::Room;
use crate::scene::built_in;
use crate::trace::{Cone, LobeAs, Look, Strategy, TwoPass};
use glam::{DVec3, dvec2, dvec3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// This suite.
pub const SUITE: Suite = Suite {
    name: "second-pass",
    about: "pictures by two passes and by paths; gloss by cones and by rays",
    measure,
    views: &[
        ChartView {
            title: "Error of a picture with a mirror against the time for it",
            upward: (Column::Error, "error of a pixel, relative to the mean"),
            ..view("second-pass-mirror", |t| t.scene == MIRROR)
        },
        ChartView {
            title: "Error of a picture without a mirror against the time for it",
            upward: (Column::Error, "error of a pixel, relative to the mean"),
            ..view("second-pass-plain", |t| t.scene == PLAIN)
        },
        ChartView {
            title: "Error of what a glossy floor shows against the time of pass 2",
            upward: (Column::Error, "error of a pixel, relative to the mean"),
            ..view("second-pass-gloss", |t| t.scene == GLOSS)
        },
        ChartView {
            title: "Error of one lamp's light in a lobe against cones or rays",
            across: (Column::Setting, "N: cones, or rays"),
            upward: (Column::Error, "relative error"),
            ..view("second-pass-lobe", |t| t.scene == LOBE)
        },
    ],
};

const fn view(file: &'static str, shows: fn(&Trial) -> bool) -> ChartView {
    ChartView {
        file,
        title: "",
        across: (Column::Seconds, "CPU seconds, one thread"),
        upward: (Column::Error, ""),
        least: 1e-4,
        shows,
    }
}

/// Scenes of the suite.
pub const MIRROR: &str = "Cornell box with a mirror";
/// See [`MIRROR`].
pub const PLAIN: &str = "Cornell box";
/// See [`MIRROR`].
pub const GLOSS: &str = "glossy floor";
/// See [`MIRROR`].
pub const LOBE: &str = "lamp half in a lobe";

/// Pixels along an edge of the pictures; how many are held against walks, and how many of
/// these there are for each, twice.
const PICTURE: (u32, usize, usize) = (256, 3000, 800);

fn measure(bench: &Bench) -> Vec<Trial> {
    let (size, pixels, walks) = PICTURE;
    let tolerances = [0.1, 0.05, 0.03, 0.02, 0.015, 0.01];
    let mut trials = vec![];
    for (name, scene) in [(MIRROR, "cornell-mirror"), (PLAIN, "cornell-regular")] {
        let look = Onlooker::at(scene, size, pixels, walks);
        let contest = look
            .contest(name)
            .with(look.two_passes(&tolerances))
            .with(look.gathered(0.1, &[4.0, 16.0, 64.0]))
            .with(look.paths("paths", Strategy::Both, &[4.0, 16.0, 64.0]));
        trials.extend(contest.run(SUITE.name, bench));
    }
    trials.extend(gloss(48, 256, bench));
    trials.extend(lobe(bench));
    trials
}

const RAYS: [f64; 5] = [1.0, 4.0, 16.0, 64.0, 256.0];

/// What the floor of `glossy-floor` shows, its diffuse light given: `size × size` pixels,
/// nine samples each,
/// held against two pictures by 64 cones and so many rays.
pub fn gloss(size: u32, rays: usize, bench: &Bench) -> Vec<Trial> {
    let scene = built_in("glossy-floor").expect("it is built in");
    let (solution, _) = solved(&scene, 0.1);
    let (mesh, light) = (&solution.field.mesh, &solution.vertex_radiosity);
    let camera = scene.camera;
    let shot = Shot { camera, width: size, height: size, samples: 3 };
    let shown = |lobe, rays, seed| {
        // None may be cut because it is one of many.
        let options = Look { lobe, gloss: rays, seed, weight: 0.0, ..Look::default() };
        let two = TwoPass::showing(&Room::of(&scene), mesh, light, options);
        let shown = two.picture(&shot, &|_, _, _| {});
        (shown.picture, WorkDone { rays: shown.rays, ..WorkDone::default() })
    };
    let items = shot.items(mesh);
    let glossy = |seen: Seen| {
        let Seen::Front(element) = seen else { return false };
        let surface = mesh.surface_of(&mesh.elements[element as usize]);
        let material = scene.material(&scene.surfaces[surface as usize]);
        material.shine().gloss().is_some()
    };
    let pixels = (0..items.pixels().count()).zip(items.pixels());
    let pixels = pixels.filter(|(_, seen)| glossy(*seen)).map(|(k, _)| k).collect();
    let truth = PictureTruth::of(pixels, |seed| shown(LobeAs::Stack(64), rays, seed).0);
    let judge = |seen: &Picture| truth.judge(seen);
    let (cones, rays) = ([1.0, 2.0, 4.0, 8.0, 16.0, 32.0], [1.0, 4.0, 8.0, 32.0]);
    Contest::new(GLOSS, truth.uncertainty(), judge)
        .with(Method::random("N rays and 8 cones", &rays, |n, seed| {
            shown(LobeAs::Stack(8), n as usize, seed + 10)
        }))
        .with(Method::random("8 rays and N cones", &cones, |n, seed| {
            shown(LobeAs::Stack(n as usize), 8, seed + 10)
        }))
        .with(Method::random("N rays in one cone", &rays, |n, seed| {
            shown(LobeAs::OneCone(0.9), n as usize, seed + 10)
        }))
        .run(SUITE.name, bench)
}

/// Exponent of the lobe, and where the lamp begins: degrees from its axis.
const EXPONENT: f64 = 100.0;
const EDGE: f64 = 5.0;

/// Quick, and wrong by chance: more runs tell how wrong.
const OFTEN: u64 = 256;

/// How much of a lobe a lamp fills that begins beside its axis and goes on.
pub fn lobe(bench: &Bench) -> Vec<Trial> {
    let tan = EDGE.to_radians().tan();
    let corners = [(tan, -40.0), (40.0, -40.0), (40.0, 40.0), (tan, 40.0)];
    let corners = corners.map(|(x, y)| dvec3(x, y, 1.0));
    let lamp = Polygon::new(corners.to_vec()).expect("a rectangle");
    let overlap = |c: &Cone| c.overlap(DVec3::ZERO, DVec3::Z, lamp.vertices());
    let exact = filled(EDGE.to_radians());
    let off = |share: &f64| Verdict::of((share / exact - 1.0).abs());
    let phong = Lobe::Phong { exponent: EXPONENT };
    Contest::new(LOBE, 0.0, off)
        .with(
            Method::random("N stacked cones", &RAYS, |n, seed| {
                let offset = Stream::named(seed, &[n as u64]).next();
                let cone = |j| Cone::above((j as f64 + offset) / n, EXPONENT, DVec3::Z);
                let cones: Vec<Cone> = (0..n as u64).map(cone).collect();
                // Of the whole lobe each would count 2π/(n + 2).
                let counts = (EXPONENT + 2.0) / TAU / n;
                let sum: f64 = cones.iter().map(overlap).sum();
                (counts * sum, WorkDone { factors: n as u64, ..WorkDone::default() })
            })
            .seeds(OFTEN),
        )
        .with(
            Method::random("N rays", &RAYS, |n, seed| {
                let mut random = Stream::named(seed, &[n as u64]);
                let points = random.points(n as usize);
                // Each counts what the lobe and the cosine are over its density.
                let counts = |[u, v]: [f64; 2]| {
                    let wi = phong.sample(DVec3::Z, dvec2(u, v));
                    let counts =
                        phong.value(wi, DVec3::Z) * wi.z / phong.pdf(wi, DVec3::Z);
                    if wi.x > tan * wi.z { counts } else { 0.0 }
                };
                let sum: f64 = points.map(counts).sum();
                (
                    sum / n / phong.albedo(1.0),
                    WorkDone { rays: n as u64, ..WorkDone::default() },
                )
            })
            .seeds(OFTEN),
        )
        .with(Method::new("one cone of 90 %", &[1.0], |_, _| {
            let cone = Cone::holding(0.9, EXPONENT, DVec3::Z);
            let share = overlap(&cone) / cone.projected_solid_angle(DVec3::Z);
            (share, WorkDone { factors: 1, ..WorkDone::default() })
        }))
        .run(SUITE.name, bench)
}

/// The share of the lobe beyond a plane through its place, tilted so far from its axis:
/// along the plane's edge and across it the integral is a product.
///
/// ```text
/// ∫_α^{π/2} cosⁿ⁺¹β dβ / ∫_{−π/2}^{π/2} cosⁿ⁺¹β dβ
/// ```
fn filled(angle: f64) -> f64 {
    let beyond = |from: f64| {
        let (parts, width) = (4000, FRAC_PI_2 - from);
        let at =
            |k: u32| (from + width * (f64::from(k) + 0.5) / f64::from(parts)).cos();
        width / f64::from(parts)
            * (0..parts).map(|k| at(k).powf(EXPONENT + 1.0)).sum::<f64>()
    };
    beyond(angle) / (2.0 * beyond(0.0))
}
