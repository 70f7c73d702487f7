//! One right answer.
#![deny(warnings)]

use super::Work;
use super::given::{Hidden, Near, Room, Slow};

/// Task 1: two thirds of (side/distance)², and some more than is asked for.
pub fn near(wanted: f64) -> Near {
    let error = 1.4 * wanted;
    Near { distance: (2.0 / 3.0 / error).sqrt(), error }
}

/// Task 2: it is seen when the middle of a cell lies in it; all light of the places
/// where it is not seen is at those where it is.
pub fn hidden(cells: u32, missed: f64) -> Hidden {
    let (cell, seen) = (2.0 / f64::from(cells), 1.0 - missed);
    Hidden { side: cell * seen.sqrt(), brightness: 1.0 / seen }
}

/// Task 3: what a bounce does to light that has bounced very often.
pub fn runaway(factors: &[Vec<f64>]) -> f64 {
    let mut light = vec![1.0; factors.len()];
    let mut growth = 1.0;
    for _ in 0..2000 {
        let bounced = |row: &Vec<f64>| -> f64 {
            row.iter().zip(&light).map(|(f, b)| f * b).sum::<f64>()
        };
        let next: Vec<f64> = factors.iter().map(bounced).collect();
        growth = next.iter().sum::<f64>() / light.iter().sum::<f64>();
        light = next.iter().map(|b| b / growth).collect();
    }
    1.0 / growth
}

/// Task 4: after k bounces ρ^(k+1) is missing; the last one added ρ^k (1 − ρ).
pub fn slow(sweeps: u32, missing: f64) -> Slow {
    let reflectance = missing.powf(1.0 / f64::from(sweeps + 1));
    Slow { reflectance, behind: reflectance / (1.0 - reflectance) }
}

/// Task 5: what the ceiling gets from the floor it gets less from a wall, and so on
/// round a ring of four: floor, ceiling, wall, opposite wall.
pub fn lawful(room: &Room, wanted: f64) -> Vec<Vec<f64>> {
    let mut factors = room.factors.clone();
    let power = wanted * room.area[4] * room.factors[4][5];
    for (i, j, sign) in [(4, 5, 1.0), (5, 0, -1.0), (0, 1, 1.0), (1, 4, -1.0)] {
        factors[i][j] += sign * power / room.area[i];
        factors[j][i] += sign * power / room.area[j];
    }
    factors
}

/// What is handed in.
pub const WORK: Work = Work { near, hidden, runaway, slow, lawful };
