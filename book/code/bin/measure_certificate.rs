//! Measures the chart of the chapter *How wrong is it?*: width of the interval and CPU time.
//!
//! `RAYON_NUM_THREADS=1 cargo run --release -p book --bin measure-certificate >
//! book/data/certificate-DATE.csv`. Takes about a minute.

use radiosity::mesh::{ElementId, Mesh};
use radiosity::scene::built_in;
use radiosity::solve::{Factors, Options, Sampling, certify, solve_on};

/// Runs of each setting; the times are their means.
const RUNS: u64 = 6;

/// CPU time of this process so far, in s, as Linux counts it, in steps of 10 ms.
fn cpu_seconds() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // After the name in brackets: user and system time are the 12th and 13th.
    let fields = stat.rsplit(')').next().unwrap_or_default().split_whitespace();
    let ticks = fields.skip(11).take(2).filter_map(|field| field.parse::<f64>().ok());
    ticks.sum::<f64>() / 100.0
}

fn main() {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let mesh = Mesh::uniform(&scene, 0.05);
    let options = Options { factors: Factors::Hemicube(128), ..Options::default() };
    let solution = solve_on(&scene, mesh, &options, &|_, _, _| ());
    let mesh = &solution.mesh;
    let field = |id: ElementId, x| {
        mesh.value_at(mesh.element(id), x, &solution.vertex_radiosity)
    };
    println!("method,setting,milliseconds,max_error,reference");
    for rays in [16, 64, 256] {
        for points in [800, 3200, 12_800] {
            let (start, mut width) = (cpu_seconds(), 0.0);
            for seed in 0..RUNS {
                let sampling = Sampling { points, rays, seed };
                let c = certify(&scene, mesh, &field, sampling);
                width += 0.5 * (c.high - c.low) / c.error / RUNS as f64;
            }
            let time = 1e3 * (cpu_seconds() - start) / RUNS as f64;
            println!("{rays} rays,{points},{time:.3e},{width:.3e},itself");
        }
    }
}
