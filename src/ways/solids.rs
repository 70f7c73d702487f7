//! The solids of a scene: which faces of glass belong together.

use crate::geometry::{Polygon, Ray, bounds, split};
use crate::radiometry::solid_angle_triangle;
use crate::scene::{Face, FaceId, Scene};
use crate::visibility::Visibility;
use glam::DVec3;
use smallvec::SmallVec;
use std::collections::HashMap;
use std::f64::consts::PI;

/// The solids of glass of a scene, in the order of their first faces.
///
/// Faces of one index that share corners are a solid. Where each edge of it is, the other
/// way round, an edge of it again, it is *closed*, and has an inside. A closed one whose
/// normals lead inwards is a hollow in the last solid about it of the same index. All other
/// faces of one index together are an *open* solid: it bends rays, but nobody can tell
/// where it ends.
#[derive(Clone, Debug, Default)]
pub struct Solids {
    all: Vec<Solid>,
    /// The solid of each face of the scene; none for those of other materials.
    of_face: Vec<Option<u32>>,
    walls: Vec<Wall>,
    /// Of each face of a solid: the walls of others in its plane, whose boxes it meets, and
    /// whether they look the same way.
    touching: Vec<Vec<(u32, bool)>>,
    /// The walls, as rays meet them.
    rays: Visibility,
    /// What lies in one plane to within this does, in scene units.
    margin: f64,
}

#[derive(Clone, Debug)]
struct Solid {
    index: f64,
    closed: bool,
    low: DVec3,
    high: DVec3,
}

/// A convex piece of a face of a solid, nothing cut out of it.
#[derive(Clone, Debug)]
struct Wall {
    face: u32,
    polygon: Polygon,
}

impl Solids {
    /// Those of a scene.
    pub fn of(scene: &Scene) -> Solids {
        let index = |face: &Face| {
            scene.materials[face.material.0 as usize].shine().index_of_solid()
        };
        let glass = scene.faces.iter().enumerate();
        let glass: Vec<(usize, f64)> =
            glass.filter_map(|(k, face)| Some((k, index(face)?))).collect();
        if glass.is_empty() {
            return Solids::default();
        }
        let pieces = |&(k, _): &(usize, f64)| {
            let polygons = split(&scene.faces[k].outline).unwrap_or_default();
            polygons.into_iter().map(move |polygon| Wall { face: k as u32, polygon })
        };
        let walls: Vec<Wall> = glass.iter().flat_map(pieces).collect();
        let mut solids = Solids {
            all: vec![],
            of_face: vec![None; scene.faces.len()],
            touching: vec![vec![]; scene.faces.len()],
            rays: Visibility::new(walls.iter().map(|w| &w.polygon)),
            walls,
            margin: scene.rounding(),
        };
        for (index, closed, faces) in joined(&scene.faces, components(scene, &glass)) {
            let corners = faces.iter().flat_map(|&k| scene.faces[k].outline.clone());
            let (low, high) = bounds(corners);
            for face in faces {
                solids.of_face[face] = Some(solids.all.len() as u32);
            }
            solids.all.push(Solid { index, closed, low, high });
        }
        solids.find_touching();
        solids
    }

    /// Are there none?
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// The solid that a face bounds.
    pub fn of_face(&self, face: FaceId) -> Option<u32> {
        self.of_face.get(face.0 as usize).copied().flatten()
    }

    pub(super) fn index_of(&self, solid: u32) -> f64 {
        self.all[solid as usize].index
    }

    /// Has it an inside?
    pub fn is_closed(&self, solid: u32) -> bool {
        self.all[solid as usize].closed
    }

    /// The closed solids whose boxes hold `x`.
    pub(super) fn near(&self, x: DVec3) -> impl Iterator<Item = u32> {
        let holds =
            move |s: &Solid| s.closed && x.cmpge(s.low).all() && x.cmple(s.high).all();
        (0u32..).zip(&self.all).filter(move |(_, s)| holds(s)).map(|(k, _)| k)
    }

