//! The Cornell box, split where the oracle says, round by round.

use crate::ledger as books;
use crate::shooting::beside;
use radiosity::film::{RgbImage, Shot};
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::mesh::{Element, Mesh};
use radiosity::scene::{Scene, built_in};
use radiosity::solve::{OnElements, Oracle, Substructure};
use std::sync::OnceLock;

/// Longest edge of a patch, relative to the scene's diagonal.
pub const EDGE: f64 = 0.12;

/// Cells along an edge of each hemicube's top.
pub const RESOLUTION: u32 = 128;

/// The error that the oracle allows.
pub const TOLERANCE: f64 = 0.04;

/// How often a patch may be split.
pub const DEPTH: i32 = 4;

/// How many rounds are shown, that of whole patches included.
pub const ROUNDS: usize = 4;

/// After some rounds.
pub struct Round {
    /// Patches and elements.
    pub mesh: Mesh,
    /// Their light.
    pub light: OnElements,
    /// The factors that were computed until then.
    pub factors: usize,
}

/// Which elements a round splits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Splits {
    /// All.
    All,
    /// Those that the oracle marks.
    Marked,
}

/// Patches of the scene, split `rounds` times; stops when nothing is marked.
pub fn run(scene: &Scene, splits: Splits, rounds: usize) -> Vec<Round> {
    let edge = EDGE * scene.diagonal();
    let patches = Mesh::patched(scene, edge);
    let cube = Hemicube::new(&patches, RESOLUTION).turned(1);
    let sees = |e: &Element, row: &mut [f64]| {
        cube.at(e.polygon.centroid(), e.polygon.normal(), row)
    };
    let smallest = 1.01 * edge * edge / 4_f64.powi(DEPTH);
    let oracle = Oracle { tolerance: TOLERANCE, smallest };
    let mut both = Substructure::new(scene, patches.clone(), &sees);
    let mut done = Vec::new();
    loop {
        let light = both.solve(1e-4);
        let marks = match splits {
            Splits::All => vec![true; both.mesh().elements.len()],
            Splits::Marked => oracle.marks(scene, both.mesh(), &light.radiosity),
        };
        let (mesh, factors) = (both.mesh().clone(), both.factors_computed());
        done.push(Round { mesh, light, factors });
        if done.len() == rounds || !marks.contains(&true) {
            return done;
        }
        both.split(&marks);
    }
}

/// The scene of the figures.
pub fn cornell() -> Scene {
    built_in("cornell").expect("`cornell` is built in")
}

/// The rounds that are shown; computed once.
pub fn shown() -> &'static [Round] {
    static SHOWN: OnceLock<Vec<Round>> = OnceLock::new();
    SHOWN.get_or_init(|| run(&cornell(), Splits::Marked, ROUNDS))
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
