//! The energy ledger of the chapter's scene, solved with hemicubes.

use crate::ledger::table;
use radiosity::field::Classical;
use radiosity::field::Factors;
use radiosity::field::MatrixSolver;
use radiosity::mesh::Mesh;
use radiosity::room::Room;
use radiosity::scene::built_in;
use radiosity::solution::Goal;
use radiosity::solution::{Solution, solve_on};
use radiosity::solve::Ledger;
use radiosity::work::Work;

/// A scene solved by gathering, with factors of this kind and elements of this edge.
fn solved(name: &str, max_edge: f64, factors: Factors) -> Solution {
    let scene = built_in(name).expect("the scene is built in");
    let mesh = Mesh::uniform(&scene, max_edge);
    let method = Classical { solver: MatrixSolver::Gather, ..Classical::by(factors) };
    solve_on(&Room::of(&scene), &method, mesh, &Goal::default(), &Work::quiet())
        .unwrap()
}

/// The ledger as a Markdown table.
pub fn markdown() -> String {
    let solution = solved("cornell", 0.1, Factors::Hemicube(64));
    let mut text = format!(
        "`cornell`, {} elements (edges ≤ 0.1 m), hemicubes of resolution 64, \
         gathered in {} sweeps:\n\n",
        solution.field.mesh.elements.len(),
        solution.field.steps
    );
    text.push_str(&table(&solution));
    text.push_str(
        "\nThe imbalance alone, in the closed room `l-room` (edges ≤ 0.5 m):\n\n\
         | factors | imbalance |\n|---|---|\n",
    );
    for (name, factors) in [
        ("hemicube, resolution 64", Factors::Hemicube(64)),
        ("hemicube, resolution 256", Factors::Hemicube(256)),
        ("rays, 10 000 from each element", Factors::Sampling(10_000)),
        ("analytic", Factors::Analytic),
    ] {
        let Ledger { emitted, imbalance, .. } =
            solved("l-room", 0.5, factors).field.ledger;
        let share = 100.0 * imbalance.element_sum() / emitted.element_sum();
        text.push_str(&format!("| {name} | {share:.2} % |\n"));
    }
    text
}
