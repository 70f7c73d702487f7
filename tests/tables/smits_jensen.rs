//! The test scenes of Smits & Jensen (2000) that have an exact answer: two lamps over a
//! floor, and the furnace.

use crate::common::rooms::{gathered, scene};
use crate::common::{cases, point, polygon, within};
use glam::DVec3;
use radiosity::form_factor::analytic::{Analytic, lambert_polygon};
use radiosity::form_factor::{FormFactors, Lost, Matrix, Row};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::room::Direct;
use radiosity::scene::Scene;
use radiosity::solve::{Enclosure, GaussSeidel, Solver};
use serde_json::Value;
use std::f64::consts::PI;

/// The case of the table that is called so.
fn case(id: &str) -> Value {
    let found = cases("D_smits_jensen").into_iter().find(|case| case["id"] == id);
    found.unwrap_or_else(|| panic!("no case {id}"))
}

/// Floor, left lamp, right lamp: radiance 1, so radiosity π; a floor that reflects
/// half.
fn emission_scene(case: &Value) -> Scene {
    let face = |key: &str, e, rho| (polygon(&case[key]), e, rho);
    scene([
        face("floor", 0.0, 0.5),
        face("left_light", PI, 0.0),
        face("right_light", PI, 0.0),
    ])
}

/// Each lamp's irradiance, their sum, and what a floor of reflectance ½ shows of it.
#[test]
fn two_lamps_at_the_published_points() {
    let case = case("D1-emission-points-public");
    let scene = emission_scene(&case);
    let floor = &scene.surfaces[0].polygon;
    let (direct, lamps) = (
        Direct::of(&scene),
        [polygon(&case["left_light"]), polygon(&case["right_light"])],
    );
    let points = case["expected"]["points"].as_array().unwrap();
    assert_eq!(points.len(), 13);
    for expected in points {
        let x = point(&expected["point"]);
        let meets = |got: f64, key: &str| {
            let expected = expected[key].as_f64().unwrap();
            assert!(
                within(got, expected, 1e-12, 1e-14),
                "{x} {key}: {got}, not {expected}"
            );
        };
        for (lamp, key) in lamps.iter().zip(["E_left", "E_right"]) {
            meets(PI * lambert_polygon(x, floor.normal(), lamp), key);
        }
        let arriving = direct.on(floor).irradiance(x).x;
        meets(arriving, "E");
        meets(0.5 * arriving / PI, "radiance_diffuse50");
    }
}

/// The published scene cuts the right lamp into ten by ten: nothing may depend on it.
#[test]
fn a_lamp_in_a_hundred_pieces_is_the_lamp() {
    let case = case("D1-emission-points-public");
    let lamp = polygon(&case["right_light"]);
    let whole = scene([(lamp.clone(), PI, 0.0)]);
    let pieces: Vec<Polygon> =
        Mesh::uniform(&whole, 10.0).polygons().cloned().collect();
    assert_eq!(pieces.len(), 100);
    for expected in case["expected"]["points"].as_array().unwrap() {
        let x = point(&expected["point"]);
        let from = |piece: &Polygon| lambert_polygon(x, DVec3::Y, piece);
        let got = PI * pieces.iter().map(from).sum::<f64>();
        let expected = expected["E_right"].as_f64().unwrap();
        assert!(within(got, expected, 1e-11, 1e-14), "{x}: {got}, not {expected}");
    }
}

/// The same as power: factors between whole polygons, and the equation solved with
/// them.
#[test]
fn two_lamps_light_the_floor() {
    let case = case("D1-emission-flux");
    let scene = emission_scene(&case);
    let mesh = Mesh::whole(&scene);
    let enclosure = Enclosure::of(&scene, &mesh);
    let method = Analytic::new(&scene, &mesh, 1e-12, 0);
    let matrix = method.matrix(&|| ());
    let meets = |got: f64, key: &str| {
        let expected = case["expected"][key].as_f64().unwrap();
        assert!(within(got, expected, 1e-9, 1e-12), "{key}: {got}, not {expected}");
    };
    let mut row = [0.0; 3];
    for lamp in [1, 2] {
        matrix.row(ElementId(lamp), &mut row);
        meets(row[0], "F_light_to_floor");
        let lamp = lamp as usize;
        meets(enclosure.area[lamp] * enclosure.emission[lamp].x, "flux_one_light");
    }
    let mut solver = GaussSeidel::new(&enclosure, &matrix);
    assert!(solver.next().is_some());
    let floor = solver.irradiance()[0].x; // the lamps are black: one sweep is all
    meets(floor, "mean_floor_irradiance");
    meets(floor * enclosure.area[0], "flux_to_floor_both_lights");
}

