//! Faces that lie exactly in each other give the light that they give when the one in front
//! is moved by a hair: every pair of kinds, every way to overlap, by every method.
//!
//! Between a floor and a ceiling that both shine and scatter, under an even sky, lie two
//! faces in one plane. What falls on the floor and on the ceiling is held against the scene
//! in which the two are a hair apart. A hair lets as much light by at the edges as it is
//! wide: less than 1e-4.

use crate::common::paths::{by_chance, dull, mirror, pane, shine, shiny, z};
use crate::common::rooms::{moved, rectangle};
use glam::{DVec3, dvec3};
use radiosity::field::{Gathered, Smooth, gather_unbiased};
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::material::optics::pane as pane_shares;
use radiosity::material::{Coefficients, Material, Shine};
use radiosity::mesh::Mesh;
use radiosity::room::{Direct, Room};
use radiosity::scene::{Face, FaceId, MaterialId, Scene};
use radiosity::sky::Sky;
use radiosity::solution::{Goal, solve};
use radiosity::trace::{Look, PathTracer, Strategy, Whitted};
use radiosity::work::Work;
use std::f64::consts::PI;

/// A millionth of the scene, whose edges are 1 and whose diagonal is 2.2.
const HAIR: f64 = 1e-6;

/// What may pass beside a hair, relative.
const LEAK: f64 = 1e-4;

