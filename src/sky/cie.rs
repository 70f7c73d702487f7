//! The general skies of the CIE: overcast, partly cloudy, clear.

use super::grid::{Draws, Grid};
use crate::geometry::Rgb;
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// `a, b, c, d, e` of the standard general sky `kind`, 1 to 15 (ISO 15469): 1 is
/// overcast, 5 uniform, 12 clear.
pub fn cie_coefficients(kind: usize) -> Option<[f64; 5]> {
    #[rustfmt::skip]
    let [a, b] = *[
        [4.0, -0.7], [4.0, -0.7], [1.1, -0.8], [1.1, -0.8], [0.0, -1.0],
        [0.0, -1.0], [0.0, -1.0], [0.0, -1.0], [-1.0, -0.55], [-1.0, -0.55],
        [-1.0, -0.55], [-1.0, -0.32], [-1.0, -0.32], [-1.0, -0.15], [-1.0, -0.15],
    ].get(kind.checked_sub(1)?)?;
    let [c, d, e] = match kind {
        1 | 3 | 5 => [0.0, -1.0, 0.0],
        2 | 4 | 6 | 9 => [2.0, -1.5, 0.15],
        7 | 10 => [5.0, -2.5, 0.3],
        8 | 11 | 12 => [10.0, -3.0, 0.45],
        13 | 14 => [16.0, -3.0, 0.3],
        _ => [24.0, -2.8, 0.15],
    };
    Some([a, b, c, d, e])
}

/// A general sky, in the sky's own axes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cie {
    pub coefficients: [f64; 5],
    pub sun: DVec3,
    /// Radiance at the zenith, and that divided by the two factors there.
    pub zenith: Rgb,
    scale: Rgb,
    draws: Draws,
}

/// Cells of the table that samples are drawn from.
const GRID: Grid = Grid { width: 128, height: 32, bottom: FRAC_PI_2 };

/// Irradiance is right to this, relative to the zenith's radiance × π.
const ACCURACY: f64 = 1e-8;

impl Cie {
    pub fn new(coefficients: [f64; 5], sun: DVec3, zenith: Rgb) -> Cie {
        let black = Draws::new(GRID, vec![0.0; GRID.width * GRID.height]);
        let mut cie = Cie { coefficients, sun, zenith, scale: Rgb::ONE, draws: black };
        cie.scale = zenith / cie.relative(DVec3::Y);
        let cells = (0..GRID.height).flat_map(|r| (0..GRID.width).map(move |c| (c, r)));
        let brightness = cells.map(|(column, row)| cie.cell(column, row)).collect();
        cie.draws = Draws::new(GRID, brightness);
        cie
    }

    // ANCHOR: cie
    /// Brightness by elevation × brightness by angle from the sun.
    fn relative(&self, d: DVec3) -> f64 {
        let [a, b, c, fall, e] = self.coefficients;
        let cos = self.sun.dot(d);
        let angle = self.sun.cross(d).length().atan2(cos);
        let gradation = 1.0 + a * (b / d.y.max(0.0)).exp();
        let about_sun = 1.0 + c * ((fall * angle).exp() - (fall * FRAC_PI_2).exp());
        (gradation * (about_sun + e * cos * cos)).max(0.0)
    }
    // ANCHOR_END: cie

    pub fn radiance(&self, d: DVec3) -> Rgb {
        self.scale * self.relative(d)
    }

    /// Mean brightness of a cell, roughly.
    fn cell(&self, column: usize, row: usize) -> f64 {
        let at = |x: f64, y: f64| {
            self.relative(GRID.direction(column as f64 + x, row as f64 + y))
        };
        at(0.25, 0.25) + at(0.25, 0.75) + at(0.75, 0.25) + at(0.75, 0.75)
    }

    pub fn sample(&self, u: DVec2) -> DVec3 {
        self.draws.sample(u)
    }

    pub fn pdf(&self, d: DVec3) -> f64 {
        self.draws.pdf(d)
    }

    /// Irradiance of a plane with unit `normal`, by elevation within azimuth.
    ///
    /// The brightness has a peak at the sun, and what the plane sees has corners where
    /// it cuts the horizon: both are ends of intervals.
    pub fn irradiance(&self, normal: DVec3) -> Rgb {
        let (rise, flat) = (normal.y, normal.x.hypot(normal.z));
        let towards = normal.x.atan2(-normal.z);
        let sun = self.sun.y.clamp(-1.0, 1.0).asin();
        let accuracy = ACCURACY * self.relative(DVec3::Y);
        let strip = |azimuth: f64| {
            let (sin, cos) = (azimuth + towards).sin_cos();
            let light = |elevation: f64| {
                let (up, out) = elevation.sin_cos();
                let d = DVec3::new(out * sin, up, -out * cos);
                self.relative(d) * normal.dot(d).max(0.0) * out
            };
            let ahead = flat * azimuth.cos();
            let (low, high) = match (rise >= 0.0, ahead >= 0.0) {
                (true, true) => (0.0, FRAC_PI_2),
                (true, false) => ((-ahead).atan2(rise), FRAC_PI_2),
                (false, true) => (0.0, ahead.atan2(-rise)),
                (false, false) => return 0.0,
            };
            let split = sun.clamp(low, high);
            integral(&light, low, split, accuracy)
                + integral(&light, split, high, accuracy)
        };
        let mut ends = [-PI, -FRAC_PI_2, FRAC_PI_2, PI, 0.0];
        let of_sun = self.sun.x.atan2(-self.sun.z) - towards;
        ends[4] = of_sun.sin().atan2(of_sun.cos());
        ends.sort_by(f64::total_cmp);
        let parts = ends.windows(2).map(|e| integral(&strip, e[0], e[1], accuracy));
        self.scale * parts.sum::<f64>()
    }
}

/// `∫ f` from `a` to `b`, to about `accuracy`: Simpson's rule, halved where it must be.
fn integral(f: &impl Fn(f64) -> f64, a: f64, b: f64, accuracy: f64) -> f64 {
    const PARTS: usize = 8; // nothing is seen by chance between three points
    let width = (b - a) / PARTS as f64;
    if width <= 0.0 {
        return 0.0;
    }
    let part = |k: usize| {
        let ends = [a + width * k as f64, a + width * (k + 1) as f64];
        let values = [f(ends[0]), f((ends[0] + ends[1]) / 2.0), f(ends[1])];
        simpson(f, ends, values, accuracy / PARTS as f64, 24)
    };
    (0..PARTS).map(part).sum()
}

fn simpson(
    f: &impl Fn(f64) -> f64,
    [a, b]: [f64; 2],
    [fa, fm, fb]: [f64; 3],
    accuracy: f64,
    depth: u32,
) -> f64 {
    let middle = (a + b) / 2.0;
    let (left, right) = (f((a + middle) / 2.0), f((middle + b) / 2.0));
    let whole = (b - a) / 6.0 * (fa + 4.0 * fm + fb);
    let halves = (b - a) / 12.0 * (fa + 4.0 * left + 2.0 * fm + 4.0 * right + fb);
    let off = (halves - whole) / 15.0;
    if off.abs() <= accuracy || depth == 0 {
        return halves + off;
    }
    simpson(f, [a, middle], [fa, left, fm], accuracy / 2.0, depth - 1)
        + simpson(f, [middle, b], [fm, right, fb], accuracy / 2.0, depth - 1)
}
