//! Whole matrices of convex rooms, and solid angles, against exact values.

mod common;

use common::rooms::{black, box_walls, exact_factors, rectangle, rows};
use common::{cases, has_tag, point, polygon, within};
use glam::DVec3;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::{FormFactors, Lost};
use radiosity::geometry::Polygon;
use radiosity::mesh::Mesh;
use radiosity::radiometry::{solid_angle, solid_angle_of_cap, solid_angle_triangle};
use serde_json::Value;

/// Nine rooms, through the scene and the mesh as a user would: every factor to 1e-9.
#[test]
fn matrices_of_convex_rooms() {
    let cases = cases("A_enclosures");
    assert_eq!(cases.len(), 9);
    for case in &cases {
        let faces = case["faces"].as_array().unwrap();
        let scene = black(faces.iter().map(|face| polygon(&face["polygon"])));
        let mesh = Mesh::whole(&scene);
        let method = Analytic::new(&scene, &mesh, 1e-300, 0);

        let pairs = exact_factors(&mesh);
        let gate = if has_tag(case, "extreme") { 1e-6 } else { 1e-9 };
        for (name, rows) in [
            ("row", rows(&method)),
            ("matrix", rows(&method.matrix(&|| ()))),
            ("pair", rows(&pairs)),
        ] {
            for (i, (row, lost)) in rows.into_iter().enumerate() {
                assert_eq!(lost, Lost::default(), "{}", case["id"]);
                for (j, got) in row.into_iter().enumerate() {
                    let expected = case["expected"]["F"][i][j].as_f64().unwrap();
                    assert!(
                        within(got, expected, gate, 1e-16),
                        "{} by {name}: F[{i}][{j}] = {got}, not {expected}",
                        case["id"]
                    );
                }
            }
        }
    }
}

fn number(v: &Value) -> f64 {
    v.as_f64().unwrap()
}

/// A triangle, a cap, a rectangle on the axis, a box from outside: to 1e-9 or rounding.
#[test]
fn solid_angles() {
    let mut seen = 0;
    for case in cases("I_brdf_solid_angle") {
        let params = &case["params"];
        let got = match case["kind"].as_str().unwrap() {
            "solid_angle_triangle" => {
                let [a, b, c] = [0, 1, 2].map(|k| point(&case["triangle"][k]));
                solid_angle_triangle(a, b, c).abs()
            }
            "solid_angle_cap" => {
                solid_angle_of_cap(number(&params["half_angle_deg"]).to_radians())
            }
            "solid_angle_rectangle_on_axis" => {
                let [a, b, d] = ["a", "b", "d"].map(|key| number(&params[key]));
                let corner = DVec3::new(-a / 2.0, -b / 2.0, d);
                solid_angle(DVec3::ZERO, &rectangle(corner, DVec3::X * a, DVec3::Y * b))
            }
            "solid_angle_box" => {
                let [lo, hi, p] = ["lo", "hi", "point"].map(|key| point(&params[key]));
                let walls = box_walls((hi - lo).to_array());
                // A convex body hides its far walls: those that show their back inside-out.
                let facing = |wall: &&Polygon| wall.plane().height(p - lo) < 0.0;
                walls.iter().filter(facing).map(|wall| solid_angle(p - lo, wall)).sum()
            }
            _ => continue,
        };
        seen += 1;
        let expected = number(&case["expected"]["solid_angle"]);
        assert!(
            within(got, expected, 1e-9, number(&case["uncertainty_abs"])),
            "{}: {got}, not {expected}",
            case["id"]
        );
    }
    assert_eq!(seen, 15);
}
