//! Numbers against exact values that nobody here computed.
#![allow(missing_docs)]

#[path = "../common/mod.rs"]
mod common;

mod brdf;
mod cie171;
mod cie171_sky;
mod closed;
mod cornell;
mod enclosures;
mod form_factors;
mod mirror;
mod occluded;
mod radiosity;
mod shortcuts;
mod sky;
mod smits_jensen;
mod solid_angle;
