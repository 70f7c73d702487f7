//! The cone about the reflection ray: how much of it a polygon fills, exactly.

use crate::geometry::{Frame, Outline, Plane, clip};
use crate::radiometry::{projected_solid_angle, projected_solid_angle_of_cap};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// All directions within an angle of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// Its middle, of unit length.
    pub axis: DVec3,
    /// In radians, in `[0, π/2]`.
    pub half_angle: f64,
}

impl Cone {
    /// The cone that holds this share, in `[0, 1)`, of a Phong lobe about `axis`.
    ///
    /// ```text
    /// share = (n + 1)/2π ∫ cosⁿα dω = 1 − cosⁿ⁺¹β        β = acos (1 − share)^(1/(n + 1))
    /// ```
    // ANCHOR: holding
    pub fn holding(share: f64, exponent: f64, axis: DVec3) -> Cone {
        debug_assert!((0.0..=1.0).contains(&share), "share: {share}");
        let cosine = (1.0 - share).powf(1.0 / (exponent + 1.0));
        Cone { axis, half_angle: cosine.acos() }
    }
    // ANCHOR_END: holding

    /// The cone in which a Phong lobe is higher than this `level` of its peak, in `(0, 1)`.
    ///
    /// ```text
    /// cosⁿβ = level        cosⁿα = ∫₀¹ [α < β(level)] d level: the lobe is a stack of cones
    /// ```
    // ANCHOR: above
    pub fn above(level: f64, exponent: f64, axis: DVec3) -> Cone {
        debug_assert!((0.0..=1.0).contains(&level), "level: {level}");
        Cone { axis, half_angle: level.powf(1.0 / exponent).acos() }
    }
    // ANCHOR_END: above

    /// Projected solid angle, in sr, of what lies inside the cone and above the horizon of
    /// a surface with unit normal `n`.
    pub fn projected_solid_angle(&self, n: DVec3) -> f64 {
        let tilt = n.cross(self.axis).length().atan2(n.dot(self.axis));
        projected_solid_angle_of_cap(self.half_angle, tilt)
    }

    /// The share of the cone, by projected solid angle, that `outline` fills, as seen from
    /// `p` on a surface with unit normal `n`; in `[0, 1]`. 0 when the cone is below the
    /// horizon.
    pub fn share(&self, p: DVec3, n: DVec3, outline: &[DVec3]) -> f64 {
        let whole = self.projected_solid_angle(n);
        if whole > 0.0 { self.overlap(p, n, outline) / whole } else { 0.0 }
    }

    /// Projected solid angle, in sr, of what of a convex `outline` lies inside the cone and
    /// above the horizon of `p`, on a surface with unit normal `n`: `∫ cosθ dω` over both.
    ///
    /// Lambert's contour integral about the overlap: along edges of the outline where they
    /// are inside the cone, and along the cone's rim where that is inside the outline.
    ///
    /// ```text
    /// Ω⊥ = ½ ∮ n·(ω × dω)
    /// edge   ½ γ n·m                  γ: angle run through inside; m: normal of its plane
    /// rim    ½ (sin²β (n·a) Δφ − sinβ cosβ ((n·x) Δsinφ − (n·y) Δcosφ))
    /// ```
    /// with the axis `a` and `x`, `y` across it.
    ///
    /// # Accuracy
    /// Rounding of π sin²β, for outlines that do not pass through `p`.
    pub fn overlap(&self, p: DVec3, n: DVec3, outline: &[DVec3]) -> f64 {
        debug_assert!((0.0..=FRAC_PI_2 + 1e-12).contains(&self.half_angle));
        let above = clip(outline, Plane::through(p, n));
        let corners: Outline = above.iter().map(|v| v - p).collect();
        let cosine = self.half_angle.cos();
        let inside = |v: &DVec3| v.dot(self.axis) >= cosine * v.length();
        if corners.len() < 3 {
            return 0.0;
        }
        if corners.iter().all(inside) {
            return projected_solid_angle(p, n, outline); // a cone is convex
        }
        let mut contour = Contour::new(self, n, turn(&corners));
        let mut a = corners[corners.len() - 1];
        for &b in &corners {
            contour.edge(a, b);
            a = b;
        }
        match contour.finish() {
            Some(sum) => sum.clamp(0.0, PI),
            None if holds(&corners, self.axis) => self.projected_solid_angle(n),
            None => 0.0,
        }
    }
}

