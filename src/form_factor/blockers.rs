//! What may stand between two polygons: blockers, walls and shafts.
//!
//! A blocker outside the **shaft** of two polygons, their convex hull, hides nothing of one
//! from the other. A surface that has the whole scene on one side never blocks. And the
//! tiles of a wall block as one: so most pairs of a room need no visibility at all, however
//! finely it is tiled. The faces of a convex solid block as one, too.
//!
//! Sources: Haines & Wallace 1991 (shaft culling); Andrew 1979 (convex hulls).

use super::blocker::Blocker;
use crate::geometry::{Frame, Plane, Polygon, bounds};
use crate::material::Shine;
use crate::scene::Scene;
use crate::visibility::Visibility;
use glam::DVec3;
use std::collections::HashMap;
use std::sync::OnceLock;

/// The surfaces of a scene as what stands in the way.
#[derive(Debug)]
pub struct Blockers {
    /// What can stand between surfaces.
    within: Standing,
    /// All opaque sheets: what can hide a lamp that is far away. Made when it is asked for.
    from_outside: OnceLock<Standing>,
    opaque: Vec<Polygon>,
    bounds: (DVec3, DVec3),
    walls: Vec<Polygon>,
    wall_of: Vec<u32>,
    margin: f64,
}

/// Blockers, to be found by where they are.
struct Standing {
    blockers: Vec<Blocker>,
    /// All sheets of all blockers, and whose they are.
    sheets: Visibility,
    owner: Vec<u32>,
}

impl Standing {
    fn of(sheets: &[Polygon], margin: f64) -> Standing {
        let (blockers, owner) = solids(sheets, margin);
        Standing { blockers, sheets: Visibility::new(sheets), owner }
    }

    /// Those that reach into the shaft, always in one order.
    fn within(&self, shaft: &Shaft) -> Vec<&Blocker> {
        let mut found = Vec::new();
        let outside = |low, high| shaft.misses_box(low, high);
        self.sheets.visit(outside, |sheet| found.push(self.owner[sheet as usize]));
        found.sort_unstable();
        found.dedup();
        let blockers = found.iter().map(|&k| &self.blockers[k as usize]);
        blockers.filter(|b| !shaft.misses(b)).collect()
    }
}

impl Blockers {
    /// Those of a scene.
    pub fn of(scene: &Scene) -> Blockers {
        let margin = scene.rounding();
        let surfaces: Vec<&Polygon> =
            scene.surfaces.iter().map(|s| &s.polygon).collect();
        // Light goes through panes: no wall has any, and none blocks.
        let pane = |k: usize| {
            let shine = scene.material(&scene.surfaces[k]).shine();
            matches!(shine, Shine::Pane { .. })
        };
        let in_plane = |k: usize| in_plane(surfaces[k], margin, i64::from(pane(k)));
        let (wall_of, tiles) = joined(&surfaces, margin, in_plane);
        let walls: Vec<Polygon> = tiles.iter().map(|t| hull(t, &surfaces)).collect();
        let blocks = |wall: &Polygon| {
            let heights = || {
                let corners = walls.iter().flat_map(|w| w.vertices());
                corners.map(|&v| wall.plane().height(v))
            };
            heights().any(|h| h > margin) && heights().any(|h| h < -margin)
        };
        let (mut between, mut opaque) = (Vec::new(), Vec::new());
        for (wall, tiles) in walls.iter().zip(&tiles).filter(|(_, t)| !pane(t[0])) {
            let first = opaque.len();
            let area: f64 = tiles.iter().map(|&t| surfaces[t].area()).sum();
            if (wall.area() - area).abs() <= 1e-9 * area {
                opaque.push(wall.clone());
            } else {
                opaque.extend(tiles.iter().map(|&t| surfaces[t].clone()));
            }
            if blocks(wall) {
                between.extend_from_slice(&opaque[first..]);
            }
        }
        Blockers {
            within: Standing::of(&between, margin),
            from_outside: OnceLock::new(),
            opaque,
            bounds: scene.bounds(),
            walls,
            wall_of,
            margin,
        }
    }

    /// Convex outlines that hold whole walls: each surface lies in one.
    pub fn walls(&self) -> &[Polygon] {
        &self.walls
    }

    /// Everything that can stand between surfaces.
    pub fn all(&self) -> &[Blocker] {
        &self.within.blockers
    }

    /// In which of the [`Blockers::walls`] a surface lies.
    pub fn wall_of(&self, surface: usize) -> u32 {
        self.wall_of[surface]
    }

