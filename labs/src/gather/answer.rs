//! One right answer.
#![deny(warnings)]

use super::Work;
use super::given::{Balance, Room, Solved};

/// Task 1: the mean of what element `i` sees.
pub fn arriving(room: &Room, b: &[f64], i: usize) -> f64 {
    room.factors[i].iter().zip(b).map(|(f, b)| f * b).sum()
}

/// The right-hand side of the equation of element `i`.
fn asked(room: &Room, b: &[f64], i: usize) -> f64 {
    room.emission[i] + room.reflectance[i] * arriving(room, b, i)
}

/// Task 2: a list of its own for the new values.
pub fn bounce(room: &Room, b: &[f64]) -> Vec<f64> {
    (0..b.len()).map(|i| asked(room, b, i)).collect()
}

/// Task 3: the old list becomes the new one, bit by bit.
pub fn sweep(room: &Room, b: &mut [f64]) {
    for i in 0..b.len() {
        b[i] = asked(room, b, i);
    }
}

/// Task 4: what the equation asks, less what is there.
pub fn residual(room: &Room, b: &[f64]) -> Vec<f64> {
    (0..b.len()).map(|i| asked(room, b, i) - b[i]).collect()
}

/// Task 5: each sum by area; an element keeps 1 − ρ of what arrives.
pub fn balance(room: &Room, b: &[f64]) -> Balance {
    let rest = residual(room, b);
    let power = |x: &dyn Fn(usize) -> f64| -> f64 {
        (0..b.len()).map(|i| room.area[i] * x(i)).sum()
    };
    Balance {
        emitted: power(&|i| room.emission[i]),
        absorbed: power(&|i| (1.0 - room.reflectance[i]) * arriving(room, b, i)),
        unshot: power(&|i| rest[i]),
    }
}

/// Task 6: an error E leaves a residual of (1 − ρ_max) E at least.
pub fn solve(room: &Room, accuracy: f64) -> Solved {
    let largest = |x: &[f64]| x.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let rho = largest(&room.reflectance);
    let (mut radiosity, mut sweeps) = (room.emission.clone(), 0);
    while largest(&residual(room, &radiosity)) > accuracy * (1.0 - rho) {
        sweep(room, &mut radiosity);
        sweeps += 1;
    }
    Solved { radiosity, sweeps }
}

/// What is handed in.
pub const WORK: Work = Work { arriving, bounce, sweep, residual, balance, solve };
