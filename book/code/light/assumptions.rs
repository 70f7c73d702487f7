//! One number for each element: what that means, and what it costs.

use crate::{ledger, map};
use glam::{DVec2, DVec3, dvec3};
use radiosity::field::Classical;
use radiosity::field::Factors;
use radiosity::film::{RgbImage, Shot};
use radiosity::form_factor::analytic::{exchange, lambert_polygon};
use radiosity::geometry::Polygon;
use radiosity::mesh::Mesh;
use radiosity::room::Room;
use radiosity::scene::{Camera, built_in};
use radiosity::solution::Goal;
use radiosity::solution::{Solution, solve_on};
use radiosity::work::Work;
use std::fmt::Write;

/// Longest edges of the elements, in metres, of the picture that all is seen in.
pub const FINE: f64 = 0.05;

/// Those of two coarser pictures beside it.
pub const COARSE: [f64; 2] = [0.3, 0.15];

/// Pixels along an edge of a picture.
const SIZE: u32 = 160;

/// The Cornell box, solved on elements of this edge.
pub fn solved(max_edge: f64) -> Solution {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let mesh = Mesh::uniform(&scene, max_edge);
    let method = Classical::by(Factors::Analytic);
    solve_on(&Room::of(&scene), &method, mesh, &Goal::default(), &Work::quiet())
        .unwrap()
}

/// The camera of the scene, and one that looks at it from the right and above.
pub fn cameras() -> [Camera; 2] {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let moved = Camera {
        eye: dvec3(0.06, 0.47, -0.55),
        target: dvec3(0.3, 0.2, 0.3),
        ..scene.camera
    };
    [scene.camera, moved]
}

/// Each element in its one radiance.
pub fn picture(solution: &Solution, camera: Camera) -> RgbImage {
    let shot = Shot { camera, width: SIZE, height: SIZE, samples: 2 };
    shot.flat(&solution.field.mesh, &solution.radiosity).display(1.0)
}

/// The caption under a picture of these elements.
pub fn edge_caption(max_edge: f64) -> String {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let elements = Mesh::uniform(&scene, max_edge).elements.len();
    format!("Edges up to {max_edge} m: {elements} numbers for each colour")
}

/// Elements along an edge of the floor under the lamp, in the three maps.
pub const CUTS: [u32; 3] = [4, 8, 16];

/// A lamp of 0.3 × 0.3 m, 0.5 m over the middle of a floor of 4 × 4 m.
fn lamp() -> Polygon {
    map::square(0.3, 0.5 * DVec3::Z)
}

/// By how much one number for each element is off, over the floor: the mean of the element
/// over the true value there, less one.
pub fn errors(cuts: u32) -> Vec<f64> {
    let (lamp, step) = (lamp(), 4.0 / f64::from(cuts));
    let mean = |place: DVec2| {
        let cell = (place / step).floor() + 0.5;
        let element = map::square(step, (step * cell).extend(0.0)).flipped();
        exchange(&lamp, &element, 1e-9) / element.area()
    };
    map::over(DVec2::splat(-2.0), DVec2::splat(2.0), |place| {
        mean(place) / lambert_polygon(place.extend(0.0), DVec3::Z, &lamp) - 1.0
    })
}

/// Root mean square of the errors.
pub fn rms(errors: &[f64]) -> f64 {
    (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt()
}

/// The range of the colours.
const RANGE: (f64, f64) = (0.01, 1.0);

/// The map of the errors.
pub fn error_picture(cuts: u32) -> RgbImage {
    map::draw(&errors(cuts), RANGE.0, RANGE.1)
}

/// The caption under it.
pub fn error_caption(cuts: u32) -> String {
    let off = 100.0 * rms(&errors(cuts));
    format!("{cuts} × {cuts} elements: off by {off:.0} %")
}

/// By what halving the elements divides the error, from map to map.
pub fn order() -> String {
    let [coarse, middle, fine] = CUTS.map(|cuts| rms(&errors(cuts)));
    format!(
        "Halve the elements, and here the error is divided by {:.1}, and then by {:.1}: by 2 in the \
         end, when they are small. It is of *first order*.",
        coarse / middle,
        middle / fine
    )
}

/// The key to the maps.
pub fn key() -> String {
    map::key(RANGE.0, RANGE.1, 3, map::per_cent)
}

/// What halving costs, as a Markdown table.
pub fn cost() -> String {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let mut text = String::from(
        "| edges up to | elements n | pairs n² | all factors, 8 bytes each |\n\
         |---|---|---|---|\n",
    );
    for edge in [0.2, 0.1, 0.05, 0.025] {
        let n = Mesh::uniform(&scene, edge).elements.len() as f64;
        let (thousands, megabytes) = (n * n / 1e3, n * n * 8e-6);
        let _ = writeln!(
            text,
            "| {edge} m | {n} | {thousands:.0} thousand | {megabytes:.1} MB |"
        );
    }
    text
}

/// The ledger of the Cornell box.
pub fn ledger() -> String {
    ledger::table(&solved(0.1))
}
