//! Measures the chart of the chapter *The pipeline*: what each stage takes.
//!
//! `RAYON_NUM_THREADS=1 cargo run --release -p book --bin measure-pipeline >
//! book/data/pipeline-DATE.csv`, on Linux. Takes about a minute. Times are processor
//! time, so that other programs hardly matter.

use radiosity::film::Shot;
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use radiosity::solve::{Enclosure, GaussSeidel, Solver};
use std::fs;
use std::hint::black_box;

/// Longest edges of the elements, in metres.
const EDGES: [f64; 6] = [0.3, 0.15, 0.1, 0.05, 0.035, 0.025];

/// The solver stops when its own error is below this.
const ACCURACY: f64 = 1e-3;

fn main() {
    let scene = built_in("cornell").expect("`cornell` is built in");
    println!("stage,setting,elements,milliseconds,megabytes");
    for edge in EDGES {
        let (mesh, split) = timed(|| Mesh::uniform(&scene, edge));
        let n = mesh.elements.len();
        let say = |stage: &str, milliseconds: f64, megabytes: f64| {
            println!("{stage},{n},{n},{milliseconds:.3e},{megabytes:.3}");
        };
        say("split", split, 0.0);
        let enclosure = Enclosure::of(&scene, &mesh);
        let cube = Hemicube::new(&mesh, 256);
        let (matrix, factors) = timed(|| cube.matrix(&|| ()));
        let kept: usize = matrix.rows().iter().map(|row| row.factors().len()).sum();
        let megabytes = kept as f64 * size_of::<(u32, f64)>() as f64 / 1e6;
        say("form factors", factors, megabytes);
        let contraction = enclosure.largest_reflectance().max_element();
        let (radiosity, solve) = timed(|| {
            let mut solver = GaussSeidel::new(&enclosure, &matrix);
            solver.run(contraction, ACCURACY, 1000);
            solver.radiosity().to_vec()
        });
        say("solve", solve, 0.0);
        let shot = Shot { camera: scene.camera, width: 512, height: 512, samples: 1 };
        let (_, render) = timed(|| shot.smooth(&mesh, &mesh.vertex_values(&radiosity)));
        say("render", render, 0.0);
    }
}

/// The kernel counts in steps of some ms: calls are repeated for as long as this, in
/// ms.
const ROUND: f64 = 400.0;

/// What `make` makes, and the processor time of a call in ms.
fn timed<T>(make: impl Fn() -> T) -> (T, f64) {
    let start = processor();
    let mut made = black_box(make());
    let mut calls = 1;
    while processor() - start < ROUND {
        made = black_box(make());
        calls += 1;
    }
    (made, (processor() - start) / f64::from(calls))
}

/// Processor time of all threads so far, in ms, as the kernel counts it.
fn processor() -> f64 {
    let tasks = fs::read_dir("/proc/self/task").expect("Linux");
    let spent = |task: std::io::Result<fs::DirEntry>| {
        let file = task.ok()?.path().join("schedstat");
        let text = fs::read_to_string(file).ok()?;
        text.split_whitespace().next()?.parse::<f64>().ok()
    };
    tasks.filter_map(spent).sum::<f64>() / 1e6
}
