//! Pictures of the second pass: against the path tracer, at any number of threads, and as
//! snapshots.

use crate::common::paths::{
    by_chance, camera, dull, glass, mirror, pane, shine, shiny, sphere,
};
use crate::common::picture::assert_picture;
use crate::common::rooms::{box_walls, moved, rectangle};
use glam::{DVec3, dvec3};
use radiosity::film::Shot;
use radiosity::geometry::{Ray, Rgb};
use radiosity::material::{Coefficients, Shine};
use radiosity::mesh::Mesh;
use radiosity::random::Stream;
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in};
use radiosity::solve::Enclosure;
use radiosity::trace::{LobeAs, Look, PathTracer, TwoPass, Whitted};

const PICTURES: &str = "tests/pictures";

/// A room of walls that shine in their own colours and reflect nothing, so that pass 1 is
/// exact; in it a glossy plate, a mirror, a pane, a block of glass and a lamp.
fn still_life() -> Scene {
    let coloured = |k: usize| Coefficients {
        emission: Rgb::new(1.0 + k as f64, 6.0 - k as f64, 2.0 + (k % 3) as f64),
        ..Coefficients::default()
    };
    let walls = box_walls([4.0; 3]).into_iter().enumerate();
    let walls = walls.map(|(k, p)| (p, coloured(k)));
    let at = |x, y, z| dvec3(x, y, z);
    let gloss = Shine::Gloss { reflectance: Rgb::new(0.9, 0.6, 0.3), exponent: 60.0 };
    let plate = rectangle(at(0.1, 0.1, 0.5), 3.8 * DVec3::X, 3.8 * DVec3::Y);
    let glossy = Coefficients { emission: Rgb::splat(0.3), ..shine(gloss) };
    let standing = rectangle(at(0.3, 3.0, 0.7), 1.5 * DVec3::X, 2.0 * DVec3::Z);
    let sheet = rectangle(at(2.2, 2.8, 0.7), at(1.4, 0.5, 0.0), 2.0 * DVec3::Z);
    let lamp = rectangle(at(1.8, 2.2, 3.2), DVec3::Y * 0.6, DVec3::X * 0.6);
    let block = box_walls([0.5, 0.6, 0.7])
        .map(|p| (moved(&p.flipped(), |v| v + at(1.6, 1.4, 0.8)), glass(1.5)));
    let all = [
        (plate, glossy),
        (standing, mirror(0.8)),
        (sheet, pane()),
        (lamp, dull(200.0, 0.0)),
    ];
    let mut scene = shiny(walls.chain(all).chain(block));
    scene.camera = camera(at(2.0, 0.2, 1.7), at(2.0, 2.4, 1.1), 70.0);
    scene
}

fn solved(scene: &Scene) -> (Mesh, Vec<Rgb>) {
    let mesh = Mesh::uniform(scene, 1.0);
    let b = mesh.vertex_values(&Enclosure::of(scene, &mesh).emission);
    (mesh, b)
}

fn shot(scene: &Scene, size: u32, samples: u32) -> Shot {
    Shot { camera: scene.camera, width: size, height: size, samples }
}

/// Where pass 1 is exact the second pass is right, ray by ray: lamps in the gloss are
/// counted once, also where panes, mirrors and glass stand before them.
#[test]
fn the_second_pass_shows_what_paths_find() {
    let scene = still_life();
    let (mesh, b) = solved(&scene);
    let tracer = PathTracer::of(&Room::of(&scene));
    let look = Look::following(40, 1e-5);
    let mut all = Vec::new();
    for k in 0..24_u32 {
        let (u, v) = (f64::from(k % 6) / 5.0, f64::from(k / 6) / 3.0);
        let target = dvec3(0.4 + 3.2 * u, 3.0 - 1.4 * v, 2.1 - 1.6 * v);
        let eye = scene.camera.eye;
        let ray = Ray { origin: eye, direction: (target - eye).normalize() };
        let mut random = Stream::named(5, &[k.into()]);
        let paths: Vec<f64> =
            (0..6000).map(|_| tracer.radiance(ray, &mut random).y).collect();
        let passes: Vec<f64> = (0..100)
            .map(|seed| {
                let options = Look { seed, ..look };
                TwoPass::showing(&Room::of(&scene), &mesh, &b, options)
                    .along(&ray)
                    .radiance
                    .y
            })
            .collect();
        let of = |all: &[f64]| {
            let n = all.len() as f64;
            let mean = all.iter().sum::<f64>() / n;
            let square = all.iter().map(|x| (x - mean).powi(2)).sum::<f64>();
            (mean, square / (n - 1.0) / n)
        };
        let ((right, of_paths), (got, of_passes)) = (of(&paths), of(&passes));
        // What is cut by weight is a part in ten thousand.
        let cut = 1e-4 * right;
        all.push((k, got, (of_paths + of_passes + cut * cut).sqrt(), right));
    }
    by_chance(&all);
}

