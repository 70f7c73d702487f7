//! What may stand between two polygons: blockers, walls and shafts.
//!
//! A blocker outside the **shaft** of two polygons, their convex hull, hides nothing of one
//! from the other. A surface that has the whole scene on one side never blocks. And the
//! tiles of a wall block as one: so most pairs of a room need no visibility at all, however
//! finely it is tiled. The faces of a convex solid block as one, too.
//!
//! Sources: Haines & Wallace 1991 (shaft culling); Andrew 1979 (convex hulls).

use super::blocker::Blocker;
use super::shaft::Shaft;
use super::tiles::{convex_hull, in_plane, joined};
use crate::geometry::{Polygon, bounds};
use crate::scene::Scene;
use crate::visibility::Visibility;
use glam::DVec3;
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
#[derive(Debug)]
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
    /// Those of a scene; light goes through panes.
    pub fn of(scene: &Scene) -> Blockers {
        Blockers::but_for(scene, |k| {
            scene.material(&scene.surfaces[k]).shine().pane().is_some()
        })
    }

    /// The same, and panes stop light as all else does.
    pub fn with_panes(scene: &Scene) -> Blockers {
        Blockers::but_for(scene, |_| false)
    }

    /// Those of a scene but for surfaces that let light pass.
    fn but_for(scene: &Scene, passes: impl Fn(usize) -> bool) -> Blockers {
        let margin = scene.rounding();
        let surfaces: Vec<&Polygon> =
            scene.surfaces.iter().map(|s| &s.polygon).collect();
        // No wall has any of these, and none of them blocks.
        let in_plane = |k: usize| in_plane(surfaces[k], margin, i64::from(passes(k)));
        let (wall_of, tiles) = joined(&surfaces, margin, in_plane);
        let walls: Vec<Polygon> =
            tiles.iter().map(|t| convex_hull(t, &surfaces)).collect();
        let blocks = |wall: &Polygon| {
            let heights = || {
                let corners = walls.iter().flat_map(|w| w.vertices());
                corners.map(|&v| wall.plane().height(v))
            };
            heights().any(|h| h > margin) && heights().any(|h| h < -margin)
        };
        let (mut between, mut opaque) = (Vec::new(), Vec::new());
        for (wall, tiles) in walls.iter().zip(&tiles).filter(|(_, t)| !passes(t[0])) {
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
