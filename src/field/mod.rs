//! The field of light of pass 1, and the methods that find it.
//!
//! ```text
//! H(x) = Σ_sources (H_direct(x) + H_reflected(x))     W/m², on the front of a surface
//! B(x) = E + ρ H(x) + τ H_behind(x)                   what leaves it
//! ```
//! A [`Field`] is what every method of pass 1 finds: irradiance on the elements of a mesh. A
//! method says what of a room it knows ([`Pass1::knows`]) and how finely it is to look
//! ([`Fineness`]); how often it is asked is not its business.
//!
//! | method              | use it when                          | it fails when                  |
//! |---------------------|--------------------------------------|--------------------------------|
//! | [`Smooth`]          | a field is wanted, to an error       | surfaces are many: m² rows     |
//! | [`Classical`]       | the lecture's methods are compared   | there is a sky, or solid glass |
//! | [`Links`]           | elements are many, and all dull      | anything shines or transmits   |
//! | [`Everywhere`]      | light is the same everywhere         | anything is unlike the rest    |
//! | [`gather_unbiased`] | all that is faster is to be judged   | time is short: 1/√walks        |
//!
//! ```
//! use radiosity::field::{Classical, Links, Pass1};
//! use radiosity::{room::Room, scene::built_in};
//! let scene = built_in("sky-room").unwrap();
//! let refused = Links::default().knows(&Room::of(&scene)).unwrap_err();
//! assert!(refused.to_string().contains("sky"));
//! assert!(Classical::default().knows(&Room::of(&scene)).is_err());
//! ```
//!
//! **Not here:** how wrong a field is ([`crate::certificate`]), and until when it is refined
//! ([`crate::solution`]). Chapters *What does this scene need?* and *Who carries which
//! light?* (L17). Sources: Cohen, Greenberg, Immel & Brock 1986; Max & Allison 1992; Kajiya
//! 1986.

mod cannot;
mod classical;
mod everywhere;
mod links;
mod refine;
mod smooth;
mod unbiased;

pub use cannot::{Cannot, Dropped};
pub use classical::{Classical, Factors, MatrixSolver};
pub use everywhere::Everywhere;
pub use links::Links;
pub use smooth::Smooth;
pub use unbiased::{Gathered, gather_unbiased};

use crate::geometry::Rgb;
use crate::mesh::{Backs, ElementId, Mesh};
use crate::room::Room;
use crate::scene::Scene;
use crate::solve::Ledger;
use crate::work::Work;
use glam::DVec3;

/// How finely light is resolved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fineness {
    /// The longest edge of a patch, in scene units.
    pub patch: f64,
    /// Cells along the edge of a hemicube.
    pub hemicube: u32,
    /// The error that interpolating direct light may make, relative to the reflected
    /// light of the scene.
    pub direct: f64,
    /// The same for reflected light; infinite when light that was reflected twice is left
    /// out.
    pub reflected: f64,
    /// The error that the solver may leave.
    pub solver: f64,
    /// The most patches: the work grows as their square.
    pub most_patches: usize,
    /// The most elements.
    pub most_elements: usize,
    /// Names the random streams.
    pub seed: u64,
}

/// One way to find the light of a room.
pub trait Pass1: Sync {
    /// Does it know all that this room has? What it does not know is refused by name.
    fn knows(&self, room: &Room) -> Result<(), Cannot>;

    /// What of the room it leaves out, where an answer without it is still of use: gloss.
    fn drops(&self, _room: &Room) -> Option<Dropped> {
        None
    }

    /// How finely to look first, for an error of `tolerance`.
    fn first(&self, room: &Room, tolerance: f64) -> Fineness;

    /// How finely to look next, for `share` (below 1) of the error; `None` at its limits.
    fn finer(&self, room: &Room, last: &Fineness, share: f64) -> Option<Fineness>;

    /// The light of the room.
    fn field(&self, room: &Room, fineness: &Fineness, work: &Work) -> Field;
}

/// Irradiance on one side of a mesh, W/m².
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Irradiance {
    /// Per vertex: what is shown, and certified.
    pub of_vertices: Vec<Rgb>,
    /// Per element, the mean: what is told in tables.
    pub of_elements: Vec<Rgb>,
}

/// The light of one source, or of all together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lit {
    /// On the fronts.
    pub front: Irradiance,
    /// On the other side in the same place, where there is one.
    pub behind: Irradiance,
}

