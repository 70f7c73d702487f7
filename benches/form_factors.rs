//! Form factors: time beside error. `cargo bench --bench form_factors` prints the record.
//!
//! Everything runs on one thread, so that a time is a CPU time. Errors are against the
//! same method asked for more digits; its agreement with published values is tested in
//! `tests/tables_*.rs`. A false zero is a factor above 1e-6 that was found to be 0.

use radiosity::form_factor::analytic::{Analytic, exchange};
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::hybrid::Hybrid;
use radiosity::form_factor::pictures::Pictures;
use radiosity::form_factor::{Accuracy, FormFactors, Matrix};
use radiosity::geometry::Polygon;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::prelude::*;
use radiosity::scene::{Face, MaterialId, Scene, built_in};
use std::hint::black_box;
use std::time::Instant;

fn main() {
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    one.install(|| {
        pairs();
        matrices(
            "open cube",
            &open_cube(11),
            &[1e-4, 1e-5, 1e-6, 1e-8],
            Accuracy::Best,
        );
        matrices(
            "Cornell room, tiled",
            &tiled("cornell-regular", 1700.0),
            &[1e-4, 3e-5, 1e-5],
            Accuracy::Absolute(1e-7),
        );
        hemicubes();
        scaling("furnace");
        scaling("cornell-regular");
    });
}

/// Seconds of the fastest of several runs.
fn fastest(runs: usize, mut work: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..runs).map(time).fold(f64::INFINITY, f64::min)
}

fn square(z: f64, up: bool) -> Polygon {
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let square =
        Polygon::new(corners.map(|(x, y)| dvec3(x, y, z)).to_vec()).expect("a square");
    if up { square } else { square.flipped() }
}

fn pairs() {
    println!("one pair of unit squares, face to face, at 1e-10");
    for distance in [0.1, 1.0, 2.0, 5.0, 20.0] {
        let (a, b) = (square(0.0, true), square(distance, false));
        let best = exchange(&a, &b, Accuracy::Best);
        let error = (exchange(&a, &b, 1e-10) - best).abs();
        let many = 2000;
        let seconds = fastest(5, || {
            (0..many).for_each(|_| {
                black_box(exchange(black_box(&a), black_box(&b), 1e-10));
            });
        });
        let micro = 1e6 * seconds / many as f64;
        println!("  distance {distance:5}: {micro:7.2} µs, error {error:.1e}");
    }
}

/// Every element of an even mesh as a face of its own.
fn tiles(scene: &Scene, max_edge: f64) -> Scene {
    let mesh = Mesh::uniform(scene, max_edge);
    let face = |e: &radiosity::mesh::Element| Face {
        outline: e.polygon.vertices().to_vec(),
        material: MaterialId(0),
    };
    let faces = mesh.elements.iter().map(face).collect();
    let materials = scene.materials.clone();
    Scene::assemble("tiles", materials, faces, None).expect("elements are fit").0
}

fn tiled(name: &str, faces: f64) -> Scene {
    let scene = built_in(name).expect("a built-in scene");
    let area: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
    tiles(&scene, (area / faces).sqrt())
}

fn open_cube(cells: u32) -> Scene {
    let cube = built_in("furnace").expect("a built-in scene");
    let five = cube.faces[..5].to_vec();
    let cube = Scene::assemble("open cube", cube.materials, five, None).expect("fit").0;
    tiles(&cube, 1.0 / cells as f64)
}

fn dense(matrix: &Matrix) -> Vec<f64> {
    let n = matrix.rows().len();
    let mut dense = vec![0.0; n * n];
    for (row, i) in matrix.rows().iter().zip(0..) {
        row.factors().iter().for_each(|&(j, f)| dense[i * n + j as usize] = f);
    }
    dense
}

