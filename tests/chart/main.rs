//! Charts: the suites without a clock, and the record of other programs.
#![allow(missing_docs)]

mod kernels;
mod peers;
mod pictures;
mod race;
mod side_by_side;
mod suites;
