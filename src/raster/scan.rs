//! Which pixels a convex polygon covers, in exact integer arithmetic.
//!
//! A pixel is covered when its centre lies inside, on a left edge or on a top edge. Row by
//! row this is the half-open span from the left to the right edge:
//!
//! ```text
//! x_edge(c) = a.x + (c − a.y) (b.x − a.x)/(b.y − a.y)        a above b, c the row's centre
//! first pixel at or right of it:  ⌈x_edge(c) − ½⌉
//! ```
//! An edge gives the same number to the polygon on its left, as an end, and to the one on
//! its right, as a start. That is all of the top-left rule.

use glam::DVec3;
use std::ops::Range;

/// Corners are snapped to 1/65536 of a pixel: with pictures of up to 2¹⁴ pixels a side,
/// products of two coordinates stay below 2⁶¹ and fit an `i64`.
const BITS: u32 = 16;
const ONE: i64 = 1 << BITS;
const HALF: i64 = ONE / 2;

/// A corner on the picture, in 1/65536 pixels, `y` down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Corner {
    x: i64,
    y: i64,
}

/// Memory for the spans of one polygon.
#[derive(Clone, Debug, Default)]
pub(super) struct Spans {
    corners: Vec<Corner>,
    rows: Vec<(i64, i64)>,
}

impl Spans {
    /// The rows that `outline` (in clip coordinates, inside the pyramid) covers, each with
    /// its range of columns, which may be empty.
    pub(super) fn of(
        &mut self,
        outline: &[DVec3],
        width: u32,
        height: u32,
    ) -> impl Iterator<Item = (usize, Range<usize>)> + use<'_> {
        let scale = |size: u32| 0.5 * size as f64 * ONE as f64;
        let (sx, sy) = (scale(width), scale(height));
        // `+ 0.5` and the cast round: the numbers are not negative but for rounding.
        let snap = |v: &DVec3| Corner {
            x: ((1.0 + v.x / v.z) * sx + 0.5) as i64,
            y: ((1.0 - v.y / v.z) * sy + 0.5) as i64,
        };
        self.corners.clear();
        self.corners.extend(outline.iter().map(snap));
        let low = self.corners.iter().map(|c| row_from(c.y)).min().unwrap_or(0);
        let high = self.corners.iter().map(|c| row_from(c.y)).max().unwrap_or(0);
        self.rows.clear();
        self.rows.resize((high - low) as usize, (i64::MAX, i64::MIN));
        for k in 0..self.corners.len() {
            let (a, b) = (self.corners[k], self.corners[(k + 1) % self.corners.len()]);
            if a.y < b.y {
                follow(a, b, low, &mut self.rows);
            } else {
                follow(b, a, low, &mut self.rows);
            }
        }
        let row = move |(k, &(start, end)): (usize, &(i64, i64))| {
            (low as usize + k, start as usize..end as usize)
        };
        self.rows.iter().enumerate().map(row)
    }
}

/// The first row whose centre is at or below `y`.
fn row_from(y: i64) -> i64 {
    (y + HALF - 1) >> BITS
}

// ANCHOR: follow
/// Follows the edge from `a` down to `b` and widens the spans of `rows` (the first of which
/// is row `low`) to the first pixel right of it.
fn follow(a: Corner, b: Corner, low: i64, rows: &mut [(i64, i64)]) {
    let (first, end) = (row_from(a.y), row_from(b.y));
    if first == end {
        return; // no row's centre lies between them
    }
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    // column = ⌈top/bottom⌉, kept as a quotient and a remainder from row to row
    let bottom = ONE * dy;
    let top = (a.x - HALF) * dy + (first * ONE + HALF - a.y) * dx + bottom - 1;
    let (mut column, mut rest) = (top.div_euclid(bottom), top.rem_euclid(bottom));
    let (step, step_rest) =
        ((ONE * dx).div_euclid(bottom), (ONE * dx).rem_euclid(bottom));
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
