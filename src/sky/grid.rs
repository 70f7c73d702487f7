//! Cells of a sphere between meridians and parallels, and draws among them by
//! brightness.
//!
//! In the sky's own axes: x right, y up, z back. Rows go from the pole down, columns
//! from the seam behind, around by the left, the front (`−z`) and the right.

use crate::random::Shares;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// `width × height` cells from the pole down to the polar angle `bottom`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Grid {
    pub width: usize,
    pub height: usize,
    pub bottom: f64,
}

impl Grid {
    /// Polar angle from up at `row`; whole numbers are the edges of rows.
    pub fn polar(&self, row: f64) -> f64 {
        self.bottom * row / self.height as f64
    }

    /// Azimuth from the front to the right at `column`, from −π to π.
    pub fn azimuth(&self, column: f64) -> f64 {
        TAU * (column / self.width as f64 - 0.5)
    }

    // ANCHOR: direction
    /// The direction to a place in the picture; the middle of a cell is at a half.
    pub fn direction(&self, column: f64, row: f64) -> DVec3 {
        let (x, z) = self.azimuth(column).sin_cos();
        let (sin, cos) = self.polar(row).sin_cos();
        DVec3::new(sin * x, cos, -sin * z)
    }
    // ANCHOR_END: direction

    // ANCHOR: cell
    /// The column and row of the cell that holds `direction`; of the lowest row for
    /// what lies below the grid.
    pub fn cell(&self, d: DVec3) -> (usize, usize) {
        let polar = d.x.hypot(d.z).atan2(d.y);
        let azimuth = d.x.atan2(-d.z);
        let column = (azimuth / TAU + 0.5) * self.width as f64;
        let row = polar / self.bottom * self.height as f64;
        ((column as usize).min(self.width - 1), (row as usize).min(self.height - 1))
    }
    // ANCHOR_END: cell

    // ANCHOR: solid_angle
    /// Solid angle of a cell in `row`, in sr: `Δφ (cosθ₀ − cosθ₁)`, written as a
    /// product of sines, for the difference loses its digits at the pole.
    pub fn solid_angle(&self, row: usize) -> f64 {
        let (half, middle) = (self.polar(0.5), self.polar(row as f64 + 0.5));
        TAU / self.width as f64 * 2.0 * middle.sin() * half.sin()
    }
    // ANCHOR_END: solid_angle
}

/// Cells drawn as likely as they are bright and large.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Draws {
    grid: Grid,
    /// Row by row; of any unit.
    brightness: Vec<f64>,
    /// Sum of brightness × solid angle.
    total: f64,
    rows: Shares,
    /// For each row, its cells.
    columns: Vec<Shares>,
}

impl Draws {
    /// All cells are alike if all are black.
    pub fn new(grid: Grid, mut brightness: Vec<f64>) -> Draws {
        debug_assert_eq!(brightness.len(), grid.width * grid.height);
        if brightness.iter().all(|&b| b == 0.0) {
            brightness.fill(1.0);
        }
        let cells = brightness.chunks(grid.width);
        let columns =
            cells.clone().map(|row| Shares::of(row.iter().copied())).collect();
        let power = |(row, cells): (usize, &[f64])| {
            cells.iter().sum::<f64>() * grid.solid_angle(row)
        };
        let power: Vec<f64> = cells.enumerate().map(power).collect();
        let (total, rows) = (power.iter().sum(), Shares::of(power));
        Draws { grid, brightness, total, rows, columns }
    }

    // ANCHOR: sample
    /// A direction within the cell drawn; all of the cell is equally likely.
    pub fn sample(&self, u: DVec2) -> DVec3 {
        let (row, down) = self.rows.pick(u.x);
        let (column, along) = self.columns[row].pick(u.y);
        let [top, low] = [row, row + 1].map(|edge| self.grid.polar(edge as f64).cos());
        let cos = top + (low - top) * down; // not the angle: the cell widens downward
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let (x, z) = self.grid.azimuth(column as f64 + along).sin_cos();
        DVec3::new(sin * x, cos, -sin * z)
    }
    // ANCHOR_END: sample

    /// Density of [`Draws::sample`], in 1/sr.
    pub fn pdf(&self, direction: DVec3) -> f64 {
        let (column, row) = self.grid.cell(direction);
        self.brightness[row * self.grid.width + column] / self.total
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// The corners of the contract: row 0 is up, the middle column looks along −z, and
    /// columns run to the right.
    #[test]
    fn the_picture_hangs_the_right_way_round() {
        let grid = Grid { width: 8, height: 4, bottom: PI };
        let is = |column, row, d: DVec3| {
            assert!(
                (grid.direction(column, row) - d).length() < 1e-15,
                "{column} {row}"
            );
        };
        is(4.0, 2.0, DVec3::NEG_Z);
        is(6.0, 2.0, DVec3::X);
        is(2.0, 2.0, DVec3::NEG_X);
        is(0.0, 2.0, DVec3::Z);
        is(3.0, 0.0, DVec3::Y);
        is(3.0, 4.0, DVec3::NEG_Y);
    }

    #[test]
    fn the_middle_of_a_cell_lies_in_it() {
        for bottom in [PI, PI / 2.0] {
            let grid = Grid { width: 12, height: 6, bottom };
            for (column, row) in (0..12).flat_map(|c| (0..6).map(move |r| (c, r))) {
                let d = grid.direction(column as f64 + 0.5, row as f64 + 0.5);
                assert_eq!(grid.cell(d), (column, row));
            }
            let all: f64 = (0..6).map(|row| 12.0 * grid.solid_angle(row)).sum();
            assert!((all - TAU * (1.0 - bottom.cos())).abs() < 1e-14, "{all}");
        }
    }
}
