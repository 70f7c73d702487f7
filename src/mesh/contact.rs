//! Contact lines: where a surface is touched or pierced by another one, or an edge hovers
//! just above it.
//!
//! An element that lies on both sides of a wall shows the mean of two unrelated lights: a
//! *light leak* or a *shadow leak*. So elements are cut along contact lines, and vertices
//! on a contact line belong to one side of it. The edges of a box that hovers a hair above
//! the floor do the same: beneath it is another room, and what changes from one to the other
//! does so within a few times the gap.

use crate::geometry::{Plane, Polygon, Rgb, bounds};
use crate::scene::{MaterialId, Scene};
use glam::DVec3;
use std::collections::HashMap;
use std::ops::Range;

/// Surfaces grouped by plane and material, each group with its contact lines.
#[derive(Debug)]
pub(super) struct Planes {
    group_of: Vec<u32>,
    contacts: Vec<Contacts>,
    /// See [`Scene::rounding`].
    pub(super) rounding: f64,
}

/// The contact lines in one plane.
#[derive(Debug, Default)]
pub(super) struct Contacts {
    lines: Vec<Contact>,
    /// What counts as touching, in scene units.
    margin: f64,
}

#[derive(Debug)]
struct Contact {
    ends: [DVec3; 2],
    /// Contains the line, at right angles to the surface.
    wall: Plane,
    /// Nothing is cut off that is narrower than this, in scene units.
    sliver: f64,
}

/// What is near, and what is small, is told by the size of the scene, but of no more of it
/// than this many times the surfaces of the plane.
const LARGER: f64 = 10.0;

/// An edge hovers when it is nearer than this share of that size, and longer.
/// What is farther away casts shadows that elements resolve; what is shorter is part of
/// something round.
const HOVERS: f64 = 1e-2;

/// What such an edge cuts off is wider than this share of that size.
const HOVERS_INSIDE: f64 = 1e-4;

impl Planes {
    pub(super) fn of(scene: &Scene) -> Planes {
        let margin = 100.0 * scene.rounding();
        let mut groups: HashMap<(MaterialId, [i64; 4]), u32> = HashMap::new();
        let mut planes: Vec<(Vec<Plane>, Vec<&Polygon>)> = Vec::new();
        let mut group_of = Vec::new();
        for surface in &scene.surfaces {
            let plane = surface.polygon.plane();
            let [x, y, z] = (plane.normal * 1.2345e7).to_array();
            let place = [x, y, z, plane.offset / (1.2345 * margin)];
            let place = place.map(|coordinate| coordinate.round() as i64);
            let group = *groups.entry((surface.material, place)).or_insert_with(|| {
                // What light passes shows the lines of either side on both.
                let through = scene.material(surface).translucence() != Rgb::ZERO;
                let behind = through.then(|| plane.flipped());
                planes.push(([plane].into_iter().chain(behind).collect(), Vec::new()));
                planes.len() as u32 - 1
            });
            planes[group as usize].1.push(&surface.polygon);
            group_of.push(group);
        }
        let diagonal = scene.diagonal();
        let others: Vec<(&Polygon, (DVec3, DVec3))> = scene
            .surfaces
            .iter()
            .map(|s| (&s.polygon, bounds(s.polygon.vertices().iter().copied())))
            .collect();
        let contacts = planes.iter().map(|(sides, own)| {
            let (low, high) =
                bounds(own.iter().flat_map(|p| p.vertices().iter().copied()));
            let size = diagonal.min(LARGER * low.distance(high));
            let near = [HOVERS, HOVERS_INSIDE].map(|share| share * size);
            let lines = contact_lines(sides, own, &others, margin, near);
            Contacts { lines, margin }
        });
        Planes { contacts: contacts.collect(), group_of, rounding: scene.rounding() }
    }

    /// The group of a surface of the scene, and its contact lines.
    pub(super) fn of_surface(&self, id: u32) -> (u32, &Contacts) {
        let group = self.group_of[id as usize];
        (group, &self.contacts[group as usize])
    }
}

