//! `Ω ≈ A cosθ/r²`, and the same for a surface cut into pieces: where it fails.

use crate::map;
use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::film::RgbImage;
use radiosity::geometry::Polygon;
use radiosity::radiometry::solid_angle;

/// Into how many rows and columns the square is cut, in the three maps.
pub const CUTS: [u32; 3] = [1, 2, 4];

/// The range of the colours, as relative errors.
const RANGE: (f64, f64) = (1e-3, 1.0);

/// The middles of the `cuts × cuts` pieces of a unit square about the origin.
pub fn middles(cuts: u32) -> impl Iterator<Item = DVec3> {
    let at = move |k: u32| (f64::from(k) + 0.5) / f64::from(cuts) - 0.5;
    (0..cuts * cuts).map(move |k| dvec3(at(k % cuts), at(k / cuts), 0.0))
}

/// `Σ ΔA cosθ/r²` over the pieces of the unit square about the origin, that looks along −z.
pub fn by_pieces(p: DVec3, cuts: u32) -> f64 {
    let area = f64::from(cuts * cuts).recip();
    let piece = |middle: DVec3| {
        let r = p - middle;
        area * r.z.abs() / r.length().powi(3)
    };
    middles(cuts).map(piece).sum()
}

/// The square itself.
pub fn target() -> Polygon {
    map::square(1.0, DVec3::ZERO)
}

/// Relative error of the pieces, seen from `p`.
pub fn error(p: DVec3, cuts: u32) -> f64 {
    by_pieces(p, cuts) / solid_angle(p, &target()) - 1.0
}

/// The error over a section through the square's middle: 4 to each side, 8 away.
pub fn errors(cuts: u32) -> Vec<f64> {
    let low = dvec2(-4.0, -8.0);
    map::over(low, dvec2(4.0, 0.0), |DVec2 { x, y }| error(dvec3(x, 0.0, y), cuts))
}

/// The map of the error.
pub fn picture(cuts: u32) -> RgbImage {
    map::draw(&errors(cuts), RANGE.0, RANGE.1)
}

/// The caption under one map.
pub fn caption(cuts: u32) -> String {
    let off = |distance: f64| 100.0 * error(dvec3(0.0, 0.0, -distance), cuts);
    let pieces = cuts * cuts;
    let name =
        if pieces == 1 { "One piece".into() } else { format!("{pieces} pieces") };
    format!("{name}: {:+.2} % at distance 1, {:+.2} % at 5", off(1.0), off(5.0))
}

/// The key to the maps.
pub fn key() -> String {
    map::key(RANGE.0, RANGE.1, 4, map::per_cent)
}
