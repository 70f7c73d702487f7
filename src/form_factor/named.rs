//! Closed forms of named pairs: oracles that share no code with the methods.
//!
//! | function                     | Howell | pair                                      |
//! |------------------------------|--------|-------------------------------------------|
//! | [`parallel_rectangles`]      | C-11   | two equal rectangles, face to face        |
//! | [`perpendicular_rectangles`] | C-14   | floor and wall with a common edge         |
//! | [`concentric_spheres`]       | C-131  | the outer sphere to the inner             |
//!
//! The formulas as they are printed lose their digits to cancellation: that of the parallel
//! rectangles has none left at 1e4 sizes, that of the discs five at a hundred. Here they
//! are rearranged so that small differences are never taken between large numbers.
//!
//! **Not here:** pairs in general position ([`super::analytic`]). Chapter *Form factors*
//! (L07). Sources: Howell, Mengüç, Daun & Siegel, *A catalog of radiation heat transfer
//! configuration factors*; Hamilton & Morgan 1952.

use std::f64::consts::PI;

/// From one rectangle `a` × `b` to another straight opposite at distance `c`; positive
/// lengths in one unit. In `(0, 1)`.
///
/// ```text
/// πXY/2 F = ½ ln (1+X²)(1+Y²)/(1+X²+Y²) + X√(1+Y²) atan X/√(1+Y²) − X atan X
///           + Y√(1+X²) atan Y/√(1+X²) − Y atan Y             X = a/c, Y = b/c
/// ```
///
/// # Accuracy
/// Relative 1e-14 from 1e-6 to 1e4 sizes, and beyond.
pub fn parallel_rectangles(a: f64, b: f64, c: f64) -> f64 {
    let (x, y) = (a / c, b / c);
    let logarithm = 0.5 * (x * x * y * y / (1.0 + x * x + y * y)).ln_1p();
    // s atan(x/s) − atan x with s = √(1+y²), where both arcs are almost one
    let arcs = |x: f64, y: f64| {
        let s = y.hypot(1.0);
        let less_one = y * y / (s + 1.0);
        less_one * (x / s).atan() - (x * less_one / (s + x * x)).atan()
    };
    2.0 / (PI * x * y) * (logarithm + x * arcs(x, y) + y * arcs(y, x))
}

/// From a rectangle of width `w` to one of width `h` that stands on their common edge, of
/// length `l`, at a right angle; positive lengths in one unit. In `(0, ½)`.
///
/// ```text
/// πW F = W atan 1/W + H atan 1/H − R atan 1/R + ¼ ln (1+W²)(1+H²)/(1+R²)
///        + ¼ W² ln W²(1+R²)/((1+W²)R²) + ¼ H² ln H²(1+R²)/((1+H²)R²)
/// W = w/l,  H = h/l,  R² = W² + H²
/// ```
///
/// # Accuracy
/// Relative 1e-11 for ratios of sides up to 1e3.
pub fn perpendicular_rectangles(w: f64, h: f64, l: f64) -> f64 {
    let (w, h) = (w / l, h / l);
    let (w2, h2) = (w * w, h * h);
    let (r, r2) = (w.hypot(h), w2 + h2);
    let arc = |x: f64| x * (1.0 / x).atan();
    let logarithms = (w2 * h2 / (1.0 + r2)).ln_1p()
        + w2 * (-h2 / ((1.0 + w2) * r2)).ln_1p()
        + h2 * (-w2 / ((1.0 + h2) * r2)).ln_1p();
    (arc(w) + arc(h) - arc(r) + 0.25 * logarithms) / (PI * w)
}

/// From the inside of a sphere of radius `outer` to a concentric one of radius `inner`, both
/// positive, in one unit: `F = (inner/outer)²`. The inner one sends all to the outer; the
/// outer sends `1 − F` to itself.
///
/// # Accuracy
/// Rounding.
pub fn concentric_spheres(inner: f64, outer: f64) -> f64 {
    (inner / outer).powi(2)
}
