//! Many lamps: tiles of one are one lamp; of hundreds some are asked by chance, and the
//! light is right on average. Nothing changes at any number.

use glam::{DVec3, dvec3};
use radiosity::field::Smooth;
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::material::{Coefficients, Material};
use radiosity::random::Stream;
use radiosity::room::Room;
use radiosity::scene::{Face, MaterialId, Scene};
use radiosity::solution::{Goal, Solution, solve};
use radiosity::trace::{Look, PathTracer, TwoPass, Whitted};
use radiosity::work::Work;
use std::f64::consts::PI;

fn solved(room: &Room, tolerance: f64) -> Solution {
    solve(room, &Smooth, &Goal::within(tolerance), &Work::quiet()).unwrap()
}

fn in_tiles(name: &str) -> Scene {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/light");
    radiosity::obj::load(format!("{folder}/{name}.obj")).expect(name).0
}

/// Straight down at a point of a floor, from a hair above it.
fn down_at(x: DVec3) -> Ray {
    Ray { origin: x + 0.01 * DVec3::Y, direction: DVec3::NEG_Y }
}

/// One lamp in 32 tiles and in 33: the same picture but for rounding, and pass 1 finds the
/// same light by about the same work.
#[test]
fn a_lamp_in_tiles_is_one_lamp() {
    let scenes = ["l32", "l33"].map(in_tiles);
    let rooms = scenes.each_ref().map(Room::of);
    for room in &rooms {
        assert_eq!(room.lamps().lamps().all().len(), 1);
    }
    let [a, b] = rooms.each_ref().map(|room| Whitted::of(room, Look::default()));
    for k in 0..100 {
        let x = dvec3((k % 10) as f64 / 5.0 - 0.9, 0.0, (k / 10) as f64 / 5.0 - 0.9);
        let [a, b] = [&a, &b].map(|picture| picture.along(&down_at(x)).radiance.x);
        assert!(a > 0.0 && (a / b - 1.0).abs() < 1e-9, "{x}: {a} {b}");
    }
    let [a, b] = rooms.each_ref().map(|room| solved(room, 0.02));
    for found in [&a, &b] {
        assert!(found.converged, "{:?}", found.certificate);
    }
    let power = |found: &Solution| found.field.ledger.absorbed.x;
    assert!((power(&a) / power(&b) - 1.0).abs() < 0.02, "{} {}", power(&a), power(&b));
    let rows = |found: &Solution| found.attempts.iter().map(|a| a.rows).sum::<usize>();
    let elements = |found: &Solution| found.field.mesh.elements.len();
    // Whole tiles are patches: they differ by one.
    assert!(rows(&b) < 2 * rows(&a), "{} {}", rows(&a), rows(&b));
    assert!(elements(&b) < 2 * elements(&a), "{} {}", elements(&a), elements(&b));
}

const HALF: f64 = 2.0;
const CARD: f64 = 0.7;
const RHO: f64 = 0.5;

/// A floor of 4 × 4 under small lamps of all sizes and powers at height 2, and a black card
/// between.
struct Crowd {
    scene: Scene,
    /// Corner, edge and emission.
    lamps: Vec<(DVec3, f64, f64)>,
}

impl Crowd {
    fn of(count: usize) -> Crowd {
        let square = |corner: DVec3, edge: f64| {
            let (u, v) = (edge * DVec3::X, edge * DVec3::Z);
            vec![corner, corner + u, corner + u + v, corner + v] // looks down
        };
        let material = |name: &str, diffuse: f64, emission: f64| {
            let (emission, diffuse) = (Rgb::splat(emission), Rgb::splat(diffuse));
            let all = Coefficients { emission, diffuse, ..Coefficients::default() };
            Material::new(name, all).unwrap()
        };
        let mut materials =
            vec![material("floor", RHO, 0.0), material("card", 0.0, 0.0)];
        let mut floor = square(dvec3(-HALF, 0.0, -HALF), 2.0 * HALF);
        floor.reverse();
        let card = square(dvec3(-CARD, 1.0, -CARD), 2.0 * CARD);
        let face = |outline, k: usize| Face { outline, material: MaterialId(k as u32) };
        let mut faces = vec![face(floor, 0), face(card, 1)];
        let per_edge = (count as f64).sqrt().ceil() as usize;
        let cell = 2.0 * HALF / per_edge as f64;
        let mut random = Stream::named(5, &[]);
        let mut lamps = Vec::new();
        for k in 0..count {
            let edge = cell * (0.1 + 0.6 * random.next());
            let at = |k: usize| -HALF + cell * (k as f64 + 0.1);
            let corner = dvec3(at(k % per_edge), 2.0, at(k / per_edge));
            let emission = 10.0 * random.next().powi(3) + 0.01;
            lamps.push((corner, edge, emission));
            faces.push(face(square(corner, edge), materials.len()));
            materials.push(material(&format!("{k}"), 0.0, emission));
        }
        let (scene, warnings) =
            Scene::assemble("crowd", materials, faces, None).unwrap();
        assert!(warnings.is_empty());
        Crowd { scene, lamps }
    }

