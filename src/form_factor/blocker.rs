//! One convex thing that stands in the way: a sheet, or a solid of several faces.
//!
//! Seen from a point, a convex thing hides the cone over its **silhouette**: the edges
//! between a face that looks at the point and one that does not. A sheet is a flat solid
//! with two faces, so that all its edges are silhouette.

use crate::geometry::{Plane, Polygon, clip};
use glam::DVec3;
use smallvec::SmallVec;

/// The planes of a convex cone, facing inward.
pub(super) type Cone = SmallVec<[Plane; 6]>;

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
        let corners: Vec<DVec3> =
            sheets.iter().flat_map(|s| s.vertices()).copied().collect();
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

    /// Its corners.
    pub fn corners(&self) -> &[DVec3] {
        &self.corners
    }

    /// Adds the cones that hide some of `target` from `p`.
    pub(super) fn hidden_cones(
        &self,
        p: DVec3,
        target: &Polygon,
        cones: &mut Vec<Cone>,
    ) {
        let front = target.plane();
        if self.corners.iter().all(|&v| front.height(v) >= 0.0) && self.is_outside(p) {
            cones.extend(self.cone(p, target));
        } else {
            let sheets = self.sheets.iter();
            cones.extend(sheets.filter_map(|sheet| cone_of_sheet(p, sheet, target)));
        }
    }

    /// The cone over the silhouette; `None` when all of the target is outside it.
    fn cone(&self, p: DVec3, target: &Polygon) -> Option<Cone> {
        let looks: SmallVec<[bool; 8]> =
            self.faces.iter().map(|f| f.height(p) > 0.0).collect();
        let mut cone = Cone::new();
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
    /// point by point, on the other.
    pub(super) fn hides_all(&self, i: &Polygon, j: &Polygon) -> bool {
        i.vertices().iter().all(|&a| j.vertices().iter().all(|&b| self.cuts(a, b)))
    }

    /// Does the segment run through the inside, ends outside?
    fn cuts(&self, a: DVec3, b: DVec3) -> bool {
        if let [plane, _] = self.faces[..] {
            let (ha, hb) = (plane.height(a), plane.height(b));
            let crosses = || a + (b - a) * (ha / (ha - hb));
            return ha * hb < 0.0 && self.sheets[0].contains(crosses(), 0.0);
        }
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for face in &self.faces {
            let (ha, hb) = (face.height(a), face.height(b));
            if ha >= 0.0 && hb >= 0.0 {
                return false;
            }
            let at = ha / (ha - hb);
            if ha > 0.0 {
                enter = enter.max(at);
            } else if hb > 0.0 {
                leave = leave.min(at);
            }
        }
        enter > 0.0 && leave < 1.0 && enter < leave
    }
}

/// The cone of the sheet's part in front of the target; `None` when it hides nothing.
fn cone_of_sheet(p: DVec3, sheet: &Polygon, target: &Polygon) -> Option<Cone> {
    let rest = clip(sheet.vertices(), target.plane());
    let rest = Polygon::piece(rest.to_vec(), sheet.normal())?;
    let rest = Blocker::sheet(&rest);
    if rest.is_outside(p) { rest.cone(p, target) } else { None }
}
