//! The experiment of the report question: what is a shadow's edge worth?
//!
//! `cargo run -p labs --example shadow_edge` runs it on the student's work.

use super::Work;
use super::given::Sample;

/// After a round of splitting.
#[derive(Clone, Copy, Debug)]
pub struct Round {
    /// How many elements there are.
    pub elements: usize,
    /// `√Σ A Δ²/12`, the error that the oracle sees.
    pub error: f64,
}

/// A square with a shadow on one side of the line `x + y/3 = 0.37`: rounds of marking and
/// splitting in four, each allowed an error of `tolerance`, until nothing is marked or `most`
/// rounds are done.
pub fn rounds(work: &Work, tolerance: f64, smallest: f64, most: usize) -> Vec<Round> {
    let mut squares = vec![[0.0, 0.0, 1.0]];
    let mut done = Vec::new();
    for _ in 0..most {
        let samples: Vec<Sample> = squares.iter().map(sample).collect();
        let square = |e: &Sample| {
            let of = |f: fn(f64, f64) -> f64| e.radiosity.iter().copied().reduce(f);
            let rise = of(f64::max).zip(of(f64::min)).map_or(0.0, |(a, b)| a - b);
            e.area * rise * rise / 12.0
        };
        let error = samples.iter().map(square).sum::<f64>().sqrt();
        done.push(Round { elements: squares.len(), error });
        let share = tolerance * tolerance / squares.len() as f64;
        let marks = (work.marks)(&samples, share, smallest);
        if !marks.contains(&true) {
            break;
        }
        let four = |(&[x, y, h], &split): (&[f64; 3], &bool)| match split {
            true => {
                let h = h / 2.0;
                vec![[x, y, h], [x + h, y, h], [x, y + h, h], [x + h, y + h, h]]
            }
            false => vec![[x, y, h]],
        };
        squares = squares.iter().zip(&marks).flat_map(four).collect();
    }
    done
}

fn sample(&[x, y, h]: &[f64; 3]) -> Sample {
    let light = |u: f64, v: f64| {
        if x + u * h + (y + v * h) / 3.0 < 0.37 { 1.0 } else { 0.0 }
    };
    let places = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.5, 0.5)];
    Sample { area: h * h, radiosity: places.map(|(u, v)| light(u, v)).to_vec() }
}
