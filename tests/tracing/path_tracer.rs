//! The path tracer is right on the average: against laws, exact values and itself.

use crate::common::paths::{
    by_chance, camera, dull, irradiance, mirror, shiny, sphere,
};
use crate::common::rooms::{box_walls, rectangle};
use crate::common::{cases, point, polygon};
use glam::{DVec3, dvec2, dvec3};
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::material::Shine;
use radiosity::radiometry::cosine_direction;
use radiosity::random::Stream;
use radiosity::room::Room;
use radiosity::scene::{FaceId, Scene};
use radiosity::sky::Sky;
use radiosity::trace::{PathTracer, Strategy};
use std::f64::consts::PI;

const STRATEGIES: [Strategy; 3] = [Strategy::Lamps, Strategy::Lobes, Strategy::Both];

/// The mean radiance (red) seen from `eye` in all directions, and its standard error.
fn glance(tracer: &PathTracer, eye: DVec3, samples: usize, seed: u64) -> (f64, f64) {
    let mut random = Stream::named(seed, &[]);
    let (mut sum, mut squares) = (0.0, 0.0);
    for k in 0..samples {
        let up = cosine_direction(dvec2(random.next(), random.next()));
        let direction = if k % 2 == 0 { up } else { -up };
        let l = tracer.radiance(Ray { origin: eye, direction }, &mut random).x;
        sum += l;
        squares += l * l;
    }
    let n = samples as f64;
    let mean = sum / n;
    (mean, ((squares / n - mean * mean).max(0.0) / (n - 1.0)).sqrt())
}

/// Two shapes in which every point glows alike and has the same reflectance: radiance is
/// E/(π (1 − ρ)) everywhere. The sphere has ρ = ½ and shows 1.
#[test]
fn furnaces_glow_evenly() {
    let cube = shiny(box_walls([1.0; 3]).map(|wall| (wall, dull(1.0, 0.8))));
    let inside = sphere(DVec3::ZERO, 1.0, 8).into_iter().map(|p| p.flipped());
    let ball = shiny(inside.map(|p| (p, dull(0.5 * PI, 0.5))));
    let mut all = vec![];
    for strategy in STRATEGIES {
        for (name, scene, eye, right) in [
            ("cube", &cube, dvec3(0.3, 0.4, 0.2), 5.0 / PI),
            ("sphere", &ball, dvec3(0.1, 0.2, 0.3), 1.0),
        ] {
            let tracer = PathTracer::of(&Room::of(scene)).by(strategy);
            let (got, error) = glance(&tracer, eye, 20_000, 1);
            assert!(error < 0.02 * right, "{name}: {error}");
            all.push((format!("{name}, {strategy:?}"), got, error, right));
        }
    }
    by_chance(&all);
}

/// CIE 171, case 5.3: fourteen points lit by a lamp in the ceiling.
#[test]
fn a_lamp_lights_points_as_the_table_says() {
    let case = cases("E_cie171").into_iter().find(|c| c["id"] == "E-5.3-area-source");
    let case = case.expect("the table has it");
    let lamp = rectangle(dvec3(1.5, 1.5, 3.0), DVec3::Y, DVec3::X);
    let black = [(lamp, dull(1000.0 * PI, 0.0))];
    let walls = box_walls([4.0, 4.0, 3.0]).map(|wall| (wall, dull(0.0, 0.0)));
    let scene = shiny(walls.into_iter().chain(black));
    let mut all = vec![];
    for (name, x) in case["params"]["points"].as_object().unwrap() {
        let x = point(x);
        let surface = if x.y == 0.0 { 2 } else { 4 };
        let right = case["expected"]["E_lux"][name].as_f64().unwrap();
        let (got, error) = irradiance(&scene, surface, x, 20_000);
        assert!(error < 0.01 * right, "{name}: {error}");
        all.push((name, got, error, right));
    }
    assert_eq!(all.len(), 14);
    by_chance(&all);
}

