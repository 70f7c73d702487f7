//! A ledger that shows a failure: light that factors make of nothing.

use crate::ledger;
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use radiosity::solution::{Factors, Method, Options, solve_on};

/// The closed L-shaped room in coarse elements, by hemicubes at their centres.
pub fn markdown() -> String {
    let scene = built_in("l-room").expect("the scene is built in");
    let mesh = Mesh::uniform(&scene, 1.0);
    let count = mesh.elements.len();
    let factors = Factors::Hemicube(64);
    let options = Options { method: Method::Gather, factors, ..Options::default() };
    let solution = solve_on(&scene, mesh, &options, &|_, _, _| {});
    format!(
        "The closed room `l-room` in {count} elements, with hemicubes of resolution 64 \
         (row 15):\n\n{}",
        ledger::table(&solution)
    )
}
