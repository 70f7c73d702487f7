//! The experiment of the report question: how good is the factor of a patch, taken at its
//! centre?
//!
//! `cargo run -p labs --example centre_point` runs it on the student's work.

use super::Work;
use radiosity::form_factor::named::parallel_rectangles;
use radiosity::prelude::{DVec3, dvec3};

/// The factor from one unit square to another straight opposite.
#[derive(Clone, Copy, Debug)]
pub struct Factors {
    /// From the centre of the one, by the student's formula.
    pub from_centre: f64,
    /// From all of it: the exact one.
    pub exact: f64,
}

/// Takes two unit squares at this distance.
pub fn opposed(work: &Work, distance: f64) -> Factors {
    let corners = [(-0.5, -0.5), (-0.5, 0.5), (0.5, 0.5), (0.5, -0.5)];
    let lid = corners.map(|(x, y)| dvec3(x, y, distance));
    Factors {
        from_centre: (work.form_factor)(DVec3::ZERO, DVec3::Z, &lid),
        exact: parallel_rectangles(1.0, 1.0, distance),
    }
}
