//! What several tests share: the accuracy tables under `tests/data/accuracy`.
#![allow(dead_code, missing_docs)] // each test uses its part

pub mod any;
pub mod mirrored;
pub mod paths;
pub mod picture;
pub mod random_rooms;
pub mod rooms;
pub mod shapes;
pub mod shots;
pub mod texts;
pub mod truth;

use glam::DVec3;
use radiosity::geometry::Polygon;
use serde_json::Value;

/// The cases of one table.
pub fn cases(table: &str) -> Vec<Value> {
    let path =
        format!("{}/tests/data/accuracy/{table}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect(&path);
    let mut file: Value = serde_json::from_str(&text).expect(&path);
    match file["cases"].take() {
        Value::Array(cases) => cases,
        _ => panic!("{path} has no cases"),
    }
}

pub fn point(v: &Value) -> DVec3 {
    let x = |k: usize| v[k].as_f64().expect("a coordinate");
    DVec3::new(x(0), x(1), x(2))
}

pub fn polygon(v: &Value) -> Polygon {
    let vertices = v.as_array().expect("vertices").iter().map(point).collect();
    Polygon::new(vertices).expect("a polygon of the table is fit")
}

/// The convex pieces of an outline, which need not be convex.
pub fn pieces(v: &Value) -> Vec<Polygon> {
    let outline: Vec<DVec3> =
        v.as_array().expect("vertices").iter().map(point).collect();
    radiosity::geometry::split(&outline).expect("an outline of the table is fit")
}

pub fn has_tag(case: &Value, tag: &str) -> bool {
    case["tags"].as_array().is_some_and(|tags| tags.iter().any(|t| t == tag))
}

/// `|got − expected| ≤ max(relative·|expected|, uncertainty)`, as the tables ask.
pub fn within(got: f64, expected: f64, relative: f64, uncertainty: f64) -> bool {
    (got - expected).abs() <= (relative * expected.abs()).max(uncertainty)
}