/// All kinds of faces: their names, and whether they let light through.
fn kinds() -> [(&'static str, Coefficients, bool); 7] {
    let sheet = Coefficients { translucence: Rgb::splat(0.5), ..dull(0.0, 0.3) };
    let gloss = Shine::Gloss { reflectance: Rgb::splat(0.6), exponent: 20.0 };
    [
        ("diffuse", dull(0.0, 0.7), false),
        ("lamp", dull(2.0 * PI, 0.2), false),
        ("mirror", mirror(0.9), false),
        ("pane", pane(), true),
        ("sheet", sheet, true),
        ("glossy", shine(gloss), false),
        ("black", dull(0.0, 0.0), false),
    ]
}

/// How two squares in one plane overlap: the second's corner and size; the first is the
/// unit square.
const OVERLAPS: [(&str, f64, f64); 3] =
    [("identical", 0.0, 1.0), ("inside", 0.2, 0.5), ("partly", 0.4, 1.0)];

/// Two faces in one plane, in the order of the file: what they are, how large, and whether
/// they look down.
struct Pair {
    name: String,
    kinds: [usize; 2],
    outlines: [Polygon; 2],
}

/// All pairs, in both orders, looking the same way and opposite ways.
fn pairs() -> Vec<Pair> {
    let square = |at: f64, size: f64, down: bool| {
        let upward = rectangle(dvec3(at, 1.0, at), size * DVec3::Z, size * DVec3::X);
        if down { upward.flipped() } else { upward }
    };
    let mut all = Vec::new();
    for code in 0..7 * 7 * 3 * 2 * 2 {
        let [first, second, overlap] = [code % 7, code / 7 % 7, code / 49 % 3];
        let [down, alike] = [code / 147 % 2, code / 294].map(|bit| bit == 1);
        let (how, at, size) = OVERLAPS[overlap];
        let [a, b] = [first, second].map(|k| kinds()[k].0);
        let way = if alike { "alike" } else { "opposite" };
        all.push(Pair {
            name: format!("{a} {b} {how} {way}"),
            kinds: [first, second],
            outlines: [square(0.0, 1.0, down), square(at, size, down == alike)],
        });
    }
    all
}

/// The floor, the ceiling and a pair between them, moved by these.
fn scene(pair: &Pair, by: [DVec3; 2]) -> Scene {
    let floor = rectangle(dvec3(0.0, 0.0, 0.0), DVec3::Z, DVec3::X);
    let ceiling = moved(&floor, |v| v + 1.7 * DVec3::Y).flipped();
    let of_pair = pair.kinds.map(|k| kinds()[k].1);
    let coefficients = [dull(PI, 0.5), dull(2.0, 0.3), of_pair[0], of_pair[1]];
    let [a, b] = [0, 1].map(|k| moved(&pair.outlines[k], |v| v + by[k]));
    let (mut materials, mut faces) = (Vec::new(), Vec::new());
    for (k, outline) in (0u32..).zip([floor, ceiling, a, b]) {
        let of = coefficients[k as usize];
        materials.push(Material::new(format!("{k}"), of).unwrap());
        faces.push(Face {
            outline: outline.vertices().to_vec(),
            material: MaterialId(k),
        });
    }
    let (scene, _) = Scene::assemble("pair", materials, faces, None).unwrap();
    Scene { sky: Some(Sky::uniform(Rgb::splat(0.5), DVec3::Y)), ..scene }
}

/// By how much the two are to be moved so that they act as they should: what lets light
/// through stands before the other; of two that do, or that look the same way, the smaller,
/// or else the earlier; opaque ones that look opposite ways stand back to back.
fn apart(pair: &Pair) -> [DVec3; 2] {
    let normal = pair.outlines.each_ref().map(|p| HAIR * p.normal());
    let passes = pair.kinds.map(|k| kinds()[k].2);
    let second_is_smaller = pair.outlines[1].area() < 0.9 * pair.outlines[0].area();
    let alike = normal[0].dot(normal[1]) > 0.0;
    match (passes, alike) {
        ([true, false], _) => [normal[1], DVec3::ZERO],
        ([false, true], _) => [DVec3::ZERO, normal[0]],
        ([false, false], false) => [0.5 * normal[0], 0.5 * normal[1]],
        _ if second_is_smaller => [DVec3::ZERO, normal[0]],
        _ => [normal[1], DVec3::ZERO],
    }
}

/// The scene as it is, and with the two a hair apart.
fn both(pair: &Pair) -> [Scene; 2] {
    [[DVec3::ZERO; 2], apart(pair)].map(|by| scene(pair, by))
}

/// A number for each pair that lets all kinds meet, however few of them are taken.
fn every(n: usize) -> impl Iterator<Item = Pair> {
    let spread = move |(k, _): &(usize, Pair)| k * 193 % n == 0;
    pairs().into_iter().enumerate().filter(spread).map(|(_, pair)| pair)
}

/// Rays that meet the pair from below and from above, by way of where its faces are alone
/// and where both are: deterministic, equal to what passes beside a hair. Where the eye
/// sees stored or scattered light there is none to see in black; emission, mirrors and
/// panes are what is compared.
#[test]
fn classical_rays_see_coincident_faces_as_if_a_hair_apart() {
    for pair in pairs() {
        let scenes = both(&pair);
        let rooms = scenes.each_ref().map(Room::of);
        let eyes = rooms
            .each_ref()
            .map(|room| Whitted::of(room, Look { gloss: 0, ..Look::default() }));
        for at in [dvec3(0.11, 1.0, 0.13), dvec3(0.55, 1.0, 0.51), dvec3(1.2, 1.0, 1.1)]
        {
            for from in [dvec3(0.4, 0.3, 0.6), dvec3(0.6, 1.6, 0.3)] {
                let direction = (at - from).normalize();
                let ray = Ray { origin: from, direction };
                let seen = eyes.each_ref().map(|eye| eye.along(&ray).radiance.x);
                let off = (seen[0] - seen[1]).abs();
                assert!(
                    off <= LEAK * seen[1].max(1.0),
                    "{} at {at}: {seen:?}",
                    pair.name
                );
            }
        }
    }
}

/// Both scenes by paths, at points of the floor and of the ceiling.
#[test]
fn paths_find_coincident_faces_as_if_a_hair_apart() {
    let mut found = Vec::new();
    for pair in pairs() {
        let scenes = both(&pair);
        let rooms = scenes.each_ref().map(Room::of);
        let tracers = rooms.each_ref().map(PathTracer::of);
        for (surface, x) in [(0, dvec3(0.5, 0.0, 0.4)), (1, dvec3(0.6, 1.7, 0.5))] {
            let [got, right] = [0, 1].map(|k| {
                let seed = u64::from(surface) + 2 * k as u64;
                tracers[k].irradiance(surface, x, 1000, seed)
            });
            let error = got.error.x.hypot(right.error.x) + LEAK * right.mean.x;
            found.push((pair.name.clone(), got.mean.x, error, right.mean.x));
        }
        let powers = [0, 1].map(|k| fallen_on_the_pair(&tracers[k], &scenes[k]));
        for (got, right) in powers[0].iter().zip(&powers[1]) {
            let error = got.1.hypot(right.1) + LEAK * right.0.max(1.0);
            found.push((format!("on {}", pair.name), got.0, error, right.0));
        }
    }
    by_chance(&found);
    let off = far_off(&found);
    assert!(off < 30, "{off} of {} lie beyond 3 standard errors", found.len());
}

/// What falls on the two faces, W, and its standard error: what is covered gets nothing.
fn fallen_on_the_pair(tracer: &PathTracer, scene: &Scene) -> [(f64, f64); 2] {
    let areas = scene.face_areas();
    [FaceId(2), FaceId(3)].map(|face| match areas[face] {
        0.0 => (0.0, 0.0),
        area => {
            let found = tracer.face_irradiance(face, 1000, face.0.into());
            (area * found.mean.x, area * found.error.x)
        }
    })
}

/// How many of these lie beyond 3 standard errors: one in 370 by chance.
fn far_off(found: &[(String, f64, f64, f64)]) -> usize {
    let off = |f: &&(String, f64, f64, f64)| z(f.1, f.2, f.3) > 3.0;
    found.iter().filter(off).count()
}

/// Both scenes by unbiased gathering, on the whole floor and the whole ceiling.
#[test]
fn walks_find_coincident_faces_as_if_a_hair_apart() {
    let mut found = Vec::new();
    for pair in every(2) {
        let [got, right]: [Vec<Gathered>; 2] = [0, 1].map(|k| {
            let scene = &both(&pair)[k];
            gather_unbiased(&Room::of(scene), &Mesh::whole(scene), 300, k as u64)
        });
        for (got, right) in got.iter().zip(&right).take(2) {
            let (mean, doubt) = (right.irradiance.x, got.error.x.hypot(right.error.x));
            let error = doubt + LEAK * mean;
            found.push((pair.name.clone(), got.irradiance.x, error, mean));
        }
    }
    by_chance(&found);
}

/// Both scenes by pass 1: two certified fields of one light are no farther apart than the
/// sum of their errors, in the norm that is certified. So are their means on one surface,
/// which is a part of the norm.
#[test]
fn pass_1_finds_coincident_faces_as_if_a_hair_apart() {
    for pair in every(12) {
        let scenes = both(&pair);
        let solved = scenes.each_ref().map(|scene| {
            let goal = Goal::within(0.1);
            solve(&Room::of(scene), &Smooth, &goal, &Work::quiet()).unwrap()
        });
        let [got, right] = solved.each_ref().map(|solution| {
            let mesh = &solution.field.mesh;
            let mut sums = [(0.0, 0.0); 2];
            let mut reflected = 0.0;
            for (k, element) in mesh.elements.iter().enumerate() {
                let surface = mesh.surface_of(element) as usize;
                let scene = &scenes[0];
                let area = element.polygon.area();
                let emission = mesh.material(scene, element).emission();
                reflected += area * (solution.radiosity[k] - emission).x.powi(2);
                if let Some((power, of)) = sums.get_mut(surface) {
                    *power += area * solution.irradiance[k].x;
                    *of += area;
                }
            }
            (sums.map(|(power, area)| power / area), reflected.sqrt())
        });
        let most = solved.iter().map(|s| s.certificate.high).sum::<f64>();
        for (surface, rho) in [(0, 0.5), (1, 0.3)] {
            let off = rho * (got.0[surface] - right.0[surface]).abs();
            let norm = right.1.max(got.1);
            assert!(
                off <= most * norm,
                "{} on {surface}: {got:?} and {right:?}, {most}",
                pair.name
            );
        }
        assert!(solved.iter().all(|s| s.converged), "{}", pair.name);
    }
}

/// A lamp sees itself in the pane a hair before it: all over it `H = E ∫ 2 R(θ) cosθ sinθ dθ`,
/// though all its corners are seen there at the horizon, where `R` is 1.
#[test]
fn a_lamp_behind_a_pane_sees_as_much_of_itself_as_the_pane_reflects() {
    let lamp = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let before = moved(&lamp, |v| v + HAIR * lamp.normal());
    let (mut materials, mut faces) = (Vec::new(), Vec::new());
    for (k, (outline, of)) in (0u32..).zip([(lamp, dull(PI, 0.0)), (before, pane())]) {
        materials.push(Material::new(format!("{k}"), of).unwrap());
        let outline = outline.vertices().to_vec();
        faces.push(Face { outline, material: MaterialId(k) });
    }
    let (scene, _) = Scene::assemble("lamp", materials, faces, None).unwrap();
    let n = 100_000;
    let share = |k: usize| {
        let sine_squared = (k as f64 + 0.5) / n as f64;
        pane_shares((1.0 - sine_squared).sqrt(), 1.5).0
    };
    let right = PI * (0..n).map(share).sum::<f64>() / n as f64;
    let (whole, direct) = (&scene.surfaces[0].polygon, Direct::of(&scene));
    let light = direct.on(whole);
    for at in [[0.5, 0.5], [0.2, 0.9], [1e-3, 0.4], [0.999, 0.999]] {
        let found = light.irradiance(dvec3(at[0], at[1], 0.0)).x;
        // Over a piece the share is taken as even to 2e-3.
        assert!((found - right).abs() < 2e-3 * PI, "{found} at {at:?}, not {right}");
    }
}

/// Between the floor and a lamp lies a pane on the floor: also rays that start on the floor
/// meet it, and each method finds `∫ T(θ) cosθ cosθ'/r² dA`.
#[test]
fn rays_that_start_on_a_floor_meet_the_pane_on_it() {
    let ground = rectangle(dvec3(-1.0, -1.0, 0.0), 2.0 * DVec3::X, 2.0 * DVec3::Y);
    let lamp = rectangle(dvec3(-0.5, -0.5, 1.0), DVec3::Y, DVec3::X);
    let n = 400;
    let cell = |k: usize| {
        let at = |k: usize| (k as f64 + 0.5) / n as f64 - 0.5;
        let cosine = 1.0 / dvec3(at(k % n), at(k / n), 1.0).length();
        pane_shares(cosine, 1.5).1 * cosine.powi(4) / (n * n) as f64
    };
    let right: f64 = (0..n * n).map(cell).sum();
    let mut found = Vec::new();
    for glass in [ground.clone(), ground.flipped()] {
        let faces = [(ground.clone(), dull(0.0, 0.0)), (glass, pane())];
        let lamp = (lamp.clone(), dull(PI, 0.0));
        let scene = shiny(faces.into_iter().chain([lamp]));
        let room = Room::of(&scene);
        let exact = room.lamps().on(&scene.surfaces[0].polygon).irradiance(DVec3::ZERO);
        assert!((exact.x / right - 1.0).abs() < LEAK, "{} {right}", exact.x);
        for strategy in [Strategy::Lamps, Strategy::Lobes, Strategy::Both] {
            let tracer = PathTracer::of(&room).by(strategy);
            let paths = tracer.irradiance(0, DVec3::ZERO, 50_000, 4);
            found.push((format!("{strategy:?}"), paths.mean.x, paths.error.x, right));
        }
    }
    by_chance(&found);
}

/// In the opening of a black room lie two faces that let light through, or one: in whatever
/// order, what falls on the floor is what it is when one of them is a millimetre lower.
#[test]
fn faces_that_let_light_through_lie_in_a_window_together() {
    let floor = rectangle(DVec3::ZERO, DVec3::Z, DVec3::X);
    let lid = moved(&floor, |v| v + DVec3::Y);
    let walls = floor.edges().map(|(a, b)| {
        let outline = vec![b, a, a + DVec3::Y, b + DVec3::Y];
        (Polygon::new(outline).unwrap(), dull(0.0, 0.0))
    });
    let walls: Vec<_> = walls.collect();
    let room = |panes: Vec<(Polygon, Coefficients)>| {
        let floor = [(floor.clone(), dull(0.0, 0.5))];
        let faces = floor.into_iter().chain(walls.clone()).chain(panes);
        Scene { sky: Some(Sky::uniform(Rgb::ONE, DVec3::Y)), ..shiny(faces) }
    };
    let [clear, paper] = [kinds()[3].1, kinds()[4].1];
    let mut found = Vec::new();
    for (name, above, below) in [
        ("panes", clear, clear),
        ("paper below", clear, paper),
        ("pane below", paper, clear),
    ] {
        let lower = moved(&lid, |v| v - 1e-3 * DVec3::Y);
        let right = room(vec![(lid.clone(), above), (lower, below)]);
        let right = PathTracer::of(&Room::of(&right)).irradiance(0, MIDDLE, 20_000, 1);
        // The earlier stands before the front of the later.
        for (down, faces) in [(true, [below, above]), (false, [above, below])] {
            let outline = if down { lid.flipped() } else { lid.clone() };
            for first in [outline.clone(), outline.flipped()] {
                let [a, b] = faces;
                let scene = room(vec![(first, a), (outline.clone(), b)]);
                let room = Room::of(&scene);
                let paths = PathTracer::of(&room).irradiance(0, MIDDLE, 20_000, 2);
                let error = paths.error.x.hypot(right.error.x) + 1e-3 * right.mean.x;
                found.push((
                    format!("{name} {down}"),
                    paths.mean.x,
                    error,
                    right.mean.x,
                ));
            }
        }
    }
    by_chance(&found);
}

const MIDDLE: DVec3 = dvec3(0.5, 0.0, 0.5);