fn matrices(what: &str, scene: &Scene, tolerances: &[f64], reference: Accuracy) {
    let mesh = Mesh::whole(scene);
    let matrix = |accuracy: Accuracy| {
        Analytic::new(scene, &mesh, accuracy, 0).without_losses().matrix(&|| {})
    };
    let best = dense(&matrix(reference));
    let n = mesh.elements.len();
    println!("{what}, {n} faces; errors against the method at {reference:?}");
    for &tolerance in tolerances {
        let mut found = Matrix::default();
        let seconds = fastest(3, || found = matrix(tolerance.into()));
        let found = dense(&found);
        let pairs = || found.iter().zip(&best);
        let square: f64 = pairs().map(|(a, b)| (a - b).powi(2)).sum();
        let norm: f64 = best.iter().map(|b| b * b).sum();
        let largest = pairs().map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let false_zeros = pairs().filter(|(a, b)| **a == 0.0 && **b > 1e-6).count();
        println!(
            "  asked {tolerance:.0e}: {seconds:7.3} s, rms {:.1e}, relative Frobenius {:.1e}, \
             largest {largest:.1e}, false zeros {false_zeros}",
            (square / (n * n) as f64).sqrt(),
            (square / norm).sqrt(),
        );
    }
}

/// The hemicube and its cousins, with cells of one size at the zenith; and with exact
/// factors where their assumptions break. Root mean square and largest error of a factor.
fn hemicubes() {
    let scene = tiled("cornell-regular", 1800.0);
    let mesh = Mesh::whole(&scene);
    let n = mesh.elements.len();
    let ids: Vec<u32> = (0..n as u32).step_by(n / 50).collect();
    let rows = |method: &dyn FormFactors| {
        let mut row = vec![0.0; n];
        let mut all = Vec::new();
        let start = Instant::now();
        for &i in &ids {
            method.row(ElementId(i), &mut row);
            all.push(row.clone());
        }
        (all, start.elapsed().as_secs_f64())
    };
    let exact =
        rows(&Analytic::new(&scene, &mesh, 1e-6, 1).without_losses()).0.concat();
    println!("one row by pictures in a room of {n} elements");
    for resolution in [64, 256, 1024] {
        let methods: [(String, Box<dyn FormFactors>); 5] = [
            ("hemicube".into(), Box::new(Hemicube::new(&mesh, resolution).turned(1))),
            (
                "tetrahedron".into(),
                Box::new(Pictures::tetrahedron(&mesh, 3 * resolution / 2).turned(1)),
            ),
            (
                "plane to 4".into(),
                Box::new(Pictures::single_plane(&mesh, 4 * resolution, 4.0).turned(1)),
            ),
            (
                "hybrid 1e-2".into(),
                Box::new(Hybrid::new(&scene, &mesh, resolution, 1e-2, 1)),
            ),
            (
                "hybrid 1e-3".into(),
                Box::new(Hybrid::new(&scene, &mesh, resolution, 1e-3, 1)),
            ),
        ];
        for (name, method) in methods {
            let mut found = Vec::new();
            let seconds = fastest(3, || found = rows(&*method).0.concat());
            let milli = 1e3 * seconds / ids.len() as f64;
            let off = || found.iter().zip(&exact).map(|(a, b)| (a - b).abs());
            let rms = (off().map(|e| e * e).sum::<f64>() / found.len() as f64).sqrt();
            let worst = off().fold(0.0, f64::max);
            println!(
                "  {name:12} {resolution:4}: {milli:6.2} ms, error {rms:.1e}, at most \
                 {worst:.1e}"
            );
        }
    }
}

/// Time per row of the analytic method as a scene is tiled ever more finely.
fn scaling(name: &str) {
    println!("{name}: time per row, asked 1e-5, rows sampled");
    for faces in [100.0, 300.0, 1000.0, 3000.0, 10_000.0, 30_000.0] {
        let scene = tiled(name, faces);
        let mesh = Mesh::whole(&scene);
        let method = Analytic::new(&scene, &mesh, 1e-5, 0).without_losses();
        let n = mesh.elements.len();
        let rows: Vec<u32> = (0..n as u32).step_by((n / 40).max(1)).collect();
        let mut row = vec![0.0; n];
        let seconds = fastest(1, || {
            rows.iter().for_each(|&i| {
                method.row(ElementId(i), &mut row);
            });
        });
        let milli = 1e3 * seconds / rows.len() as f64;
        let scaled = 1e6 * milli / (n as f64 * (n as f64).ln());
        println!("  {n:6} faces: {milli:8.3} ms a row, {scaled:6.1} ns × n ln n");
    }
}
