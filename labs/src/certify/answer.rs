//! One right answer.
#![deny(warnings)]

use super::Work;
use super::given::{Point, Room};

/// Task 1: what the equation asks, less what is there.
pub fn residual(point: &Point, gather: usize) -> f64 {
    point.emission + point.reflectance * point.gathered[gather] - point.stored
}

/// Task 2: the noises of two gathers have nothing to do with each other.
pub fn squared(points: &[Point]) -> f64 {
    points.iter().map(|p| p.area * residual(p, 0) * residual(p, 1)).sum()
}

/// Task 3: all errors against each other, or all of one sign.
pub fn worst_case(norm: f64, reflectance: f64) -> [f64; 2] {
    [norm / (1.0 + reflectance), norm / (1.0 - reflectance)]
}

/// Task 4: without the lamp's own light.
pub fn relative(norm: f64, points: &[Point]) -> f64 {
    let square = |p: &Point| p.area * (p.stored - p.emission).powi(2);
    norm / points.iter().map(square).sum::<f64>().sqrt()
}

/// Task 5: a radiosity equation whose lamp is the residual.
pub fn propagated(room: &Room, residual: &[f64]) -> Vec<f64> {
    let mut error = residual.to_vec();
    loop {
        let mut change = 0.0_f64;
        for i in 0..error.len() {
            let arriving: f64 =
                room.factors[i].iter().zip(&error).map(|(f, e)| f * e).sum();
            let new = residual[i] + room.reflectance[i] * arriving;
            change = change.max((new - error[i]).abs());
            error[i] = new;
        }
        if change < 1e-13 {
            return error;
        }
    }
}

/// What is handed in.
pub const WORK: Work = Work { residual, squared, worst_case, relative, propagated };