    /// The solids that are entered (or else left) where a ray meets a face at `x`: that of
    /// the face, and all that touch it there.
    pub(super) fn faces_at(
        &self,
        face: FaceId,
        entering: bool,
        x: DVec3,
    ) -> SmallVec<[(u32, bool); 2]> {
        let own = self.of_face(face).map(|solid| (solid, entering));
        let mut all: SmallVec<[(u32, bool); 2]> = own.into_iter().collect();
        let touching = self.touching.get(face.0 as usize).into_iter().flatten();
        for &(wall, alike) in touching {
            let wall = &self.walls[wall as usize];
            let Some(solid) = self.of_face(FaceId(wall.face)) else { continue };
            let other = (solid, alike == entering);
            if !all.contains(&other) && wall.polygon.contains(x, self.margin) {
                all.push(other);
            }
        }
        all
    }

    /// Calls `crossed` for each solid that a ray enters (or else leaves) on its way straight
    /// on through everything.
    pub(super) fn along(&self, ray: &Ray, mut crossed: impl FnMut(u32, bool)) {
        let (mut ray, mut leaving) = (*ray, None);
        while let Some(hit) = self.rays.closest(&ray, leaving) {
            ray.origin += hit.distance * ray.direction;
            leaving = Some(hit.item);
            let face = FaceId(self.walls[hit.item as usize].face);
            for (solid, entering) in self.faces_at(face, hit.front, ray.origin) {
                crossed(solid, entering);
            }
        }
    }

    /// Finds which walls lie in the plane of each face.
    fn find_touching(&mut self) {
        for wall in &self.walls {
            let (low, high) = bounds(wall.polygon.vertices().iter().copied());
            let (low, high) = (low - self.margin, high + self.margin);
            let apart =
                |lo: DVec3, hi: DVec3| lo.cmpgt(high).any() || hi.cmplt(low).any();
            let mut found = Vec::new();
            self.rays.visit(apart, |k| {
                let other = &self.walls[k as usize];
                let alike = self.in_one_plane(wall, other);
                found.extend(alike.map(|alike| (k, alike)));
            });
            let of_face = &mut self.touching[wall.face as usize];
            of_face.extend(found);
            of_face.sort_unstable();
            of_face.dedup();
        }
    }

    /// Do two walls of different faces that lie in one plane look the same way? `None` if
    /// they do not lie in one, or are neighbours in the skin of one solid.
    fn in_one_plane(&self, a: &Wall, b: &Wall) -> Option<bool> {
        let off = |a: &Polygon, b: &Polygon| {
            let heights = b.vertices().iter().map(|&v| a.plane().height(v).abs());
            heights.fold(0.0, f64::max) > self.margin
        };
        let cosine = a.polygon.normal().dot(b.polygon.normal());
        let solid = |wall: &Wall| self.of_face[wall.face as usize];
        let skin = a.face == b.face || solid(a) == solid(b) && cosine > 0.0;
        let apart = off(&a.polygon, &b.polygon) && off(&b.polygon, &a.polygon);
        (!skin && !apart && cosine.abs() > 0.999).then_some(cosine > 0.0)
    }

    /// Does `x` lie in a plane through `y`, to within rounding?
    pub(super) fn in_plane(&self, normal: DVec3, x: DVec3, y: DVec3) -> bool {
        normal.dot(x - y).abs() <= self.margin
    }
}

/// Faces of one index that hang together, in order.
struct Component {
    index: f64,
    faces: Vec<usize>,
    /// Do their edges cancel?
    closed: bool,
}

fn bits(corner: DVec3) -> [u64; 3] {
    (corner + 0.0).to_array().map(f64::to_bits) // −0 is 0
}

fn edges(face: &Face) -> impl Iterator<Item = (DVec3, DVec3)> {
    let next = face.outline.iter().cycle().skip(1);
    face.outline.iter().copied().zip(next.copied())
}

