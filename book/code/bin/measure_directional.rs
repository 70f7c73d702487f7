//! Measures the charts of *Why not specular radiosity?*: how patches times bins grow, and
//! what is gained by it, beside path tracing of the same view.
//!
//! `cargo run -p book --bin measure-directional > book/data/directional-DATE.csv`.
//! CPU time of one thread, so that it matters little what else the machine does; the crate
//! itself is optimised in every profile. Counts and errors are the same on every machine.
//! Takes some minutes.

use book::directional::{Tiny, error, scene, shot};
use book::timing::cpu_milliseconds;
use radiosity::film::Picture;
use radiosity::solve::{Ask, automatic, resolution_for};
use radiosity::trace::{Options, PathTracer, TwoPass};

/// Longest edges of the patches, in metres.
const EDGES: [f64; 3] = [0.5, 0.25, 0.125];

/// Bins along an edge of the chessboard.
const SIDES: [u32; 5] = [1, 2, 4, 8, 16];

/// Rays from each beam.
const RAYS: usize = 200;

/// Paths for each pixel of what is compared with, and of what is measured.
const TRUTH: usize = 4000;
const PATHS: [usize; 5] = [2, 8, 32, 128, 512];

/// Bytes of a colour, and of a stored pair of beams.
const COLOUR: usize = size_of::<radiosity::geometry::Rgb>();
const PAIR: usize = size_of::<(u32, f64)>();

/// Milliseconds of one call: the mean of as many as fill [`LONG_ENOUGH`].
fn time(call: &dyn Fn() -> usize) -> f64 {
    let start = cpu_milliseconds();
    let mut calls = 0;
    while cpu_milliseconds() - start < LONG_ENOUGH {
        std::hint::black_box(call());
        calls += 1;
    }
    (cpu_milliseconds() - start) / f64::from(calls)
}

/// Milliseconds; the system's clock of a thread is right to a few.
const LONG_ENOUGH: f64 = 200.0;

fn by_bins(truth: &Picture) {
    for (edge, side) in EDGES.into_iter().flat_map(|e| SIDES.map(|s| (e, s))) {
        let tiny = Tiny::new(edge, side, RAYS);
        let before = time(&|| Tiny::new(edge, side, RAYS).transport.pairs());
        let (light, bounces, _) = tiny.solve();
        let solve = time(&|| tiny.solve().1);
        let (n, m) = (tiny.mesh.elements.len(), tiny.transport.bins().len());
        let (unknowns, pairs) = (n * m, tiny.transport.pairs());
        // What leaves, what arrives, what leaves next; the shares; the paints.
        let kept = 3 * COLOUR * unknowns + PAIR * pairs;
        let bytes = kept + COLOUR * m * m * tiny.scene.materials.len();
        let off = error(&tiny.picture(&light, &shot(3)), truth);
        println!(
            "bins,{n},{m},{unknowns},{pairs},{bytes},{},{before:.2},{:.3},{off:.4}",
            unknowns * RAYS,
            solve / bounces as f64,
        );
    }
}

fn by_paths(truth: &Picture) {
    let scene = scene();
    let tracer = PathTracer::of(&scene);
    for paths in PATHS {
        let start = cpu_milliseconds();
        let found = tracer.picture(&shot(1), paths, 1, &|_, _, _| {});
        let spent = cpu_milliseconds() - start;
        let off = error(&found.picture, truth);
        println!("paths,0,{paths},0,0,0,0,{spent:.1},0,{off:.4}");
    }
}

/// Radiosity for the diffuse light, to this error, and rays for the gloss.
fn by_two_passes(truth: &Picture) {
    let scene = scene();
    for tolerance in [0.05, 0.02, 0.01] {
        let start = cpu_milliseconds();
        let ask = Ask { tolerance, ..Ask::default() };
        let first = resolution_for(&scene, tolerance);
        let (solution, _) = automatic(&scene, first, &ask, &|_, _, _| {});
        let light = &solution.vertex_radiosity;
        let second = TwoPass::of(&scene, &solution.mesh, light, Options::default());
        let solved = cpu_milliseconds();
        let picture = second.picture(&shot(2), &|_, _, _| {}).picture;
        let seen = cpu_milliseconds();
        println!(
            "two-pass,{},{},{},0,0,0,{:.1},{:.2},{:.4}",
            solution.patches,
            100.0 * tolerance,
            solution.mesh.elements.len(),
            seen - start,
            seen - solved,
            error(&picture, truth)
        );
    }
}

type Measure = fn(&Picture);

/// All that is measured; the first argument may name one that is to be measured alone.
const METHODS: [(&str, Measure); 3] =
    [("bins", by_bins), ("paths", by_paths), ("two-pass", by_two_passes)];

fn main() {
    let only = std::env::args().nth(1);
    let asked = |method: &str| only.as_deref().is_none_or(|only| only == method);
    let scene = scene();
    let truth = PathTracer::of(&scene).picture(&shot(1), TRUTH, 0, &|_, _, _| {});
    println!("method,patches,bins,unknowns,pairs,bytes,rays,before_ms,bounce_ms,error");
    // All on this one thread, so that its clock tells the whole of it.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.expect("one thread is not too many").install(|| {
        for (method, measure) in METHODS {
            if asked(method) {
                measure(&truth.picture);
            }
        }
    });
}
