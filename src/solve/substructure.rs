//! Substructuring: light leaves patches, and arrives at elements.
//!
//! ```text
//! F_pq = Σ_e A_e F_eq / A_p                     over the elements e of patch p
//! B_p  = E_p + ρ_p Σ_q F_pq B_q                 m equations: the patches
//! B_e  = E_p + ρ_p Σ_q F_eq B_q                 one sum for each of the n elements
//! ```
//! How bright a patch is in each of its corners matters little to what is far away: its mean
//! will do. How bright it is *seen* to be matters a lot. So many elements receive, few patches
//! send, and `m n` factors are computed instead of `n²`. Elements of one patch do not see
//! each other, since a patch is flat.
//!
//! The mean of what the elements gather is what their patch has, for the patch's factors are
//! the means of theirs. So the two levels agree, and have one ledger between them.
//!
//! | part                  | use it when                            | it fails when            |
//! |-----------------------|----------------------------------------|--------------------------|
//! | [`Substructure`]      | few patches light many elements        | patches are seen close by|
//! | [`Oracle`]            | elements are to be small where it pays | what it looks at is alike|
//!
//! **Not here:** patches that are linear between their corners; links between patches of
//! several sizes; faces that let light through diffusely. Chapter *Patches and elements* (L11, L12).
//! Sources: Cohen, Greenberg, Immel & Brock 1986.

use super::{Enclosure, GaussSeidel, Outcome, Solver, contraction};
use crate::form_factor::{Lost, Matrix, Row};
use crate::geometry::Rgb;
use crate::material::Material;
use crate::mesh::{Element, Mesh, Patch, VertexId};
use crate::scene::Scene;
use rayon::prelude::*;
use std::collections::HashMap;
use std::fmt;

/// What an element sees: writes to `row[q]` the form factor from the element to patch `q`,
/// and returns what reaches no front.
///
/// Any method will do that can ask from a place of its own; see [`Substructure::new`]. What
/// it says of the element's own patch does not count: that is 0.
pub type Sees<'a> = dyn Fn(&Element, &mut [f64]) -> Lost + Sync + 'a;

/// Patches that send, divided into elements that receive.
pub struct Substructure<'a> {
    scene: &'a Scene,
    sees: &'a Sees<'a>,
    mesh: Mesh,
    rows: Vec<Row>,
    computed: usize,
}

impl fmt::Debug for Substructure<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Substructure { scene, mesh, computed, .. } = self;
        write!(f, "Substructure of {}: {mesh:?}, {computed} rows", scene.name)
    }
}

/// The light of a [`Substructure`].
#[derive(Clone, Debug, PartialEq)]
pub struct OnElements {
    /// `B`, W/m², per patch: what other patches see of it.
    pub patches: Vec<Rgb>,
    /// `H`, W/m², per element.
    pub irradiance: Vec<Rgb>,
    /// `B`, W/m², per element.
    pub radiosity: Vec<Rgb>,
    /// How the patches' equations were solved. Its ledger is that of the elements too.
    pub outcome: Outcome,
}

