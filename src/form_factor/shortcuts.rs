//! Textbook approximations of the form factor, kept to be compared with.
//!
//! ```text
//! point to point    F ≈ cosθ_i cosθ_j A_j/(π r²)             between the middles
//! point to disc     F ≈ cosθ_i cosθ_j A_j/(π r² + A_j)
//! Nusselt           F = area of the shadow on the unit disc/π
//! crossed strings   F = (Σ crossed − Σ uncrossed)/(2 L_i)    in the plane, exact
//! ```
//!
//! | method             | use it when                          | it fails when              |
//! |--------------------|--------------------------------------|----------------------------|
//! | [`point_to_point`] | five sizes away, or farther          | near: it exceeds 1         |
//! | [`point_to_disc`]  | a number below 1 is needed, cheaply  | near: 20 % at one size     |
//! | [`nusselt`]        | the factor is to be *seen*           | exact only with many steps |
//!
//! None but the strings knows anything of what stands between. Errors of the first two,
//! between unit squares that face each other (`tests/stability/form_factors.rs`):
//!
//! | distance/size  | ¼      | ½      | 1     | 2     | 5     | 10    |
//! |----------------|--------|--------|-------|-------|-------|-------|
//! | point to point | +706 % | +207 % | +59 % | +16 % | +2.6 %| +.7 % |
//! | point to disc  | +32 %  | +35 %  | +21 % | +7.5 %| +1.4 %| +.3 % |
//!
//! **Not here:** exact factors ([`super::analytic`]); closed forms of named pairs
//! ([`super::named`]). Chapter *Form factors* (L07). Sources: Nusselt 1928; Hottel 1954;
//! Wallace, Elmquist & Haines 1989 (the disc); Murdoch 1981 (five times).

use crate::geometry::{Frame, Plane, Polygon, clip};
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// What both rules of the middle points share: `cosθ_i cosθ_j` and `r²`.
///
/// A cosine below 0 counts 0.
fn between_middles(i: &Polygon, j: &Polygon) -> (f64, f64) {
    let (from, to) = (i.centroid(), j.centroid());
    let r = to - from;
    let across = r.dot(i.normal()).max(0.0) * (-r).dot(j.normal()).max(0.0);
    (across / r.length_squared(), r.length_squared())
}

// ANCHOR: point_to_point
/// Form factor from `i` to `j`, both taken at their middles: dimensionless, 0 when either
/// is behind the other, and **not bounded by 1**.
///
/// ```text
/// F ≈ cosθ_i cosθ_j A_j/(π r²)
/// ```
/// The kernel at one point, as in the first lecture on `1/r²`.
///
/// # Accuracy
/// Relative error about `⅔ (size/r)²` between facing squares: 2.6 % at five sizes, 59 % at
/// one. Nearer than half a size the factor exceeds 1, and a solver that uses it diverges.
pub fn point_to_point(i: &Polygon, j: &Polygon) -> f64 {
    let (cosines, square) = between_middles(i, j);
    cosines * j.area() / (PI * square)
}
// ANCHOR_END: point_to_point

// ANCHOR: point_to_disc
/// Form factor from the middle of `i` to `j`, taken for a disc of the same area: in
/// `[0, 1)`, 0 when either is behind the other.
///
/// ```text
/// F ≈ cosθ_i cosθ_j A_j/(π r² + A_j)
/// ```
/// Exact from a point to a disc straight above that faces it (Howell B-12); the cosines of
/// other places are put in by hand (Wallace, Elmquist & Haines 1989).
///
/// # Accuracy
/// That of [`point_to_point`] five sizes away (1.4 %) and better nearer, 21 % at one size:
/// it is finite near by, not right.
pub fn point_to_disc(i: &Polygon, j: &Polygon) -> f64 {
    // ANCHOR: disc
    let (cosines, square) = between_middles(i, j);
    cosines * j.area() / (PI * square + j.area())
    // ANCHOR_END: disc
}
// ANCHOR_END: point_to_disc

/// The longer side of the rectangle around `polygon` that lies along its longest edge, in
/// scene units: the side of a square, the length of a lamp.
pub fn size(polygon: &Polygon) -> f64 {
    let longest = polygon.edges().map(|(a, b)| b - a);
    let along =
        longest.max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    let frame = Frame::towards(polygon.normal(), along.unwrap_or(DVec3::X));
    let extent = |axis: DVec3| {
        let along = polygon.vertices().iter().map(|v| v.dot(axis));
        let (low, high) = along
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    extent(frame.x).max(extent(frame.y))
}

// ANCHOR: nusselt
/// The shadow of `polygon` on the unit disc around `p` (unit normal `n`), corner by corner,
/// `steps` (positive) to an edge: first onto the unit sphere, then straight down.
///
/// Empty when all of the polygon is below the horizon. Of either side; the outline runs
/// clockwise or counter-clockwise accordingly.
pub fn nusselt_outline(
    p: DVec3,
    n: DVec3,
    polygon: &Polygon,
    steps: u32,
) -> Vec<DVec2> {
    let frame = Frame::about(n);
    let above = clip(polygon.vertices(), Plane::through(p, n));
    let on_sphere = |k: usize| (above[k % above.len()] - p).normalize_or_zero();
    let edge = |k: usize| {
        // A great circle from a to b, in equal steps: a cos t + (what is left of b) sin t
        let (a, b) = (on_sphere(k), on_sphere(k + 1));
        let angle = a.cross(b).length().atan2(a.dot(b));
        let across = b.reject_from(a).normalize_or_zero();
        (0..steps).map(move |s| {
            let (sin, cos) = (angle * f64::from(s) / f64::from(steps)).sin_cos();
            frame.local_from_world(a * cos + across * sin).truncate()
        })
    };
    (0..above.len()).flat_map(edge).collect()
}

/// Form factor from a differential area at `p` (unit normal `n`) to `polygon`, by Nusselt's
/// analog: the area of its shadow on the unit disc, as a share of the disc. In `[0, 1]`.
///
/// # Accuracy
/// The shadow's edges are arcs of ellipses about the centre, and are taken as chords: off
/// by less than `(edge's angle/steps)²` of the disc's share. With arcs instead of chords
/// it is Lambert's formula ([`super::analytic::lambert_polygon`]).
pub fn nusselt(p: DVec3, n: DVec3, polygon: &Polygon, steps: u32) -> f64 {
    // ANCHOR: shadow_area
    let outline = nusselt_outline(p, n, polygon, steps);
    let next = outline.iter().cycle().skip(1);
    let twice: f64 = outline.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum();
    0.5 * twice.abs() / PI
    // ANCHOR_END: shadow_area
}
// ANCHOR_END: nusselt