    /// `Σ_k E_k ∫ V cos²θ/(π r²) dA` by midpoints, N × N on each lamp: off by a share of the
    /// lamps that the card hides in part.
    fn irradiance(&self, x: DVec3) -> f64 {
        const N: usize = 6;
        let point = |(corner, edge, emission): &(DVec3, f64, f64), k: usize| {
            let at = |k: usize| edge * (k as f64 + 0.5) / N as f64;
            let way = *corner + dvec3(at(k % N), 0.0, at(k / N)) - x;
            let crossing = x + way * ((1.0 - x.y) / way.y);
            let hidden = crossing.x.abs() < CARD && crossing.z.abs() < CARD;
            let area = edge * edge / (N * N) as f64;
            let kernel = way.y * way.y / (PI * way.length_squared().powi(2));
            if hidden { 0.0 } else { emission * area * kernel }
        };
        let lamp = |lamp| (0..N * N).map(|k| point(lamp, k)).sum::<f64>();
        self.lamps.iter().map(lamp).sum()
    }
}

/// Points spread over the floor.
fn places(n: usize) -> Vec<DVec3> {
    let at = |u: f64| HALF * (2.0 * u - 1.0);
    Stream::named(6, &[]).points(n).map(|[u, v]| dvec3(at(u), 0.0, at(v))).collect()
}

/// The mean of what is found over what is right is 1 within 4 standard errors, and the
/// single values differ by no more than `spread`, root mean square.
#[track_caller]
fn is_right(found: impl Fn(DVec3) -> f64, crowd: &Crowd, n: usize, spread: f64) {
    let ratio = |x: DVec3| found(x) / crowd.irradiance(x) - 1.0;
    let off: Vec<f64> = places(n).into_iter().map(ratio).collect();
    let mean = off.iter().sum::<f64>() / n as f64;
    let square = off.iter().map(|o| o * o).sum::<f64>() / n as f64;
    let error = (square / n as f64).sqrt();
    // The midpoints of lamps that are hidden in part are off by less.
    assert!(mean.abs() < 4.0 * error + 1e-3, "{mean} ± {error}");
    assert!(square.sqrt() < spread, "{} more than {spread}", square.sqrt());
}

/// A piece of the floor about a point.
fn piece(x: DVec3) -> Polygon {
    let corner = |u: f64, v: f64| x + 0.05 * dvec3(u, 0.0, v);
    let corners = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
    Polygon::new(corners.map(|(u, v)| corner(u, v)).to_vec()).unwrap()
}

/// Pass 1: 200 lamps are summed; of 900 the weaker ones by chance.
#[test]
fn direct_light_of_many_lamps_is_right() {
    for (count, spread) in [(200, 0.004), (900, 0.02)] {
        let crowd = Crowd::of(count);
        let room = Room::of(&crowd.scene);
        let direct = room.lamps();
        assert_eq!(direct.sums_all_lamps(), count == 200);
        let found = |x: DVec3| direct.on(&piece(x)).irradiance(x).x;
        is_right(found, &crowd, 200, spread);
    }
}

/// The solver is certified under a crowd, and its floor has the light of the crowd.
#[test]
fn pass_1_converges_under_many_lamps() {
    for count in [200, 400] {
        let crowd = Crowd::of(count);
        let room = Room::of(&crowd.scene);
        let found = solved(&room, 0.05);
        assert!(found.converged, "{count}: {:?}", found.certificate);
        let right = places(1000).into_iter().map(|x| crowd.irradiance(x)).sum::<f64>()
            * (4.0 * HALF * HALF / 1000.0);
        let mesh = &found.field.mesh;
        let power = mesh.elements.iter().zip(&found.irradiance);
        let floor = power
            .filter(|(e, _)| mesh.surface_of(e) == 0)
            .map(|(e, h)| e.polygon.area() * h.x)
            .sum::<f64>();
        // Nothing is reflected back to the floor; points at even distances: 1 %.
        assert!((floor / right - 1.0).abs() < 0.06, "{count}: {floor} of {right}");
    }
}

/// The ray-tracer, final gathering and the path tracer ask some at each point.
#[test]
fn pictures_of_many_lamps_are_right() {
    let crowd = Crowd::of(200);
    let room = Room::of(&crowd.scene);
    let whitted = Whitted::of(&room, Look::default());
    let by_rays = |x: DVec3| PI / RHO * whitted.along(&down_at(x)).radiance.x;
    is_right(by_rays, &crowd, 400, 0.1);

    let field = solved(&room, 0.3).field;
    let look = Look { gather: 4, ..Look::default() };
    let second = TwoPass::of(&room, &field, look);
    let gathered = |x: DVec3| PI / RHO * second.along(&down_at(x)).radiance.x;
    is_right(gathered, &crowd, 400, 0.1);

    let paths = PathTracer::of(&room);
    let by_paths = |x: DVec3| {
        let mut random = Stream::named(7, &x.to_array().map(f64::to_bits));
        let mean = |_| paths.radiance(down_at(x), &mut random).x / 256.0;
        PI / RHO * (0..256).map(mean).sum::<f64>()
    };
    is_right(by_paths, &crowd, 200, 0.3);
}
