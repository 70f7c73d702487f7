//! The experiment of the report question: who goes first where lamps are small?
//!
//! `cargo run -p labs --example who_first` runs it on the student's work.

use super::Work;
use super::given::{By, Light};
use crate::gather::given::Room;
use crate::gather::rooms::ball;

/// A white ball of 6 m² with a lamp of 1 m² and many specks, each `brighter` times as
/// bright as the lamp; together they emit a tenth of its power.
pub fn specks(count: usize, brighter: f64) -> Room {
    let speck = 0.1 / (brighter * count as f64);
    let mut area = vec![speck; count];
    area.extend([1.0; 6]);
    let mut room = ball(area);
    room.reflectance.fill(0.5);
    room.emission[..count].fill(brighter);
    room.emission[count] = 1.0;
    room
}

/// The share of the emitted power that is unshot after each of so many shots.
pub fn unshot(work: &Work, room: &Room, by: By, shots: usize) -> Vec<f64> {
    let power = |x: &[f64]| x.iter().zip(&room.area).map(|(x, a)| a * x).sum::<f64>();
    let mut light = Light {
        irradiance: vec![0.0; room.area.len()],
        radiosity: room.emission.clone(),
        unshot: room.emission.clone(),
    };
    let shot = |_| {
        if let Some(from) = (work.brightest)(room, &light.unshot, by) {
            (work.shoot)(room, &mut light, from);
        }
        power(&light.unshot) / power(&room.emission)
    };
    (0..shots).map(shot).collect()
}
