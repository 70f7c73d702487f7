//! Surfaces to look at: closed ones, and an outline that is not convex.

use crate::draw::{direction, frame, uniform, whole_number};
use radiosity::prelude::{DVec3, Frame, Polygon, dvec3};
use radiosity::random::Stream;
use std::f64::consts::TAU;

/// A rectangle from `corner` along `a` and `b`; its front is along a × b.
pub fn rectangle(corner: DVec3, a: DVec3, b: DVec3) -> Polygon {
    // Two edges at right angles always span a polygon.
    Polygon::new(vec![corner, corner + a, corner + a + b, corner + b])
        .expect("a rectangle")
}

/// An L in the plane z = 0, counter-clockwise seen from above: the square (0, 0) to (w, d)
/// less its corner beyond (u, v).
///
/// A fan from its first corner runs through the notch: one triangle counts negative.
pub fn l_shape([w, d]: [f64; 2], [u, v]: [f64; 2]) -> Vec<DVec3> {
    let corners = [(w, 0.0), (w, v), (u, v), (u, d), (0.0, d), (0.0, 0.0)];
    corners.map(|(x, y)| dvec3(x, y, 0.0)).to_vec()
}

/// A convex outline in the plane z = 0: corners of a circle, in order, then stretched.
pub fn convex(stream: &mut Stream) -> Vec<DVec3> {
    let n = whole_number(stream, 3, 9);
    let (a, b) = (uniform(stream, 0.2, 2.0), uniform(stream, 0.2, 2.0));
    let corner = |k: usize| {
        let turn = (k as f64 + 0.8 * stream.next()) / n as f64 * TAU;
        dvec3(a * turn.cos(), b * turn.sin(), 0.0)
    };
    (0..n).map(corner).collect()
}

/// A prism on `base`, which runs counter-clockwise seen from above; its fronts look
/// inward.
pub fn room(base: &[DVec3], height: f64) -> Vec<Vec<DVec3>> {
    let up = DVec3::Z * height;
    let n = base.len();
    let wall = |k: usize| {
        let (a, b) = (base[k], base[(k + 1) % n]);
        vec![b, a, a + up, b + up]
    };
    let ceiling = base.iter().rev().map(|&corner| corner + up).collect();
    let mut faces: Vec<Vec<DVec3>> = (0..n).map(wall).collect();
    faces.extend([base.to_vec(), ceiling]);
    faces
}

/// Where a shape stands: turned, enlarged and moved at random.
pub struct Place {
    turn: Frame,
    scale: f64,
    origin: DVec3,
}

impl Place {
    /// A random place, within a few metres.
    pub fn draw(stream: &mut Stream) -> Place {
        let scale = uniform(stream, 0.5, 2.0);
        Place { turn: frame(stream), scale, origin: direction(stream) * 3.0 }
    }

    /// A random turn about the origin, enlarged by `scale`.
    pub fn about_origin(stream: &mut Stream, scale: f64) -> Place {
        Place { turn: frame(stream), scale, origin: DVec3::ZERO }
    }

    /// Where a point of the shape comes to lie.
    pub fn of(&self, p: DVec3) -> DVec3 {
        self.origin + self.turn.world_from_local(p * self.scale)
    }

    /// Where a direction of the shape comes to point.
    pub fn direction(&self, d: DVec3) -> DVec3 {
        self.turn.world_from_local(d)
    }

    /// Where an outline comes to lie.
    pub fn all(&self, outline: &[DVec3]) -> Vec<DVec3> {
        outline.iter().map(|&p| self.of(p)).collect()
    }
}
