//! Measures the chart of the chapter *What does this scene need?*: error asked for, error
//! given, and work.
//!
//! `RAYON_NUM_THREADS=1 cargo run --release -p book --bin measure-plan >
//! book/data/plan-DATE.csv`, on Linux. Takes some minutes. Times are processor time of one
//! thread, so that other programs hardly matter.

use book::timing::cpu_milliseconds_of_all as processor;
use radiosity::plan::Plan;
use radiosity::scene::built_in;
use radiosity::solve::Ask;

/// Errors asked for.
const TOLERANCES: [f64; 5] = [0.1, 0.05, 0.02, 0.01, 0.005];

fn main() {
    println!(
        "scene,asked,milliseconds,at_most,likely,passes,patches,hemicubes,elements"
    );
    for name in ["cornell", "l-room", "indirect-room"] {
        let scene = built_in(name).expect("it is built in");
        for tolerance in TOLERANCES {
            let start = processor();
            let plan = Plan::of(&scene, tolerance);
            let done = plan.run(&Ask::default(), &|_, _, _| {});
            let milliseconds = processor() - start;
            let light = &done.solution;
            let hemicubes: usize = done.passes.iter().map(|p| p.hemicubes).sum();
            println!(
                "{name},{} %,{milliseconds:.0},{:.5},{:.5},{},{},{hemicubes},{}",
                100.0 * tolerance,
                light.certificate.high,
                light.certificate.error,
                done.passes.len(),
                light.patches,
                light.mesh.elements.len(),
            );
        }
    }
}