/// The lines along which `others` meet a plane inside one of its `own` polygons, or hover
/// above one of its `sides`, nearer than `near`, farther inside than `sliver`.
fn contact_lines(
    sides: &[Plane],
    own: &[&Polygon],
    others: &[(&Polygon, (DVec3, DVec3))],
    margin: f64,
    [near, sliver]: [f64; 2],
) -> Vec<Contact> {
    let (plane, mut lines) = (sides[0], Vec::<Contact>::new());
    let (low, high) = bounds(own.iter().flat_map(|p| p.vertices().iter().copied()));
    for (other, (from, to)) in others {
        if from.cmpgt(high + near).any() || to.cmplt(low - near).any() {
            continue;
        }
        let meets = meets(other, plane, margin).map(|ends| (ends, margin));
        let hovering =
            sides.iter().flat_map(|&side| hovering(other, side, margin..near));
        let hovering = hovering.map(|ends| (ends, sliver));
        for (ends, sliver) in meets.into_iter().chain(hovering) {
            if !own.iter().any(|p| overlap(p, ends, sliver) > 10.0 * sliver) {
                continue;
            }
            let across = plane.normal.cross(ends[1] - ends[0]).normalize();
            let wall = Plane::through(ends[0], across);
            let known = |l: &Contact| {
                ends.iter().all(|&e| l.wall.height(e).abs() <= sliver)
                    && l.ends
                        .iter()
                        .all(|e| ends.iter().any(|f| e.distance(*f) <= sliver))
            };
            if !lines.iter().any(known) {
                lines.push(Contact { ends, wall, sliver });
            }
        }
    }
    lines
}

/// The edges of `polygon` that hover in front of `plane` so near, moved into it.
fn hovering(
    polygon: &Polygon,
    plane: Plane,
    near: Range<f64>,
) -> impl Iterator<Item = [DVec3; 2]> {
    polygon.edges().filter_map(move |(a, b)| {
        let heights = [plane.height(a), plane.height(b)];
        let hovers = heights.iter().all(|h| near.contains(h));
        let [a, b] = [a - heights[0] * plane.normal, b - heights[1] * plane.normal];
        (hovers && a.distance(b) > near.end).then_some([a, b])
    })
}

/// The segment that `polygon` and `plane` have in common, unless it is a point, or all.
fn meets(polygon: &Polygon, plane: Plane, margin: f64) -> Option<[DVec3; 2]> {
    let mut points = Vec::new();
    for (a, b) in polygon.edges() {
        let (ha, hb) = (plane.height(a), plane.height(b));
        if ha.abs() <= margin {
            points.push(a);
        } else if hb.abs() > margin && (ha > 0.0) != (hb > 0.0) {
            points.push(a + (b - a) * (ha / (ha - hb)));
        }
    }
    let coplanar = polygon.vertices().iter().all(|&v| plane.height(v).abs() <= margin);
    match points[..] {
        [a, b] if !coplanar && a.distance(b) > margin => Some([a, b]),
        _ => None,
    }
}

/// How much of a segment in the polygon's plane runs through its inside, in scene units.
fn overlap(polygon: &Polygon, [a, b]: [DVec3; 2], margin: f64) -> f64 {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (p, q) in polygon.edges() {
        let inward = polygon.normal().cross(q - p).normalize();
        let edge = Plane::through(p, inward);
        // Along the edge itself there is no inside: ask for a margin.
        let (ha, hb) = (edge.height(a) - margin, edge.height(b) - margin);
        match (ha >= 0.0, hb >= 0.0) {
            (false, false) => return 0.0,
            (false, true) => from = from.max(ha / (ha - hb)),
            (true, false) => to = to.min(ha / (ha - hb)),
            (true, true) => {}
        }
    }
    (to - from).max(0.0) * a.distance(b)
}

impl Contacts {
    /// The pieces of `cell` between the contact lines that run through it.
    pub(super) fn cut(&self, cell: Polygon) -> Vec<Polygon> {
        let mut pieces = vec![cell];
        for line in &self.lines {
            let through =
                |p: &Polygon| overlap(p, line.ends, line.sliver) > line.sliver;
            pieces = pieces
                .into_iter()
                .flat_map(|piece| {
                    if through(&piece) {
                        let halves = [line.wall, line.wall.flipped()];
                        halves.into_iter().filter_map(|w| piece.clipped(w)).collect()
                    } else {
                        vec![piece]
                    }
                })
                .collect();
        }
        pieces
    }

    /// For a corner `at` on contact lines: on which side of each the element with this
    /// `middle` lies.
    pub(super) fn sides(&self, at: DVec3, middle: DVec3) -> Vec<(u32, bool)> {
        let on = |line: &Contact| {
            let [a, b] = line.ends;
            let along = ((at - a).dot(b - a) / a.distance_squared(b)).clamp(0.0, 1.0);
            a.lerp(b, along).distance(at) <= self.margin
        };
        let lines = (0u32..).zip(&self.lines).filter(|(_, line)| on(line));
        lines.map(|(k, line)| (k, line.wall.height(middle) > 0.0)).collect()
    }
}
