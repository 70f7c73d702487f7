//! Who sees whom: the matrix of form factors as a picture, and what it becomes.

use super::system::System;
use crate::hemicube::view::paint;
use crate::map;
use radiosity::film::{FalseColour, Picture, RgbImage};
use radiosity::geometry::Rgb;
use std::sync::OnceLock;

/// A coarse box: a pixel for each pair.
fn room() -> &'static System {
    static SYSTEM: OnceLock<System> = OnceLock::new();
    SYSTEM.get_or_init(|| System::of("cornell", 0.14))
}

/// Pixels of the band beside the matrix that shows the paint of each element.
const BAND: u32 = 8;

/// The range of the colours.
const RANGE: (f64, f64) = (1e-4, 0.1);

/// `F`: row by row, what each element sees.
pub fn factors() -> Vec<Vec<f64>> {
    let room = room();
    let n = room.mesh.elements.len();
    let dense = |row: &radiosity::form_factor::Row| {
        let mut all = vec![0.0; n];
        row.factors().iter().for_each(|&(j, f)| all[j as usize] = f);
        all
    };
    room.factors.rows().iter().map(dense).collect()
}

/// `F + F ρF + F ρF ρF + …`, the green channel: what each element gets of a unit of
/// emission from each other, by all ways.
pub fn by_all_ways() -> Vec<Vec<f64>> {
    let room = room();
    let n = room.mesh.elements.len();
    let column = |j: usize| {
        let mut unit = vec![Rgb::ZERO; n];
        unit[j] = Rgb::Y;
        let mut b = unit.clone();
        for _ in 0..60 {
            b = room.bounced(&b);
            b[j] += Rgb::Y;
        }
        room.arriving(&b).into_iter().map(|h| h.y).collect::<Vec<f64>>()
    };
    let columns: Vec<_> = (0..n).map(column).collect();
    (0..n).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
}

/// A matrix as a picture, row 0 on top; what is zero is black. The bands above and on
/// the left have the paint of the elements.
pub fn picture(matrix: &[Vec<f64>]) -> RgbImage {
    let room = room();
    let scale = FalseColour { low: RANGE.0, high: RANGE.1 };
    let size = matrix.len() as u32 + BAND;
    let paint = |k: u32| paint(&room.scene, room.mesh.elements[k as usize].patch.0);
    let mut picture = Picture::new(size, size).map(|_| [255; 3]);
    for (x, y, pixel) in picture.enumerate_pixels_mut() {
        // A white line of one pixel parts the bands from the matrix.
        pixel.0 = match (x.checked_sub(BAND), y.checked_sub(BAND)) {
            (Some(j), Some(i)) => match matrix[i as usize][j as usize] {
                0.0 => [0; 3],
                value => scale.colour(value),
            },
            (Some(j), None) if y + 1 < BAND => paint(j),
            (None, Some(i)) if x + 1 < BAND => paint(i),
            _ => [255; 3],
        };
    }
    picture
}

/// The share of the pairs that see something of each other.
pub fn filled(matrix: &[Vec<f64>]) -> f64 {
    let (n, seen) =
        (matrix.len(), matrix.iter().flatten().filter(|f| **f > 0.0).count());
    seen as f64 / (n * n) as f64
}

/// The caption of the two pictures.
pub fn caption() -> String {
    let (direct, all) = (factors(), by_all_ways());
    format!(
        "{n} elements of the Cornell box, one pixel for each of {pairs} pairs; the \
         bands show their paint (lamp: yellow; patches differ in brightness). Left: \
         the form factors; {:.0} % of the pairs see each other. Right: what arrives \
         by all ways together; {:.0} % of the pairs light each other. What stays \
         black is the floor under the blocks.",
        100.0 * filled(&direct),
        100.0 * filled(&all),
        n = direct.len(),
        pairs = direct.len() * direct.len(),
    )
}

/// The key to the colours.
pub fn key() -> String {
    map::key(RANGE.0, RANGE.1, 4, |v| format!("{v:.0e}"))
}
