//! The experiment of the report question: how many rays until the noise is gone?
//!
//! `cargo run -p labs --example past_the_noise` runs it on the student's work.

use super::Work;
use super::given::Point;
use crate::draw::uniform;
use radiosity::random::Stream;

/// Norms of the residual of one field, relative to the reflected light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Without noise.
    pub truth: f64,
    /// By the student's product of two gathers; 0 when the product is negative.
    pub product: f64,
    /// By the square of one.
    pub square: f64,
}

/// A field that is off by 2 % here and there, at `points` points with gathers of so many
/// rays, each of which is off by a half on its own.
pub fn norms(work: &Work, points: usize, rays: usize) -> Found {
    let mut stream = Stream::named(rays as u64, &[points as u64]);
    let half = 0.5 * (3.0 / rays as f64).sqrt();
    let mut point = |k: usize| {
        let off = if k.is_multiple_of(2) { 0.02 } else { -0.02 };
        Point {
            area: 1.0 / points as f64,
            emission: 0.0,
            reflectance: 0.5,
            stored: 0.5 * (1.0 + off),
            gathered: [0; 2].map(|_| 1.0 + uniform(&mut stream, -half, half)),
        }
    };
    let points: Vec<Point> = (0..points).map(&mut point).collect();
    let with = |gathered: fn(&Point) -> [f64; 2]| -> f64 {
        let of = |p: &Point| Point { gathered: gathered(p), ..*p };
        let points: Vec<Point> = points.iter().map(of).collect();
        let norm = (work.squared)(&points).max(0.0).sqrt();
        (work.relative)(norm, &points)
    };
    Found {
        truth: with(|_| [1.0; 2]),
        product: with(|p| p.gathered),
        square: with(|p| [p.gathered[0]; 2]),
    }
}
