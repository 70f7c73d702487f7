//! One camera, three ways to see: by lamps and mirrors alone, by pass 1 alone, by both.

use crate::ledger::table;
use radiosity::field::Pass1;
use radiosity::field::Smooth;
use radiosity::film::{RgbImage, Shot};
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in};
use radiosity::solution::{Goal, Solution, solve_from};
use radiosity::trace::{Look, Shown, TwoPass, Whitted};
use radiosity::work::Work;
use std::sync::OnceLock;

/// Pixels along an edge.
const SIZE: u32 = 192;

/// A scene with its diffuse light, found in one attempt.
pub struct Lit {
    /// The scene.
    pub scene: Scene,
    /// Its light.
    pub solution: Solution,
}

impl Lit {
    /// Of a built-in scene, as finely as this tolerance asks for at first.
    pub fn of(scene: Scene, tolerance: f64) -> Lit {
        let (room, goal) = (Room::of(&scene), Goal::within(f64::INFINITY));
        let how = Smooth.first(&room, tolerance);
        let solution = solve_from(&room, &Smooth, how, &goal, &Work::quiet());
        let solution = solution.expect("it can be solved");
        Lit { scene, solution }
    }

    /// What its camera sees, by two passes.
    pub fn two_passes(&self, size: u32, options: Look) -> Shown {
        let Solution { field, vertex_radiosity, .. } = &self.solution;
        let two = TwoPass::showing(
            &Room::of(&self.scene),
            &field.mesh,
            vertex_radiosity,
            options,
        );
        two.picture(&self.shot(size), &|_, _, _| {})
    }

    fn shot(&self, size: u32) -> Shot {
        Shot { camera: self.scene.camera, width: size, height: size, samples: 3 }
    }
}

/// The Cornell box whose tall block is a mirror.
fn cornell() -> &'static Lit {
    static LIT: OnceLock<Lit> = OnceLock::new();
    LIT.get_or_init(|| {
        Lit::of(built_in("cornell-mirror").expect("it is built in"), 0.1)
    })
}

/// The exposure of all three pictures: that of the last.
fn exposure() -> f64 {
    static EXPOSURE: OnceLock<f64> = OnceLock::new();
    let find = || cornell().two_passes(SIZE, Look::default()).picture.auto_exposure();
    *EXPOSURE.get_or_init(find)
}

/// Classical ray tracing: mirrors and lamps.
pub fn classical() -> RgbImage {
    let lit = cornell();
    let whitted = Whitted::of(&Room::of(&lit.scene), Look::default());
    let shown = whitted.picture(&lit.shot(SIZE), &|_, _, _| {});
    shown.picture.display(exposure())
}

/// Pass 1 alone: diffuse light, and black where the mirror is.
pub fn first_pass() -> RgbImage {
    let Lit { solution, .. } = cornell();
    let shot = cornell().shot(SIZE);
    shot.smooth(&solution.field.mesh, &solution.vertex_radiosity).display(exposure())
}

/// Both passes.
pub fn both() -> RgbImage {
    cornell().two_passes(SIZE, Look::default()).picture.display(exposure())
}

/// The caption under the three.
pub fn caption() -> String {
    let shown = cornell().two_passes(SIZE, Look::default());
    let samples = u64::from(9 * SIZE * SIZE);
    format!(
        "`cornell-mirror`: the tall block is a mirror. Left: classical ray tracing. Middle: \
         pass 1 alone. Right: both passes. The second pass followed {} rays; {:.0} % of its \
         {samples} samples saw a diffuse surface and needed none.",
        shown.rays,
        100.0 * (1.0 - shown.rays as f64 / samples as f64)
    )
}

/// The glass ball.
fn ball() -> &'static Lit {
    static LIT: OnceLock<Lit> = OnceLock::new();
    LIT.get_or_init(|| Lit::of(built_in("glass-ball").expect("it is built in"), 0.1))
}

/// The glass ball by two passes.
pub fn ball_picture() -> RgbImage {
    let shown = ball().two_passes(SIZE, Look::default());
    shown.picture.display(shown.picture.auto_exposure())
}

/// Its caption.
pub fn ball_caption() -> String {
    let shown = ball().two_passes(SIZE, Look::default());
    let look = Look::default();
    format!(
        "`glass-ball`: {:.1} rays for each sample of the picture. Branches \
         end after {} bounces or below {} of a pixel: {:.2} % of the light a picture could \
         show was cut.",
        shown.rays as f64 / f64::from(9 * SIZE * SIZE),
        look.depth,
        look.weight,
        100.0 * shown.cut.element_sum() / 3.0
    )
}

/// Where the light of the opening picture went.
pub fn ledger() -> String {
    table(&cornell().solution)
}
