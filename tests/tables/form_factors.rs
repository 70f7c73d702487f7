//! Form factors against exact values that nobody here computed.

use crate::common::rooms::{rectangle, unit_square};
use crate::common::{cases, has_tag, pieces, point, polygon, within};
use glam::{DVec3, dvec3};
use radiosity::form_factor::Accuracy;
use radiosity::form_factor::analytic::{exchange, lambert_polygon};
use radiosity::form_factor::named;
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
        let (a, b) = (pieces(&case["A"]), pieces(&case["B"]));
        let pairs = a
            .iter()
            .flat_map(|i| b.iter().map(move |j| exchange(i, j, Accuracy::Best)));
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

/// A unit square in the plane z = 0, and one that leans over it at this angle (degrees)
/// from a shared edge, each `width` deep.
fn wedge(angle: f64, width: f64) -> [Polygon; 2] {
    let (x, (sine, cosine)) = (DVec3::X, angle.to_radians().sin_cos());
    let floor = DVec3::Y * width;
    let leaning = dvec3(0.0, cosine, sine) * width;
    [rectangle(DVec3::ZERO, x, floor), rectangle(DVec3::ZERO, leaning, x)]
}

/// Unit squares that share an edge, by the angle between them: ten digits of Schröder &
/// Hanrahan's closed form.
#[test]
fn wedges() {
    for (angle, expected) in [
        (5.0, 0.9202619081),
        (10.0, 0.8496061250),
        (30.0, 0.6190283231),
        (60.0, 0.3709053212),
        (90.0, 0.2000437761),
        (120.0, 0.0866150011),
        (150.0, 0.0213453254),
        (175.0, 0.0005902909),
    ] {
        let [a, b] = wedge(angle, 1.0);
        let got = exchange(&a, &b, Accuracy::Best);
        assert!((got - expected).abs() < 1e-10, "{angle}°: {got}, not {expected}");
    }
}

/// Square plates face to face, by side over distance; and at right angles, by depth
/// over the shared edge (Howell's C-11 and C-14).
#[test]
fn plates() {
    for (ratio, expected) in [
        (0.1, 0.003162056838754),
        (0.2, 0.012403977313243),
        (0.4, 0.046137416744875),
        (0.6, 0.09336233784065),
        (1.0, 0.199824895698387),
        (2.0, 0.415253283577147),
        (4.0, 0.63203643001386),
        (10.0, 0.826994522397256),
    ] {
        let got = exchange(
            &unit_square(0.0, true),
            &unit_square(1.0 / ratio, false),
            Accuracy::Best,
        );
        assert!((got - expected).abs() < 1e-14, "{ratio}: {got}, not {expected}");
    }
    for (depth, expected) in [
        (0.1, 0.281887806787901),
        (1.0, 0.200043776075403),
        (2.0, 0.149299795886762),
        (4.0, 0.101358700221681),
        (10.0, 0.055023979528411),
    ] {
        let [a, b] = wedge(90.0, depth);
        let got = exchange(&a, &b, Accuracy::Best) / a.area();
        assert!((got - expected).abs() < 1e-13, "{depth}: {got}, not {expected}");
    }
}

/// From the middle of a square to the opposite one: 20 % more than the mean.
#[test]
fn from_the_middle() {
    let middle = dvec3(0.5, 0.5, 0.0);
    let got = lambert_polygon(middle, DVec3::Z, &unit_square(1.0, false));
    assert!((got - 0.239456470460774).abs() < 1e-14, "{got}");
}

/// Strips up to a thousand times as long as wide, near and far, face to face and sharing
/// their long or their short edge: 1e-10 absolute, as everywhere.
#[test]
fn slender_strips() {
    let rectangle = |corners: [[f64; 3]; 4]| {
        Polygon::new(corners.map(|[x, y, z]| dvec3(x, y, z)).to_vec()).unwrap()
    };
    for aspect in [1.0, 10.0, 100.0, 1000.0] {
        let (a, b) = (aspect, 1.0);
        let floor = rectangle([[0., 0., 0.], [a, 0., 0.], [a, b, 0.], [0., b, 0.]]);
        for c in [1e-3, 0.1, 1.0, 30.0, 1000.0] {
            let lid = rectangle([[0., 0., c], [0., b, c], [a, b, c], [a, 0., c]]);
            let got = exchange(&floor, &lid, Accuracy::Best) / floor.area();
            let exact = named::parallel_rectangles(a, b, c);
            assert!(
                (got - exact).abs() < 1e-10,
                "{a} × {b} at {c}: {got}, not {exact}"
            );
        }
        for h in [1e-3, 1.0, 1000.0] {
            let wall = rectangle([[0., 0., 0.], [0., 0., h], [a, 0., h], [a, 0., 0.]]);
            let got = exchange(&floor, &wall, Accuracy::Best) / floor.area();
            let exact = named::perpendicular_rectangles(b, h, a);
            assert!(
                (got - exact).abs() < 1e-10,
                "{a} × {b}, wall {h}: {got}, not {exact}"
            );
        }
    }
}
