//! A picture of all directions: each texel is a small lamp, infinitely far away.

use super::grid::{Draws, Grid};
use crate::geometry::Rgb;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;
use std::fmt;

/// Radiance by direction, in W/(m² sr), the same all over each texel: no value between
/// two texels is made up, so that all who ask see the same light.
///
/// Row 0 is up, the middle column looks along `−Z`, columns run to the right as seen
/// from inside (while up is `+Y`); angles are even in both (latitude and longitude).
#[derive(Clone, Debug, PartialEq)]
pub struct Panorama {
    grid: Grid,
    texels: Vec<Rgb>,
    draws: Draws,
}

/// Why some texels make no panorama.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PanoramaError {
    /// Nothing is in it, or the last row is not whole.
    Size {
        /// Texels in a row.
        width: usize,
        /// All texels.
        texels: usize,
    },
    /// Too many texels.
    TooLarge {
        /// Texels in a row.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// A texel is negative, infinite or no number.
    Texel {
        /// From the left, counted from 0.
        column: usize,
        /// From above, counted from 0.
        row: usize,
        /// Its radiance.
        value: Rgb,
    },
}

/// 8192 × 4096: a gigabyte of memory.
pub(super) const MOST_TEXELS: usize = 1 << 25;

impl fmt::Display for PanoramaError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            PanoramaError::Size { width, texels } => write!(
                f,
                "has {texels} texels in rows of {width}; a sky needs one whole row at least"
            ),
            PanoramaError::TooLarge { width, height } => write!(
                f,
                "is {width}x{height} texels, and a sky has {MOST_TEXELS} at most; scale it \
                 down"
            ),
            PanoramaError::Texel { column, row, value } => write!(
                f,
                "holds the radiance ({}, {}, {}) at column {column}, row {row}; all must be \
                 finite and 0 or more",
                value.x, value.y, value.z
            ),
        }
    }
}

impl std::error::Error for PanoramaError {}

/// What decides how often a texel is drawn: all channels count alike, for they are
/// solved apart.
fn brightness(radiance: Rgb) -> f64 {
    radiance.element_sum() / 3.0
}

impl Panorama {
    /// A panorama of `texels`, row by row, `width` in each.
    ///
    /// # Errors
    /// See [`PanoramaError`].
    pub fn new(width: usize, texels: Vec<Rgb>) -> Result<Panorama, PanoramaError> {
        if texels.is_empty() || !texels.len().is_multiple_of(width) {
            return Err(PanoramaError::Size { width, texels: texels.len() });
        }
        let height = texels.len() / width;
        if texels.len() > MOST_TEXELS {
            return Err(PanoramaError::TooLarge { width, height });
        }
        let bad = |l: &Rgb| !(l.is_finite() && l.min_element() >= 0.0);
        if let Some(k) = texels.iter().position(bad) {
            let (column, row, value) = (k % width, k / width, texels[k]);
            return Err(PanoramaError::Texel { column, row, value });
        }
        let grid = Grid { width, height, bottom: PI };
        let draws = Draws::new(grid, texels.iter().map(|&l| brightness(l)).collect());
        Ok(Panorama { grid, texels, draws })
    }

    /// A panorama of what `radiance` says at the middle of each texel, with `+Y` up.
    ///
    /// # Errors
    /// See [`PanoramaError`].
    pub fn painted(
        width: usize,
        height: usize,
        radiance: impl Fn(DVec3) -> Rgb,
    ) -> Result<Panorama, PanoramaError> {
        let grid = Grid { width, height, bottom: PI };
        let middle = |k: usize| {
            grid.direction((k % width) as f64 + 0.5, (k / width) as f64 + 0.5)
        };
        let all = (0..width * height).map(|k| radiance(middle(k)));
        Panorama::new(width, all.collect())
    }

    /// Texels in a row.
    pub fn width(&self) -> usize {
        self.grid.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.grid.height
    }

    /// All texels, row by row.
    pub fn texels(&self) -> &[Rgb] {
        &self.texels
    }

    /// Solid angle of a texel in `row`, in sr: `Δφ (cosθ₀ − cosθ₁)`.
    pub fn solid_angle(&self, row: usize) -> f64 {
        self.grid.solid_angle(row)
    }

