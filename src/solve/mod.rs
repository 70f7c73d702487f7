//! Solving the radiosity equation, with an account of where the light went.
//!
//! ```text
//! B_i = E_i + ρ_i H_i + τ_i H_back(i),   H_i = Σ_j F_ij B_j      gathering, W/m²
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
//! an error. A certificate ([`crate::certificate`]) then says how far the field is from the truth. The last makes
//! a system that is smaller, for any of them to solve.
//!
//! ```
//! use radiosity::form_factor::{FormFactors, analytic::Analytic};
//! use radiosity::solve::{Enclosure, Jacobi, Solver};
//! use radiosity::{mesh::Mesh, scene::built_in};
//! let scene = built_in("furnace").unwrap(); // E = 1, ρ = ½ on all walls: B = E/(1 − ρ)
//! let mesh = Mesh::whole(&scene);
//! let factors = Analytic::new(&scene, &mesh, 1e-9, 0).matrix(&|| {});
//! let enclosure = Enclosure::of(&scene, &mesh);
//! let mut gathering = Jacobi::new(&enclosure, &factors);
//! assert!(gathering.run(0.5, 1e-6, 100).converged);
//! assert!(gathering.radiosity().iter().all(|b| (b.x - 2.0).abs() < 1e-5));
//! ```
//!
//! **Not here:** the factors ([`crate::form_factor`]); what a camera sees.
//! Chapters *The radiosity equation* (L06), *Solving it*, *Patches and elements* (L11, L12),
//! *Progressive refinement* (L13, L14).
//! Sources: Goral et al. 1984; Cohen & Greenberg 1985; Cohen, Chen, Wallace &
//! Greenberg 1988; Hestenes & Stiefel 1952.

mod conjugate;
mod gather;
mod gauss_seidel;
pub mod hierarchy;
mod jacobi;
mod ledger;
mod overshoot;
mod shoot;
mod solver;
mod substructure;

pub use conjugate::ConjugateGradients;
pub use gauss_seidel::GaussSeidel;
pub use jacobi::Jacobi;
pub use ledger::{Ledger, LostPower};
pub use overshoot::Overshoot;
pub use shoot::{Brightest, Shoot};
pub use solver::{Outcome, Solver, Step, contraction, error_bound};
pub use substructure::{OnElements, Oracle, Sees, Substructure};

use crate::geometry::Rgb;
use crate::mesh::{ElementId, Mesh};
use crate::scene::Scene;

/// The knowns of the radiosity equation but for the form factors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Enclosure {
    // ANCHOR: knowns
    /// `A_i`, scene units squared.
    pub area: Vec<f64>,
    /// `E_i`, emitted radiosity, W/m².
    pub emission: Vec<Rgb>,
    /// `ρ_i`, diffuse reflectance, in `[0, 1)`.
    pub reflectance: Vec<Rgb>,
    // ANCHOR_END: knowns
    /// Of elements that let light through diffusely, the other side; empty: none does.
    pub through: Vec<Option<Through>>,
}

/// What an element lets through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Through {
    /// `τ`, diffuse transmittance, in `[0, 1)`; with `ρ` less than 1.
    pub transmittance: Rgb,
    /// The element in the same place that looks the other way.
    pub back: ElementId,
}

impl Enclosure {
    /// Those of the elements of a mesh.
    pub fn of(scene: &Scene, mesh: &Mesh) -> Enclosure {
        let material = |e| mesh.material(scene, e);
        Enclosure {
            area: mesh.elements.iter().map(|e| e.polygon.area()).collect(),
            emission: mesh.elements.iter().map(|e| material(e).emission()).collect(),
            reflectance: mesh.elements.iter().map(|e| material(e).diffuse()).collect(),
            through: through(scene, mesh),
        }
    }

    /// Does any element let light through?
    pub fn is_translucent(&self) -> bool {
        !self.through.is_empty()
    }

    // ANCHOR: passed
    /// `τ_i H_back(i)`, W/m²: what comes through element `i` from its other side.
    pub fn passed(&self, i: usize, irradiance: &[Rgb]) -> Rgb {
        let through = self.through.get(i).copied().flatten();
        through.map_or(Rgb::ZERO, |t| t.transmittance * irradiance[t.back])
    }
    // ANCHOR_END: passed

    /// `ρ_i + τ_i`: the share of what arrives that leaves again, on either side.
    pub fn scattered(&self, i: usize) -> Rgb {
        let through = self.through.get(i).copied().flatten();
        self.reflectance[i] + through.map_or(Rgb::ZERO, |t| t.transmittance)
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

    /// `max (ρ + τ)`, per channel.
    pub fn largest_reflectance(&self) -> Rgb {
        (0..self.len()).fold(Rgb::ZERO, |m, i| m.max(self.scattered(i)))
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
    pub(crate) fn relative_residual(&self, residual: &[Rgb], radiosity: &[Rgb]) -> f64 {
        let r = self.norm_squared(residual.iter().copied());
        let reflected = radiosity.iter().zip(&self.emission).map(|(&b, &e)| b - e);
        let scale = self.norm_squared(reflected);
        let ratio = |k: usize| if r[k] == 0.0 { 0.0 } else { (r[k] / scale[k]).sqrt() };
        (0..3).map(ratio).fold(0.0, f64::max)
    }
}

/// For each element of a translucent face its other side; empty if there is none.
fn through(scene: &Scene, mesh: &Mesh) -> Vec<Option<Through>> {
    let mut of_surface: Vec<Vec<u32>> = vec![Vec::new(); scene.surfaces.len()];
    for (k, element) in (0u32..).zip(&mesh.elements) {
        of_surface[mesh.surface_of(element) as usize].push(k);
    }
    let of = |element: &crate::mesh::Element| {
        let surface = &scene.surfaces[mesh.surface_of(element) as usize];
        let transmittance = scene.material(surface).translucence();
        let twins = &of_surface[surface.back? as usize];
        let back = mesh.nearest_of(twins, element.polygon.centroid())?;
        let found = Through { transmittance, back: ElementId(back) };
        (transmittance != Rgb::ZERO).then_some(found)
    };
    let all: Vec<Option<Through>> = mesh.elements.iter().map(of).collect();
    if all.iter().any(Option::is_some) { all } else { Vec::new() }
}
