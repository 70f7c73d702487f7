//! Failures of whole matrices of factors: rows 15 to 17; and matrices of a rule for pairs.

use super::rooms::{
    box_walls, exact_factors, gathered, rectangle, rows as all_rows, scene,
};
use super::{Found, Row, Shown, Sweep, curve};
use glam::{DVec3, dvec3};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::form_factor::cast::Cast;

use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::named::parallel_rectangles;
use radiosity::form_factor::shortcuts::point_to_point;
use radiosity::form_factor::{FormFactors, Lost, Matrix, Row as OfMatrix, close};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::mesh::Mesh;
use radiosity::scene::Scene;
use radiosity::solve::{Enclosure, GaussSeidel, Ledger};

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 15,
        name: "Rows that balance, pairs that do not",
        why: "Factors from centres sum to one and are not reciprocal: large elements send \
              small ones more than these get back.",
        size: "A small lamp in a cube makes 57, 13 and 3.4 % of its light out of nothing \
               with 1, 2 and 4 elements a wall.",
        remedy: "Compute A·F once for each pair, and use it both ways.",
        tests: &["form_factors::row_15_gathering_from_centres_invents_light"],
        shown: Shown::Curve(invented),
    },
    Row {
        number: 16,
        name: "Repair that hides",
        why: "Rows that are divided by their sum look right, whatever is in them.",
        size: "The books balance to rounding, and 6 to 9 % of the reflected light is wrong; \
               as much when the pairs are made reciprocal, too.",
        remedy: "Test a factor that is known, not the sum of a row.",
        tests: &["form_factors::row_16_normalising_hides_the_error"],
        shown: Shown::Curve(hidden),
    },
    Row {
        number: 17,
        name: "Closing what is open",
        why: "A row of an open scene must sum to less than one: the rest leaves.",
        size: "From a box without a lid 20 % of the floor's light leaves at height 1; after \
               the repair none does.",
        remedy: "Count what leaves, by rays or empty cells; never as 1 − ΣF.",
        tests: &["form_factors::row_17_normalising_an_open_scene_closes_it"],
        shown: Shown::Curve(closed_up),
    },
];

/// A cube whose top emits, `k × k` elements a wall.
pub fn lit_cube(k: usize, rho: f64) -> (Mesh, Enclosure) {
    let emission = |wall: usize| f64::from(u8::from(wall == 5));
    let walls = box_walls([1.0; 3]).into_iter().enumerate();
    let scene = scene(walls.map(|(w, wall)| (wall, emission(w), rho)));
    let mesh = Mesh::uniform(&scene, 1.0 / k as f64);
    let enclosure = Enclosure::of(&scene, &mesh);
    (mesh, enclosure)
}

/// The matrix of a rule for pairs of elements of different walls.
pub fn by_rule(mesh: &Mesh, rule: impl Fn(&Polygon, &Polygon) -> f64) -> Vec<Vec<f64>> {
    let row = |i: usize| {
        let of = |j: usize| {
            let (a, b) = (&mesh.elements[i], &mesh.elements[j]);
            if a.patch == b.patch { 0.0 } else { rule(&a.polygon, &b.polygon) }
        };
        (0..mesh.elements.len()).map(of).collect()
    };
    (0..mesh.elements.len()).map(row).collect()
}

/// A matrix from which nothing is lost.
pub fn closed(rows: &[Vec<f64>]) -> Matrix {
    let row = |row: &Vec<f64>| OfMatrix::of(row, Lost::default());
    Matrix::from_rows(rows.iter().map(row).collect())
}

/// The factor from the middle of one polygon to all of another.
pub fn from_centre(i: &Polygon, j: &Polygon) -> f64 {
    lambert_polygon(i.centroid(), i.normal(), j)
}

/// The largest eigenvalue of a matrix that has no negative entry.
pub fn spectral_radius(rows: &[Vec<f64>]) -> f64 {
    let mut x = vec![1.0; rows.len()];
    let mut radius = 0.0;
    for _ in 0..200 {
        let times = |row: &Vec<f64>| row.iter().zip(&x).map(|(f, x)| f * x).sum();
        let y: Vec<f64> = rows.iter().map(times).collect();
        radius = y.iter().copied().fold(0.0, f64::max);
        x = y.iter().map(|y| y / radius).collect();
    }
    radius
}

/// The wrong repair: each row divided by its sum.
pub fn normalised(mut rows: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    for row in &mut rows {
        let sum: f64 = row.iter().sum();
        row.iter_mut().for_each(|f| *f /= sum);
    }
    rows
}

/// The books after so many sweeps.
pub fn ledger(enclosure: &Enclosure, matrix: &Matrix, sweeps: usize) -> Ledger {
    let mut solver = GaussSeidel::new(enclosure, matrix);
    solver.nth(sweeps).expect("a solver goes on").ledger
}

/// A small lamp in the ceiling of a cube, `k × k` elements a wall.
pub fn cube_with_a_lamp(k: f64) -> (Mesh, Enclosure) {
    let lamp = rectangle(dvec3(0.4, 0.4, 1.0), DVec3::Y * 0.2, DVec3::X * 0.2);
    let walls = box_walls([1.0; 3]).map(|wall| (wall, 0.0, 0.5));
    let scene = scene(walls.into_iter().chain([(lamp, 1.0, 0.5)]));
    let mesh = Mesh::uniform(&scene, 1.0 / k);
    let enclosure = Enclosure::of(&scene, &mesh);
    (mesh, enclosure)
}

