//! One right answer.
#![deny(warnings)]

use super::given::{Anchor, Room, Sample};
use super::{Factor, Work};

/// Task 1: what is flat does not see itself, so nobody asks.
pub fn rows(patch_of: &[usize], patches: usize, factor: Factor) -> Vec<Vec<f64>> {
    let one = |e: usize, q: usize| if q == patch_of[e] { 0.0 } else { factor(e, q) };
    let row = |e: usize| (0..patches).map(|q| one(e, q)).collect();
    (0..patch_of.len()).map(row).collect()
}

/// Task 2: means by areas, row by row.
pub fn patch_factors(room: &Room) -> Vec<Vec<f64>> {
    let m = room.patches();
    let mut factors = vec![vec![0.0; m]; m];
    let mut whole = vec![0.0; m];
    for (e, &p) in room.patch_of.iter().enumerate() {
        whole[p] += room.area[e];
        for (f, seen) in factors[p].iter_mut().zip(&room.rows[e]) {
            *f += room.area[e] * seen;
        }
    }
    for (row, area) in factors.iter_mut().zip(whole) {
        row.iter_mut().for_each(|f| *f /= area);
    }
    factors
}

/// Task 3: the element's own row, its patch's material, the other patches' light.
pub fn gather(room: &Room, patches: &[f64]) -> Vec<f64> {
    let element = |(e, &p): (usize, &usize)| {
        let arriving: f64 = room.rows[e].iter().zip(patches).map(|(f, b)| f * b).sum();
        room.emission[p] + room.reflectance[p] * arriving
    };
    room.patch_of.iter().enumerate().map(element).collect()
}

/// Task 4: A Δ²/12, above the least area.
pub fn marks(elements: &[Sample], share: f64, smallest: f64) -> Vec<bool> {
    let mark = |e: &Sample| {
        let most = e.radiosity.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = e.radiosity.iter().copied().fold(f64::INFINITY, f64::min);
        e.area * (most - least).powi(2) / 12.0 > share && e.area > smallest
    };
    elements.iter().map(mark).collect()
}

/// Task 5: in order, so that what lies on a T-vertex finds it anchored.
pub fn anchor(values: &mut [f64], anchors: &[Anchor]) {
    for &Anchor { vertex, ends: [a, b], at } in anchors {
        values[vertex] = (1.0 - at) * values[a] + at * values[b];
    }
}

/// What is handed in.
pub const WORK: Work = Work { rows, patch_factors, gather, marks, anchor };
