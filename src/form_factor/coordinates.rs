//! Coordinates on a patch, for light that is linear across it.
//!
//! ```text
//! s(p) = a·(p − middle),  t(p) = c·(p − middle)         −1 to 1 on a parallelogram
//! s = s₀ + α·(x, y, 1)/η·(x, y, 1)                      where a picture shows it at (x, y)
//! ```

use super::linear::{Moments, Slopes};
use crate::geometry::{Polygon, Rgb};
use crate::raster::{ItemBuffer, View};
use glam::{DMat4, DVec3, DVec4, dvec4};
use std::ops::Range;

/// Coordinates `s`, `t` on a patch or an element, from −1 to 1 on a parallelogram.
#[derive(Debug)]
pub(super) struct PatchCoordinates {
    pub(super) middle: DVec3,
    along: DVec3,
    across: DVec3,
    /// For each corner, what its value adds to the four coefficients.
    fit: Vec<DVec4>,
    /// The mean of `s t` over the patch; those of `s` and `t` are 0.
    pub(super) mean_product: f64,
}

impl PatchCoordinates {
    /// `s` and `t` of a point of the plane.
    pub(super) fn place(&self, p: DVec3) -> (f64, f64) {
        let from_middle = p - self.middle;
        (self.along.dot(from_middle), self.across.dot(from_middle))
    }

    pub(super) fn of(polygon: &Polygon) -> PatchCoordinates {
        let (v, n, middle) = (polygon.vertices(), polygon.normal(), polygon.centroid());
        let u = 0.5 * (v[1] - v[0]);
        let w = if v.len() == 4 { 0.5 * (v[3] - v[0]) } else { n.cross(u) };
        let (along, across) = (w.cross(n), n.cross(u));
        let (along, across) = (along / along.dot(u), across / across.dot(w));
        let place = |p: DVec3| (along.dot(p - middle), across.dot(p - middle));
        let basis = |p: DVec3| {
            let (s, t) = place(p);
            dvec4(1.0, s, t, if v.len() > 3 { s * t } else { 0.0 })
        };
        // Least squares over the corners; for a quadrilateral they are met exactly.
        let mut normal = DMat4::ZERO;
        for &corner in v {
            let b = basis(corner);
            normal += DMat4::from_cols(b.x * b, b.y * b, b.z * b, b.w * b);
        }
        if v.len() == 3 {
            normal.w_axis.w = 1.0;
        }
        let regular = normal.determinant() > 1e-9;
        let inverse = normal.inverse();
        let fit = |corner: DVec3| {
            if regular { inverse * basis(corner) } else { DVec4::X / v.len() as f64 }
        };
        let product = |[a, b, c]: [DVec3; 3]| {
            let [(s0, t0), (s1, t1), (s2, t2)] = [a, b, c].map(place);
            let area = 0.5 * (b - a).cross(c - a).dot(n);
            let sums = (s0 + s1 + s2) * (t0 + t1 + t2);
            area / 12.0 * (s0 * t0 + s1 * t1 + s2 * t2 + sums)
        };
        let triangles = (1..v.len() - 1).map(|k| [v[0], v[k], v[k + 1]]);
        PatchCoordinates {
            middle,
            along,
            across,
            fit: v.iter().map(|&corner| fit(corner)).collect(),
            mean_product: triangles.map(product).sum::<f64>() / polygon.area(),
        }
    }

    /// The linear light that comes nearest to these values at the corners.
    pub(super) fn slopes(&self, of_corners: impl Iterator<Item = Rgb>) -> Slopes {
        let mut b = [Rgb::ZERO; 4];
        for (value, weights) in of_corners.zip(&self.fit) {
            for (b, weight) in b.iter_mut().zip(weights.to_array()) {
                *b += weight * value;
            }
        }
        b
    }
}

/// A patch or an element as it stands in a picture: `s = s₀ + α·(x, y, 1)/η·(x, y, 1)`.
pub(super) struct InView {
    s: (f64, DVec3),
    t: (f64, DVec3),
    nearness: DVec3,
}

impl InView {
    pub(super) fn new(view: &View, polygon: &Polygon, on: &PatchCoordinates) -> InView {
        let from_middle = view.eye() - on.middle;
        let of = |axis: DVec3| (axis.dot(from_middle), view.plane_from_world(axis));
        let height = polygon.plane().height(view.eye());
        let nearness = -view.plane_from_world(polygon.normal()) / height;
        InView { s: of(on.along), t: of(on.across), nearness }
    }

    /// The moments of the cells `run`.
    pub(super) fn moments(
        &self,
        cells: &ItemBuffer,
        weights: &[f64],
        run: Range<usize>,
    ) -> Moments {
        let (width, height) = (cells.width() as usize, cells.height());
        let (mut m, mut start) = ([0.0; 4], run.start);
        while start < run.end {
            let row = start / width;
            let end = run.end.min((row + 1) * width);
            let column = (start - row * width) as u32;
            let at = View::pixel_centre(column, row as u32, width as u32, height);
            let (mut x, step) = (at.x, 2.0 / width as f64);
            for &weight in &weights[start..end] {
                let place = DVec3::new(x, at.y, 1.0);
                let depth = self.nearness.dot(place).recip();
                let s = (self.s.0 + depth * self.s.1.dot(place)).clamp(-1.5, 1.5);
                let t = (self.t.0 + depth * self.t.1.dot(place)).clamp(-1.5, 1.5);
                m[0] += weight;
                m[1] += weight * s;
                m[2] += weight * t;
                m[3] += weight * s * t;
                x += step;
            }
            start = end;
        }
        m
    }
}
