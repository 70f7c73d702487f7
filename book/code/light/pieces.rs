//! `Ω ≈ A cosθ/r²`, and the same for a surface cut into pieces: where it fails.

use crate::map;
use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::chart::suites::light::by_pieces;
use radiosity::film::RgbImage;
use radiosity::geometry::Polygon;
use radiosity::radiometry::solid_angle;

/// Into how many rows and columns the square is cut, in the three maps.
pub const CUTS: [u32; 3] = [1, 2, 4];

/// The range of the colours, as relative errors.
const RANGE: (f64, f64) = (1e-3, 1.0);

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
