//! Form factors: the fraction of the power leaving one surface that reaches another.
//!
//! ```text
//! F_ij = 1/A_i ∫∫ V cosθ_i cosθ_j / (π r²) dA_j dA_i         0 ≤ F_ij ≤ 1, no unit
//! A_i F_ij = A_j F_ji (reciprocity)      Σ_j F_ij = 1 (closure, in a closed room)
//! ```

pub mod hemicube;

use crate::mesh::ElementId;

/// One way to compute form factors: the place where methods are exchanged under a solver.
pub trait FormFactors: Sync {
    /// How many elements there are.
    fn len(&self) -> usize;

    /// Writes to `row[j]` the factor from element `from` to the front of element `j`, and
    /// returns what reaches no front. `row` has [`FormFactors::len`] entries.
    fn row(&self, from: ElementId, row: &mut [f64]) -> Lost;

    /// Is there no element?
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// The shares of an element's power that reach no front side, as the method counts them
/// (never as one minus the rest).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lost {
    /// Leaves the scene: empty hemicube cells, rays that hit nothing.
    pub escaped: f64,
    /// Falls on the black back of a surface, and is absorbed there.
    pub absorbed: f64,
}