/// Same bytes at any number of threads.
#[test]
fn threads_change_nothing() {
    let scene = still_life();
    let (mesh, b) = solved(&scene);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| {
            let two = TwoPass::showing(&Room::of(&scene), &mesh, &b, Look::default());
            let whitted = Whitted::of(&Room::of(&scene), Look::default());
            let shot = shot(&scene, 24, 2);
            (two.picture(&shot, &|_, _, _| {}), whitted.picture(&shot, &|_, _, _| {}))
        })
    };
    assert_eq!(with(1), with(4));
}

/// Where nothing shines no ray is followed, and the picture is that of pass 1.
#[test]
fn nothing_that_shines_costs_no_second_pass() {
    let scene = built_in("cornell").unwrap();
    let mesh = Mesh::uniform(&scene, 0.2);
    let b: Vec<Rgb> = mesh.vertices.iter().map(|v| *v + Rgb::ONE).collect();
    let shot = shot(&scene, 48, 3);
    let two = TwoPass::showing(&Room::of(&scene), &mesh, &b, Look::default());
    let shown = two.picture(&shot, &|_, _, _| {});
    assert_eq!((shown.rays, shown.cut), (0, Rgb::ZERO));
    let stored = shot.smooth(&mesh, &b);
    for (a, b) in shown.picture.pixels.iter().zip(&stored.pixels) {
        assert!((*a - *b).abs().max_element() < 1e-12);
    }
}

#[test]
fn a_still_life() {
    let scene = still_life();
    let (mesh, b) = solved(&scene);
    let two = TwoPass::showing(&Room::of(&scene), &mesh, &b, Look::default());
    let shown = two.picture(&shot(&scene, 64, 3), &|_, _, _| {});
    assert_picture(PICTURES, "trace-two-pass", &shown.picture.display(0.4));
    let one_cone = Look { lobe: LobeAs::OneCone(0.9), ..Look::default() };
    let two = TwoPass::showing(&Room::of(&scene), &mesh, &b, one_cone);
    let shown = two.picture(&shot(&scene, 64, 3), &|_, _, _| {});
    assert_picture(PICTURES, "trace-one-cone", &shown.picture.display(0.4));
}

#[test]
fn a_ball_of_glass() {
    let walls = box_walls([4.0; 3]).into_iter().enumerate();
    let light = |k: usize| Coefficients {
        emission: Rgb::new([1.0, 4.0][k % 2], 2.0, [4.0, 1.0][k / 2 % 2]),
        ..Coefficients::default()
    };
    let ball = sphere(DVec3::splat(2.0), 0.8, 16).into_iter().map(|p| (p, glass(1.5)));
    let mut scene = shiny(walls.map(|(k, p)| (p, light(k))).chain(ball));
    scene.camera = camera(dvec3(2.3, 0.1, 2.5), DVec3::splat(2.0), 60.0);
    let (mesh, b) = solved(&scene);
    let two = TwoPass::showing(&Room::of(&scene), &mesh, &b, Look::default());
    let shown = two.picture(&shot(&scene, 64, 3), &|_, _, _| {});
    assert!(shown.cut.max_element() < 0.02, "{}", shown.cut);
    assert_picture(PICTURES, "trace-glass", &shown.picture.display(0.8));
}

#[test]
fn classical_ray_tracing() {
    let scene = built_in("cornell-mirror").unwrap();
    let whitted = Whitted::of(&Room::of(&scene), Look::default());
    let shown = whitted.picture(&shot(&scene, 64, 3), &|_, _, _| {});
    let exposure = shown.picture.auto_exposure();
    assert_picture(PICTURES, "trace-classical", &shown.picture.display(exposure));
}