/// Row 15.
pub fn invented() -> Sweep {
    let by = |k: f64, matrix: &dyn Fn(&Mesh) -> Matrix| {
        let (mesh, enclosure) = cube_with_a_lamp(k);
        let books = ledger(&enclosure, &matrix(&mesh), 60);
        -100.0 * books.imbalance.x / books.emitted.x
    };
    let (few, all) = ([1.0, 2.0, 4.0], [1.0, 2.0, 3.0, 4.0, 6.0]);
    let centres = |mesh: &Mesh| closed(&by_rule(mesh, from_centre));
    let cubes = |mesh: &Mesh| Hemicube::new(mesh, 256).matrix(&|| ());
    Sweep {
        knob: "elements along a wall",
        quantity: "light made of nothing, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("centres", &all, |k| by(k, &centres)),
            Found::over("hemicubes of 256", &few, |k| by(k, &cubes)),
            Found::over("reciprocal factors", &few, |k| by(k, &exact_factors)),
        ],
        theory: curve(&all, |k| 54.0 / (k * k)),
        law: "a quarter with each halving",
    }
}

/// The error of a solution against that by exact factors, relative to reflected light.
pub fn error(enclosure: &Enclosure, got: &[Rgb], exact: &[Rgb]) -> f64 {
    let off = enclosure.norm_squared(got.iter().zip(exact).map(|(&a, &b)| a - b)).x;
    let emission = enclosure.emission.iter();
    let light =
        enclosure.norm_squared(exact.iter().zip(emission).map(|(&b, &e)| b - e)).x;
    (off / light).sqrt()
}

/// The error in a lit cube with ρ = ½ of point factors after a repair.
pub fn repaired(k: usize, repair: impl Fn(&Mesh, Vec<Vec<f64>>) -> Matrix) -> f64 {
    let (mesh, enclosure) = lit_cube(k, 0.5);
    let matrix = repair(&mesh, by_rule(&mesh, point_to_point));
    let got = gathered(&enclosure, &matrix, 1e-9, 1000);
    let exact = gathered(&enclosure, &exact_factors(&mesh), 1e-9, 1000);
    error(&enclosure, &got, &exact)
}

/// Rows that sum to one, and pairs that are reciprocal.
pub fn reciprocal_too(mesh: &Mesh, rows: Vec<Vec<f64>>) -> Matrix {
    let areas: Vec<f64> = mesh.polygons().map(Polygon::area).collect();
    let sparse = |row: Vec<f64>| (0..).zip(row).filter(|f| f.1 > 0.0).collect();
    let mut rows: Vec<Vec<(u32, f64)>> = rows.into_iter().map(sparse).collect();
    close(&mut rows, &areas);
    let row = |factors| OfMatrix::new(factors, Lost::default());
    Matrix::from_rows(rows.into_iter().map(row).collect())
}

/// Row 16.
pub fn hidden() -> Sweep {
    let knobs = [2.0, 3.0, 4.0, 5.0];
    let by_rows = |_: &Mesh, rows: Vec<Vec<f64>>| closed(&normalised(rows));
    Sweep {
        knob: "elements along a wall",
        quantity: "error of the reflected light, %",
        logarithmic: [false, false],
        found: vec![
            Found::over("rows made to sum to 1", &knobs, |k| {
                100.0 * repaired(k as usize, by_rows)
            }),
            Found::over("and made reciprocal", &knobs, |k| {
                100.0 * repaired(k as usize, reciprocal_too)
            }),
        ],
        theory: curve(&knobs, |_| 0.0),
        law: "what the sums of the rows show of it: nothing",
    }
}

/// A box without a lid whose floor emits, other walls with this reflectance.
pub fn lidless(height: f64, rho: f64) -> Scene {
    let mut walls = box_walls([1.0, 1.0, height]).map(|wall| (wall, 0.0, rho)).to_vec();
    walls[4].1 = 1.0; // the floor emits
    walls.pop(); // and the ceiling is missing
    scene(walls)
}

/// A matrix whose rows sum to one, losses and all.
pub fn shut(matrix: &Matrix) -> Matrix {
    closed(&normalised(all_rows(matrix).into_iter().map(|row| row.0).collect()))
}

/// Row 17.
pub fn closed_up() -> Sweep {
    let leaves = |height: f64, repair: &dyn Fn(Matrix) -> Matrix| {
        let scene = lidless(height, 0.0);
        let mesh = Mesh::whole(&scene);
        let enclosure = Enclosure::of(&scene, &mesh);
        let matrix = repair(Cast::new(&mesh, 8000, 17).matrix(&|| ()));
        let books = ledger(&enclosure, &matrix, 2);
        100.0 * books.escaped.x / books.emitted.x
    };
    let knobs = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0];
    Sweep {
        knob: "height of the box / side",
        quantity: "light that leaves, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("rows made to sum to 1", &knobs, |h| leaves(h, &|m| shut(&m))),
            Found::over("rows as they are", &knobs, |h| leaves(h, &|m| m)),
        ],
        theory: curve(&knobs, |h| 100.0 * parallel_rectangles(1.0, 1.0, h)),
        law: "closed form from the floor to the missing lid",
    }
}
