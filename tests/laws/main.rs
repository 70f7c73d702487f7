//! What holds of any scene, by theory: laws, mostly as properties over random input.
#![allow(missing_docs)]

#[path = "../common/mod.rs"]
mod common;

mod bounds;
mod brdf;
mod form_factors;
mod random_rooms;
mod random_rooms_found;
mod sky;
mod solve;
