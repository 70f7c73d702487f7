//! Where the light of a lamp may peak on an element larger than the lamp.
//!
//! ```text
//! area of the spot ≈ a + p d + π d²        lamp of area a and perimeter p, at distance d
//! ```
//! (Steiner 1840: the area of a convex outline that is widened by d.) A lamp that is small
//! and near lights a spot next to it, and hardly anything else. Points spread over an
//! element much larger than the spot miss it, and find the element dark.

use super::Direct;
use super::lamps::Lamp;
use crate::geometry::Polygon;
use glam::DVec3;

/// Steps of projecting to and fro: the points need only be near the nearest.
const STEPS: usize = 8;

impl Direct<'_> {
    /// For each lamp whose spot is smaller than the element: the point of the element that
    /// is nearest to the lamp, and the area of the spot, in scene units squared.
    ///
    /// Lamps themselves, not their images in mirrors.
    pub(crate) fn near_lamps(&self, element: &Polygon) -> Vec<(DVec3, f64)> {
        let (middle, size, area) =
            (element.centroid(), element.diameter(), element.area());
        let spot = |lamp: &Lamp| {
            let lamp = &lamp.outline;
            let far = middle.distance(lamp.centroid()) - size - lamp.diameter();
            let faces = |p: &Polygon, q: &Polygon| {
                q.vertices().iter().any(|&v| p.plane().height(v) > 0.0)
            };
            if lamp.area() > area || far > size || !faces(element, lamp) {
                return None;
            }
            let (at, from) = nearest(element, lamp);
            let d = at.distance(from);
            let perimeter: f64 = lamp.edges().map(|(a, b)| a.distance(b)).sum();
            let spot = lamp.area() + d * (perimeter + std::f64::consts::PI * d);
            (spot < area && faces(lamp, element)).then_some((at, spot))
        };
        self.lamps().all().iter().filter_map(spot).collect()
    }
}

/// Points of two polygons that are nearest to each other, or nearly.
fn nearest(a: &Polygon, b: &Polygon) -> (DVec3, DVec3) {
    let mut from = b.centroid();
    let mut at = nearest_to(a, from);
    for _ in 0..STEPS {
        from = nearest_to(b, at);
        at = nearest_to(a, from);
    }
    (at, from)
}

/// The point of a polygon that is nearest to `p`.
fn nearest_to(polygon: &Polygon, p: DVec3) -> DVec3 {
    let foot = p - polygon.plane().height(p) * polygon.normal();
    if polygon.contains(foot, 0.0) {
        return foot;
    }
    let on_edge = |(a, b): (DVec3, DVec3)| {
        let t = (p - a).dot(b - a) / a.distance_squared(b);
        a.lerp(b, t.clamp(0.0, 1.0))
    };
    let distance = |x: &DVec3| x.distance_squared(p);
    let nearer = |x: DVec3, y: DVec3| if distance(&y) < distance(&x) { y } else { x };
    polygon.edges().map(on_edge).reduce(nearer).unwrap_or(foot)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    fn square(at: DVec3, u: DVec3, v: DVec3) -> Polygon {
        Polygon::new(vec![at, at + u, at + u + v, at + v]).unwrap()
    }

    #[test]
    fn the_nearest_points_are_found() {
        let floor = square(DVec3::ZERO, DVec3::X, DVec3::Y);
        let above = square(dvec3(0.2, 0.6, 0.3), 0.1 * DVec3::Y, 0.1 * DVec3::X);
        let (at, from) = nearest(&floor, &above);
        assert!((at - dvec3(0.25, 0.65, 0.0)).length() < 1e-12);
        assert!((from - dvec3(0.25, 0.65, 0.3)).length() < 1e-12);
        // Beside it, standing: corner to corner.
        let beside = square(dvec3(1.5, 1.5, 0.1), DVec3::X, DVec3::Z);
        let (at, from) = nearest(&floor, &beside);
        assert!((at - dvec3(1.0, 1.0, 0.0)).length() < 1e-12);
        assert!((from - dvec3(1.5, 1.5, 0.1)).length() < 1e-12);
    }
}
