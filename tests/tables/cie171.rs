//! Test cases in the style of CIE 171:2006 (those without a sky), recomputed exactly.
//!
//! | case | source            | here                                                  |
//! |------|-------------------|-------------------------------------------------------|
//! | 5.2  | point, I₀ cosθ    | a tiny Lambertian square; the error falls as its area |
//! | 5.3  | square lamp       | as it is                                              |
//! | 5.4  | point, isotropic  | no polygon shines so: solid angles instead of factors |
//! | 5.6  | diffuse floor     | as it is                                              |
//! | 5.7  | the same, blocked | as it is                                              |
//! | 5.8  | point, isotropic  | its first reflection emits; the mean is compared      |
//!
//! A Lambertian polygon sends `L A cosθ`. A small cube of six sends in proportion to
//! `|x| + |y| + |z|`, from 1 to √3: no set of flat lamps is isotropic. (A ball of many
//! faces is, nearly; nothing is tested by it that is not tested here.)

use crate::common::rooms::{box_walls, exact_factors, gathered, rectangle, scene};
use crate::common::{cases, point, polygon, within};
use glam::{DVec3, dvec3};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::Mesh;
use radiosity::radiometry::solid_angle;
use radiosity::room::Direct;
use radiosity::scene::Scene;
use radiosity::solve::Enclosure;
use serde_json::Value;
use std::f64::consts::PI;

/// The case of the table that is called so.
fn case(id: &str) -> Value {
    let found = cases("E_cie171").into_iter().find(|case| case["id"] == id);
    found.unwrap_or_else(|| panic!("no case {id}"))
}

/// A square of this side in the plane `z`, about `(x, y)`, that looks up or down.
fn square(side: f64, middle: DVec3, up: bool) -> Polygon {
    let corner = middle - dvec3(side / 2.0, side / 2.0, 0.0);
    let square = rectangle(corner, DVec3::X * side, DVec3::Y * side);
    if up { square } else { square.flipped() }
}

/// The room of the cases, 4 × 4 × 3, with black walls: x = 0, x = 4, y = 0, y = 4,
/// floor, ceiling.
fn walls() -> impl Iterator<Item = (Polygon, f64, f64)> {
    box_walls([4.0, 4.0, 3.0]).into_iter().map(|wall| (wall, 0.0, 0.0))
}

/// Holds the irradiance at each of the case's points, in the unit of `key`, against the
/// table. A point lies on the face of `scene` whose plane it is in.
fn meets(case: &Value, scene: &Scene, key: &str, unit: f64, gate: f64) {
    let direct = Direct::of(scene);
    let places = case["params"]["points"].as_object().unwrap();
    let expected = case["expected"][key].as_object().unwrap();
    assert_eq!(places.len(), expected.len());
    for (name, place) in places {
        let x = point(place);
        let on = |p: &&Polygon| p.contains(x, 1e-9) && p.plane().height(x).abs() < 1e-9;
        let mut faces = scene.surfaces.iter().map(|s| &s.polygon).filter(on);
        let face = faces.next().unwrap_or_else(|| panic!("{name} lies on no face"));
        let got = direct.on(face).irradiance(x).x / unit;
        let expected = expected[name].as_f64().unwrap();
        let own = case["expected"]["uncertainty_abs"].as_f64();
        let own = own.or(case["uncertainty_abs"].as_f64()).unwrap();
        assert!(within(got, expected, gate, own), "{name}: {got}, not {expected}");
    }
}

/// 5.3: a square metre of 1000 cd/m² in the ceiling; it is cut out of the ceiling
/// itself.
#[test]
fn an_area_source_lights_walls_and_floor() {
    let case = case("E-5.3-area-source");
    let lamp = square(1.0, dvec3(2.0, 2.0, 3.0), false);
    let room = scene(walls().chain([(lamp, PI * 1000.0, 0.0)]));
    meets(&case, &room, "E_lux", 1.0, 1e-12);
}

/// 5.6: a diffuse floor lights wall and ceiling, in per cent of what it sends.
#[test]
fn a_diffuse_reflector_lights_the_room() {
    for (id, side) in [("E-5.6-s2-4x4", 4.0), ("E-5.6-s2-0.5", 0.5)] {
        let floor = (square(side, dvec3(2.0, 2.0, 0.0), true), 1.0, 0.0);
        let black = walls().filter(|(wall, ..)| wall.normal() != DVec3::Z);
        let room = scene(black.chain([floor]));
        meets(&case(id), &room, "E_over_Ehz_rho_percent", 0.01, 1e-12);
    }
}

/// 5.7: a diffuse wall lights the opposite one and the floor, past a low box: some
/// points see all of it, some a part, two nothing.
#[test]
fn an_obstruction_casts_its_shadow() {
    let case = case("E-5.7-obstruction");
    let black = walls().filter(|(wall, ..)| wall.normal() != DVec3::NEG_Y);
    let boxes = case["occluders"].as_array().unwrap();
    let boxes = boxes.iter().map(|face| (polygon(face), 0.0, 0.0));
    let room = scene(black.chain([(polygon(&case["emitter"]), 1.0, 0.0)]).chain(boxes));
    meets(&case, &room, "E_over_Ev_rho_percent", 0.01, 1e-9);
}

