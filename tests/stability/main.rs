//! Failures, pinned row by row of the table of failures: each fails by as much as theory says.
#![allow(missing_docs)]

#[path = "../common/mod.rs"]
mod common;
#[path = "../failures/mod.rs"]
mod failures;

mod display;
mod files;
mod form_factors;
mod hemicube;
mod links;
mod mesh;
mod mirrors;
mod occlusion;
mod pairs;
mod passes;
mod rays;
mod sheets;
mod shooting;
mod sky;
mod solver;
