//! The second pass, classical ray tracing and path tracing.
#![allow(missing_docs)]

#[path = "../common/mod.rs"]
mod common;

mod classes;
mod coincident;
mod cone;
mod media;
mod path_glass;
mod path_tracer;
mod pictures;
mod rays;
mod visibility;