    /// All that may hide some of one polygon from some of the other, always in one order.
    /// Where one of them lies outside the scene, walls around the scene may, too.
    pub fn between(&self, i: &Polygon, j: &Polygon) -> Vec<&Blocker> {
        let outside = [i, j].into_iter().any(|p| self.is_outside(p));
        let standing = match outside {
            false => &self.within,
            true => self
                .from_outside
                .get_or_init(|| Standing::of(&self.opaque, self.margin)),
        };
        if standing.blockers.is_empty() {
            return Vec::new();
        }
        standing.within(&Shaft::between(i, j, self.margin))
    }

    /// Does any of it lie outside the box that holds the scene?
    fn is_outside(&self, polygon: &Polygon) -> bool {
        let (low, high) = bounds(polygon.vertices().iter().copied());
        low.cmplt(self.bounds.0 - self.margin).any()
            || high.cmpgt(self.bounds.1 + self.margin).any()
    }

    /// Those of `blockers` that reach into the shaft.
    pub fn narrowed<'a>(
        &self,
        blockers: &[&'a Blocker],
        i: &Polygon,
        j: &Polygon,
    ) -> Vec<&'a Blocker> {
        if blockers.is_empty() {
            return Vec::new();
        }
        let shaft = Shaft::between(i, j, self.margin);
        blockers.iter().copied().filter(|b| !shaft.misses(b)).collect()
    }
}

/// A solid of more faces than this is taken face by face.
const MOST_FACES: usize = 64;

/// Joins sheets that make a convex solid: the blockers, and for each sheet its blocker.
fn solids(sheets: &[Polygon], margin: f64) -> (Vec<Blocker>, Vec<u32>) {
    let sheets: Vec<&Polygon> = sheets.iter().collect();
    let (_, parts) = joined(&sheets, margin, |_| [0; 5]);
    let mut blockers = Vec::new();
    let mut owner = vec![0; sheets.len()];
    for part in parts {
        let faces: Vec<&Polygon> = part.iter().map(|&k| sheets[k]).collect();
        let small = faces.len() <= MOST_FACES;
        let solid = if small { Blocker::solid(&faces, margin) } else { None };
        let whole = solid.is_some();
        let first = blockers.len() as u32;
        match solid {
            Some(solid) => blockers.push(solid),
            None => blockers.extend(faces.iter().map(|f| Blocker::sheet(f))),
        }
        for (k, &sheet) in (0u32..).zip(&part) {
            owner[sheet] = if whole { first } else { first + k };
        }
    }
    (blockers, owner)
}

/// Groups polygons of one `class` that share corners: for each its group, and the groups.
fn joined(
    polygons: &[&Polygon],
    margin: f64,
    class: impl Fn(usize) -> [i64; 5],
) -> (Vec<u32>, Vec<Vec<usize>>) {
    // The odd factor keeps round numbers off the border between two quanta.
    let quantum = 1.2345 * margin;
    let mut parent: Vec<usize> = (0..polygons.len()).collect();
    let mut seen: HashMap<([i64; 5], [i64; 3]), usize> = HashMap::new();
    for (id, polygon) in polygons.iter().enumerate() {
        for &corner in polygon.vertices() {
            let place = (corner / quantum).to_array().map(|x| x.round() as i64);
            let other = *seen.entry((class(id), place)).or_insert(id);
            let (a, b) = (root(&mut parent, id), root(&mut parent, other));
            parent[a.max(b)] = a.min(b);
        }
    }
    let mut number = vec![u32::MAX; polygons.len()];
    let (mut group_of, mut groups) = (Vec::new(), Vec::<Vec<usize>>::new());
    for id in 0..polygons.len() {
        let root = root(&mut parent, id);
        if number[root] == u32::MAX {
            number[root] = groups.len() as u32;
            groups.push(Vec::new());
        }
        group_of.push(number[root]);
        groups[number[root] as usize].push(id);
    }
    (group_of, groups)
}

fn root(parent: &mut [usize], mut id: usize) -> usize {
    while parent[id] != id {
        parent[id] = parent[parent[id]];
        id = parent[id];
    }
    id
}

