//! The hemicube: weights, closure, books. (Its failures: `tests/stability/hemicube.rs`.)

use glam::{DVec3, dvec3};
use radiosity::form_factor::hemicube::{CubeFace, Hemicube, Weights};
use radiosity::form_factor::{FormFactors, Lost};
use radiosity::geometry::Polygon;
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::scene::{MaterialId, Scene};
use serde_json::Value;

/// Centre of a unit square to the opposite one at distance 1 (closed form).
const CENTRE_TO_SQUARE: f64 = 0.239_456_470_460_774;

fn mesh_of(polygons: Vec<Polygon>, max_edge: f64) -> Mesh {
    let face = |polygon: &Polygon| radiosity::scene::Face {
        outline: polygon.vertices().to_vec(),
        material: MaterialId(0),
    };
    let grey = Material::new("grey", Coefficients::default()).unwrap();
    let faces = polygons.iter().map(face).collect();
    let scene = Scene::assemble("test", vec![grey], faces, None).unwrap().0;
    Mesh::uniform(&scene, max_edge)
}

/// A rectangle from a corner and two edges; its front is where `a × b` points.
fn rectangle(corner: DVec3, a: DVec3, b: DVec3) -> Polygon {
    Polygon::new(vec![corner, corner + a, corner + a + b, corner + b]).unwrap()
}

/// A square of this side, about `(x, y, z)`, looking down.
fn lid(side: f64, centre: DVec3) -> Polygon {
    let corner = centre - dvec3(side / 2.0, side / 2.0, 0.0);
    rectangle(corner, DVec3::Y * side, DVec3::X * side)
}

/// The six walls of the unit cube, fronts inwards.
fn cube() -> Vec<Polygon> {
    let (x, y, z, o) = (DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO);
    vec![
        rectangle(o, x, y),
        rectangle(z, y, x),
        rectangle(o, y, z),
        rectangle(x, z, y),
        rectangle(o, z, x),
        rectangle(y, x, z),
    ]
}

/// The factor from the origin, looking along +Z, to the only element of `mesh`.
fn seen_from_origin(mesh: &Mesh, resolution: u32) -> f64 {
    let mut row = vec![0.0; mesh.elements.len()];
    Hemicube::new(mesh, resolution).at(DVec3::ZERO, DVec3::Z, &mut row);
    row[0]
}

#[test]
fn classic_weights_meet_the_table() {
    let text = include_str!("../data/hemicube_delta_sum.json");
    let table: Value = serde_json::from_str(text).unwrap();
    for case in table["cases"].as_array().unwrap() {
        let resolution = case["params"]["resolution"].as_u64().unwrap() as u32;
        let expected = |key: &str| case["expected"][key].as_f64().unwrap();
        let (classic, exact) =
            (Weights::at_centres(resolution), Weights::exact(resolution));
        let sum = |weights: &Weights, face| weights.of(face).iter().sum::<f64>();
        for (got, key) in [
            (sum(&classic, CubeFace::Top), "sum_top"),
            (4.0 * sum(&classic, CubeFace::West), "sum_four_sides"),
            (classic.sum(), "sum_total"),
            (sum(&exact, CubeFace::Top), "exact_top"),
            (4.0 * sum(&exact, CubeFace::East), "exact_sides"),
            (exact.sum() + 1.0, "two"),
        ] {
            let expected = if key == "two" { 2.0 } else { expected(key) };
            assert!(
                (got - expected).abs() < 1e-12,
                "{resolution} {key}: {got} {expected}"
            );
        }
    }
}

#[test]
fn every_cell_weighs_something() {
    for resolution in [2, 16, 1024] {
        let weights = Weights::exact(resolution);
        for face in CubeFace::ALL {
            assert!(weights.of(face).iter().all(|&w| w > 0.0), "{resolution} {face:?}");
        }
    }
}

