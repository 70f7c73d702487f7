//! The figures and numbers of the chapters on shooting: *Progressive refinement*, *Only
//! what still shines*.
//!
//! [`steps`] stops after some shots and looks; [`work`] draws error over shots;
//! [`specks`] has many small lamps; [`lit`] asks who shines; [`ahead`] overshoots;
//! [`cost`] draws what was measured.

pub mod ahead;
pub mod cost;
pub mod lit;
pub mod specks;
pub mod steps;
pub mod work;

use radiosity::film::{RgbImage, Shot};
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::{FormFactors, Matrix};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::scene::{Camera, Scene, built_in};
use radiosity::solve::{Enclosure, GaussSeidel, Solver};
use std::sync::OnceLock;

/// A scene with all that shooting needs, and the solution to compare with.
pub struct Room {
    /// The elements.
    pub mesh: Mesh,
    /// What they emit and reflect.
    pub enclosure: Enclosure,
    /// All factors.
    pub factors: Matrix,
    /// `B*`, W/m², to ten digits.
    pub solution: Vec<Rgb>,
    /// Who looks at it.
    pub camera: Camera,
}

/// Longest edge of an element of the Cornell box, in metres.
pub const MAX_EDGE: f64 = 0.07;

/// The Cornell box; computed once.
pub fn cornell() -> &'static Room {
    static ROOM: OnceLock<Room> = OnceLock::new();
    let scene = || built_in("cornell").expect("`cornell` is built in");
    ROOM.get_or_init(|| Room::of(&scene(), MAX_EDGE))
}

impl Room {
    /// A scene with elements of at most this edge.
    pub fn of(scene: &Scene, max_edge: f64) -> Room {
        let mesh = Mesh::uniform(scene, max_edge);
        let enclosure = Enclosure::of(scene, &mesh);
        let factors = Analytic::new(scene, &mesh, 1e-4, 0).matrix(&|| ());
        let (solution, camera) = (Vec::new(), scene.camera);
        let mut room = Room { mesh, enclosure, factors, solution, camera };
        room.solve();
        room
    }

    /// Finds the solution to compare with, of the enclosure as it is now.
    pub fn solve(&mut self) {
        let rho = self.enclosure.largest_reflectance().max_element();
        let mut solver = GaussSeidel::new(&self.enclosure, &self.factors);
        solver.run(rho, 1e-10, 10_000);
        self.solution = solver.radiosity().to_vec();
    }

    /// How far `radiosity` is from the solution: `‖B − B*‖/‖B* − E‖`, worst channel.
    pub fn error(&self, radiosity: &[Rgb]) -> f64 {
        let norm = |from: &[Rgb]| {
            let off = self.solution.iter().zip(from).map(|(&b, &from)| b - from);
            self.enclosure.norm_squared(off)
        };
        (norm(radiosity) / norm(&self.enclosure.emission)).max_element().sqrt()
    }

    /// The share of the emitted power that this radiosity is, over all channels.
    pub fn share(&self, radiosity: &[Rgb]) -> f64 {
        let power = |x: &[Rgb]| self.enclosure.power(x.iter().copied()).element_sum();
        power(radiosity) / power(&self.enclosure.emission)
    }

    /// A panel: each element in its one radiance.
    pub fn panel(&self, radiosity: &[Rgb], exposure: f64) -> RgbImage {
        let shot =
            Shot { camera: self.camera, width: PANEL, height: PANEL, samples: 2 };
        shot.flat(&self.mesh, radiosity).display(exposure)
    }
}

/// Pixels along an edge of a panel.
pub const PANEL: u32 = 128;

/// Panels of one size beside each other.
pub fn beside(panels: &[RgbImage]) -> RgbImage {
    const GAP: u32 = 4;
    let (wide, high) = (panels[0].width(), panels[0].height());
    let count = panels.len() as u32;
    let mut strip = RgbImage::from_pixel(
        count * (wide + GAP) - GAP,
        high,
        [128, 128, 128].into(), // neither paper nor ink
    );
    for (left, panel) in (0..).step_by((wide + GAP) as usize).zip(panels) {
        for (x, y, pixel) in panel.enumerate_pixels() {
            strip.put_pixel(left + x, y, *pixel);
        }
    }
    strip
}

/// Path and text of the generated files of these chapters.
pub fn files() -> Vec<(String, String)> {
    let mut files = vec![
        ("generated/progressive-work.svg".to_string(), work::svg()),
        ("generated/progressive-work.md".into(), work::text()),
        ("generated/progressive-specks.md".into(), specks::text()),
        ("generated/progressive-ledger.md".into(), steps::ledger()),
        ("generated/progressive-cost.md".into(), cost::text()),
        ("generated/shines-bounces.md".into(), lit::bounces()),
        ("generated/shines-rows.md".into(), lit::rows()),
        ("generated/shines-held.md".into(), lit::held()),
        ("generated/shines-key.md".into(), lit::key()),
        ("generated/shines-map.md".into(), lit::caption()),
        ("generated/shines-work.svg".into(), ahead::work_svg()),
        ("generated/shines-gain.md".into(), ahead::gain()),
        ("generated/shines-debt.svg".into(), ahead::debt_svg()),
        ("generated/shines-ledger.md".into(), ahead::ledger()),
    ];
    for shots in steps::STAGES {
        let name = format!("generated/progressive-after-{shots}.md");
        files.push((name, steps::caption(shots)));
    }
    for shots in ahead::STAGES {
        let name = format!("generated/shines-after-{shots}.md");
        files.push((name, ahead::caption(shots)));
    }
    files
}
