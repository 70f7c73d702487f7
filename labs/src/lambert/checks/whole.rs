//! Task 5: the formula at work.

use crate::check::{Verdict, Within, compare};
use crate::draw::{direction, uniform};
use crate::lambert::Work;
use crate::shapes::{Place, room};
use radiosity::prelude::{DVec3, dvec3};
use radiosity::random::Stream;
use std::f64::consts::TAU;

/// From a point inside a room, tilted at random: all walls together are everything.
pub fn closed(work: &Work, stream: &mut Stream) -> Verdict {
    let corner = |k: usize| {
        let turn = k as f64 / 5.0 * TAU;
        dvec3(turn.cos(), turn.sin(), 0.0)
    };
    let walls = room(&(0..5).map(corner).collect::<Vec<_>>(), 1.0);
    let mut sums = Vec::new();
    for _ in 0..10 {
        let place = Place::draw(stream);
        let mut within = |low| uniform(stream, low, 0.5);
        let (x, y, z) = (within(-0.5), within(-0.5), 0.5 + within(-0.4));
        let (p, n) = (place.of(dvec3(x, y, z.min(0.9))), direction(stream));
        let seen = |wall: &Vec<DVec3>| (work.form_factor)(p, n, &place.all(wall));
        sums.push(walls.iter().map(seen).sum());
    }
    let place = |_| "the sum over the walls of a room".to_string();
    compare(&sums, &[1.0; 10], Within::Absolute(1e-7), &[], place)
}

/// The mean over 24 × 24 points of a unit square to the opposite one, 1 away. The rule is
/// off by h²/24 times the mean of −∇²F, which is below 1.
pub fn squares(work: &Work, _: &mut Stream) -> Verdict {
    const N: usize = 24;
    const F: f64 = 0.199_824_895_698_387;
    let lid = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
    let lid = lid.map(|(x, y)| dvec3(x, y, 1.0));
    let middle = |k: usize| (k as f64 + 0.5) / N as f64;
    let at = |k: usize| dvec3(middle(k % N), middle(k / N), 0.0);
    let sum: f64 = (0..N * N).map(|k| (work.form_factor)(at(k), DVec3::Z, &lid)).sum();
    let place = |_| "two unit squares, 1 apart".to_string();
    let within = Within::Absolute(1.0 / (24 * N * N) as f64);
    compare(&[sum / (N * N) as f64], &[F], within, &[], place)
}
