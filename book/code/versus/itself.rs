//! A chart that lies: a method held against its own finest run.

use crate::chart::{self, Point};
use radiosity::chart::suites::form_factors::{Pair, TOUCHING};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::mesh::{ElementId, Mesh};

/// Cells along an edge of the hemicubes; the last is taken for the truth.
pub const CELLS: [u32; 6] = [8, 16, 32, 64, 128, 1024];

/// The factor between two squares with a common edge, by one hemicube.
pub fn factor(pair: &Pair, cells: u32) -> f64 {
    let mesh = Mesh::whole(pair.scene());
    let mut row = [0.0; 2];
    Hemicube::new(&mesh, cells).row(ElementId(0), &mut row);
    row[1]
}

/// Cells, the error against the finest run, and the true one.
pub fn errors() -> Vec<(u32, f64, f64)> {
    let pair = Pair::named(TOUCHING).expect("the pair has a name");
    let [.., finest] = CELLS.map(|cells| factor(&pair, cells));
    let [rest @ .., _] = CELLS;
    let off = |cells: u32| {
        let f = factor(&pair, cells);
        (cells, (f / finest - 1.0).abs(), (f / pair.exact() - 1.0).abs())
    };
    rest.map(off).into()
}

/// Both errors over the number of cells.
pub fn svg() -> String {
    let point = |method: &str, cells: u32, error| Point {
        method: method.into(),
        setting: String::new(),
        milliseconds: f64::from(cells),
        error,
    };
    let errors = errors();
    let own = errors.iter().map(|e| point("against its finest run", e.0, e.1));
    let truth = errors.iter().map(|e| point("against the closed form", e.0, e.2));
    chart::svg(
        "One hemicube, two squares that share an edge: two errors of the same runs",
        &own.chain(truth).collect::<Vec<_>>(),
        "cells along an edge of the hemicube",
        "relative error",
    )
}

/// What the chart says.
pub fn text() -> String {
    let errors = errors();
    let (cells, own, truth) = errors[errors.len() - 1];
    format!(
        "With {cells} cells the hemicube is within {:.2} % of its own answer with 1024, and \
         {:.1} % off the truth.\n",
        100.0 * own,
        100.0 * truth
    )
}
