//! Many small lamps, brighter than the large one: who goes first?

use super::beside;
use glam::{DVec3, dvec3};
use radiosity::film::{RgbImage, Shot};
use radiosity::form_factor::Cached;
use radiosity::form_factor::analytic::Analytic;
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::Mesh;
use radiosity::scene::{Face, MaterialId, Scene, built_in};
use radiosity::solve::{Brightest, Enclosure, Shoot, Solver};

/// How many specks.
const SPECKS: usize = 40;

/// How many shots are made.
pub const SHOTS: usize = 40;

/// The Cornell box with specks of 2 mm below its ceiling, five times as bright as the
/// lamp.
fn scene() -> Scene {
    let mut scene = built_in("cornell").expect("`cornell` is built in");
    let lamp = scene.materials.iter().find(|m| m.emits()).expect("it has a lamp");
    let coefficients = Coefficients {
        emission: 5.0 * lamp.emission(),
        diffuse: lamp.diffuse(),
        ..Coefficients::default()
    };
    let speck = Material::new("speck", coefficients).expect("as passive as the lamp");
    scene.materials.push(speck);
    let material = MaterialId(scene.materials.len() as u32 - 1);
    let (across, along) = (0.002 * DVec3::X, 0.002 * DVec3::Z);
    for k in 0..SPECKS {
        let at = dvec3(0.1 + 0.05 * (k % 8) as f64, 0.54, 0.1 + 0.05 * (k / 8) as f64);
        let outline = vec![at, at + across, at + across + along, at + along];
        scene.faces.push(Face { outline, material });
    }
    let Scene { name, faces, materials, camera, .. } = scene;
    Scene::assemble(&name, materials, faces, Some(camera)).expect("flat faces").0
}

/// What is left of the light, as a share, and the picture, after `SHOTS`.
pub fn shot(brightest: Brightest) -> (f64, RgbImage) {
    let scene = scene();
    let mesh = Mesh::uniform(&scene, super::MAX_EDGE);
    let enclosure = Enclosure::of(&scene, &mesh);
    let analytic = Analytic::new(&scene, &mesh, 1e-4, 0);
    let factors = Cached::new(&analytic);
    let mut solver = Shoot::new(&enclosure, &factors, brightest);
    let last = solver.by_ref().take(SHOTS).last().unwrap_or_default();
    let left = last.ledger.unshot.element_sum() / last.ledger.emitted.element_sum();
    let size = super::PANEL;
    let eye = Shot { camera: scene.camera, width: size, height: size, samples: 2 };
    (left, eye.flat(&mesh, solver.radiosity()).display(1.0))
}

/// By radiosity, and by power.
pub fn picture() -> RgbImage {
    beside(&[shot(Brightest::ByRadiosity).1, shot(Brightest::ByPower).1])
}

/// The caption under it.
pub fn text() -> String {
    let [radiosity, power] =
        [Brightest::ByRadiosity, Brightest::ByPower].map(|b| 100.0 * shot(b).0);
    format!(
        "After {SHOTS} shots. Left: by radiosity, {radiosity:.0} % of the light is \
         unshot. Right: by power, {power:.0} %.\n"
    )
}
