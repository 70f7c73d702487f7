//! Solids of glass in, on and beside each other: no tracer makes light, and all agree.

use crate::common::paths::{by_chance, dull, glass, glow, pane, shiny, sphere};
use crate::common::rooms::{box_walls, moved, rectangle};
use glam::{DMat3, DVec3, dvec3};
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::material::Coefficients;
use radiosity::material::optics::{fresnel, pane as pane_shares};
use radiosity::mesh::Mesh;
use radiosity::obj::{Cause, Warning};
use radiosity::random::Stream;
use radiosity::room::Room;
use radiosity::scene::{Face, Scene};
use radiosity::sky::Sky;
use radiosity::solve::Enclosure;
use radiosity::trace::{Look, PathTracer, Strategy, TwoPass, Whitted};
use radiosity::visibility::Visibility;
use radiosity::ways::{
    Branching, Event, Media, Meeting, Met, Solids, Specular, Ways, ways,
};
use std::f64::consts::PI;

/// Nothing is cut but what is far beyond rounding.
const FAR: Look = Look::following(60, 1e-14);

/// Samples of what is drawn by chance.
const SAMPLES: usize = 2000;

/// What a ray sees, by every tracer: what it is called, the radiance, its standard error.
/// What is cut of the trees is added, as if radiance 1 were found there.
fn seen(scene: &Scene, ray: Ray, look: Look) -> Vec<(&'static str, f64, f64)> {
    let mesh = Mesh::whole(scene);
    let b = mesh.vertex_values(&Enclosure::of(scene, &mesh).emission);
    let trees = [
        ("classical", Whitted::of(&Room::of(scene), look).along(&ray)),
        ("two passes", TwoPass::showing(&Room::of(scene), &mesh, &b, look).along(&ray)),
    ];
    let trees = trees.map(|(name, found)| (name, found.radiance.x + found.cut.x, 1e-9));
    let tracer = PathTracer::of(&Room::of(scene));
    let room = Room::of(scene);
    let walk = || Specular::through(scene, room.visibility(), room.solids());
    let (one, both) = (walk(), walk().branching(Branching::Both(1e-3)));
    let by = |walk: &Specular, random: &mut Stream| {
        let mut sum = 0.0;
        walk.follow((ray, None), random, &mut |arrival| {
            let found = match arrival.met {
                Met::Surface { surface, front: true, .. } => {
                    scene.material(&scene.surfaces[surface as usize]).emission() / PI
                }
                Met::Sky(d) => scene.sky.as_ref().map_or(Rgb::ZERO, |s| s.radiance(d)),
                Met::Cut => Rgb::ONE,
                Met::Surface { .. } => Rgb::ZERO,
            };
            sum += (arrival.weight * found).x;
        });
        sum
    };
    let drawn = [
        ("paths", mean(|random| tracer.radiance(ray, random).x)),
        ("a walk, one branch", mean(|random| by(&one, random))),
        ("a walk, both", mean(|random| by(&both, random))),
    ];
    let drawn = drawn.map(|(name, (mean, error))| (name, mean, error));
    trees.into_iter().chain(drawn).collect()
}

/// Mean and standard error, not below rounding.
fn mean(mut sample: impl FnMut(&mut Stream) -> f64) -> (f64, f64) {
    let mut random = Stream::named(23, &[]);
    let all: Vec<f64> = (0..SAMPLES).map(|_| sample(&mut random)).collect();
    let n = SAMPLES as f64;
    let mean = all.iter().sum::<f64>() / n;
    let spread = all.iter().map(|l| (l - mean).powi(2)).sum::<f64>();
    (mean, (spread / n / (n - 1.0)).sqrt().max(1e-9))
}

/// All tracers see this much.
fn all_see(what: &str, scene: &Scene, ray: Ray, look: Look, right: f64) {
    let found = seen(scene, ray, look).into_iter();
    let found = found.map(|(by, l, error)| (format!("{what}, {by}"), l, error, right));
    by_chance(&found.collect::<Vec<_>>());
}