/// The convex hull of coplanar tiles (Andrew's monotone chain).
fn hull(tiles: &[usize], surfaces: &[&Polygon]) -> Polygon {
    let first = surfaces[tiles[0]];
    if tiles.len() == 1 {
        return first.clone();
    }
    // An odd angle, so that no edge runs along an axis and rounding cannot change the
    // order of its corners.
    let frame = Frame::about(first.normal());
    let (sine, cosine) = 1.0_f64.sin_cos();
    let flat = |v: DVec3| {
        let (x, y) = (frame.x.dot(v), frame.y.dot(v));
        (cosine * x + sine * y, cosine * y - sine * x)
    };
    let corners = tiles.iter().flat_map(|&t| surfaces[t].vertices());
    let mut points: Vec<(f64, f64, DVec3)> =
        corners.map(|&v| (flat(v).0, flat(v).1, v)).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let size = points[0].2.distance(points[points.len() - 1].2);
    let chain = |points: &mut dyn Iterator<Item = &(f64, f64, DVec3)>| {
        let mut chain: Vec<(f64, f64, DVec3)> = Vec::new();
        for &p in points {
            while let [.., a, b] = chain[..] {
                let turn = (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0);
                if turn > 1e-9 * size * size {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut outline = chain(&mut points.iter());
    outline.extend(chain(&mut points.iter().rev()));
    let outline = outline.into_iter().map(|p| p.2).collect();
    Polygon::piece(outline, first.normal()).unwrap_or_else(|| first.clone())
}

/// Polygons of one `class` that share corners in one plane, joined: each group's convex
/// hull where they fill it, else each by itself; with the polygons that it is made of.
pub(crate) fn joined_tiles(
    polygons: &[&Polygon],
    margin: f64,
    class: impl Fn(usize) -> i64,
) -> Vec<(Polygon, Vec<usize>)> {
    let (_, groups) =
        joined(polygons, margin, |k| in_plane(polygons[k], margin, class(k)));
    let mut whole = Vec::new();
    for tiles in groups {
        let hull = hull(&tiles, polygons);
        let area: f64 = tiles.iter().map(|&t| polygons[t].area()).sum();
        if (hull.area() - area).abs() <= 1e-9 * area {
            whole.push((hull, tiles));
        } else {
            whole.extend(tiles.into_iter().map(|t| (polygons[t].clone(), vec![t])));
        }
    }
    whole
}

/// What polygons of one plane and `class` have in common.
fn in_plane(p: &Polygon, margin: f64, class: i64) -> [i64; 5] {
    let [x, y, z] = (1.2345e8 * p.normal()).to_array();
    let offset = p.plane().offset / (1.2345 * margin);
    let [x, y, z, offset] = [x, y, z, offset].map(|v| v.round() as i64);
    [x, y, z, offset, class]
}

/// Planes that have both polygons on their front.
pub(crate) struct Shaft {
    planes: Vec<Plane>,
    margin: f64,
}

impl Shaft {
    /// The shaft of two polygons; what protrudes less than `margin` into it is outside.
    pub(crate) fn between(i: &Polygon, j: &Polygon, margin: f64) -> Shaft {
        let mut planes = vec![i.plane(), j.plane()];
        for (from, to) in [(i, j), (j, i)] {
            for (a, b) in from.edges() {
                planes
                    .extend(to.vertices().iter().filter_map(|&c| side(a, b, c, i, j)));
            }
        }
        Shaft { planes, margin }
    }

    fn misses(&self, blocker: &Blocker) -> bool {
        self.misses_all(blocker.corners())
    }

    /// Does it miss the convex hull of these points, for certain?
    pub(crate) fn misses_all(&self, points: &[DVec3]) -> bool {
        let below =
            |plane: &Plane| points.iter().all(|&v| plane.height(v) <= self.margin);
        self.planes.iter().any(below)
    }

    fn misses_box(&self, low: DVec3, high: DVec3) -> bool {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let top = |p: &Plane| p.height(middle) + p.normal.abs().dot(half);
        self.planes.iter().any(|p| top(p) <= self.margin)
    }
}

/// The plane through the edge `a b` and the corner `c`, if both polygons are on one side.
fn side(a: DVec3, b: DVec3, c: DVec3, i: &Polygon, j: &Polygon) -> Option<Plane> {
    let across = (b - a).cross(c - a);
    let (length, size) = (across.length(), a.distance(c).max(a.distance(b)));
    if length <= 1e-12 * size * size {
        return None;
    }
    // Through the point that has the smaller coordinates: a lamp may be far away.
    let near = if c.length_squared() < a.length_squared() { c } else { a };
    let plane = Plane::through(near, across / length);
    let rounding = 1e-12 * size;
    let (mut above, mut below) = (false, false);
    for &v in i.vertices().iter().chain(j.vertices()) {
        let h = plane.height(v);
        above |= h > rounding;
        below |= h < -rounding;
        if above && below {
            return None;
        }
    }
    Some(if below { plane.flipped() } else { plane })
}
