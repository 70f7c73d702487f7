//! Form factors: their methods, the hemicube, meshes, the item buffer, mirrors.
#![allow(missing_docs)]

#[path = "../common/mod.rs"]
mod common;

mod area_sampling;
mod extended_factors;
mod hemicube;
mod hybrid;
mod mesh_split;
mod methods;
mod mirrors;
mod pair;
mod pictures;
mod raster;