/// What a stack of layers passes straight on, all reflections between its faces summed:
///
/// ```text
/// (1 − T)/T = Σ Rₖ/(1 − Rₖ)        Rₖ = ((n − n')/(n + n'))²
/// ```
/// (Stokes 1862: of each polarisation, and at normal incidence they are one.)
fn passed(indices: &[f64]) -> f64 {
    let faces = indices.windows(2).map(|n| ((n[0] - n[1]) / (n[0] + n[1])).powi(2));
    1.0 / (1.0 + faces.map(|r| r / (1.0 - r)).sum::<f64>())
}

fn house(name: &str) -> Scene {
    let file = format!("{}/tests/data/house/{name}.obj", env!("CARGO_MANIFEST_DIR"));
    let (mut scene, warnings) = radiosity::obj::load(file).unwrap();
    let closed =
        |w: &Warning| !matches!(w.cause, Cause::Open { .. } | Cause::InsideOut { .. });
    assert!(warnings.iter().all(closed), "{warnings:?}");
    scene.sky = Some(Sky::uniform(Rgb::ONE, dvec3(0.0, 1.0, 1.0).normalize()));
    scene
}

/// The same scene turned and scaled, its sky with it.
fn turned(scene: &Scene, by: DMat3) -> Scene {
    let outline = |f: &Face| f.outline.iter().map(|&v| by * v).collect();
    let faces = scene.faces.iter();
    let faces = faces.map(|f| Face { outline: outline(f), material: f.material });
    let materials = scene.materials.clone();
    let (mut all, _) =
        Scene::assemble("turned", materials, faces.collect(), None).unwrap();
    let up = (by * dvec3(0.0, 1.0, 1.0)).normalize();
    all.sky = Some(Sky::uniform(Rgb::ONE, up));
    all
}

/// The same scene, its faces in another order.
fn reordered(scene: &Scene, order: impl Iterator<Item = usize>) -> Scene {
    let faces = order.map(|k| scene.faces[k].clone()).collect();
    let materials = scene.materials.clone();
    let (mut all, _) = Scene::assemble("reordered", materials, faces, None).unwrap();
    all.sky = scene.sky.clone();
    all
}

/// Two boxes that overlap, one in the other, and apart, under half a sky of radiance 1: what
/// is seen through them, straight on, is what their layers pass; the overlap is water, which
/// stands later in the file. So it is turned, at any scale, and from the other side.
#[test]
fn boxes_pass_what_their_layers_pass() {
    const GLASS: f64 = 1.5;
    const WATER: f64 = 1.33;
    let turn = DMat3::from_axis_angle(dvec3(0.3, -0.5, 0.8).normalize(), 1.1);
    for (name, layers) in [
        ("over", &[1.0, GLASS, WATER, 1.0][..]),
        ("nest", &[1.0, GLASS, WATER, GLASS, 1.0]),
        ("apart", &[1.0, GLASS, 1.0, WATER, 1.0]),
    ] {
        let scene = house(name);
        let right = passed(layers);
        assert!(right < 1.0);
        for by in
            [DMat3::IDENTITY, turn, 1e-3 * turn, 1e3 * turn, 1e3 * DMat3::IDENTITY]
        {
            let scene = turned(&scene, by);
            let origin = by * dvec3(0.3, 0.2, -3.0);
            let ray = Ray { origin, direction: (by * DVec3::Z).normalize() };
            all_see(name, &scene, ray, FAR, right);
        }
        // Whoever looks the other way sees the dark half, past what the boxes mirror.
        let down = Ray { origin: dvec3(0.3, 0.2, 9.0), direction: DVec3::NEG_Z };
        all_see(&format!("{name}, mirrored"), &scene, down, FAR, 1.0 - right);
    }
    // With glass later in the file, glass holds the overlap.
    let scene = reordered(&house("over"), (6..12).chain(0..6));
    let right = passed(&[1.0, GLASS, WATER, 1.0]);
    let ray = Ray { origin: dvec3(0.3, 0.2, -3.0), direction: DVec3::Z };
    all_see("glass later", &scene, ray, FAR, right);
}

