//! The equation is exact for constant elements; light is not constant on them.

use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use radiosity::solve::{Enclosure, GaussSeidel, Solver};
use std::fmt::Write;

/// Mean radiosity of the wall that faces the emitting one, in a unit cube of
/// reflectance ½: the integral equation solved to ten digits (`C_continuous.json` of
/// the tests).
pub const TRUTH: f64 = 0.171_215_992_3;

/// Elements along an edge of the cube.
pub const CUTS: [u32; 4] = [1, 2, 4, 8];

/// The same mean from `cuts` × `cuts` elements on each wall, with exact factors.
pub fn opposite(cuts: u32) -> f64 {
    let scene = built_in("furnace").expect("`furnace` is built in");
    let mesh = Mesh::uniform(&scene, 1.0 / f64::from(cuts));
    let matrix = Analytic::new(&scene, &mesh, 1e-10, 0).matrix(&|| ());
    let mut room = Enclosure::of(&scene, &mesh);
    let [lit, facing] = facing(&mesh);
    for (emission, element) in room.emission.iter_mut().zip(&mesh.elements) {
        *emission = if element.patch.0 == lit { Rgb::ONE } else { Rgb::ZERO };
    }
    let mut solver = GaussSeidel::new(&room, &matrix);
    solver.by_ref().take(60).for_each(drop);
    let on = |k: &usize| mesh.elements[*k].patch.0 == facing;
    let of_wall = (0..mesh.elements.len()).filter(on);
    of_wall.map(|k| room.area[k] * solver.radiosity()[k].x).sum()
}

/// The first wall, and the one that faces it.
fn facing(mesh: &Mesh) -> [u32; 2] {
    let normal = |e: &radiosity::mesh::Element| e.polygon.normal();
    let first = &mesh.elements[0];
    let other = mesh.elements.iter().find(|e| normal(e).dot(normal(first)) < -0.5);
    [first.patch.0, other.expect("a cube has opposite walls").patch.0]
}

/// How the error falls, as a Markdown table.
pub fn table() -> String {
    let mut text = String::from(
        "| elements on a wall | mean B opposite | off by |\n|---|---|---|\n",
    );
    for cuts in CUTS {
        let b = opposite(cuts);
        let off = 100.0 * (b / TRUTH - 1.0);
        let _ = writeln!(text, "| {cuts} × {cuts} | {b:.5} | {off:+.2} % |");
    }
    text
}