/// The components of faces that share corners and have the same index, in the order of
/// their first faces.
fn components(scene: &Scene, glass: &[(usize, f64)]) -> Vec<Component> {
    // Each face points to an earlier one of its component, or to itself.
    let mut earlier: Vec<usize> = (0..glass.len()).collect();
    fn first(earlier: &mut [usize], mut k: usize) -> usize {
        while earlier[k] != k {
            earlier[k] = earlier[earlier[k]];
            k = earlier[k];
        }
        k
    }
    let mut at: HashMap<([u64; 3], u64), usize> = HashMap::new();
    for (k, &(face, index)) in glass.iter().enumerate() {
        for &corner in &scene.faces[face].outline {
            let other = *at.entry((bits(corner), index.to_bits())).or_insert(k);
            let (a, b) = (first(&mut earlier, other), first(&mut earlier, k));
            earlier[a.max(b)] = a.min(b);
        }
    }
    let mut all: Vec<Component> = Vec::new();
    let mut place: HashMap<usize, usize> = HashMap::new();
    for (k, &(face, index)) in glass.iter().enumerate() {
        let at = *place.entry(first(&mut earlier, k)).or_insert(all.len());
        if at == all.len() {
            all.push(Component { index, faces: vec![], closed: false });
        }
        all[at].faces.push(face);
    }
    for component in &mut all {
        component.closed = is_closed(&scene.faces, &component.faces);
    }
    all
}

/// Is each edge, the other way round, an edge again?
fn is_closed(faces: &[Face], of: &[usize]) -> bool {
    let mut count: HashMap<[[u64; 3]; 2], i32> = HashMap::new();
    for (a, b) in of.iter().flat_map(|&k| edges(&faces[k])) {
        *count.entry([bits(a), bits(b)]).or_default() += 1;
        *count.entry([bits(b), bits(a)]).or_default() -= 1;
    }
    count.values().all(|&n| n == 0)
}

/// How often faces wind about `x`: 1 inside of a closed solid whose normals lead outwards.
fn winding(faces: &[Face], of: &[usize], x: DVec3) -> f64 {
    let of_face = |&k: &usize| {
        let apex = faces[k].outline[0] - x;
        let of_edge = |(a, b)| solid_angle_triangle(apex, a - x, b - x);
        edges(&faces[k]).map(of_edge).sum::<f64>()
    };
    -of.iter().map(of_face).sum::<f64>() / (4.0 * PI)
}

/// Six times the volume that faces bound; negative when they look inwards.
fn volume(faces: &[Face], of: &[usize]) -> f64 {
    let start = faces[of[0]].outline[0];
    let of_face = |&k: &usize| {
        let apex = faces[k].outline[0] - start;
        edges(&faces[k])
            .map(|(a, b)| apex.dot((a - start).cross(b - start)))
            .sum::<f64>()
    };
    of.iter().map(of_face).sum()
}

/// Solids of components: index, closed?, faces.
fn joined(faces: &[Face], components: Vec<Component>) -> Vec<(f64, bool, Vec<usize>)> {
    let outwards = |c: &Component| c.closed && volume(faces, &c.faces) > 0.0;
    let (mut solids, others): (Vec<Component>, Vec<Component>) =
        components.into_iter().partition(outwards);
    let closed = solids.len();
    let skins: Vec<Vec<usize>> = solids.iter().map(|s| s.faces.clone()).collect();
    for Component { index, faces: own, closed: hollow } in others {
        let x = faces[own[0]].outline[0];
        let about = |k: &usize| {
            solids[*k].index == index && winding(faces, &skins[*k], x) > 0.5
        };
        let host = (0..closed).rev().filter(|_| hollow).find(about);
        let open = || (closed..solids.len()).find(|&k| solids[k].index == index);
        match host.or_else(open) {
            Some(k) => solids[k].faces.extend(own),
            None => solids.push(Component { index, faces: own, closed: false }),
        }
    }
    solids.sort_by_key(|s| s.faces.iter().min().copied());
    solids.into_iter().map(|s| (s.index, s.closed, s.faces)).collect()
}
