//! Pass 1 as it is asked for by an error: resolve, certify, and finer until it suffices.
//!
//! ```text
//! ‖B* − B‖ / ‖B* − E‖ ≤ tolerance, certified
//! ```
//!
//! | entry         | use it when                              | it fails when               |
//! |---------------|------------------------------------------|-----------------------------|
//! | [`automatic`] | light is wanted, to an error             | the limits are reached      |
//! | [`solve`]     | the lecture's methods are to be compared | there is a sky              |
//! | [`solve_on`]  | the mesh is given                        | the same                    |
//!
//! **Not here:** what a scene needs ([`crate::plan`]).
//! Chapter *What does this scene need?* (L17). Sources: Lischinski, Smits & Greenberg 1994.

mod auto;
mod classical;

pub use auto::{Ask, Pass, automatic, resolution_for, sampling_for};
pub use classical::{Factors, Method, Options, Solution, solve, solve_on};
