//! The radiosity equation of the Cornell box, with all its knowns, and one bounce.

use radiosity::film::{RgbImage, Shot};
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::{FormFactors, Matrix};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::scene::{Scene, built_in};
use radiosity::solve::{Enclosure, Jacobi, Solver};
use std::sync::OnceLock;

/// Pixels along an edge of a picture.
const SIZE: u32 = 160;

/// `B = E + ρ F B`, but for B.
pub struct System {
    /// What the room is made of.
    pub scene: Scene,
    /// Its elements.
    pub mesh: Mesh,
    /// Their areas, emissions and reflectances.
    pub enclosure: Enclosure,
    /// Their form factors.
    pub factors: Matrix,
}

/// Bounces that stand for all: what is left is below a byte's step.
pub const ALL: u32 = 60;

/// The Cornell box in elements whose edges are up to 5 cm.
pub fn cornell() -> &'static System {
    static SYSTEM: OnceLock<System> = OnceLock::new();
    SYSTEM.get_or_init(|| System::of("cornell", 0.05))
}

impl System {
    /// That of a built-in scene.
    pub fn of(name: &str, max_edge: f64) -> System {
        let scene = built_in(name).expect("the name of a built-in scene");
        let mesh = Mesh::uniform(&scene, max_edge);
        let enclosure = Enclosure::of(&scene, &mesh);
        let accuracy = 0.02 / mesh.elements.len() as f64;
        let factors = Analytic::new(&scene, &mesh, accuracy, 0).sharp().matrix(&|| ());
        System { scene, mesh, enclosure, factors }
    }

    /// `H_i = Σ_j F_ij B_j`.
    pub fn arriving(&self, b: &[Rgb]) -> Vec<Rgb> {
        let gather =
            |row: &[(u32, f64)]| row.iter().map(|&(j, f)| f * b[j as usize]).sum();
        self.factors.rows().iter().map(|row| gather(row.factors())).collect()
    }

    /// `ρ F B`: the light `b` after one more bounce.
    pub fn bounced(&self, b: &[Rgb]) -> Vec<Rgb> {
        let reflect = |(h, &rho): (Rgb, &Rgb)| rho * h;
        let rho = &self.enclosure.reflectance;
        self.arriving(b).into_iter().zip(rho).map(reflect).collect()
    }

    /// `(ρF)^k E`: the light that has bounced `k` times.
    pub fn alone(&self, k: u32) -> Vec<Rgb> {
        (0..k).fold(self.enclosure.emission.clone(), |b, _| self.bounced(&b))
    }

    /// The light that has bounced at most `k` times.
    pub fn after(&self, k: u32) -> Vec<Rgb> {
        let mut solver = Jacobi::new(&self.enclosure, &self.factors);
        solver.by_ref().take(k as usize).for_each(drop);
        solver.radiosity().to_vec()
    }

    /// `Σ A B`, of all channels together, in W.
    pub fn power(&self, b: &[Rgb]) -> f64 {
        self.enclosure.power(b.iter().copied()).element_sum()
    }

    /// The light `b` as the scene's camera sees it.
    pub fn picture(&self, b: &[Rgb], exposure: f64) -> RgbImage {
        let shot =
            Shot { camera: self.scene.camera, width: SIZE, height: SIZE, samples: 2 };
        shot.smooth(&self.mesh, &self.mesh.vertex_values(b)).display(exposure)
    }
}
