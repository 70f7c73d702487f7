//! The field of light of pass 1: irradiance on the elements of a mesh.
//!
//! ```text
//! H(x) = H_direct(x) + H_reflected(x)            W/m², on the front of a surface
//! B(x) = E + ρ H(x) + τ H_behind(x)              what leaves it
//! ```
//!
//! | method              | use it when                         | it fails when              |
//! |---------------------|-------------------------------------|----------------------------|
//! | [`smooth()`]        | a field is wanted, to an error      | surfaces are many: m² rows |
//! | [`gather_unbiased`] | all that is faster is to be judged  | time is short: 1/√walks    |
//!
//! **Not here:** how wrong a field is ([`crate::certificate`]), and until when it is refined
//! ([`crate::solution`]). Chapters *What does this scene need?* and *Who carries which
//! light?* (L17). Sources: Cohen, Greenberg, Immel & Brock 1986; Max & Allison 1992; Kajiya
//! 1986.

mod refine;
mod smooth;
mod unbiased;

pub use smooth::{Resolution, Smooth, smooth};
pub use unbiased::{Gathered, gather_unbiased};
