//! What the same time buys: patches of the Cornell box by walks and by smooth light.

use crate::chart::{find, trials};
use crate::ledger;
use radiosity::chart::patches::Patches;
use radiosity::chart::suites::solvers::{PATCH, PATCHES};
use radiosity::field::Smooth;
use radiosity::film::{RgbImage, Shot};
use radiosity::geometry::Rgb;
use radiosity::room::Room;
use radiosity::scene::built_in;

/// Method and setting of each picture.
pub const VIEWS: [(&str, f64); 3] = [
    ("unbiased gathering", 64.0),
    ("smooth light", 0.05),
    ("unbiased gathering", 4096.0),
];

/// Pixels along an edge.
const SIZE: u32 = 160;

/// The patches as the method lights them.
pub fn picture(k: usize) -> RgbImage {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let patches = Patches::unjudged(&scene, PATCH);
    let (irradiance, _) = match VIEWS[k] {
        ("smooth light", tolerance) => patches.by_smooth(tolerance),
        (_, walks) => patches.by_walks(walks as usize, 0),
    };
    let mesh = patches.mesh();
    let shines = |(e, &h): (_, &Rgb)| {
        let material = mesh.material(&scene, e);
        material.emission() + material.diffuse() * h
    };
    let radiosity: Vec<Rgb> =
        mesh.elements.iter().zip(&irradiance).map(shines).collect();
    let shot = Shot { camera: scene.camera, width: SIZE, height: SIZE, samples: 2 };
    let picture = shot.flat(mesh, &radiosity);
    picture.display(picture.auto_exposure())
}

/// What one of them cost.
pub fn caption(k: usize) -> String {
    let trials = trials(include_str!("../../data/solvers.csv"));
    let (method, setting) = VIEWS[k];
    let trial = find(&trials, PATCHES, method, setting);
    let what = match method {
        "smooth light" => format!("Smooth light, asked for {} %", 100.0 * setting),
        _ => format!("Random walks, {setting} from each patch"),
    };
    let (off, time) = (100.0 * trial.error, 1e3 * trial.seconds);
    let time = if time < 1e3 {
        format!("{time:.0} ms")
    } else {
        format!("{:.1} s", 1e-3 * time)
    };
    format!("{what}: {off:.1} % off, after {time}\n")
}

/// Where the light of the second picture went.
pub fn ledger() -> String {
    let scene = built_in("cornell").expect("`cornell` is built in");
    ledger::of(&Smooth::once(&Room::of(&scene), VIEWS[1].1).ledger)
}
