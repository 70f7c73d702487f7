//! Speed against accuracy: methods run side by side, and what came out as a table and a
//! picture.
//!
//! ```text
//! transfers = Σ over steps of the factors used          work, the same on any machine
//! seconds of one processor                              time, of this machine
//! ‖B − B*‖/‖B* − E‖ ≤ residual/(1 − ρ)                  accuracy, the same for all
//! ```
//!
//! | part       | use it when                             | it fails when                   |
//! |------------|-----------------------------------------|---------------------------------|
//! | [`Race`]   | solvers are to be compared              | the machine does something else |
//! | [`patches`]| light itself is to be compared          | its truth is not finer          |
//! | [`Comparison`] | pictures are to be compared         | the reference is noisy          |
//! | [`Chart`]  | numbers span decades, both ways         | a value is 0: it has no decade  |
//!
//! **Not here:** where numbers are written to, and the clock: the command brings both. The
//! errors of form factors: `benches/form_factors.rs`.
//! Chapter *Solving it*, for the comparisons of (L13) and (L14), and *Side by side* (L22).
//! Sources: Gortler, Cohen & Slusallek 1994, who compared relaxations by their work.

pub mod patches;
pub mod race;
mod side_by_side;
mod svg;

pub use race::Race;
pub use side_by_side::{Comparison, Effort, Panel};
pub use svg::{Chart, Line, Mark};
