//! The checks of this lab.
//!
//! ```text
//! |â − a| ≲ h²        an albedo by rings of width h: the rule at their middle
//! |m̂ − m| ≲ 1/N       a moment of N × N even samples
//! ```
//! Of both, a few times as much is allowed, so that other rules pass too.

mod sums;
mod values;

use super::Work;
use crate::draw::{direction, uniform};
use crate::lab::{Check, check};
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;
use std::f64::consts::TAU;
use sums::{albedo, furnace, passive, sample, weights};
use values::{WRONG_DENSITIES, WRONG_LOBES, below, lambert, lobes, reciprocal};

/// All checks, in order of tasks.
pub const ALL: &[Check<Work>] = &[
    check(1, "lambert", "Lambert's BRDF is right above the horizon", 1, lambert),
    check(1, "lambert-below", "it is 0 below the horizon", 1, |w, s| {
        below(&|_, wi, wo| (w.lambert)(0.5, wi, wo), s, false)
    }),
    check(2, "phong", "Phong's lobe is right above the horizon", 2, |w, s| {
        lobes(w.phong, phong, WRONG_LOBES, s)
    }),
    check(2, "phong-below", "it is 0 below the horizon, and behind", 1, |w, s| {
        below(&w.phong, s, true)
    }),
    check(2, "reciprocal", "lamp and eye can be exchanged", 1, reciprocal),
    check(3, "albedo", "known albedos are found", 3, albedo),
    check(4, "pdf", "the density is right", 1, |w, s| {
        lobes(w.pdf, density, WRONG_DENSITIES, s)
    }),
    check(4, "sample", "samples follow it", 2, sample),
    check(5, "passive", "what creates light is found", 1, passive),
    check(6, "furnace", "in a white furnace a white ball vanishes", 1, furnace),
    check(6, "weights", "samples find the albedo", 1, weights),
];

/// A value of an exponent, `wi` and `wo`.
type Value = fn(f64, DVec3, DVec3) -> f64;

fn mirrored(w: DVec3) -> DVec3 {
    dvec3(-w.x, -w.y, w.z)
}

/// cosⁿα with nothing in front; where the lobe ends and below the horizon 0.
fn bare(n: f64, wi: DVec3, wo: DVec3) -> f64 {
    if wi.z <= 0.0 || wo.z <= 0.0 { 0.0 } else { power(mirrored(wo).dot(wi), n) }
}

fn power(cosine: f64, n: f64) -> f64 {
    cosine.max(0.0).powf(n)
}

fn phong(n: f64, wi: DVec3, wo: DVec3) -> f64 {
    (n + 2.0) / TAU * bare(n, wi, wo)
}

/// Of directions above the horizon, as is all that the checks of values draw.
fn density(n: f64, wi: DVec3, wo: DVec3) -> f64 {
    (n + 1.0) / TAU * bare(n, wi, wo)
}

/// A direction above the horizon, not too flat.
fn upper(stream: &mut Stream) -> DVec3 {
    let w = direction(stream);
    dvec3(w.x, w.y, w.z.abs() + 0.05).normalize()
}

/// A direction this far from the normal, in degrees, turned at random about it.
fn at(degrees: f64, stream: &mut Stream) -> DVec3 {
    let (across, up) = degrees.to_radians().sin_cos();
    let (y, x) = uniform(stream, 0.0, TAU).sin_cos();
    dvec3(across * x, across * y, up)
}
