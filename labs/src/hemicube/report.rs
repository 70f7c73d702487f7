//! The experiment of the report question: a small square somewhere, facing the eye.
//!
//! `cargo run -p labs --example small_square` runs it on the student's work.

use super::Work;
use super::given::StudentHemicube;
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::mesh::ElementId;
use radiosity::prelude::{DVec3, Frame, Polygon, dvec3};
use radiosity::random::Stream;
use std::f64::consts::TAU;

/// What became of many small squares.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// The share of places at which no cell saw the square.
    pub missed: f64,
    /// The root mean square of F̂/F − 1 over all places.
    pub rms: f64,
}

/// Puts a square of this side at `places` random places 1 away, facing the element, and
/// compares a hemicube of `n` cells with the exact factor.
///
/// Directions are uniform over the upper hemisphere down to a height of 0.1, so that
/// the whole square lies above the horizon (for sides up to 0.14).
pub fn small_squares(work: &Work, n: usize, side: f64, places: usize) -> Seen {
    let mut stream = Stream::named(n as u64, &[]);
    let mut place = || {
        let z = 0.1 + 0.9 * stream.next();
        let (turn, across) = (TAU * stream.next(), (1.0 - z * z).sqrt());
        dvec3(across * turn.cos(), across * turn.sin(), z)
    };
    let squares: Vec<Polygon> =
        (0..places).map(|_| square(place(), side / 2.0)).collect();
    let own = square(DVec3::ZERO, 0.01).flipped();
    let (mut missed, mut off) = (0, 0.0);
    for lamp in squares {
        let exact = lambert_polygon(DVec3::ZERO, DVec3::Z, &lamp);
        let elements = [own.clone(), lamp];
        let mut row = [0.0; 2];
        StudentHemicube::new(work, &elements, n).row(ElementId(0), &mut row);
        missed += usize::from(row[1] == 0.0);
        off += (row[1] / exact - 1.0).powi(2);
    }
    let places = places as f64;
    Seen { missed: missed as f64 / places, rms: (off / places).sqrt() }
}

/// A square about `centre` whose front looks at the origin.
fn square(centre: DVec3, half: f64) -> Polygon {
    let frame = Frame::about(-centre.try_normalize().unwrap_or(DVec3::Z));
    let corner = |x: f64, y: f64| centre + frame.x * (x * half) + frame.y * (y * half);
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let corners = corners.iter().map(|&(x, y)| corner(x, y)).collect();
    // The corners of a square are a polygon.
    Polygon::new(corners).expect("a square")
}
