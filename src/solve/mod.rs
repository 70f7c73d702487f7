//! Solving the radiosity equation, with an account of where the light went.
//!
//! ```text
//! B_i = E_i + ρ_i Σ_j F_ij B_j                             gathering, W/m²
//! A_i B_i = A_i E_i + ρ_i Σ_j F_ji A_j B_j                 the same as power, W
//! emitted = absorbed + escaped + unshot + imbalance        the ledger, W
//! ```
//!
//! | method                 | use it when                        | it fails when              |
//! |------------------------|------------------------------------|----------------------------|
//! | [`Jacobi`]             | bounces are to be seen one by one  | ρ → 1: steps ~ 1/(1 − ρ)   |
//! | [`GaussSeidel`]        | all factors are at hand            | the same, half as many     |
//! | [`ConjugateGradients`] | ρ → 1: steps ~ 1/√(1 − ρ)          | factors are not reciprocal |
//! | [`Shoot`]              | an early picture, row by row       | every last bit is wanted   |
//! | [`Overshoot`]          | the same, and light lasts long     | none comes back: no gain   |
//! | [`Substructure`]       | few patches light many elements    | patches are seen close by  |
//!
//! All but the last are a [`Solver`], an iterator: each step yields the [`Ledger`] and the
//! residual, from which [`error_bound`] tells when to stop. Not converging is a value, never
//! an error. A [`Certificate`] then says how far the field is from the truth. The last makes
//! a system that is smaller, for any of them to solve.
//!
//! **Not here:** the factors ([`crate::form_factor`]); what a camera sees.
//! Chapters *The radiosity equation* (L06), *Solving it*, *Patches and elements* (L11, L12),
//! *Progressive refinement* (L13, L14).
//! Sources: Goral et al. 1984; Cohen & Greenberg 1985; Cohen, Chen, Wallace &
//! Greenberg 1988; Hestenes & Stiefel 1952.

mod auto;
mod certificate;
mod conjugate;
mod direct;
mod gather;
mod gauss_seidel;
pub mod hierarchy;
mod jacobi;
mod ledger;
mod overshoot;
mod portals;
mod refine;
mod shoot;
mod smooth;
mod solution;
mod solver;
mod substructure;
mod unbiased;

pub use auto::{Ask, Pass, automatic, resolution_for};
pub use certificate::{Audit, Certificate, Sampling, audit, certify};
pub use conjugate::ConjugateGradients;
pub use direct::{Direct, OnPiece};
pub use gauss_seidel::GaussSeidel;
pub use jacobi::Jacobi;
pub use ledger::{Ledger, LostPower};
pub use overshoot::Overshoot;
pub use shoot::{Brightest, Shoot};
pub use smooth::{Resolution, Smooth, smooth};
pub use solution::{Factors, Method, Options, Progress, Solution, solve, solve_on};
pub use solver::{Outcome, Solver, Step, contraction, error_bound};
pub use substructure::{OnElements, Oracle, Sees, Substructure};
pub use unbiased::{Gathered, gather_unbiased};

use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::scene::Scene;

/// The knowns of the radiosity equation but for the form factors.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosure {
    // ANCHOR: knowns
    /// `A_i`, scene units squared.
    pub area: Vec<f64>,
    /// `E_i`, emitted radiosity, W/m².
    pub emission: Vec<Rgb>,
    /// `ρ_i`, diffuse reflectance, in `[0, 1)`.
    pub reflectance: Vec<Rgb>,
    // ANCHOR_END: knowns
}

impl Enclosure {
    /// Those of the elements of a mesh.
    pub fn of(scene: &Scene, mesh: &Mesh) -> Enclosure {
        let material = |e: &crate::mesh::Element| {
            &scene.materials[mesh.patch_of(e).material.0 as usize]
        };
        Enclosure {
            area: mesh.elements.iter().map(|e| e.polygon.area()).collect(),
            emission: mesh.elements.iter().map(|e| material(e).emission()).collect(),
            reflectance: mesh.elements.iter().map(|e| material(e).diffuse()).collect(),
        }
    }

    /// The same room under other lamps: `emission` in W/m², per element. Form factors know
    /// nothing of light, and the same serve again. For the lamps apart and together,
    /// `B(E + E') = B(E) + B(E')`: what is solved once can be dimmed without solving.
    pub fn relit(&self, emission: Vec<Rgb>) -> Enclosure {
        assert_eq!(emission.len(), self.len(), "one emission per element");
        Enclosure { emission, ..self.clone() }
    }

    /// How many elements.
    pub fn len(&self) -> usize {
        self.area.len()
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.area.is_empty()
    }

    /// `ρ_max`, per channel.
    pub fn largest_reflectance(&self) -> Rgb {
        self.reflectance.iter().fold(Rgb::ZERO, |m, &rho| m.max(rho))
    }

    /// `Σ A_i x_i`: a radiosity summed to power, W.
    pub fn power(&self, x: impl IntoIterator<Item = Rgb>) -> Rgb {
        self.area.iter().zip(x).map(|(&area, x)| area * x).sum()
    }

    /// `‖x‖² = Σ A_i x_i²`, per channel: the area norm, squared.
    pub fn norm_squared(&self, x: impl IntoIterator<Item = Rgb>) -> Rgb {
        self.power(x.into_iter().map(|x| x * x))
    }

    /// `‖r‖ / ‖B − E‖` in the worst channel: the solver's residual relative to the
    /// reflected light. 0 where nothing is left, ∞ where nothing is reflected yet.
    fn relative_residual(&self, residual: &[Rgb], radiosity: &[Rgb]) -> f64 {
        let r = self.norm_squared(residual.iter().copied());
        let reflected = radiosity.iter().zip(&self.emission).map(|(&b, &e)| b - e);
        let scale = self.norm_squared(reflected);
        let ratio = |k: usize| if r[k] == 0.0 { 0.0 } else { (r[k] / scale[k]).sqrt() };
        (0..3).map(ratio).fold(0.0, f64::max)
    }
}
