//! Work: what is told of a computation while it goes on.
//!
//! ```text
//! done/all      steps done, of steps in all; 0 ≤ done ≤ all
//! ```
//!
//! | part         | use it when                        | it fails when              |
//! |--------------|------------------------------------|----------------------------|
//! | [`Progress`] | somebody waits, and wants to know  | never: it decides nothing  |
//!
//! ```
//! let quiet: radiosity::work::Progress = &|_, _, _| {};
//! quiet("hemicubes", 3, 100);
//! ```
//!
//! **Not here:** clocks. Chapter *From a scene to a picture* (L08).
//! Source: none; every long computation of this crate takes one.

/// How far a computation has come: what it does, steps done, steps in all.
pub type Progress<'a> = &'a (dyn Fn(&'static str, usize, usize) + Sync);