/// The light of a scene, linear across each element.
#[derive(Clone, Debug)]
pub struct Field {
    /// The elements.
    pub mesh: Mesh,
    /// The light of each source; of a scene's own lamps and sky together, one.
    pub sources: Vec<Lit>,
    /// How many patches shone on each other: as many as elements, unless they were split.
    pub patches: usize,
    /// Where the light went.
    pub ledger: Ledger,
    /// `‖r‖/‖B − E‖` of the discrete system.
    pub solver_residual: f64,
    /// How many sweeps, rounds or shots.
    pub steps: usize,
    /// How many hemicubes or rows of factors were computed.
    pub rows: usize,
}

impl Field {
    /// Light that is linear between the vertices of a mesh: `irradiance` on the fronts,
    /// W/m², per vertex.
    pub fn linear(scene: &Scene, mesh: Mesh, irradiance: Vec<Rgb>) -> Field {
        let behind = Backs::of(scene, &mesh).apply(&irradiance);
        let side = |of_vertices: Vec<Rgb>| {
            let of_elements = mesh.element_means(&of_vertices);
            Irradiance { of_vertices, of_elements }
        };
        let lit = Lit { front: side(irradiance), behind: side(behind) };
        Field {
            patches: mesh.elements.len(),
            mesh,
            sources: vec![lit],
            ledger: Ledger::default(),
            solver_residual: 0.0,
            steps: 0,
            rows: 0,
        }
    }

    /// Light that is constant on each element, `irradiance` W/m² on the fronts, and is
    /// shown smoothed: at a vertex the mean of the elements about it.
    pub fn constant(scene: &Scene, mesh: Mesh, irradiance: Vec<Rgb>) -> Field {
        let of_vertices = mesh.vertex_values(&irradiance);
        let mut field = Field::linear(scene, mesh, of_vertices);
        let elements = 0..irradiance.len();
        let through = crate::solve::Enclosure::of(scene, &field.mesh).through;
        let other = |k: usize| through.get(k).copied().flatten();
        let behind = elements
            .map(|k| other(k).map_or(Rgb::ZERO, |t| irradiance[t.back.0 as usize]))
            .collect();
        let lit = &mut field.sources[0];
        (lit.front.of_elements, lit.behind.of_elements) = (irradiance, behind);
        field
    }

    /// `H`, W/m², of all sources: mean of each element, on the front.
    pub fn irradiance(&self) -> Vec<Rgb> {
        self.sum(|lit| &lit.front.of_elements)
    }

    /// `B = E + ρ H + τ H_behind`, W/m², mean of each element.
    pub fn radiosity(&self, scene: &Scene) -> Vec<Rgb> {
        let (front, behind) =
            (self.irradiance(), self.sum(|lit| &lit.behind.of_elements));
        let of = |(k, element)| {
            self.mesh.material(scene, element).radiosity(front[k], behind[k])
        };
        self.mesh.elements.iter().enumerate().map(of).collect()
    }

    /// `H`, W/m², of all sources at each vertex: on the fronts, and behind them.
    pub fn vertex_irradiance(&self) -> [Vec<Rgb>; 2] {
        let front = self.sum(|lit| &lit.front.of_vertices);
        [front, self.sum(|lit| &lit.behind.of_vertices)]
    }

    /// `B`, W/m², at each vertex: what smooth shading shows, and is certified.
    pub fn vertex_radiosity(&self, scene: &Scene) -> Vec<Rgb> {
        let [front, behind] = self.vertex_irradiance();
        let mut radiosity = vec![Rgb::ZERO; self.mesh.vertices.len()];
        for element in &self.mesh.elements {
            let material = self.mesh.material(scene, element);
            for k in element.corners.iter().map(|c| c.0 as usize) {
                radiosity[k] = material.radiosity(front[k], behind[k]);
            }
        }
        radiosity
    }

    fn sum(&self, of: impl Fn(&Lit) -> &[Rgb]) -> Vec<Rgb> {
        let Some((first, others)) = self.sources.split_first() else {
            return Vec::new();
        };
        let mut sum = of(first).to_vec();
        for lit in others {
            sum.iter_mut().zip(of(lit)).for_each(|(sum, h)| *sum += h);
        }
        sum
    }

    /// What is linear across an element at a point of it, from its values at the vertices.
    pub fn at(&self, id: ElementId, x: DVec3, of_vertices: &[Rgb]) -> Rgb {
        self.mesh.value_at(self.mesh.element(id), x, of_vertices)
    }
}