/// A box about a point, fronts outwards.
fn block(at: DVec3, size: DVec3) -> Vec<Polygon> {
    let wall = |p: &Polygon| moved(&p.flipped(), |v| v + at - 0.5 * size);
    box_walls(size.to_array()).iter().map(wall).collect()
}

fn cube(at: DVec3, size: f64) -> Vec<Polygon> {
    block(at, DVec3::splat(size))
}

fn of(faces: Vec<Polygon>, material: Coefficients) -> Vec<(Polygon, Coefficients)> {
    faces.into_iter().map(|p| (p, material)).collect()
}

/// Solids in every relation.
fn arrangements() -> Vec<(&'static str, Vec<(Polygon, Coefficients)>)> {
    let o = DVec3::ZERO;
    let tilted = |faces: Vec<Polygon>| -> Vec<Polygon> {
        let turn = DMat3::from_axis_angle(dvec3(1.0, 2.0, -1.0).normalize(), 0.7);
        faces.iter().map(|p| moved(p, |v| turn * v + dvec3(0.2, 0.1, 0.3))).collect()
    };
    let inwards = |faces: Vec<Polygon>| -> Vec<Polygon> {
        faces.iter().map(Polygon::flipped).collect()
    };
    let plate = rectangle(dvec3(-0.6, -0.6, 0.1), 1.2 * DVec3::X, 1.2 * DVec3::Y);
    let mut open = cube(o, 1.6);
    open.pop();
    let overlapping = [
        of(cube(o, 1.6), glass(1.5)),
        of(tilted(cube(o, 1.6)), glass(1.33)),
        of(cube(dvec3(-0.5, 0.4, 0.2), 1.2), glass(2.4)),
    ];
    let flush = [
        of(cube(o, 1.0), glass(1.5)),
        of(cube(dvec3(0.4, 0.0, 0.0), 1.0), glass(1.33)),
    ];
    let joined =
        [of(cube(o, 1.0), glass(1.5)), of(cube(dvec3(0.5, 0.4, 0.3), 1.0), glass(1.5))];
    let touching = [
        of(block(o, dvec3(1.0, 1.0, 1.0)), glass(1.5)),
        of(block(dvec3(0.0, 0.0, 0.75), dvec3(1.0, 1.0, 0.5)), glass(1.33)),
        of(block(dvec3(0.0, 1.0, 0.25), dvec3(1.5, 1.0, 0.8)), glass(1.5)),
    ];
    let nested = [
        of(sphere(o, 1.2, 6), glass(1.5)),
        of(cube(o, 1.0), glass(1.33)),
        of(tilted(cube(o, 0.5)), glass(1.0 / 1.5)),
    ];
    vec![
        ("overlapping", overlapping.concat()),
        ("with flush sides", flush.concat()),
        ("of one index", joined.concat()),
        ("touching", touching.concat()),
        ("nested", nested.concat()),
        (
            "hollow, and filled",
            [
                of(cube(o, 1.6), glass(1.5)),
                of(inwards(cube(o, 1.0)), glass(1.5)),
                of(cube(dvec3(0.0, 0.0, -0.25), 1.0), glass(1.33)),
            ]
            .concat(),
        ),
        (
            "with a pane within",
            [of(cube(o, 1.6), glass(1.33)), vec![(plate, pane())]].concat(),
        ),
        ("inside out", of(inwards(cube(o, 1.2)), glass(1.5))),
        ("open", of(open, glass(1.5))),
    ]
}

