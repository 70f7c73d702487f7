//! Drawing scenes and numbers from a cohort's stream.

use radiosity::prelude::{DVec3, Frame, dvec3};
use radiosity::random::Stream;
use std::f64::consts::TAU;

/// A random number in `[low, high)`.
pub fn uniform(stream: &mut Stream, low: f64, high: f64) -> f64 {
    low + (high - low) * stream.next()
}

/// A random whole number in `low..high`.
pub fn whole_number(stream: &mut Stream, low: usize, high: usize) -> usize {
    uniform(stream, low as f64, high as f64) as usize
}

/// A random number in `[low, high)`, both positive; each decade is as likely.
pub fn decades(stream: &mut Stream, low: f64, high: f64) -> f64 {
    uniform(stream, low.ln(), high.ln()).exp()
}

/// A random direction of unit length, uniform over the sphere.
pub fn direction(stream: &mut Stream) -> DVec3 {
    let z = uniform(stream, -1.0, 1.0);
    let (sine, cosine) = (TAU * stream.next()).sin_cos();
    let across = (1.0 - z * z).sqrt();
    dvec3(across * cosine, across * sine, z)
}

/// A random frame: scenes that are turned at random hide no axis.
pub fn frame(stream: &mut Stream) -> Frame {
    Frame::towards(direction(stream), direction(stream))
}
