//! Which pixels a convex polygon covers, in exact integer arithmetic.
//!
//! A pixel is covered when its centre lies inside, on a left edge or on a top edge. Row
//! by row this is the half-open span from the left to the right edge:
//!
//! ```text
//! x_edge(c) = a.x + (c − a.y) (b.x − a.x)/(b.y − a.y)    a above b, c the row's centre
//! first pixel at or right of it:  ⌈x_edge(c) − ½⌉
//! ```
//! An edge gives the same number to the polygon on its left, as an end, and to the one
//! on its right, as a start. That is all of the top-left rule.

use glam::DVec3;
use std::ops::Range;

/// The grid to which corners are snapped: `2^bits` steps to a pixel.
///
/// As fine as integers allow: a coordinate stays within 2³⁰, so that sums of two
/// products of coordinates stay below 2⁶² and fit an `i64`. At 128 pixels a side a step
/// is 1e-7 pixel, at 16384 it is 1/65536.
#[derive(Clone, Copy)]
struct FixedGrid {
    bits: u32,
}

impl FixedGrid {
    fn new(width: u32, height: u32) -> FixedGrid {
        let pixels = width.max(height).next_power_of_two();
        FixedGrid { bits: 30 - pixels.trailing_zeros() }
    }

    /// One pixel, in steps.
    fn one(self) -> i64 {
        1 << self.bits
    }

    /// The first row whose centre is at or below `y`.
    fn row_from(self, y: i64) -> i64 {
        (y + self.one() / 2 - 1) >> self.bits
    }
}

/// A corner on the picture, in steps of the grid, `y` down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct FixedCorner {
    x: i64,
    y: i64,
}

/// Memory for the spans of one polygon.
#[derive(Clone, Debug, Default)]
pub(super) struct Spans {
    corners: Vec<FixedCorner>,
    rows: Vec<(i64, i64)>,
}

impl Spans {
    /// The rows that `outline` (in clip coordinates, inside the pyramid) covers, each
    /// with its range of columns, which may be empty.
    pub(super) fn of(
        &mut self,
        outline: &[DVec3],
        width: u32,
        height: u32,
    ) -> impl Iterator<Item = (usize, Range<usize>)> + use<'_> {
        let grid = FixedGrid::new(width, height);
        // Clipped corners may stray outside by rounding, hence the clamp; `+ 0.5` and
        // the cast round numbers that are not negative.
        let snap = |at: f64, size: u32| {
            let end = size as f64 * grid.one() as f64;
            (0.5 * at * end + 0.5).clamp(0.0, end) as i64
        };
        let snap = |v: &DVec3| FixedCorner {
            x: snap(1.0 + v.x / v.z, width),
            y: snap(1.0 - v.y / v.z, height),
        };
        self.corners.clear();
        self.corners.extend(outline.iter().map(snap));
        let low = self.corners.iter().map(|c| grid.row_from(c.y)).min().unwrap_or(0);
        let high = self.corners.iter().map(|c| grid.row_from(c.y)).max().unwrap_or(0);
        self.rows.clear();
        self.rows.resize((high - low) as usize, (i64::MAX, i64::MIN));
        for k in 0..self.corners.len() {
            let (a, b) = (self.corners[k], self.corners[(k + 1) % self.corners.len()]);
            if a.y < b.y {
                follow(grid, a, b, low, &mut self.rows);
            } else {
                follow(grid, b, a, low, &mut self.rows);
            }
        }
        let row = move |(k, &(start, end)): (usize, &(i64, i64))| {
            (low as usize + k, start as usize..end as usize)
        };
        self.rows.iter().enumerate().map(row)
    }
}

// ANCHOR: follow
/// Follows the edge from `a` down to `b` and widens the spans of `rows` (the first of
/// which is row `low`) to the first pixel right of it.
fn follow(
    grid: FixedGrid,
    a: FixedCorner,
    b: FixedCorner,
    low: i64,
    rows: &mut [(i64, i64)],
) {
    let (first, end) = (grid.row_from(a.y), grid.row_from(b.y));
    if first == end {
        return; // no row's centre lies between them
    }
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    // column = ⌈top/bottom⌉, kept as a quotient and a remainder from row to row
    let (one, half) = (grid.one(), grid.one() / 2);
    let bottom = one * dy;
    let top = (a.x - half) * dy + (first * one + half - a.y) * dx + bottom - 1;
    let (mut column, mut rest) = (top.div_euclid(bottom), top.rem_euclid(bottom));
    let (step, step_rest) =
        ((one * dx).div_euclid(bottom), (one * dx).rem_euclid(bottom));
    for (left, right) in &mut rows[(first - low) as usize..(end - low) as usize] {
        *left = column.min(*left);
        *right = column.max(*right);
        (column, rest) = (column + step, rest + step_rest);
        if rest >= bottom {
            (column, rest) = (column + 1, rest - bottom);
        }
    }
}
// ANCHOR_END: follow