/// 1 when the corners run counter-clockwise about what they enclose, as seen from within;
/// -1 when clockwise.
fn turn(corners: &[DVec3]) -> f64 {
    let fan = |k: usize| corners[0].dot(corners[k].cross(corners[k + 1]));
    (1..corners.len() - 1).map(fan).sum::<f64>().signum()
}

/// Does a direction lie within a convex outline about the origin?
fn holds(corners: &[DVec3], direction: DVec3) -> bool {
    let turn = turn(corners);
    (0..corners.len()).all(|k| {
        let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
        turn * a.cross(b).dot(direction) >= 0.0
    })
}

/// Lambert's integral along the border of a cone and an outline, as it is run along.
struct Contour {
    n: DVec3,
    cone: Frame,
    sine: f64,
    cosine: f64,
    /// 1 when the outline is run along counter-clockwise, else -1.
    turn: f64,
    sum: f64,
    /// Where the outline first came into the cone, as an angle about the axis.
    entered: Option<f64>,
    /// Where it left the cone last.
    left: Option<f64>,
    /// Did it ever?
    crossed: bool,
}

impl Contour {
    fn new(cone: &Cone, n: DVec3, turn: f64) -> Contour {
        let (sine, cosine) = cone.half_angle.sin_cos();
        let cone = Frame::about(cone.axis);
        let (entered, left, crossed) = (None, None, false);
        Contour { n, cone, sine, cosine, turn, sum: 0.0, entered, left, crossed }
    }

    /// The part of the edge from `a` to `b` that is inside the cone.
    fn edge(&mut self, a: DVec3, b: DVec3) {
        let Some(m) = a.cross(b).try_normalize() else { return };
        let along = a.normalize();
        let across = m.cross(along);
        let length = along.cross(b).length().atan2(along.dot(b));
        // ANCHOR: edge
        // The angle to the axis is a cosine of the place t on the edge's great circle.
        let (x, y) = (along.dot(self.cone.z), across.dot(self.cone.z));
        let reach = x.hypot(y);
        if reach <= self.cosine {
            return;
        }
        let (middle, half) = (y.atan2(x), (self.cosine / reach).acos());
        // ANCHOR_END: edge
        for middle in [middle, middle + TAU] {
            let (from, to) = (middle - half, middle + half);
            let (enters, leaves) = (from > 0.0, to < length);
            if from >= length || to <= 0.0 {
                continue;
            }
            self.crossed = true;
            // ANCHOR: edge_parts
            let at = |t: f64| t.cos() * along + t.sin() * across;
            if enters {
                self.enter(at(from));
            }
            self.sum += 0.5 * (to.min(length) - from.max(0.0)) * self.n.dot(m);
            if leaves {
                self.left = Some(self.angle(at(to)));
            }
            // ANCHOR_END: edge_parts
        }
    }

    /// An angle about the axis, in `(-π, π]`.
    fn angle(&self, w: DVec3) -> f64 {
        w.dot(self.cone.y).atan2(w.dot(self.cone.x))
    }

    fn enter(&mut self, w: DVec3) {
        let here = self.angle(w);
        match self.left.take() {
            Some(left) => self.rim(left, here),
            None => self.entered = Some(here),
        }
    }

    /// The rim from where the outline left the cone to where it comes in again.
    // ANCHOR: rim
    fn rim(&mut self, from: f64, to: f64) {
        let angle = self.turn * (self.turn * (to - from)).rem_euclid(TAU);
        let Frame { x, y, z } = self.cone;
        let (s, c) = (self.sine, self.cosine);
        let sines = self.n.dot(x) * (to.sin() - from.sin());
        let cosines = self.n.dot(y) * (to.cos() - from.cos());
        let area = s * s * self.n.dot(z) * angle;
        self.sum += 0.5 * (area - s * c * (sines - cosines));
    }
    // ANCHOR_END: rim

    /// The whole integral; `None` when outline and rim never cross.
    fn finish(mut self) -> Option<f64> {
        if let (Some(left), Some(entered)) = (self.left, self.entered) {
            self.rim(left, entered);
        }
        self.crossed.then_some(self.turn * self.sum)
    }
}
