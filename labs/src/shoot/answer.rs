//! One right answer.
#![deny(warnings)]

use super::Work;
use super::given::{By, Light, Progress};
use crate::gather::given::{Balance, Room};

/// Task 1: who has nothing left is no candidate.
pub fn brightest(room: &Room, unshot: &[f64], by: By) -> Option<usize> {
    let brightness = |i: usize| match by {
        By::Power => room.area[i] * unshot[i],
        By::Radiosity => unshot[i],
    };
    (0..unshot.len())
        .filter(|&i| unshot[i] > 0.0)
        .max_by(|&i, &j| brightness(i).total_cmp(&brightness(j)))
}

/// Task 2: power is sent, shares of it arrive, and spread over the receiver's area. The
/// sender is cleared first: a hollow one sees itself, and what comes back is unshot.
pub fn shoot(room: &Room, light: &mut Light, from: usize) {
    let power = room.area[from] * light.unshot[from];
    light.unshot[from] = 0.0;
    for (to, factor) in room.factors[from].iter().enumerate() {
        let arriving = power * factor / room.area[to];
        let reflected = room.reflectance[to] * arriving;
        light.irradiance[to] += arriving;
        light.radiosity[to] += reflected;
        light.unshot[to] += reflected;
    }
}

/// `Σ A x`.
fn power(room: &Room, x: impl Fn(usize) -> f64) -> f64 {
    (0..room.area.len()).map(|i| room.area[i] * x(i)).sum()
}

/// Task 3: the unshot power, spread evenly, until all of it is absorbed.
pub fn shown(room: &Room, light: &Light) -> Vec<f64> {
    let unshot = power(room, |i| light.unshot[i]);
    let ambient = unshot / power(room, |i| 1.0 - room.reflectance[i]);
    let lit = light.radiosity.iter().zip(&room.reflectance);
    lit.map(|(b, rho)| b + rho * ambient).collect()
}

/// Task 4: of what arrived, 1 − ρ has stayed.
pub fn ledger(room: &Room, light: &Light) -> Balance {
    Balance {
        emitted: power(room, |i| room.emission[i]),
        absorbed: power(room, |i| (1.0 - room.reflectance[i]) * light.irradiance[i]),
        unshot: power(room, |i| light.unshot[i]),
    }
}

/// Task 5: at the start, what is emitted is there, and nothing of it is sent.
pub fn refine(room: &Room, shots: usize) -> Progress {
    let emission = room.emission.clone();
    let irradiance = vec![0.0; emission.len()];
    let mut light = Light { irradiance, radiosity: emission.clone(), unshot: emission };
    for _ in 0..shots {
        let Some(from) = brightest(room, &light.unshot, By::Power) else { break };
        shoot(room, &mut light, from);
    }
    Progress { picture: shown(room, &light), light }
}

/// What is handed in.
pub const WORK: Work = Work { brightest, shoot, shown, ledger, refine };
