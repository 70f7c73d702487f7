//! A ledger that shows a failure: light that factors make of nothing.

use crate::ledger;
use radiosity::field::Classical;
use radiosity::field::Factors;
use radiosity::field::MatrixSolver;
use radiosity::mesh::Mesh;
use radiosity::room::Room;
use radiosity::scene::built_in;
use radiosity::solution::Goal;
use radiosity::solution::solve_on;
use radiosity::work::Work;

/// The closed L-shaped room in coarse elements, by hemicubes at their centres.
pub fn markdown() -> String {
    let scene = built_in("l-room").expect("the scene is built in");
    let mesh = Mesh::uniform(&scene, 1.0);
    let count = mesh.elements.len();
    let factors = Factors::Hemicube(64);
    let method = Classical { solver: MatrixSolver::Gather, ..Classical::by(factors) };
    let solution =
        solve_on(&Room::of(&scene), &method, mesh, &Goal::default(), &Work::quiet())
            .unwrap();
    format!(
        "The closed room `l-room` in {count} elements, with hemicubes of resolution 64 \
         (row 15):\n\n{}",
        ledger::table(&solution)
    )
}
