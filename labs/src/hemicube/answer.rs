//! One right answer: cells weighed at their centres (Cohen & Greenberg 1985).
#![deny(warnings)]

use super::Work;
use super::given::{FACES, Fragment, Item, Weights};
use radiosity::form_factor::Lost;
use std::f64::consts::PI;

/// Task 1: cosθ cosθ' ΔA / (π r²), where both cosines are 1/r and r² = x² + y² + 1.
pub fn top_factor(x: f64, y: f64, edge: f64) -> f64 {
    let r2 = x * x + y * y + 1.0;
    edge * edge / (PI * r2 * r2)
}

/// Task 1: here the element's cosine is z/r and the cell's is 1/r.
pub fn side_factor(y: f64, z: f64, edge: f64) -> f64 {
    let r2 = y * y + z * z + 1.0;
    z * edge * edge / (PI * r2 * r2)
}

/// Task 2: the face is 2 wide, so a cell is 2/n wide.
pub fn weights(n: usize) -> Weights {
    let edge = 2.0 / n as f64;
    let middle = |k: usize| (k as f64 + 0.5) * edge;
    let mut weights = Weights { top: Vec::new(), side: Vec::new() };
    for row in 0..n {
        for column in 0..n {
            let (x, y) = (middle(column) - 1.0, middle(row) - 1.0);
            weights.top.push(top_factor(x, y, edge));
        }
    }
    for row in 0..n / 2 {
        for column in 0..n {
            weights.side.push(side_factor(middle(column) - 1.0, middle(row), edge));
        }
    }
    weights
}

/// Task 3: keep the nearest, and remember how near it was.
pub fn item_buffer(cells: usize, own: usize, fragments: &[Fragment]) -> Vec<Item> {
    let mut items = vec![Item::Nothing; cells];
    let mut depth = vec![f64::INFINITY; cells];
    for fragment in fragments {
        let cell = fragment.cell;
        if fragment.element != own && fragment.depth < depth[cell] {
            depth[cell] = fragment.depth;
            items[cell] =
                if fragment.front { Item::Front(fragment.element) } else { Item::Back };
        }
    }
    items
}

/// Task 4: every cell's weight goes to what the cell sees.
pub fn factor_row(
    items: &[Vec<Item>; FACES],
    weights: &Weights,
    row: &mut [f64],
) -> Lost {
    let mut lost = Lost::default();
    row.fill(0.0);
    for (face, items) in items.iter().enumerate() {
        let weights = if face == 0 { &weights.top } else { &weights.side };
        for (item, weight) in items.iter().zip(weights) {
            match item {
                Item::Front(element) => row[*element] += weight,
                Item::Back => lost.absorbed += weight,
                Item::Nothing => lost.escaped += weight,
            }
        }
    }
    lost
}

/// Task 5: reciprocity, A_i F_ij = A_j F_ji.
pub fn shooting_factors(row: &[f64], areas: &[f64], from: usize) -> Vec<f64> {
    row.iter().zip(areas).map(|(f, area)| f * areas[from] / area).collect()
}

/// What is handed in.
pub const WORK: Work = Work {
    top_factor,
    side_factor,
    weights,
    item_buffer,
    factor_row,
    shooting_factors,
};
