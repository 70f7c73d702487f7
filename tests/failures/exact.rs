//! Closed forms that say where failures of factors lie, typed here from the formulas: none
//! of the crate's own methods takes part.

use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// Unit squares that face each other at distance 1 (Howell C-11).
pub const FACING: f64 = 0.199_824_895_698_387;
/// Unit squares at a right angle with a common edge (Howell C-14).
pub const CORNER: f64 = 0.200_043_776_075_403;
/// [`FACING`] past a screen at mid-height over x < ¾.
pub const STRIP: f64 = 0.029_163_422_950_906;
/// [`FACING`] past a screen at mid-height over a quarter: ¾ of it.
pub const QUARTER: f64 = 0.149_868_671_773_790;

/// From a point to an `a × b` rectangle that faces it, one away, with one corner straight
/// above (Howell B-3). Odd in `a` and in `b`.
pub fn above_corner(a: f64, b: f64) -> f64 {
    let part = |a: f64, b: f64| a / a.hypot(1.0) * (b / a.hypot(1.0)).atan();
    (part(a, b) + part(b, a)) / TAU
}

/// The same to a rectangle over these ranges, seen from `(x, y)` one below.
pub fn above(x: f64, y: f64, over: [Range<f64>; 2]) -> f64 {
    let [u, v] = over;
    let corner = |u: f64, v: f64| above_corner(u - x, v - y);
    corner(u.end, v.end) - corner(u.start, v.end) - corner(u.end, v.start)
        + corner(u.start, v.start)
}

/// From a point to a wall at distance `gap` that stands on its horizon, `height` high and
/// reaching `half` to either side (Howell B-4).
pub fn beside(gap: f64, half: f64, height: f64) -> f64 {
    let slant = gap.hypot(height);
    ((half / gap).atan() - gap / slant * (half / slant).atan()) / PI
}

/// Unit squares that face each other at distance 1 past a screen at mid-height.
///
/// The kernel depends on the shift (u, v) alone, and of the pairs with this shift the
/// screen hides those whose middle lies in it: an integral over two shifts is left.
pub fn past_screen(screen: [Range<f64>; 2]) -> f64 {
    const STEPS: usize = 300;
    let hidden = |shift: f64, range: &Range<f64>| {
        let (low, high) = (0.5 * shift, 1.0 - 0.5 * shift);
        (range.end.min(high) - range.start.max(low)).max(0.0)
    };
    let place = |k: usize| (k as f64 + 0.5) / STEPS as f64;
    let at = |i: usize, j: usize| {
        let (u, v) = (place(i), place(j));
        let pairs =
            (1.0 - u) * (1.0 - v) - hidden(u, &screen[0]) * hidden(v, &screen[1]);
        4.0 * pairs / (PI * (1.0 + u * u + v * v).powi(2))
    };
    let sum: f64 = (0..STEPS * STEPS).map(|k| at(k % STEPS, k / STEPS)).sum();
    sum / (STEPS * STEPS) as f64
}
