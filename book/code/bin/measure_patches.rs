//! Measures the chart of the chapter *Patches and elements*: error over elements, split all
//! over and split where the oracle says. No times: any machine will do.
//!
//! `cargo run --release -p book --bin measure-patches > book/data/patches-DATE.csv`. Takes two
//! minutes.

use book::patches::rounds::{Splits, run};
use radiosity::geometry::Rgb;
use radiosity::mesh::{ElementId, Mesh};
use radiosity::scene::{Scene, built_in};
use radiosity::solve::{Sampling, certify};

/// Points of each certificate: enough for two digits.
const POINTS: usize = 10_000;

fn error(scene: &Scene, mesh: &Mesh, radiosity: &[Rgb]) -> f64 {
    let vertices = mesh.vertex_values(radiosity);
    let field = |id: ElementId, x| mesh.value_at(mesh.element(id), x, &vertices);
    let sampling = Sampling { points: POINTS, ..Sampling::default() };
    certify(scene, mesh, &field, sampling).error
}

fn main() {
    println!("method,setting,elements,error,patches,factors");
    for (name, short) in [("cornell", "box"), ("indirect-room", "indirect")] {
        let scene = built_in(name).expect("the scene is built in");
        for (splits, how, rounds) in
            [(Splits::All, "all", 4), (Splits::Marked, "marked", 5)]
        {
            for round in run(&scene, splits, rounds) {
                let (mesh, n) = (&round.mesh, round.mesh.elements.len());
                let error = error(&scene, mesh, &round.light.radiosity);
                let (patches, factors) = (mesh.patches.len(), round.factors);
                println!("{short} {how},{n},{n},{error:.4},{patches},{factors}");
            }
        }
    }
}