    /// Radiance times solid angle, summed: `∫ L dω`, in W/m².
    pub fn total(&self) -> Rgb {
        let rows = self.texels.chunks(self.grid.width).enumerate();
        rows.map(|(row, t)| t.iter().sum::<Rgb>() * self.solid_angle(row)).sum()
    }

    /// The texel in `direction`; +Y is up, as in all below.
    pub(super) fn radiance(&self, direction: DVec3) -> Rgb {
        let (column, row) = self.grid.cell(direction);
        self.texels[row * self.grid.width + column]
    }

    pub(super) fn sample(&self, u: DVec2) -> DVec3 {
        self.draws.sample(u)
    }

    pub(super) fn pdf(&self, direction: DVec3) -> f64 {
        self.draws.pdf(direction)
    }

    /// Irradiance of a plane with unit `normal`: what each texel sends, summed.
    pub(super) fn irradiance(&self, normal: DVec3) -> Rgb {
        let Grid { width, height, .. } = self.grid;
        let mut sum = Rgb::ZERO;
        for row in 0..height {
            for column in 0..width {
                let radiance = self.texels[row * width + column];
                if radiance != Rgb::ZERO {
                    sum += radiance * self.cell_at(column, row).sends(normal);
                }
            }
        }
        sum
    }

    /// The direction of a place, in columns from the left and rows from above.
    pub(super) fn direction(&self, column: f64, row: f64) -> DVec3 {
        self.grid.direction(column, row)
    }

    fn cell_at(&self, column: usize, row: usize) -> Cell {
        Cell {
            polar: [row, row + 1].map(|edge| self.grid.polar(edge as f64)),
            azimuth: [column, column + 1].map(|edge| self.grid.azimuth(edge as f64)),
        }
    }
}

/// What lies between two meridians and two parallels.
#[derive(Clone, Copy)]
struct Cell {
    polar: [f64; 2],
    azimuth: [f64; 2],
}

/// Cells that the horizon of a plane cuts are halved down to this, in radians.
const FINEST: f64 = 1e-3;

impl Cell {
    // ANCHOR: vector
    /// `∫ ω dω` over the cell, in closed form: a plane that sees all of it gets the
    /// part along its normal.
    fn vector(&self) -> DVec3 {
        let [t0, t1] = self.polar;
        let [p0, p1] = self.azimuth;
        // ∫ sin²θ dθ and ∫ sinθ cosθ dθ
        let across = (t1 - t0) / 2.0 - ((2.0 * t1).sin() - (2.0 * t0).sin()) / 4.0;
        let upward = (t1.sin().powi(2) - t0.sin().powi(2)) / 2.0;
        let (right, back) = (p0.cos() - p1.cos(), p0.sin() - p1.sin());
        DVec3::new(across * right, upward * (p1 - p0), across * back)
    }
    // ANCHOR_END: vector

    /// `∫ max(0, n·ω) dω` over the cell.
    fn sends(&self, normal: DVec3) -> f64 {
        let [t, p] = [self.polar, self.azimuth].map(|[a, b]| (a + b) / 2.0);
        let middle = DVec3::new(t.sin() * p.sin(), t.cos(), -t.sin() * p.cos());
        let height = normal.dot(middle);
        let [down, turn] = [self.polar, self.azimuth].map(|[a, b]| b - a);
        let along = turn * (t.sin() + down / 2.0).min(1.0); // parallels shorten to the pole
        // No point of the cell is farther from its middle than this.
        let radius = (down + along) / 2.0;
        if height <= -radius {
            return 0.0;
        }
        if height >= radius || down.max(along) < FINEST {
            return normal.dot(self.vector()).max(0.0);
        }
        self.halves(down > along).iter().map(|half| half.sends(normal)).sum()
    }

    fn halves(&self, across: bool) -> [Cell; 2] {
        let middle = |[a, b]: [f64; 2]| (a + b) / 2.0;
        let (mut first, mut second) = (*self, *self);
        if across {
            (first.polar[1], second.polar[0]) =
                (middle(self.polar), middle(self.polar));
        } else {
            let split = middle(self.azimuth);
            (first.azimuth[1], second.azimuth[0]) = (split, split);
        }
        [first, second]
    }
}
