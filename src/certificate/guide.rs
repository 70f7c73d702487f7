//! Directions, drawn more often where light was found that no lamp's sample can find.

use crate::random::Shares;
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::PI;

/// The hemisphere in cells along both edges of the square that is mapped to it.
const CELLS: usize = 64;

/// At the most this share of all rays goes where light was found; the rest goes evenly.
const MOST: f64 = 0.75;

/// Light of few directions is noisier than what comes evenly: so many times as much for its
/// power.
const BOOST: f64 = 6.0;

/// Light that was found in a cell is looked for within these many cells of it, in equal
/// shares: closely, for a lamp; widely, for what few rays have found of a window.
const WITHIN: [usize; 4] = [0, 1, 4, 4];

/// How often the cells of the hemisphere over a stratum are drawn.
///
/// Light of the sky through a window, and of lamps in mirrors and through glass, comes from
/// few directions. They are much the same all over a stratum. What rays found there that are
/// never counted tells where to look again: the answer stays right on average, whatever they
/// found, and varies less.
#[derive(Clone, Debug)]
pub(super) struct Guide {
    rows: Shares,
    columns: Vec<Shares>,
}

/// What the first rays found.
#[derive(Clone, Debug)]
pub(super) struct BrightCells {
    bright: Vec<f64>,
    even: f64,
}

impl Default for BrightCells {
    fn default() -> BrightCells {
        BrightCells { bright: vec![0.0; CELLS * CELLS], even: 0.0 }
    }
}

impl BrightCells {
    /// Adds what a ray found: `bright` light of a lamp or the sky, which comes from few
    /// directions, and light that comes from all.
    pub fn add(&mut self, at: DVec2, bright: f64, even: f64) {
        let [row, column] = cell(at);
        self.bright[row * CELLS + column] += bright;
        self.even += even;
    }

    /// What is bright in a cell, spread over those about it.
    fn spread(&self) -> Vec<f64> {
        let mut spread = vec![0.0; CELLS * CELLS];
        for (k, bright) in self.bright.iter().enumerate().filter(|(_, b)| **b > 0.0) {
            for within in WITHIN {
                let [rows, columns] = [k / CELLS, k % CELLS]
                    .map(|at| at.saturating_sub(within)..=(at + within).min(CELLS - 1));
                let cells = (rows.clone().count() * columns.clone().count()) as f64;
                let each = bright / (cells * WITHIN.len() as f64);
                for row in rows {
                    spread[row * CELLS..][columns.clone()]
                        .iter_mut()
                        .for_each(|cell| *cell += each);
                }
            }
        }
        spread
    }
}

fn cell(at: DVec2) -> [usize; 2] {
    [at.x, at.y].map(|t| ((t * CELLS as f64) as usize).min(CELLS - 1))
}

impl Guide {
    // ANCHOR: guide
    /// Follows what was found.
    pub fn by(found: &BrightCells) -> Guide {
        let few = BOOST * found.bright.iter().sum::<f64>();
        let guided = if few > 0.0 { (few / (few + found.even)).min(MOST) } else { 0.0 };
        let spread = found.spread();
        let all: f64 = spread.iter().sum();
        let even = (1.0 - guided) / (CELLS * CELLS) as f64;
        let weight = |&s: &f64| even + if all > 0.0 { guided * s / all } else { 0.0 };
        let weights: Vec<f64> = spread.iter().map(weight).collect();
        let rows = weights.chunks(CELLS);
        Guide {
            columns: rows.clone().map(|row| Shares::of(row.iter().copied())).collect(),
            rows: Shares::of(rows.map(|row| row.iter().sum())),
        }
    }
    // ANCHOR_END: guide

    /// A point of the square, drawn by one that is even.
    pub fn draw(&self, [u, v]: [f64; 2]) -> DVec2 {
        let (row, down) = self.rows.pick(u);
        let (column, along) = self.columns[row].pick(v);
        dvec2(row as f64 + down, column as f64 + along) / CELLS as f64
    }

    /// The density of a direction, in 1/sr, in the frame whose z is the normal; `at` is its
    /// point of the square.
    pub fn pdf(&self, at: DVec2, direction: DVec3) -> f64 {
        let [row, column] = cell(at);
        let share = self.rows.share(row) * self.columns[row].share(column);
        share * (CELLS * CELLS) as f64 * direction.z / PI
    }
}

/// The point of the square that [`cosine_direction`](crate::radiometry::cosine_direction) maps to a direction with `z > 0`.
pub(super) fn square_of(direction: DVec3) -> DVec2 {
    let radius = direction.truncate().length().min(1.0);
    let angle = direction.y.atan2(direction.x); // (−π, π]
    let quarter = (angle / (PI / 2.0)).round();
    let along = radius * (angle - quarter * (PI / 2.0)) / (PI / 4.0);
    let o = match quarter as i32 {
        0 => dvec2(radius, along),
        1 => dvec2(-along, radius),
        -1 => dvec2(along, -radius),
        _ => dvec2(-radius, -along),
    };
    0.5 * (o + DVec2::ONE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::radiometry::cosine_direction;
    use crate::random::Stream;

    #[test]
    fn the_square_is_found_again() {
        let mut random = Stream::named(4, &[]);
        for _ in 0..10_000 {
            let at = dvec2(random.next(), random.next());
            let again = square_of(cosine_direction(at));
            assert!(again.distance(at) < 1e-7, "{at} {again}");
        }
    }

    /// The densities are those of the draws, and sum to one: `∫ f = mean of f/p`.
    #[test]
    fn what_is_drawn_has_the_density_it_says() {
        let mut found = BrightCells::default();
        found.add(dvec2(0.7, 0.2), 3.0, 4.0);
        found.add(dvec2(0.1, 0.9), 1.0, 2.0);
        let guide = Guide::by(&found);
        let mut random = Stream::named(5, &[]);
        let n = 200_000;
        let (mut even, mut cosine) = (0.0, 0.0);
        for place in random.points(n) {
            let at = guide.draw(place);
            let direction = cosine_direction(at);
            let pdf = guide.pdf(at, direction);
            even += direction.z / pdf / n as f64;
            cosine += direction.z * direction.x.powi(2) / pdf / n as f64;
        }
        assert!((even - PI).abs() < 0.01 * PI, "{even}");
        assert!((cosine - PI / 4.0).abs() < 0.01 * PI / 4.0, "{cosine}");
    }
}