/// The error is that of the outline: at most the cells it crosses, 4·128 of weight
/// 1/(π·128²) each for a square of half the top's width; and far less, for they average
/// out.
#[test]
fn the_opposite_square_is_found() {
    let mesh = mesh_of(vec![lid(1.0, DVec3::Z)], 9.0);
    for (resolution, tolerance) in [(64, 0.02), (256, 0.005), (1024, 0.002)] {
        let got = seen_from_origin(&mesh, resolution);
        let error = (got / CENTRE_TO_SQUARE - 1.0).abs();
        assert!(error < tolerance, "{resolution}: {got}, off by {error:.1e}");
    }
}

/// Every case of the table. An edge that runs along the cells is off by half a cell at
/// most; through the zenith, half a cell of width `h` = 2/512 weighs `h/2 ∫ 1/(π (1 +
/// y²)²) dy = h/4`, a thousandth. Edges across the cells do far better.
#[test]
fn the_hemicube_meets_the_table_of_polygons() {
    let text = include_str!("../data/point_polygon.json");
    let table: Value = serde_json::from_str(text).unwrap();
    for case in table["cases"].as_array().unwrap() {
        let vector = |v: &Value| {
            let [x, y, z] = [0, 1, 2].map(|k| v[k].as_f64().unwrap());
            dvec3(x, y, z)
        };
        let corners = case["B"].as_array().unwrap().iter().map(vector).collect();
        let polygon = Polygon::new(corners).unwrap();
        let mesh = mesh_of(vec![polygon], 1e9);
        let mut row = vec![0.0; mesh.elements.len()];
        let (point, normal) = (vector(&case["point"]), vector(&case["normal"]));
        Hemicube::new(&mesh, 512).turned(1).at(point, normal.normalize(), &mut row);
        let (got, expected) = (row[0], case["expected"]["F_dA_B"].as_f64().unwrap());
        assert!((got - expected).abs() < 1e-3, "{}: {got}, not {expected}", case["id"]);
    }
}

#[test]
fn rows_sum_to_one_in_a_closed_room() {
    let mesh = mesh_of(cube(), 0.26);
    for cube in [Hemicube::new(&mesh, 64), Hemicube::new(&mesh, 64).turned(7)] {
        let mut row = vec![0.0; mesh.elements.len()];
        for id in 0..mesh.elements.len() {
            let lost = cube.row(ElementId(id as u32), &mut row);
            let sum: f64 = row.iter().sum();
            assert!((sum - 1.0).abs() < 1e-12, "row {id} sums to {sum}");
            assert_eq!(lost, Lost::default(), "row {id}");
        }
    }
}

/// The books are kept by what the cells show: of a room without a lid, the light that
/// leaves is the lid's factor; a face that shows its back takes what its front would.
#[test]
fn lost_light_is_counted() {
    let whole = mesh_of(cube(), 9.0);
    let factors = |mesh: &Mesh| {
        let mut row = vec![0.0; mesh.elements.len()];
        let lost = Hemicube::new(mesh, 128).row(ElementId(0), &mut row);
        (row, lost)
    };
    let (closed, _) = factors(&whole);
    let mut walls = cube();
    walls.remove(1);
    let (_, lost) = factors(&mesh_of(walls.clone(), 9.0));
    assert!(
        (lost.escaped - closed[1]).abs() < 1e-12 && lost.absorbed == 0.0,
        "{lost:?}"
    );
    walls.push(cube()[1].flipped());
    let (row, lost) = factors(&mesh_of(walls, 9.0));
    assert!(
        (lost.absorbed - closed[1]).abs() < 1e-12 && lost.escaped == 0.0,
        "{lost:?}"
    );
    assert_eq!(row[5], 0.0);
}

/// The same bytes whatever order rows are asked for in, on however many threads.
#[test]
fn rows_do_not_depend_on_threads() {
    use rayon::prelude::*;
    let mesh = mesh_of(cube(), 0.5);
    let cube = Hemicube::new(&mesh, 32).turned(3);
    let n = mesh.elements.len();
    let row = |id: usize| {
        let mut row = vec![0.0; n];
        let lost = cube.row(ElementId(id as u32), &mut row);
        (row, lost)
    };
    let one: Vec<_> = (0..n).map(row).collect();
    let many: Vec<_> = (0..n).into_par_iter().map(row).collect();
    assert!(one == many);
}