/// 5.2: `I₀ h²/d⁴` on the floor below a point of intensity `I₀ cosθ`. A Lambertian
/// square of side s is that but for terms of (s/d)²: at s = 0.1 off by 1e-3 or less,
/// and a tenth of the side has a hundredth of the error.
#[test]
fn a_tiny_square_stands_for_a_cosine_source() {
    let case = case("E-5.2-lambertian");
    let number = |key: &str| case["params"][key].as_f64().unwrap();
    let (intensity, height) = (number("I0_cd"), number("height"));
    let off = |side: f64| {
        let lamp = square(side, dvec3(0.0, 0.0, height), false);
        let floor = square(4.0, DVec3::ZERO, true);
        // The lamp has intensity L A at its zenith: radiosity π L.
        let scene =
            scene([(floor, 0.0, 0.0), (lamp, PI * intensity / (side * side), 0.0)]);
        let (direct, floor) = (Direct::of(&scene), &scene.surfaces[0].polygon);
        let mut worst = 0.0_f64;
        for (name, expected) in case["expected"]["E_lux"].as_object().unwrap() {
            let xy = &case["params"]["points_xy"][name];
            let x = dvec3(xy[0].as_f64().unwrap(), xy[1].as_f64().unwrap(), 0.0);
            let expected = expected.as_f64().unwrap();
            worst =
                worst.max((direct.on(floor).irradiance(x).x / expected - 1.0).abs());
        }
        worst
    };
    let [large, small, tiny] = [0.1, 0.01, 0.001].map(off);
    assert!((1e-4..1e-3).contains(&large), "{large}");
    for ratio in [large / small, small / tiny] {
        assert!((99.0..101.0).contains(&ratio), "{large} {small} {tiny}");
    }
    assert!(tiny < 1e-6, "the gate of the table: {tiny}");
}

/// What an isotropic point of 1 W sends to a wall: its share of all directions.
fn share(x: DVec3, wall: &Polygon) -> f64 {
    solid_angle(x, wall) / (4.0 * PI)
}

/// 5.4: the flux of an isotropic point arrives, all of it, on the walls that it should.
#[test]
fn the_flux_of_a_point_is_conserved() {
    let case = case("E-5.4-flux");
    let total = case["expected"]["total_lm"].as_f64().unwrap();
    let mut sum = 0.0;
    for (wall, ..) in walls() {
        let key = match wall.normal() {
            DVec3::Z => "floor",
            DVec3::NEG_Z => "ceiling",
            _ => "each_wall",
        };
        let got = total * share(dvec3(2.0, 2.0, 1.5), &wall);
        let expected = case["expected"]["flux_lm"][key].as_f64().unwrap();
        assert!(within(got, expected, 1e-12, 1e-10), "{key}: {got}, not {expected}");
        sum += got;
    }
    assert!(within(sum, total, 1e-14, 0.0), "{sum}");
}

/// 5.8: `E = Φ/((1 − ρ) S)` in the mean over a cube, and `ρ` of it indirect - on any
/// mesh, with the point anywhere: what an element gets at first, it emits `ρ` of.
#[test]
fn an_integrating_cube_has_its_mean() {
    let case = case("E-5.8-interreflection");
    let numbers = |v: &Value| -> Vec<f64> {
        v.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let flux = case["params"]["flux"].as_f64().unwrap();
    let cube = scene(box_walls([4.0; 3]).into_iter().map(|wall| (wall, 0.0, 0.0)));
    let reflectances = numbers(&case["params"]["rho"]);
    let [total, indirect] = ["E_avg_total", "E_avg_indirect"]
        .map(|key| numbers(&case["expected"][key]).into_iter());
    let expected: Vec<_> = reflectances.into_iter().zip(total.zip(indirect)).collect();
    assert_eq!(expected.len(), 12);
    for (edge, lamp) in [(4.0, DVec3::splat(2.0)), (1.0, dvec3(0.3, 1.0, 3.5))] {
        let mesh = Mesh::uniform(&cube, edge);
        let matrix = exact_factors(&mesh);
        let first = |p: &Polygon| flux * share(lamp, p) / p.area();
        let first: Vec<f64> = mesh.polygons().map(first).collect();
        for &(rho, (total, indirect)) in &expected {
            let mut enclosure = Enclosure::of(&cube, &mesh);
            enclosure.reflectance.fill(Rgb::splat(rho));
            enclosure.emission = first.iter().map(|h| Rgb::splat(rho * h)).collect();
            let b = gathered(&enclosure, &matrix, 1e-13, 10_000);
            let area: f64 = enclosure.area.iter().sum();
            // H = B/ρ where anything is reflected; what is not first is indirect.
            let of = |b: &Rgb, h: f64| if rho > 0.0 { b.x / rho } else { h };
            let h: Vec<f64> = b.iter().zip(&first).map(|(b, &h)| of(b, h)).collect();
            let mean = |h: &[f64]| {
                enclosure.area.iter().zip(h).map(|(a, h)| a * h).sum::<f64>() / area
            };
            let more = mean(&h) - mean(&first);
            assert!(within(mean(&h), total, 1e-11, 0.0), "{rho}: {}", mean(&h));
            assert!(within(more, indirect, 1e-10, 1e-10), "{rho}: {more}");
        }
    }
}
