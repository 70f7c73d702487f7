//! Solutions: every solver, their goals, their certificate.
#![allow(missing_docs)]

#[path = "../common/mod.rs"]
mod common;

mod auto_shining;
mod certificate;
mod determinism;
mod directional;
mod hierarchy;
mod ledger;
mod lies;
mod many_lamps;
mod one_loop;
mod overshoot;
mod plan;
mod smooth;
mod solvers;
mod substructure;
mod translucent;
mod wrong_light;
