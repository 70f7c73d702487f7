//! One convex thing that stands in the way: a sheet, or a solid of several faces.
//!
//! Seen from a point, a convex thing hides the cone over its **silhouette**: the edges
//! between a face that looks at the point and one that does not. A sheet is a flat solid
//! with two faces, so that all its edges are silhouette.

use crate::geometry::{Plane, Polygon, clip};
use glam::{DAffine3, DVec3};
use smallvec::SmallVec;

/// The planes of a convex cone, facing inward.
pub(super) type ShadowCone = SmallVec<[Plane; 6]>;

/// A convex sheet or solid.
#[derive(Clone, Debug)]
pub struct Blocker {
    corners: Vec<DVec3>,
    faces: Vec<Plane>,
    edges: Vec<Edge>,
    /// A point inside.
    middle: DVec3,
    /// The faces as they stand in the scene.
    sheets: Vec<Polygon>,
}

#[derive(Clone, Debug)]
struct Edge {
    ends: [DVec3; 2],
    /// The two faces that meet in it.
    between: [usize; 2],
}

impl Blocker {
    /// A sheet.
    pub fn sheet(polygon: &Polygon) -> Blocker {
        let edge = |(a, b)| Edge { ends: [a, b], between: [0, 1] };
        Blocker {
            corners: polygon.vertices().to_vec(),
            faces: vec![polygon.plane(), polygon.plane().flipped()],
            edges: polygon.edges().map(edge).collect(),
            middle: polygon.centroid(),
            sheets: vec![polygon.clone()],
        }
    }

    /// A convex solid of these faces, which look outward; at most one of its faces may be
    /// missing, for instance the one that it stands on. `None` when they make no such
    /// solid.
    ///
    /// A segment that runs through the solid from outside to outside crosses its surface
    /// in two places, not both in one plane: so the face that is missing does not matter.
    pub fn solid(sheets: &[&Polygon], margin: f64) -> Option<Blocker> {
        let mut corners: Vec<DVec3> = Vec::new();
        for &v in sheets.iter().flat_map(|s| s.vertices()) {
            if corners.iter().all(|c| c.distance(v) > margin) {
                corners.push(v);
            }
        }
        let below = |plane: &Plane| corners.iter().all(|&v| plane.height(v) <= margin);
        let mut faces: Vec<Plane> = sheets.iter().map(|s| s.plane()).collect();
        if sheets.len() < 3 || !faces.iter().all(below) {
            return None;
        }
        let same = |(a, b): (DVec3, DVec3), (c, d): (DVec3, DVec3)| {
            a.distance(d) <= margin && b.distance(c) <= margin
        };
        let all = || {
            let faces = sheets.iter().enumerate();
            faces.flat_map(|(k, s)| s.edges().map(move |ends| (k, ends)))
        };
        let missing = sheets.len(); // the index of the face that is not there
        let (mut edges, mut rim) = (Vec::new(), Vec::new());
        for (k, (a, b)) in all() {
            match all().find(|&(_, other)| same((a, b), other)) {
                Some((l, _)) if l > k => {
                    edges.push(Edge { ends: [a, b], between: [k, l] })
                }
                Some(_) => {}
                None => {
                    rim.push(a);
                    edges.push(Edge { ends: [a, b], between: [k, missing] });
                }
            }
        }
        let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
        if let [a, b, c, ..] = rim[..] {
            let normal = (b - a).cross(c - a).try_normalize()?;
            let plane = Plane::through(a, normal);
            let plane =
                if plane.height(middle) > 0.0 { plane.flipped() } else { plane };
            if !rim.iter().all(|&v| plane.height(v).abs() <= margin) || !below(&plane) {
                return None;
            }
            faces.push(plane);
        }
        let deep = faces.iter().all(|f| f.height(middle) < -margin);
        let sheets = sheets.iter().map(|&s| s.clone()).collect();
        deep.then_some(Blocker { corners, faces, edges, middle, sheets })
    }

    /// It in another place, by an isometry.
    pub fn moved(&self, by: &DAffine3) -> Blocker {
        let at = |v: DVec3| by.transform_point3(v);
        let edge = |e: &Edge| Edge { ends: e.ends.map(at), between: e.between };
        Blocker {
            corners: self.corners.iter().map(|&v| at(v)).collect(),
            faces: self.faces.iter().map(|f| f.moved(by)).collect(),
            edges: self.edges.iter().map(edge).collect(),
            middle: at(self.middle),
            sheets: self.sheets.iter().map(|s| s.moved(by)).collect(),
        }
    }

    /// What of it rises above `plane` by more than `margin`: itself, where all does;
    /// else its sheets, cut.
    pub fn in_front(&self, plane: Plane, margin: f64) -> Vec<Blocker> {
        let heights = || self.corners.iter().map(|&v| plane.height(v));
        if heights().all(|h| h <= margin) {
            return Vec::new();
        }
        if heights().all(|h| h >= -margin) {
            return vec![self.clone()];
        }
        let above =
            |s: &Polygon| s.vertices().iter().any(|&v| plane.height(v) > margin);
        let sheets = self.sheets.iter().filter(|s| above(s));
        sheets.filter_map(|s| Some(Blocker::sheet(&s.clipped(plane)?))).collect()
    }

