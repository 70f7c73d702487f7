//! The hemicube: weights, closure, and the failures that belong to it.

use glam::{DVec3, dvec3};
use radiosity::form_factor::hemicube::{Face, Hemicube, Weights};
use radiosity::form_factor::{FormFactors, Lost};
use radiosity::geometry::{Frame, Polygon};
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::random::Stream;
use radiosity::raster::{ItemBuffer, Seen};
use radiosity::scene::{MaterialId, Scene};
use serde_json::Value;
use std::f64::consts::{PI, TAU};

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
    let text = include_str!("data/hemicube_delta_sum.json");
    let table: Value = serde_json::from_str(text).unwrap();
    for case in table["cases"].as_array().unwrap() {
        let resolution = case["params"]["resolution"].as_u64().unwrap() as u32;
        let expected = |key: &str| case["expected"][key].as_f64().unwrap();
        let (classic, exact) =
            (Weights::at_centres(resolution), Weights::exact(resolution));
        let sum = |weights: &Weights, face| weights.of(face).iter().sum::<f64>();
        for (got, key) in [
            (sum(&classic, Face::Top), "sum_top"),
            (4.0 * sum(&classic, Face::West), "sum_four_sides"),
            (classic.sum(), "sum_total"),
            (sum(&exact, Face::Top), "exact_top"),
            (4.0 * sum(&exact, Face::East), "exact_sides"),
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

/// Failure 21: what the classic weights are off by, at 16 … 128.
#[test]
fn classic_weights_miss_one_by_little() {
    for (resolution, miss) in
        [(16, 0.002123), (32, 0.00053), (64, 0.000132), (128, 0.0000331)]
    {
        let got = Weights::at_centres(resolution).sum() - 1.0;
        assert!((got - miss).abs() < 0.01 * miss, "{resolution}: {got}");
    }
}

#[test]
fn every_cell_weighs_something() {
    for resolution in [2, 16, 1024] {
        let weights = Weights::exact(resolution);
        for face in Face::ALL {
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
    let text = include_str!("data/point_polygon.json");
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

/// An element touches the wall beside it: the corner is not lost (failure 24).
#[test]
fn contacts_are_seen_down_to_the_corner() {
    for gap in [1e-2, 1e-5, 1e-8] {
        let wall = rectangle(dvec3(gap, -5.0, 0.0), DVec3::Z * 5.0, DVec3::Y * 10.0);
        let mesh = mesh_of(vec![wall], 99.0);
        let half = seen_from_origin(&mesh, 64);
        assert!((half - 0.5).abs() < 0.01 + gap, "gap {gap}: {half}");
    }
}

/// Failure 1, proximity: the centre speaks for the whole square, worst at half a side.
/// The hemicube has the same error, and no resolution cures it.
#[test]
fn near_by_the_centre_is_not_the_mean() {
    // distance, exact factor between the squares (Howell C-11), published excess
    for (distance, exact, excess) in [
        (0.1, 0.826_994_522_397_256, 0.171),
        (0.5, 0.415_253_283_577_147, 0.334),
        (1.0, 0.199_824_895_698_387, 0.198),
        (2.0, 0.068_589_588_818_552_4, 0.071),
    ] {
        let mesh = mesh_of(vec![lid(1.0, DVec3::Z * distance)], 99.0);
        let got = seen_from_origin(&mesh, 1024) / exact - 1.0;
        // width and height are found to one cell in 1024/(2 distance)
        let tolerance = 0.003 + 2.0 * 2.0 * distance / 1024.0;
        assert!((got - excess).abs() < tolerance, "{distance}: {got:.4}, not {excess}");
    }
}

/// Failures 18 and 19, aliasing: a small square faces the eye from distance 1, in
/// random directions. Root mean square of the relative error, and how often it is
/// missed.
#[test]
fn small_patches_alias() {
    for (resolution, side, rms, missed) in [
        (32, 0.02, 2.33, 0.81),
        (32, 0.1, 0.21, 0.0),
        (64, 0.02, 0.83, 0.31),
        (64, 0.05, 0.23, 0.0),
        (64, 0.1, 0.088, 0.0),
        (128, 0.02, 0.27, 0.0),
        (128, 0.1, 0.031, 0.0),
        (256, 0.02, 0.115, 0.0),
    ] {
        let (got_rms, got_missed) = aliasing(resolution, side, 4000);
        // The published squares lie along the cells, which makes it worse by up to 40
        // %; ours are also rolled at random. Four thousand places: known to a few per
        // cent.
        assert!(
            (0.7..1.1).contains(&(got_rms / rms)),
            "{resolution} {side}: {got_rms}"
        );
        assert!(
            (got_missed - missed).abs() < 0.03,
            "{resolution} {side}: {got_missed}"
        );
    }
}

/// The error of the factor to a square of this `side`, one from the eye, over `places`.
fn aliasing(resolution: u32, side: f64, places: u64) -> (f64, f64) {
    let weights = Weights::exact(resolution);
    let frame = Frame::about(DVec3::Z);
    let mut cells = ItemBuffer::new(1, 1);
    let mut random = Stream::named(1, &[resolution as u64]);
    let (mut squares, mut missed) = (0.0, 0.0);
    for _ in 0..places {
        // uniform in direction, above the horizon by more than the square
        let z = side + (1.0 - side) * random.next();
        let (around, roll) = (TAU * random.next(), TAU * random.next());
        let r = (1.0 - z * z).sqrt();
        let centre = dvec3(r * around.cos(), r * around.sin(), z);
        let facing = Frame::about(-centre);
        let (sin, cos) = roll.sin_cos();
        let a = side * (facing.x * cos + facing.y * sin);
        let b = -facing.z.cross(a);
        let polygon = rectangle(centre - (a + b) / 2.0, b, a);
        // small and one away: the point rule is exact to side², a hundredth
        let exact = side * side * z / PI;
        let mut got = 0.0;
        for face in Face::ALL {
            let (width, height) = face.size(resolution);
            cells.reset(width, height);
            cells.draw(&face.view(DVec3::ZERO, &frame), &polygon, 0);
            let seen = cells.pixels().zip(weights.of(face));
            got +=
                seen.filter(|(s, _)| *s == Seen::Front(0)).map(|(_, w)| w).sum::<f64>();
        }
        squares += (got / exact - 1.0).powi(2);
        missed += f64::from(u8::from(got == 0.0));
    }
    ((squares / places as f64).sqrt(), missed / places as f64)
}

/// Failure 20: one cell of the top is so heavy that shooting through it at a tiny
/// element sends more than there is: `F_ji = F_ij A_i/A_j > 1` once `A_i/A_j` exceeds
/// `1/ΔF`.
#[test]
fn one_cell_limits_the_ratio_of_areas() {
    for (resolution, ratio) in [(32, 804.0), (64, 3217.0), (256, 51_472.0)] {
        let weights = Weights::exact(resolution);
        let heaviest = weights.of(Face::Top).iter().copied().fold(0.0, f64::max);
        // over a cell of width h at the zenith, 1/(x² + y² + 1)² falls by 4h²/3 in the
        // mean
        let tolerance = 6.0 / f64::from(resolution).powi(2) + 3e-4;
        assert!((1.0 / heaviest / ratio - 1.0).abs() < tolerance, "{resolution}");
    }
}

/// Failure 22: lamps in a row along the cells beat with them; turned hemicubes spread
/// the same error as noise over the receivers.
#[test]
fn turning_breaks_the_beat() {
    let lamps: Vec<Polygon> =
        (0..38).map(|k| lid(0.03, dvec3(0.05 * k as f64 - 0.925, 0.0, 1.0))).collect();
    let mesh = mesh_of(lamps, 1.0);
    let total = |cube: &Hemicube, y: f64| {
        let mut row = vec![0.0; mesh.elements.len()];
        cube.at(dvec3(0.0, y, 0.0), DVec3::Z, &mut row);
        row.iter().sum::<f64>()
    };
    let straight = Hemicube::new(&mesh, 40);
    let turned = Hemicube::new(&mesh, 40).turned(1);
    let sums = |cube: &Hemicube| -> Vec<f64> {
        (0..40).map(|k| total(cube, 0.001 * k as f64)).collect()
    };
    // Straight, all lamps cross a line of cells together: a step of the whole row.
    let (straight, turned) = (sums(&straight), sums(&turned));
    let spread = |sums: &[f64]| {
        let mean = sums.iter().sum::<f64>() / sums.len() as f64;
        let squares = sums.iter().map(|s| (s / mean - 1.0).powi(2)).sum::<f64>();
        (squares / sums.len() as f64).sqrt()
    };
    assert!(spread(&straight) > 1.5 * spread(&turned), "{straight:?} {turned:?}");
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
