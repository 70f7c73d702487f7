//! Who has light left to send.

use super::{Room, cornell};
use crate::map;
use radiosity::film::{FalseColour, RgbImage, Shot};
use radiosity::geometry::Rgb;
use radiosity::mesh::ElementId;
use radiosity::solve::{Brightest, Shoot, Solver};
use std::f64::consts::PI;
use std::fmt::Write;

fn shoot(room: &Room) -> Shoot<'_> {
    Shoot::new(&room.enclosure, &room.factors, Brightest::ByPower)
}

/// How many elements emit in each of the first bounces.
pub fn emitting() -> Vec<usize> {
    let room = cornell();
    let mut solver = shoot(room);
    let bounce = |_| {
        let emitting = solver.brightest(usize::MAX);
        let unshot = solver.unshot().to_vec();
        for &ElementId(i) in &emitting {
            solver.send(ElementId(i), unshot[i as usize]);
        }
        emitting.len()
    };
    (0..4).map(bounce).collect()
}

/// The same as a Markdown table.
pub fn bounces() -> String {
    let n = cornell().mesh.elements.len();
    let mut text =
        String::from("| bounce | emitting elements | of all |\n|---|---|---|\n");
    for (k, count) in emitting().into_iter().enumerate() {
        let share = 100.0 * count as f64 / n as f64;
        let _ = writeln!(text, "| {} | {count} | {share:.1} % |", k + 1);
    }
    text
}

/// How often each element has shot by the time that the radiosity is `error` off.
pub fn counts(error: f64) -> Vec<u32> {
    let room = cornell();
    let mut solver = shoot(room);
    let mut counts = vec![0; room.mesh.elements.len()];
    while room.error(solver.radiosity()) > error
        && let Some(from) = solver.next().and_then(|step| step.shot)
    {
        counts[from] += 1;
    }
    counts
}

/// How many have shot at all.
pub fn rows_used(counts: &[u32]) -> usize {
    counts.iter().filter(|&&count| count > 0).count()
}

/// Shots and rows to ever smaller errors, as a Markdown table.
pub fn rows() -> String {
    let n = cornell().mesh.elements.len();
    let mut text =
        String::from("| error | shots | rows | of all |\n|---|---|---|---|\n");
    for error in [0.5, 0.2, 0.1, 0.05, 0.02, 0.01] {
        let counts = counts(error);
        let (shots, rows) = (counts.iter().sum::<u32>(), rows_used(&counts));
        let (error, share) = (100.0 * error, 100.0 * rows as f64 / n as f64);
        let _ = writeln!(text, "| {error} % | {shots} | {rows} | {share:.0} % |");
    }
    text
}

/// In how few elements most of the unshot light is, as a Markdown table.
pub fn held() -> String {
    let room = cornell();
    let mut text = String::from(
        "| after | with light left | half of it is in | nine tenths are in |\n\
         |---|---|---|---|\n",
    );
    let mut solver = shoot(room);
    let mut made = 0;
    for shots in [1, 4, 10, 100, 1000] {
        solver.by_ref().take(shots - made).for_each(drop);
        made = shots;
        let power = |&ElementId(i): &ElementId| {
            room.enclosure.area[i as usize] * solver.unshot()[i as usize].element_sum()
        };
        let lit: Vec<f64> = solver.brightest(usize::MAX).iter().map(power).collect();
        let all: f64 = lit.iter().sum();
        let holding = |share: f64| {
            let sums = lit.iter().scan(0.0, |sum, power| {
                *sum += power;
                Some(*sum)
            });
            1 + sums.take_while(|&sum| sum < share * all).count()
        };
        let (half, most) = (holding(0.5), holding(0.9));
        let _ = writeln!(text, "| {shots} | {} | {half} | {most} |", lit.len());
    }
    text
}

/// The error that the map is for.
pub const ERROR: f64 = 0.02;

/// The range of its colours.
const RANGE: (f64, f64) = (1.0, 8.0);

/// The Cornell box, each element in the colour of the times that it has shot; grey when
/// never.
pub fn picture() -> RgbImage {
    let room = cornell();
    let counts = counts(ERROR);
    let times: Vec<Rgb> =
        counts.iter().map(|&count| Rgb::splat(PI * f64::from(count))).collect();
    let shot = Shot { camera: room.camera, width: 192, height: 192, samples: 1 };
    let colours = FalseColour { low: RANGE.0, high: RANGE.1 };
    shot.flat(&room.mesh, &times).map(|count| match count.x {
        never if never < 0.5 => [96, 96, 96],
        count => colours.colour(count),
    })
}

/// The key to the map.
pub fn key() -> String {
    map::key(RANGE.0, RANGE.1, 4, |times| format!("{times:.0}"))
}

/// What the map says.
pub fn caption() -> String {
    let counts = counts(ERROR);
    let (n, rows) = (counts.len(), rows_used(&counts));
    let most = counts.iter().max().copied().unwrap_or(0);
    format!(
        "The Cornell box, {n} elements, by the time that it is {} % off: {} shots \
         from {rows} elements, some of which shot {most} times. Grey have not shot \
         yet.\n",
        100.0 * ERROR,
        counts.iter().sum::<u32>()
    )
}