/// The furnaces of the table: reflectance and emitted radiance, the same everywhere.
fn furnaces() -> impl Iterator<Item = (f64, f64, Value)> {
    let of = |id| {
        let case = case(id);
        let number = |key: &str| case["params"][key].as_f64().unwrap();
        (number("rho"), number("Le"), case["expected"].clone())
    };
    ["D2-furnace-0.5", "D2-furnace-0.9"].map(of).into_iter()
}

/// The nine closed rooms of another table, as matrices, with areas.
fn rooms() -> impl Iterator<Item = (String, Vec<f64>, Matrix)> {
    cases("A_enclosures").into_iter().map(|room| {
        let numbers = |v: &Value| -> Vec<f64> {
            v.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
        };
        let faces = room["faces"].as_array().unwrap();
        let area = faces.iter().map(|face| polygon(&face["polygon"]).area()).collect();
        let rows = room["expected"]["F"].as_array().unwrap();
        let row = |row| Row::of(&numbers(row), Lost::default());
        (
            room["id"].to_string(),
            area,
            Matrix::from_rows(rows.iter().map(row).collect()),
        )
    })
}

/// In any closed room: `L = Le/(1 − ρ)`, and after `k` bounces its first `k + 1` terms.
#[test]
fn furnaces_of_any_shape() {
    for (rho, le, expected) in furnaces() {
        for (room, area, matrix) in rooms() {
            let n = area.len();
            let enclosure = Enclosure {
                area,
                emission: vec![Rgb::splat(PI * le); n],
                reflectance: vec![Rgb::splat(rho); n],
                ..Default::default()
            };
            let radiance = expected["radiance"].as_f64().unwrap();
            for b in gathered(&enclosure, &matrix, 1e-14, 10_000) {
                assert!(within(b.x / PI, radiance, 1e-12, 0.0), "{room} {rho}: {b}");
            }
            let truncated = &expected["truncated_after_k_bounces"];
            let mut b = vec![PI * le; n];
            for bounces in 0..=10 {
                if let Some(expected) = truncated[bounces.to_string()].as_f64() {
                    for b in &b {
                        assert!(
                            within(b / PI, expected, 1e-12, 0.0),
                            "{room} {bounces}"
                        );
                    }
                }
                let gather = |row: &Row| {
                    let of = |&(j, f): &(u32, f64)| f * b[j as usize];
                    PI * le + rho * row.factors().iter().map(of).sum::<f64>()
                };
                b = matrix.rows().iter().map(gather).collect();
            }
        }
    }
}

/// A face that reflects all and emits nothing changes nothing: it cannot be seen.
#[test]
fn a_lossless_reflector_vanishes_in_a_furnace() {
    for (rho, le, expected) in furnaces() {
        let radiance = expected["radiance"].as_f64().unwrap();
        for (room, area, matrix) in rooms() {
            let n = area.len();
            let mut enclosure = Enclosure {
                area,
                emission: vec![Rgb::splat(PI * le); n],
                reflectance: vec![Rgb::splat(rho); n],
                ..Default::default()
            };
            (enclosure.emission[0], enclosure.reflectance[0]) = (Rgb::ZERO, Rgb::ONE);
            let mut solver = GaussSeidel::new(&enclosure, &matrix);
            // No bound holds with ρ_max = 1: sweep until rounding is all that is left.
            solver.by_ref().take(2000).for_each(drop);
            for b in solver.radiosity() {
                assert!(within(b.x / PI, radiance, 1e-10, 0.0), "{room} {rho}: {b}");
            }
        }
    }
}