impl<'a> Substructure<'a> {
    /// Computes the factors from each element of `mesh` to each of its patches.
    ///
    /// With hemicubes, the patches being the elements of a mesh of their own:
    ///
    /// ```
    /// # use radiosity::{form_factor::hemicube::Hemicube, mesh::{Element, Mesh}};
    /// # use radiosity::{scene::built_in, solve::Substructure};
    /// let scene = built_in("furnace").unwrap();
    /// let patches = Mesh::patched(&scene, 0.5);
    /// let cube = Hemicube::new(&patches, 64);
    /// let sees = |e: &Element, row: &mut [f64]| {
    ///     cube.at(e.polygon.centroid(), e.polygon.normal(), row)
    /// };
    /// let all = vec![true; patches.elements.len()];
    /// let fine = Substructure::new(&scene, patches.split(&all), &sees);
    /// assert_eq!(fine.factors_computed(), 24 * 96); // m n, not n²
    /// ```
    ///
    /// # Panics
    /// When a face lets light through diffusely: here a patch is lit on one side.
    pub fn new(scene: &'a Scene, mesh: Mesh, sees: &'a Sees<'a>) -> Substructure<'a> {
        let is_sheet = |m: &Material| m.translucence() != Rgb::ZERO;
        assert!(
            !scene.materials.iter().any(is_sheet),
            "no faces that let light through"
        );
        let mut new = Substructure { scene, sees, rows: vec![], mesh, computed: 0 };
        new.rows = new.rows_of(&HashMap::new());
        new
    }

    /// The elements and their patches.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// How many factors were computed so far: a row of `m` for each element there ever was.
    pub fn factors_computed(&self) -> usize {
        self.computed * self.mesh.patches.len()
    }

    /// Splits elements as [`Mesh::split`] does. Only the new ones have to look around: the
    /// rows of all others are kept.
    ///
    /// # Panics
    /// When there is not one mark for each element.
    // ANCHOR: split
    pub fn split(&mut self, marked: &[bool]) {
        let finer = self.mesh.split(marked);
        let old = std::mem::replace(&mut self.mesh, finer);
        let rows = std::mem::take(&mut self.rows);
        let kept = old.elements.into_iter().map(|e| e.corners).zip(rows).collect();
        self.rows = self.rows_of(&kept);
    }
    // ANCHOR_END: split

    /// The row of each element, of those that have not been `kept` by a new look.
    fn rows_of(&mut self, kept: &HashMap<Vec<VertexId>, Row>) -> Vec<Row> {
        let m = self.mesh.patches.len();
        let known = |e: &Element| kept.get(&e.corners);
        self.computed +=
            self.mesh.elements.iter().filter(|e| known(e).is_none()).count();
        let row = |buffer: &mut Vec<f64>, e: &Element| match known(e) {
            Some(row) => row.clone(),
            None => {
                let lost = (self.sees)(e, buffer);
                buffer[e.patch] = 0.0; // what is flat does not see itself
                Row::of(buffer, lost)
            }
        };
        self.mesh.elements.par_iter().map_init(|| vec![0.0; m], row).collect()
    }

    /// `F_pq`: the mean of what the elements of patch `p` see, by their areas.
    pub fn patch_factors(&self) -> Matrix {
        // ANCHOR: patch_factors
        let row = |patch: &Patch| {
            let mut mean = vec![0.0; self.mesh.patches.len()];
            let mut lost = Lost::default();
            for (share, row) in self.shares(patch) {
                row.factors().iter().for_each(|&(q, f)| mean[q as usize] += share * f);
                lost.escaped += share * row.lost().escaped;
                lost.absorbed += share * row.lost().absorbed;
            }
            Row::of(&mean, lost)
        };
        Matrix::from_rows(self.mesh.patches.iter().map(row).collect())
        // ANCHOR_END: patch_factors
    }

    /// The share `A_e/A_p` of each element in its patch, and its row.
    fn shares(&self, patch: &Patch) -> impl Iterator<Item = (f64, &Row)> {
        let elements = patch.elements.start as usize..patch.elements.end as usize;
        let all = self.mesh.patch_area(patch);
        let share =
            move |k: usize| (self.mesh.elements[k].polygon.area() / all, &self.rows[k]);
        elements.map(share)
    }

    /// The knowns of the patches' equations.
    pub fn patches(&self) -> Enclosure {
        let material = |p: &Patch| &self.scene.materials[p.material];
        let patches = &self.mesh.patches;
        Enclosure {
            area: patches.iter().map(|p| self.mesh.patch_area(p)).collect(),
            emission: patches.iter().map(|p| material(p).emission()).collect(),
            reflectance: patches.iter().map(|p| material(p).diffuse()).collect(),
            ..Enclosure::default()
        }
    }

    // ANCHOR: gather
    /// `H`, W/m², of each element, when the patches have these radiosities.
    pub fn gather(&self, of_patches: &[Rgb]) -> Vec<Rgb> {
        let from = |&(q, f): &(u32, f64)| f * of_patches[q as usize];
        self.rows.iter().map(|row| row.factors().iter().map(from).sum()).collect()
    }
    // ANCHOR_END: gather

    /// Solves the patches' equations to this `accuracy` ([`Outcome::bound`]), and gathers
    /// from them once.
    pub fn solve(&self, accuracy: f64) -> OnElements {
        // ANCHOR: solve
        let (patches, factors) = (self.patches(), self.patch_factors());
        let mut solver = GaussSeidel::new(&patches, &factors);
        let outcome =
            solver.run(contraction(&patches, &factors), accuracy, MOST_SWEEPS);
        let irradiance = self.gather(solver.radiosity());
        // ANCHOR_END: solve
        let Enclosure { emission, reflectance, .. } =
            Enclosure::of(self.scene, &self.mesh);
        let reflected = reflectance.iter().zip(&irradiance).map(|(rho, h)| rho * h);
        let radiosity = emission.iter().zip(reflected).map(|(e, r)| e + r).collect();
        let patches = solver.radiosity().to_vec();
        OnElements { patches, irradiance, radiosity, outcome }
    }
}

/// A thousand sweeps settle reflectances up to .99.
const MOST_SWEEPS: usize = 1000;

/// Which elements are to be split: where light changes much over an element, and where
/// something may stand between it and a lamp.
///
/// ```text
/// ‖B* − B‖² ≈ Σ_e A_e Δ_e²/12        Δ = largest − least of B on the element
/// split when  A_e Δ_e²/12 > ε² ‖B − E‖²/n    and  A_e > A_min
/// ```
/// Light that rises evenly by `Δ` over an element is off from its mean by `Δ/√12`, root mean
/// square. When none of the `n` elements has more than its share of the error that is
/// allowed, the whole is within it; and equal shares are the best use of so many elements.
/// `Δ` is looked for twice: between the element's value and those of its corners, each the
/// mean of the elements about it (*gradient*); and, where something may hide a lamp, in the
/// exact light of the lamps at its corners and its middle (*visibility*).
///
/// # Accuracy
/// It knows what it looks at. A spot of light that touches neither corner nor middle is not
/// seen. At the edge of a shadow `Δ` does not fall however small elements become: there
/// `A_min` keeps their number in bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oracle {
    /// `ε`: the error that is allowed, relative to the reflected light.
    pub tolerance: f64,
    /// `A_min`, scene units squared: elements no larger than that are not split.
    pub smallest: f64,
}