/// Boxes whose light goes round and round: mean irradiances of walls, and those in their
/// middles, of the continuous radiosity equation.
#[test]
fn light_that_goes_round_is_as_the_table_says() {
    let mut all = vec![];
    for case in cases("C_continuous") {
        let number = |v: &serde_json::Value, k: usize| v[k].as_f64().unwrap();
        let side = |k: usize| number(&case["params"]["dims"], k);
        let walls = box_walls([side(0), side(1), side(2)]);
        let faces = (0..6).zip(&walls).map(|(k, wall)| {
            (wall.clone(), dull(number(&case["E"], k), number(&case["rho"], k)))
        });
        let scene = shiny(faces);
        let tracer = PathTracer::of(&Room::of(&scene));
        for (k, wall) in walls.iter().enumerate() {
            let (rho, e) = (number(&case["rho"], k), number(&case["E"], k));
            if rho == 0.0 {
                continue;
            }
            for (what, found) in [
                ("B_face_mean", tracer.face_irradiance(FaceId(k as u32), 20_000, 1)),
                (
                    "B_face_centre",
                    tracer.irradiance(k as u32, wall.centroid(), 20_000, 2),
                ),
            ] {
                let right = number(&case["expected"][what], k);
                let name = format!("{} {what} {k}", case["id"]);
                let (got, error) = (e + rho * found.mean.x, rho * found.error.x);
                assert!(error < 0.02 * right, "{name}: {error}");
                all.push((name, got, error, right));
            }
        }
    }
    assert_eq!(all.len(), 2 * (6 + 6 + 2 + 2 + 6));
    by_chance(&all);
}

/// A lamp seen straight and by a mirror, unlimited and small.
#[test]
fn mirrors_show_lamps_as_the_table_says() {
    let mut all = vec![];
    for case in cases("G_mirror_glass") {
        if case["kind"] != "mirror_point" {
            continue;
        }
        let reflectance = case["params"]["mirror_reflectance"].as_f64().unwrap();
        let (lamp, glass) = (polygon(&case["emitter"]), polygon(&case["mirror"]));
        // Which side shines is told by the drawing, not by the order of corners.
        let x = point(&case["point"]);
        let facing =
            |p: Polygon| if p.plane().height(x) < 0.0 { p.flipped() } else { p };
        let ground =
            rectangle(x - dvec3(0.1, 0.1, 0.0), 0.2 * DVec3::X, 0.2 * DVec3::Y);
        let scene = shiny([
            (ground, dull(0.0, 0.0)),
            (facing(lamp), dull(PI, 0.0)),
            (facing(glass), mirror(reflectance)),
        ]);
        let right = &case["expected"]["irradiance_for_unit_radiance_emitter"];
        let (got, error) = irradiance(&scene, 0, x, 200_000);
        all.push((case["id"].to_string(), got, error, right.as_f64().unwrap()));
    }
    assert_eq!(all.len(), 2);
    by_chance(&all);
}

/// The lamp of the unit cube above the middle of its floor, walls of perfect mirrors: two of
/// them make a strip of lamps without end, F = 1/√5; four a plane, F = 1.
#[test]
fn mirror_corridors_have_no_end() {
    let walls = box_walls([1.0; 3]);
    let room = |mirrors: usize| {
        let material = |k: usize| match k {
            5 => dull(1.0, 0.0),
            k if k < mirrors => mirror(1.0),
            _ => dull(0.0, 0.0),
        };
        shiny((0..6).map(|k| (walls[k].clone(), material(k))))
    };
    let middle = dvec3(0.5, 0.5, 0.0);
    let at = |mirrors: usize| irradiance(&room(mirrors), 4, middle, 20_000);
    let (two, error) = at(2);
    by_chance(&[("two", two, error, 1.0 / 5.0_f64.sqrt())]);
    let (four, error) = at(4);
    by_chance(&[("four", four, error, 1.0)]);
}

/// A room with one perfect mirror is half of a room twice as long.
#[test]
fn a_mirror_room_is_half_of_the_doubled_room() {
    let rho = [0.0, 0.5, 0.6, 0.7, 0.4, 0.8];
    let e = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let single = shiny((0..6).zip(box_walls([1.0; 3])).map(|(k, wall)| {
        (wall, if k == 0 { mirror(1.0) } else { dull(e[k], rho[k]) })
    }));
    let double = shiny((0..6).zip(box_walls([2.0, 1.0, 1.0])).map(|(k, wall)| {
        // both ends are the far wall
        let k = k.max(1);
        (wall, dull(e[k], rho[k]))
    }));
    let h = |scene: &Scene, k: u32| {
        let found = PathTracer::of(&Room::of(scene)).face_irradiance(
            FaceId(k),
            40_000,
            u64::from(k),
        );
        (found.mean.x, found.error.x)
    };
    let compare = |k: u32| {
        let ((a, da), (b, db)) = (h(&single, k), h(&double, k));
        (format!("wall {k}"), a, da.hypot(db), b)
    };
    by_chance(&(1..6).map(compare).collect::<Vec<_>>());
}

