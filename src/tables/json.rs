//! A solution as JSON.

use super::faces;
use crate::certificate::{Certificate, RelativeError};
use crate::geometry::Rgb;
use crate::scene::{Scene, Side};
use crate::solution::Solution;
use crate::solve::Ledger;
use glam::DVec3;

/// What a solution says of itself, as one JSON object: elements, patches, certificate,
/// ledger in W, and `plan`, what was decided on the way.
///
/// A number that is infinite, such as an error that has no bound, is `null`.
pub fn summary(solution: &Solution, plan: &[String], tolerance: f64) -> String {
    object(&entries(solution, plan, tolerance))
}

/// The same, the scene's name, the means of all faces, and the whole mesh.
pub fn json(
    scene: &Scene,
    solution: &Solution,
    plan: &[String],
    tolerance: f64,
) -> String {
    let mut all = entries(solution, plan, tolerance);
    all.push(("scene", string(&scene.name)));
    let of_face = |(id, face): (usize, &super::FaceLight)| {
        object(&[
            ("face", id.to_string()),
            ("area", number(face.area)),
            ("B", triple(face.radiosity)),
            ("H", triple(face.irradiance)),
        ])
    };
    all.push(("faces", array(faces(scene, solution).iter().enumerate().map(of_face))));
    all.push(("mesh", mesh(scene, solution)));
    object(&all) + "\n"
}

fn entries(
    solution: &Solution,
    plan: &[String],
    tolerance: f64,
) -> Vec<(&'static str, String)> {
    let Certificate { error, low, high, confidence, irradiance, unseen, .. } =
        solution.certificate;
    let Ledger { emitted, absorbed, escaped, unshot, imbalance } =
        solution.field.ledger;
    let bounds = |[error, low, high]: [f64; 3]| {
        [("error", error), ("low", low), ("high", high)]
            .map(|(key, x)| (key, number(x)))
    };
    let RelativeError { error: of_h, low: h_low, high: h_high } = irradiance;
    let mut certificate = bounds([error, low, high]).to_vec();
    certificate.push(("confidence", number(confidence)));
    certificate.push(("irradiance", object(&bounds([of_h, h_low, h_high]))));
    certificate.push(("unseen", number(unseen)));
    let ledger = [
        ("emitted", emitted),
        ("absorbed", absorbed),
        ("escaped", escaped),
        ("unshot", unshot),
        ("imbalance", imbalance),
    ];
    vec![
        ("elements", solution.field.mesh.elements.len().to_string()),
        ("patches", solution.field.patches.to_string()),
        ("tolerance", number(tolerance)),
        ("converged", solution.converged.to_string()),
        ("solver_residual", number(solution.field.solver_residual)),
        ("certificate", object(&certificate)),
        ("ledger", object(&ledger.map(|(key, c)| (key, triple(c))))),
        ("plan", array(plan.iter().map(|line| string(line)))),
    ]
}

fn mesh(scene: &Scene, solution: &Solution) -> String {
    let mesh = &solution.field.mesh;
    let vertex =
        |(p, b): (&DVec3, &Rgb)| object(&[("position", triple(*p)), ("B", triple(*b))]);
    let vertices = mesh.vertices.iter().zip(&solution.vertex_radiosity).map(vertex);
    let light = solution.radiosity.iter().zip(&solution.irradiance);
    let elements = mesh.elements.iter().zip(light).map(|(element, (b, h))| {
        let side = match scene.surfaces[mesh.surface_of(element) as usize].side {
            Side::Front => "front",
            Side::Back => "back",
        };
        object(&[
            ("face", mesh.patch_of(element).face.0.to_string()),
            ("side", string(side)),
            ("corners", array(element.corners.iter().map(|c| c.0.to_string()))),
            ("area", number(element.polygon.area())),
            ("B", triple(*b)),
            ("H", triple(*h)),
        ])
    });
    object(&[("vertices", array(vertices)), ("elements", array(elements))])
}

fn object(entries: &[(&str, String)]) -> String {
    let entry = |(key, value): &(&str, String)| format!("\"{key}\":{value}");
    format!("{{{}}}", entries.iter().map(entry).collect::<Vec<_>>().join(","))
}

fn array(values: impl Iterator<Item = String>) -> String {
    format!("[{}]", values.collect::<Vec<_>>().join(","))
}

fn triple(v: DVec3) -> String {
    array(v.to_array().into_iter().map(number))
}

fn number(x: f64) -> String {
    if x.is_finite() { format!("{x:?}") } else { "null".into() }
}

fn string(text: &str) -> String {
    let escaped = |c: char| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04x}", c as u32),
        c => c.to_string(),
    };
    format!("\"{}\"", text.chars().map(escaped).collect::<String>())
}