    /// Its corners.
    pub fn corners(&self) -> &[DVec3] {
        &self.corners
    }

    /// Adds the cones that hide some of `target` from `p`.
    pub(super) fn hidden_cones(
        &self,
        p: DVec3,
        target: &Polygon,
        cones: &mut Vec<ShadowCone>,
    ) {
        let front = target.plane();
        let rounding = 1e-12 * p.distance(self.middle);
        let outside = self.is_outside(p);
        if outside && self.corners.iter().all(|&v| front.height(v) >= -rounding) {
            cones.extend(self.cone(p, target));
            return;
        }
        // A ray into the solid enters through a face that looks at its origin: those are
        // enough, unless the one that is missing looks there too.
        let looks = |k: usize| self.faces[k].height(p) > 0.0;
        let missing = (self.sheets.len()..self.faces.len()).any(looks);
        for (k, sheet) in self.sheets.iter().enumerate() {
            if missing || !outside || self.sheets.len() == 1 || looks(k) {
                cones.extend(cone_of_sheet(p, sheet, target));
            }
        }
    }

    /// The cone over the silhouette; `None` when all of the target is outside it.
    fn cone(&self, p: DVec3, target: &Polygon) -> Option<ShadowCone> {
        let looks: SmallVec<[bool; 8]> =
            self.faces.iter().map(|f| f.height(p) > 0.0).collect();
        let mut cone = ShadowCone::new();
        for Edge { ends: [a, b], between: [f, g] } in &self.edges {
            if looks[*f] == looks[*g] {
                continue;
            }
            let across = (*a - p).cross(*b - p);
            // Within a face: turn the plane so that the middle is on its front.
            let turn = if across.dot(self.middle - p) < 0.0 { -1.0 } else { 1.0 };
            let plane = Plane { normal: turn * across, offset: turn * across.dot(p) };
            if target.vertices().iter().all(|&v| plane.height(v) <= 0.0) {
                return None;
            }
            cone.push(plane);
        }
        (cone.len() >= 3).then_some(cone)
    }

    /// Is `p` off all of a solid's hull, or off the plane of a sheet?
    fn is_outside(&self, p: DVec3) -> bool {
        let near = 1e-12 * p.distance(self.middle);
        match &self.faces[..] {
            [plane, _] => plane.height(p).abs() > near,
            faces => faces.iter().any(|f| f.height(p) > near),
        }
    }

    /// Does it hide all of one polygon from all of the other?
    ///
    /// Yes when it cuts every segment between their corners: from a fixed point the hidden
    /// part is convex, so it holds all that its corners span - first on one side, then,
    /// point by point, on the other. Corners are moved in by a billionth: those of a
    /// polygon that touches the blocker lie on its rim, and see past it along the rim.
    pub fn hides_all(&self, i: &Polygon, j: &Polygon) -> bool {
        let corners = |p: &Polygon| {
            let middle = p.centroid();
            let moved = p.vertices().iter().map(|v| v.lerp(middle, 1e-9));
            moved.collect::<SmallVec<[DVec3; 8]>>()
        };
        let (from, to) = (corners(i), corners(j));
        from.iter().all(|&a| to.iter().all(|&b| self.cuts(a, b)))
    }

    /// Does the segment run through the inside?
    fn cuts(&self, a: DVec3, b: DVec3) -> bool {
        if let [plane, _] = self.faces[..] {
            let (ha, hb) = (plane.height(a), plane.height(b));
            let crosses = || a + (b - a) * (ha / (ha - hb));
            return ha * hb < 0.0 && self.sheets[0].contains(crosses(), 0.0);
        }
        // It is cut where it crosses a face that is there; the missing one lets it through.
        let there = |k: usize| k < self.sheets.len();
        let ((mut enter, mut stopped_at_entry), (mut leave, mut stopped_at_exit)) =
            ((0.0_f64, false), (1.0_f64, false));
        for (k, face) in self.faces.iter().enumerate() {
            let (ha, hb) = (face.height(a), face.height(b));
            let at = ha / (ha - hb);
            if ha >= 0.0 && hb >= 0.0 {
                return false;
            } else if ha > 0.0 && at > enter {
                (enter, stopped_at_entry) = (at, there(k));
            } else if hb > 0.0 && at < leave {
                (leave, stopped_at_exit) = (at, there(k));
            }
        }
        enter < leave && (stopped_at_entry || stopped_at_exit)
    }
}

/// The cone of the sheet's part in front of the target; `None` when it hides nothing.
fn cone_of_sheet(p: DVec3, sheet: &Polygon, target: &Polygon) -> Option<ShadowCone> {
    let rest = clip(sheet.vertices(), target.plane());
    let rest = Polygon::piece(rest.to_vec(), sheet.normal())?;
    let rest = Blocker::sheet(&rest);
    if rest.is_outside(p) { rest.cone(p, target) } else { None }
}
