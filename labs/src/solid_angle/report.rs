//! The experiment of the report question: how many digits are right, of how small a
//! triangle?
//!
//! `cargo run -p labs --example digits` runs it on the student's work.

use super::Work;
use crate::shapes::Place;
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;

/// The root mean square of the relative error.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// Of `small`, the triangle taken at its centre.
    pub small: f64,
    /// Of `triangle`.
    pub triangle: f64,
    /// Of twice the `acos` of cos(Ω/2).
    pub by_cosine: f64,
}

/// Looks at `places` triangles, half squares of edge `size` seen from a distance of 1 and
/// turned at random; the corner at the right angle lies nearest.
pub fn errors(work: &Work, size: f64, places: usize) -> Errors {
    let mut stream = Stream::named(1, &[]);
    let exact = 0.5 * (size * size).atan2((1.0 + 2.0 * size * size).sqrt());
    let mut sums = [0.0; 3];
    for _ in 0..places {
        let place = Place::about_origin(&mut stream, 1.0);
        let corner = |x: f64, y: f64| place.of(dvec3(x, y, 1.0));
        let [a, b, c] = [corner(0.0, 0.0), corner(size, size), corner(size, 0.0)];
        let across = (b - a).cross(c - a);
        let (centre, area) = ((a + b + c) / 3.0, 0.5 * across.length());
        let found = [
            (work.small)(centre, across.normalize(), area),
            (work.triangle)(a, b, c),
            by_cosine(a, b, c),
        ];
        for (sum, value) in sums.iter_mut().zip(found) {
            *sum += (value / exact - 1.0).powi(2);
        }
    }
    let [small, triangle, by_cosine] = sums.map(|sum| (sum / places as f64).sqrt());
    Errors { small, triangle, by_cosine }
}

/// ```text
/// cos(Ω/2) = (1 + a·b + b·c + c·a) / √(2 (1 + a·b) (1 + b·c) (1 + c·a))
/// ```
/// of unit vectors: right, and of no use for small triangles.
fn by_cosine(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let (a, b, c) = (a.normalize(), b.normalize(), c.normalize());
    let (ab, bc, ca) = (a.dot(b), b.dot(c), c.dot(a));
    let below = (2.0 * (1.0 + ab) * (1.0 + bc) * (1.0 + ca)).sqrt();
    2.0 * ((1.0 + ab + bc + ca) / below).min(1.0).acos()
}
