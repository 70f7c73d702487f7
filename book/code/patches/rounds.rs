//! The Cornell box, split where the oracle says, round by round.

use crate::ledger as books;
use crate::shooting::beside;
use radiosity::chart::suites::meshes::{Round, Rounds};
use radiosity::film::{RgbImage, Shot};
use radiosity::scene::{Scene, built_in};
use std::sync::OnceLock;

/// How many rounds are shown, that of whole patches included.
pub const ROUNDS: usize = 4;

/// The scene of the figures.
pub fn cornell() -> Scene {
    built_in("cornell").expect("`cornell` is built in")
}

/// The rounds that are shown; computed once.
pub fn shown() -> &'static [Round] {
    static SHOWN: OnceLock<Vec<Round>> = OnceLock::new();
    SHOWN.get_or_init(|| Rounds::new(&cornell(), true).run(ROUNDS))
}

/// Pixels along an edge of a panel.
const PANEL: u32 = 224;

/// The elements, each in its one radiance, and the picture between their vertices.
pub fn picture(round: usize) -> RgbImage {
    let Round { mesh, light, .. } = &shown()[round];
    let shot =
        Shot { camera: cornell().camera, width: PANEL, height: PANEL, samples: 2 };
    let exposure = 1.0 / 3.0;
    let flat = shot.flat(mesh, &light.radiosity).display(exposure);
    let smooth = shot.smooth(mesh, &mesh.vertex_values(&light.radiosity));
    beside(&[shot.with_mesh(flat, mesh), smooth.display(exposure)])
}

/// How many elements there are, and what they cost.
pub fn caption(round: usize) -> String {
    let Round { mesh, factors, .. } = &shown()[round];
    let (m, n) = (mesh.patches.len(), mesh.elements.len());
    let after = match round {
        0 => "The patches".to_string(),
        1 => "After one round".into(),
        _ => format!("After {round} rounds"),
    };
    let worth = (n * n) as f64 / *factors as f64;
    format!(
        "{after}: {m} patches, {n} elements, {factors} factors so far. All factors between \
         elements would be {worth:.1} times as many.\n"
    )
}

/// Where the light of the last round shown went.
pub fn ledger() -> String {
    let last = shown().last().expect("there is a round");
    books::of(&last.light.outcome.last.ledger)
}