/// A small lamp, one that fills the view, gloss, a pane before a lamp, a sky: whichever way
/// lamps are found, the light is the same.
#[test]
fn all_strategies_agree() {
    let mut faces: Vec<_> =
        box_walls([2.0, 2.0, 1.0]).map(|wall| (wall, dull(0.0, 0.5))).into();
    faces.pop(); // no ceiling: the sky
    let gloss = Shine::Gloss { reflectance: Rgb::splat(0.4), exponent: 40.0 };
    faces[4].1.shine = gloss;
    faces[4].1.diffuse = Rgb::splat(0.3);
    let lamp = |size: f64, z: f64| {
        rectangle(dvec3(0.5, 0.5, z), DVec3::Y * size, DVec3::X * size)
    };
    faces.push((lamp(0.3, 0.9), dull(10.0, 0.0)));
    faces.push((lamp(0.5, 0.7), crate::common::paths::pane()));
    faces.push((rectangle(dvec3(1.9, 0.5, 0.1), DVec3::Z, DVec3::Y), dull(3.0, 0.2)));
    let mut scene = shiny(faces);
    scene.sky = Some(Sky::overcast(Rgb::new(0.5, 0.6, 0.7), DVec3::Z));
    let mut all = vec![];
    let tracers =
        STRATEGIES.map(|strategy| PathTracer::of(&Room::of(&scene)).by(strategy));
    for k in 0..5 {
        let found =
            tracers.each_ref().map(|t| t.face_irradiance(FaceId(k), 60_000, k.into()));
        let [lamps, lobes, both] = found;
        for (what, other) in [("lamps", lamps), ("lobes", lobes)] {
            let error = both.error.x.hypot(other.error.x);
            all.push((format!("wall {k}, {what}"), other.mean.x, error, both.mean.x));
        }
    }
    by_chance(&all);
}

/// The errors told are those that are made: over 400 estimates the mean of z² is 1.
#[test]
fn the_errors_told_are_honest() {
    let scene = shiny(box_walls([1.0; 3]).map(|wall| (wall, dull(1.0, 0.5))));
    let tracer = PathTracer::of(&Room::of(&scene));
    let z2 = |seed| {
        let found = tracer.irradiance(0, dvec3(0.0, 0.4, 0.3), 256, seed);
        ((found.mean.x - 2.0) / found.error.x).powi(2)
    };
    let mean = (0..400).map(z2).sum::<f64>() / 400.0;
    // its own standard error is √(2/400) = .07
    assert!((mean - 1.0).abs() < 0.28, "{mean}");
}

/// The same picture at any number of threads, and pixel by pixel whatever is around.
#[test]
fn pictures_do_not_depend_on_threads() {
    let scene = shiny(box_walls([1.0; 3]).map(|wall| (wall, dull(1.0, 0.5))));
    let tracer = PathTracer::of(&Room::of(&scene));
    let camera = camera(dvec3(0.5, 0.1, 0.5), dvec3(0.5, 0.9, 0.4), 60.0);
    let shot = radiosity::film::Shot { camera, width: 16, height: 12, samples: 1 };
    let with = |threads: usize| {
        let pool =
            rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| tracer.picture(&shot, 8, 5, &|_, _, _| ()))
    };
    let (one, three) = (with(1), with(3));
    assert_eq!(one.picture, three.picture);
    assert_eq!(one.error, three.error);
    assert_eq!(one.classes, three.classes);
    let mean = one.picture.pixels.iter().copied().sum::<Rgb>() / (16.0 * 12.0);
    assert!((one.classes.total() - mean).length() < 1e-12);
    by_chance(&[("furnace", mean.x, one.mean_error.x, 2.0 / PI)]);
}