/// In a room that glows with radiance 1 no solid is to be seen: every tracer finds 1, or
/// light would be made or lost.
#[test]
fn no_tracer_makes_light_or_loses_it() {
    let mut random = Stream::named(5, &[]);
    let mut point = || dvec3(random.next(), random.next(), random.next()) - 0.5;
    for (what, solids) in arrangements() {
        let scene = shiny(glow().chain(solids));
        for _ in 0..4 {
            let origin = 2.5 * point().normalize();
            let direction = (1.2 * point() - origin).normalize();
            let look = Look::following(30, 1e-3);
            all_see(what, &scene, Ray { origin, direction }, look, 1.0);
        }
    }
}

/// A ray that begins in glass, in water or where both overlap knows that: radiance there is
/// n² times that outside, in the index of the solid that holds the place.
#[test]
fn a_ray_knows_where_it_begins() {
    let indices: Vec<(DVec3, f64)> = vec![
        (dvec3(0.3, 0.2, 0.3), 1.5),
        (dvec3(0.3, 0.2, 0.7), 1.33),
        (dvec3(0.3, 0.2, 1.3), 1.33),
        (dvec3(0.3, 0.2, 1.7), 1.0),
    ];
    let flat = |at: f64, high: f64| block(dvec3(0.0, 0.0, at), dvec3(3.0, 3.0, high));
    let scene = shiny(
        glow()
            .chain(of(flat(0.5, 1.0), glass(1.5)))
            .chain(of(flat(1.0, 1.0), glass(1.33))),
    );
    for (origin, n) in indices {
        for direction in [DVec3::Z, DVec3::NEG_Z, dvec3(0.5, -0.3, 0.2).normalize()] {
            let look = Look::following(40, 1e-4);
            let found = seen(&scene, Ray { origin, direction }, look).into_iter();
            // What a tree has cut counts radiance 1 here, not n²: it is left out.
            let right = n * n;
            let drawn = found.skip(2).map(|(by, l, e)| (by, l, e * right, right));
            by_chance(&drawn.collect::<Vec<_>>());
            let whitted =
                Whitted::of(&Room::of(&scene), look).along(&Ray { origin, direction });
            let all = whitted.radiance.x + right * whitted.cut.x;
            assert!((all - right).abs() < 1e-9, "{origin}: {all}, not {right}");
        }
    }
}

/// A floor under water gets n² π in a room that glows with radiance 1; of a lamp under water
/// with it, it gets what it gets in air, however the lamp is looked for, also where a body
/// that the water holds stands between.
#[test]
fn floors_under_water() {
    let (n, x) = (1.33, dvec3(0.1, 0.2, 0.1));
    let floor = rectangle(dvec3(-1.0, -1.0, 0.1), 2.0 * DVec3::X, 2.0 * DVec3::Y);
    let lamp = rectangle(dvec3(-0.4, -0.4, 0.9), 0.8 * DVec3::Y, 0.8 * DVec3::X);
    let water = of(block(dvec3(0.0, 0.0, 0.5), dvec3(4.0, 4.0, 1.0)), glass(n));
    let drowned = of(block(dvec3(0.0, 0.0, 0.5), dvec3(1.0, 1.0, 0.3)), glass(1.6));
    // So small that it does not see itself in the water's faces.
    let spot = rectangle(x, 1e-4 * DVec3::X, 1e-4 * DVec3::Y);
    // A ball: no ray is caught in it for ever.
    let ball = of(sphere(DVec3::ZERO, 1.2, 6), glass(n));
    let glowing = shiny(glow().chain([(spot, dull(0.0, 0.0))]).chain(ball));
    let h = PathTracer::of(&Room::of(&glowing)).irradiance(6, x, 20_000, 3);
    by_chance(&[("a glow", h.mean.x, h.error.x.max(1e-9), n * n * PI)]);
    let lit = [(floor, dull(0.0, 0.0)), (lamp, dull(PI, 0.0))];
    let dry =
        PathTracer::of(&Room::of(&shiny(lit.clone()))).irradiance(0, x, 50_000, 3);
    let all = drowned.into_iter().chain(water);
    let scene = shiny(lit.into_iter().chain(all));
    // Water reflects some of the lamp's light back: that is beyond the lamp's own.
    let found = [Strategy::Lamps, Strategy::Lobes, Strategy::Both].map(|strategy| {
        let tracer = PathTracer::of(&Room::of(&scene)).by(strategy);
        (strategy, tracer.irradiance(0, x, 20_000, 4))
    });
    let by = |k: usize| (found[k].1.mean.x, found[k].1.error.x);
    let both = by(2);
    let compared = [0, 1].map(|k| {
        let (mean, error) = by(k);
        (format!("{:?}", found[k].0), mean, error.hypot(both.1), both.0)
    });
    by_chance(&compared);
    assert!(both.0 > dry.mean.x - 4.0 * dry.error.x, "{} {}", both.0, dry.mean.x);
}