impl Oracle {
    /// A mark for each element of `mesh`, which has this `radiosity` (W/m²); `lamps_rise` is
    /// by how much the light of the lamps alone, W/m², changes over an element on which
    /// something may hide them ([`Direct::rise`](crate::room::Direct::rise)).
    pub fn marks(
        &self,
        scene: &Scene,
        mesh: &Mesh,
        radiosity: &[Rgb],
        lamps_rise: &(dyn Fn(&Element) -> Rgb + Sync),
    ) -> Vec<bool> {
        let of = Enclosure::of(scene, mesh);
        let reflected = radiosity.iter().zip(&of.emission).map(|(&b, &e)| b - e);
        let whole = of.norm_squared(reflected).max_element();
        let most = self.tolerance.powi(2) * whole / of.len() as f64;
        let vertices = mesh.vertex_values(radiosity);
        // ANCHOR: marked
        let marked = |(k, e): (usize, &Element)| {
            let (area, rho) = (of.area[k], of.reflectance[k]);
            let much = |rise: Rgb| area * (rise * rise).max_element() / 12.0 > most;
            let corners = e.corners.iter().map(|&v| vertices[v]);
            area > self.smallest
                && (much(rise(corners.chain([radiosity[k]])))
                    || much(rho * lamps_rise(e)))
        };
        // ANCHOR_END: marked
        mesh.elements.par_iter().enumerate().map(marked).collect()
    }
}

/// Largest minus least, per channel.
fn rise(values: impl Iterator<Item = Rgb>) -> Rgb {
    let none = [Rgb::INFINITY, Rgb::NEG_INFINITY];
    let [low, high] = values.fold(none, |[low, high], v| [low.min(v), high.max(v)]);
    high - low
}
