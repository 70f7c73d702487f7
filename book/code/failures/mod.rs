//! The gallery of failures: every row of the table with its curve or picture.

// The tests of the crate and this page call the same functions.
#[path = "../../../tests/failures/mod.rs"]
#[allow(missing_docs)]
pub mod sweeps;
