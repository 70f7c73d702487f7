//! Where a vertex is asked for its light.

use super::Mesh;
use glam::DVec3;
use std::f64::consts::TAU;

/// A point that speaks for a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The vertex itself inside a surface; at its rim, a little inside.
    pub at: DVec3,
    /// An element that the vertex is a corner of.
    pub element: u32,
}

impl Mesh {
    /// For each vertex the point that is asked for its light; `None` for T-vertices, which
    /// have none of their own.
    ///
    /// At the rim of a surface light has a cusp: the wall next to it fills half of what
    /// the point sees. So the point is moved inward, by the share `inside` of the way to
    /// the middle of the elements there.
    pub fn places(&self, inside: f64) -> Vec<Option<Place>> {
        let mut around = vec![(0.0, DVec3::ZERO, 0.0, 0u32); self.vertices.len()];
        for (k, element) in (0u32..).zip(&self.elements) {
            let (v, n) = (element.polygon.vertices(), element.corners.len());
            let middle = element.polygon.centroid();
            for (j, &corner) in element.corners.iter().enumerate() {
                let (before, after) =
                    (v[(j + n - 1) % n] - v[j], v[(j + 1) % n] - v[j]);
                let (angle, sum, count, any) = &mut around[corner];
                *angle += before.angle_between(after);
                *sum += middle;
                *count += 1.0;
                *any = k;
            }
        }
        let place = |(&at, &(angle, sum, count, element)): (
            &DVec3,
            &(f64, DVec3, f64, u32),
        )| {
            let rim = angle < TAU - 1e-6;
            let at = if rim { at.lerp(sum / count, inside) } else { at };
            Some(Place { at, element })
        };
        let mut places: Vec<Option<Place>> =
            self.vertices.iter().zip(&around).map(place).collect();
        self.t_vertices().for_each(|t| places[t] = None);
        places
    }
}
