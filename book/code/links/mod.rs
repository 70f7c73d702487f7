//! The figures and numbers of the page *Links: substructuring carried on*.
//!
//! [`walls`] draws the links of two walls; [`cost`] tells what was measured.

pub mod cost;
pub mod walls;

use crate::ledger;
use radiosity::film::{RgbImage, Shot};
use radiosity::scene::{Scene, built_in};
use radiosity::solve::hierarchy::{Hierarchical, HierarchyOptions, solve_hierarchy};

/// The errors that the pictures ask for.
pub const ERRORS: [f64; 3] = [0.16, 0.08, 0.04];

fn cornell() -> Scene {
    built_in("cornell-regular").expect("`cornell-regular` is built in")
}

fn solved(error: f64) -> Hierarchical {
    let scene = cornell();
    let options = HierarchyOptions::aiming_at(error, &scene);
    solve_hierarchy(&scene, &options, &|_, _, _| {})
}

/// The Cornell box, smooth, with its mesh.
pub fn picture(error: f64) -> RgbImage {
    let found = solved(error);
    let camera = cornell().camera;
    let shot = Shot { camera, width: 256, height: 256, samples: 2 };
    let picture = shot.smooth(&found.mesh, &found.vertex_radiosity).display(60.0);
    shot.with_mesh(picture, &found.mesh)
}

/// What it took.
pub fn caption(error: f64) -> String {
    let found = solved(error);
    let elements = found.mesh.elements.len();
    let matrix = elements * elements;
    format!(
        "ε = {error}: {elements} elements, {} links; a matrix would have {:.0} times as many \
         factors",
        found.links,
        matrix as f64 / found.links as f64
    )
}

/// The generated files of the page.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/links-walls.svg".to_string(), walls::svg()),
        ("generated/links-walls.md".into(), walls::caption()),
        ("generated/links-cost.md".into(), cost::text()),
        ("generated/links-memory.md".into(), cost::memory()),
        ("generated/links-surfaces.md".into(), cost::surfaces()),
        ("generated/links-ledger.md".into(), ledger::of(&solved(0.04).ledger)),
    ];
    for (k, error) in ERRORS.into_iter().enumerate() {
        files.push((format!("generated/links-mesh-{k}.md"), caption(error)));
    }
    files
}
