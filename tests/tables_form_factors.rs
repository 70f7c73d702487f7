//! Form factors against exact values that nobody here computed.

mod common;

use common::{cases, has_tag, pieces, point, polygon, within};
use radiosity::form_factor::analytic::{exchange, lambert_polygon};
use radiosity::geometry::Polygon;

/// Gate of the tables: 1e-9 relative, 1e-6 where a case is marked extreme.
fn relative(case: &serde_json::Value) -> f64 {
    if has_tag(case, "extreme") { 1e-6 } else { 1e-9 }
}

#[test]
fn point_to_polygon() {
    let cases = cases("A_point_polygon");
    assert_eq!(cases.len(), 15);
    for case in &cases {
        let normal = point(&case["normal"]);
        let got = lambert_polygon(point(&case["point"]), normal, &polygon(&case["B"]));
        let expected = case["expected"]["F_dA_B"].as_f64().unwrap();
        let uncertainty = case["uncertainty_abs"].as_f64().unwrap();
        assert!(
            within(got, expected, relative(case), uncertainty),
            "{}: {got} is not {expected}",
            case["id"]
        );
    }
}

#[test]
fn polygon_to_polygon() {
    let cases = cases("A_polygon_pairs");
    assert_eq!(cases.len(), 68);
    let mut wrong = Vec::new();
    for case in &cases {
        if has_tag(case, "concave") {
            continue;
        }
        let (a, b) = (pieces(&case["A"]), pieces(&case["B"]));
        let pairs =
            a.iter().flat_map(|i| b.iter().map(move |j| exchange(i, j, 1e-300)));
        let got = pairs.sum::<f64>() / a.iter().map(Polygon::area).sum::<f64>();
        let expected = case["expected"]["F_AB"].as_f64().unwrap();
        let uncertainty = case["uncertainty_abs"].as_f64().unwrap();
        if !within(got, expected, relative(case), uncertainty) {
            wrong.push(format!(
                "{}: {got} is not {expected}, off by {:e} ({:e} relative)",
                case["id"],
                got - expected,
                got / expected - 1.0
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