/// What can happen to a ray at the first surface that it meets.
fn met(scene: &Scene, ray: Ray) -> Ways {
    let solids = Solids::of(scene);
    let visibility = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
    let hit = visibility.closest(&ray, None).expect("something is met");
    let met = Meeting::of(scene, &solids, &ray, &hit);
    ways(&met, &mut Media::default())
}

/// Between equal indices nothing is reflected, at any angle; beyond the critical angle
/// everything; at grazing incidence nearly everything; a pane in glass is one between glass
/// and glass.
#[test]
fn ways_at_single_faces() {
    let aslant = |cosine: f64| dvec3((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
    let to = |target: DVec3, cosine: f64, far: f64| {
        let direction = aslant(cosine);
        Ray { origin: target - far * direction, direction }
    };
    let slab = |low: f64, high: f64| {
        block(dvec3(0.0, 0.0, 0.5 * (low + high)), dvec3(9.0, 9.0, high - low))
    };
    let two = |n: f64, m: f64| {
        shiny(
            of(slab(0.0, 1.0), glass(n))
                .into_iter()
                .chain(of(slab(0.5, 2.0), glass(m))),
        )
    };
    let inner = dvec3(0.3, 0.2, 0.5);
    for cosine in [1.0, 0.5, 1e-3] {
        let found = met(&two(1.5, 1.5), to(inner, cosine, 0.4));
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!((found[0].share, found[0].denser), (Rgb::ONE, 1.0));
        assert_eq!(found[0].event, Event::Passed);
        // From dense to dense: by the ratio of both.
        let found = met(&two(1.5, 1.2), to(inner, cosine, 0.4));
        let r = fresnel(cosine, 1.5 / 1.2).mean();
        let total: Rgb = found.iter().map(|way| way.share).sum();
        assert!((total - Rgb::ONE).abs().max_element() < 1e-15);
        assert!((found[0].share.x - r).abs() < 1e-15, "{cosine}: {found:?} {r}");
        let critical = (1.0 - (1.2_f64 / 1.5).powi(2)).sqrt();
        assert_eq!(found.len(), if cosine < critical { 1 } else { 2 });
        // A face that is no boundary of what holds both its sides: straight on.
        let found = met(&two(1.5, 1.2), to(dvec3(0.3, 0.2, 1.0), cosine, 0.2));
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].event, found[0].share), (Event::Passed, Rgb::ONE));
        // A pane under water.
        let sheet = rectangle(dvec3(-9.0, -9.0, 0.5), 18.0 * DVec3::X, 18.0 * DVec3::Y);
        let water = of(slab(0.0, 1.0), glass(1.33));
        let scene = shiny(water.into_iter().chain([(sheet, pane())]));
        let found = met(&scene, to(inner, cosine, 0.4));
        let (r, t) = pane_shares(cosine, 1.5 / 1.33);
        assert_eq!(found.len(), 2);
        assert!(
            (found[0].share.x - r).abs() < 1e-15
                && (found[1].share.x - t).abs() < 1e-15
        );
    }
    let grazing = met(&two(1.5, 1.2), to(DVec3::ZERO, 1e-6, 4.0));
    assert!(
        grazing[0].share.x > 1.0 - 1e-4 && grazing[0].share.x <= 1.0,
        "{grazing:?}"
    );
}
