//! The convex planar polygon, checked on construction.

use super::Plane;
use glam::{DAffine3, DVec3};
use smallvec::SmallVec;
use std::fmt;

/// How far a vertex may lie off the plane, relative to the polygon's diameter.
///
/// Six decimals are what OBJ exporters write; a rectangle rounded so still counts as flat.
const FLAT: f64 = 2e-6;

/// Beyond these, the square of an area is no ordinary number any more.
const AREAS: std::ops::Range<f64> = 1e-150..1e150;

/// A convex planar polygon; its front is where its vertices run counter-clockwise.
///
/// Checked once by [`Polygon::new`]; whatever holds a `Polygon` may rely on three or
/// more finite vertices, a positive area, a unit normal, and convexity.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    vertices: Vec<DVec3>,
    normal: DVec3,
    /// Of its plane, in scene units.
    offset: f64,
    area: f64,
}

/// Why some vertices are no [`Polygon`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PolygonError {
    /// Fewer than three vertices are left once repeated ones are dropped.
    TooFewVertices(usize),
    /// More corners than [`super::split`] takes.
    TooManyVertices(usize),
    /// The coordinate of vertex `index` is NaN or infinite.
    NotFinite {
        /// Which vertex, from 0.
        index: usize,
    },
    /// The vertices span no area, or one outside of `1e-150..1e150`.
    ZeroArea,
    /// A vertex lies this far off the plane, in scene units.
    NotPlanar(f64),
    /// A corner turns the wrong way, or the outline runs round twice.
    NotConvex,
    /// Two edges cross.
    SelfIntersecting,
}

impl fmt::Display for PolygonError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            PolygonError::TooFewVertices(n) => {
                write!(f, "has {n} distinct vertices; a face needs at least 3")
            }
            PolygonError::TooManyVertices(n) => {
                let most = super::MAX_CORNERS;
                write!(f, "has {n} corners; at most {most} are handled: divide it")
            }
            PolygonError::NotFinite { index } => {
                write!(f, "has a coordinate that is not finite, at its vertex {index}")
            }
            PolygonError::ZeroArea => write!(f, "has no area; remove it"),
            PolygonError::NotPlanar(off) => {
                write!(
                    f,
                    "is not planar: a vertex lies {off:.3e} off its plane; split it"
                )
            }
            PolygonError::NotConvex => write!(f, "is not convex; split it"),
            PolygonError::SelfIntersecting => {
                write!(f, "crosses or touches itself; reorder its vertices")
            }
        }
    }
}

impl std::error::Error for PolygonError {}

impl Polygon {
    /// Checks `vertices` (counter-clockwise seen from the front) and makes a polygon.
    ///
    /// # Errors
    /// As [`PolygonError`] says. Non-planar and non-convex outlines that may be repaired
    /// go through [`super::split`].
    pub fn new(vertices: Vec<DVec3>) -> Result<Polygon, PolygonError> {
        if let Some(index) = vertices.iter().position(|v| !v.is_finite()) {
            return Err(PolygonError::NotFinite { index });
        }
        let vertices = without_repeats(vertices);
        if vertices.len() < 3 {
            return Err(PolygonError::TooFewVertices(vertices.len()));
        }
        let size = diameter(&vertices);
        let area_normal = newell(&vertices);
        let area = area_normal.length();
        if !AREAS.contains(&area) || area <= 1e-14 * size * size {
            return Err(PolygonError::ZeroArea);
        }
        let normal = area_normal / area;
        let plane = Plane::through(mean(&vertices), normal);
        let off = vertices.iter().map(|&v| plane.height(v).abs()).fold(0.0, f64::max);
        if off > FLAT * size {
            return Err(PolygonError::NotPlanar(off));
        }
        let polygon = Polygon { vertices, normal, offset: plane.offset, area };
        if polygon.is_convex() { Ok(polygon) } else { Err(PolygonError::NotConvex) }
    }

    /// A polygon from vertices that are known to be fit: pieces cut from a polygon.
    ///
    /// `None` when nothing of any area is left.
    pub(crate) fn piece(vertices: Vec<DVec3>, normal: DVec3) -> Option<Polygon> {
        let vertices = without_repeats(vertices);
        if vertices.len() < 3 {
            return None;
        }
        let area = newell(&vertices).dot(normal);
        let size = diameter(&vertices);
        let offset = normal.dot(mean(&vertices));
        (area > 1e-14 * size * size).then_some(Polygon {
            vertices,
            normal,
            offset,
            area,
        })
    }

    /// The corners, counter-clockwise seen from the front, in scene units.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// The edges, each as its two ends in order.
    pub fn edges(&self) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {
        let n = self.vertices.len();
        (0..n).map(move |k| (self.vertices[k], self.vertices[(k + 1) % n]))
    }

    /// Unit normal, on the front side.
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Area of one side, in scene units squared; positive.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The plane it lies in, front as the polygon's.
    pub fn plane(&self) -> Plane {
        Plane { normal: self.normal, offset: self.offset }
    }

    /// Centre of mass.
    pub fn centroid(&self) -> DVec3 {
        let a = self.vertices[0];
        let mut moment = DVec3::ZERO;
        let mut sum = 0.0;
        for k in 1..self.vertices.len() - 1 {
            let (b, c) = (self.vertices[k], self.vertices[k + 1]);
            let twice = (b - a).cross(c - a).dot(self.normal);
            moment += twice * ((b - a) + (c - a)) / 3.0;
            sum += twice;
        }
        a + moment / sum
    }

    /// The largest distance between two corners, in scene units.
    pub fn diameter(&self) -> f64 {
        diameter(&self.vertices)
    }

    /// The same outline with front and back exchanged.
    pub fn flipped(&self) -> Polygon {
        let mut vertices = self.vertices.clone();
        vertices.reverse();
        Polygon {
            vertices,
            normal: -self.normal,
            offset: -self.offset,
            area: self.area,
        }
    }

    /// Its image under an isometry: what was in front of it is in front of the image, also
    /// where the isometry turns left into right.
    pub fn moved(&self, by: &DAffine3) -> Polygon {
        let mut vertices: Vec<DVec3> =
            self.vertices.iter().map(|&v| by.transform_point3(v)).collect();
        if by.matrix3.determinant() < 0.0 {
            vertices.reverse();
        }
        let normal = by.transform_vector3(self.normal).normalize();
        let offset = normal.dot(mean(&vertices));
        Polygon { vertices, normal, offset, area: self.area }
    }

    /// What of the polygon lies in front of `plane`; `None` when nothing does.
    pub fn clipped(&self, plane: Plane) -> Option<Polygon> {
        Polygon::piece(clip(&self.vertices, plane).to_vec(), self.normal)
    }

    /// The two pieces on either side of a cut through the centroid, across the longest
    /// edge.
    pub fn halves(&self) -> impl Iterator<Item = Polygon> + use<> {
        let longer = |e: (DVec3, DVec3), f: (DVec3, DVec3)| {
            if f.0.distance_squared(f.1) > e.0.distance_squared(e.1) { f } else { e }
        };
        let (a, b) = self.edges().reduce(longer).unwrap_or((DVec3::ZERO, DVec3::X));
        let across = Plane::through(self.centroid(), (b - a).normalize());
        [self.clipped(across), self.clipped(across.flipped())].into_iter().flatten()
    }

    /// The four parts of a triangle or quadrilateral, between the middles of its edges; of
    /// other outlines, one part for each corner.
    pub fn quarters(&self) -> Vec<Polygon> {
        let v = self.vertices();
        let n = v.len();
        let middle = |k: usize| v[k % n].midpoint(v[(k + 1) % n]);
        let centre = match v {
            &[a, b, c, d] => a.midpoint(c).midpoint(b.midpoint(d)),
            _ => self.centroid(),
        };
        let parts: Vec<_> = if n == 3 {
            let corner = |k| vec![v[k], middle(k), middle(k + 2)];
            (0..3).map(corner).chain([vec![middle(0), middle(1), middle(2)]]).collect()
        } else {
            (0..n).map(|k| vec![middle(k + n - 1), v[k], middle(k), centre]).collect()
        };
        let piece = |part| Polygon::piece(part, self.normal);
        parts.into_iter().filter_map(piece).collect()
    }

    /// The polygon less what `hole` (in the same plane) covers, as convex pieces.
    pub fn without(&self, hole: &Polygon) -> Vec<Polygon> {
        let mut pieces = Vec::new();
        let mut rest = Some(self.clone());
        for (a, b) in hole.edges() {
            let Some(inside) = rest else { break };
            let across = hole.normal.cross(b - a).normalize();
            let edge = Plane::through(a, across);
            pieces.extend(inside.clipped(edge.flipped()));
            rest = inside.clipped(edge);
        }
        pieces
    }

    /// Does the point `p` of the polygon's plane lie inside, or within `margin` outside?
    pub fn contains(&self, p: DVec3, margin: f64) -> bool {
        self.edges().all(|(a, b)| {
            let across = self.normal.cross(b - a);
            across.dot(p - a) >= -margin * across.length()
        })
    }

    /// How far the point `p` of the polygon's plane lies outside; 0 inside.
    pub fn distance_outside(&self, p: DVec3) -> f64 {
        let beyond = |(a, b): (DVec3, DVec3)| {
            (b - a).cross(self.normal).normalize_or_zero().dot(p - a)
        };
        self.edges().map(beyond).fold(0.0, f64::max)
    }

    /// The point at `(u, v)` of the unit square; uniform points give points uniform in area.
    pub fn point_at(&self, [u, v]: [f64; 2]) -> DVec3 {
        let a = self.vertices[0];
        let mut rest = u * self.area;
        let last = self.vertices.len() - 2;
        for k in 1..=last {
            let (b, c) = (self.vertices[k], self.vertices[k + 1]);
            let area = 0.5 * (b - a).cross(c - a).dot(self.normal);
            if rest < area || k == last {
                let along = (rest / area).clamp(0.0, 1.0).sqrt();
                return a + along * (b.lerp(c, v) - a);
            }
            rest -= area;
        }
        unreachable!("a polygon has three or more corners")
    }

    fn is_convex(&self) -> bool {
        let n = self.vertices.len();
        let direction = |k: usize| {
            (self.vertices[(k + 1) % n] - self.vertices[k]).normalize_or_zero()
        };
        let mut turned = 0.0;
        for k in 0..n {
            let (a, b) = (direction(k), direction((k + 1) % n));
            let sine = a.cross(b).dot(self.normal);
            if sine < -1e-7 {
                return false;
            }
            turned += sine.atan2(a.dot(b));
        }
        turned < 1.5 * std::f64::consts::TAU // one turn, not two
    }
}

/// The corners of a convex planar outline that need not be checked: what clipping leaves.
pub type Outline = SmallVec<[DVec3; 8]>;

/// Cuts `vertices` by `plane` and keeps the front (Sutherland & Hodgman 1974).
///
/// A vertex on the plane is kept. Returns an empty list when all lies behind.
pub fn clip(vertices: &[DVec3], plane: Plane) -> Outline {
    let mut kept = Outline::new();
    clip_into(vertices, plane, &mut kept);
    kept
}

/// [`clip`] into an outline that is there already; what it held is dropped.
pub fn clip_into(vertices: &[DVec3], plane: Plane, kept: &mut Outline) {
    kept.clear();
    let Some(&last) = vertices.last() else { return };
    let (mut a, mut ha) = (last, plane.height(last));
    for &b in vertices {
        let hb = plane.height(b);
        if (ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0) {
            // From the lower end up, so that both neighbours of a shared edge
            // compute the very same point.
            let (low, high, hl, hh) =
                if ha < hb { (a, b, ha, hb) } else { (b, a, hb, ha) };
            kept.push(low + (high - low) * (hl / (hl - hh)));
        }
        if hb >= 0.0 {
            kept.push(b);
        }
        (a, ha) = (b, hb);
    }
}

/// Area times normal of an outline, `½ Σ vₖ × vₖ₊₁`, taken about the first vertex.
pub(crate) fn newell(vertices: &[DVec3]) -> DVec3 {
    let a = vertices[0];
    let fan = |k: usize| (vertices[k] - a).cross(vertices[k + 1] - a);
    0.5 * (1..vertices.len() - 1).map(fan).sum::<DVec3>()
}

/// Mean of the corners.
pub(crate) fn mean(vertices: &[DVec3]) -> DVec3 {
    vertices.iter().sum::<DVec3>() / vertices.len() as f64
}

/// The largest distance between two corners.
pub(crate) fn diameter(vertices: &[DVec3]) -> f64 {
    let pairs = vertices.iter().enumerate().flat_map(|(k, a)| {
        vertices[k + 1..].iter().map(move |b| a.distance_squared(*b))
    });
    pairs.fold(0.0, f64::max).sqrt()
}

/// Drops a vertex that repeats the one before it, to within rounding.
pub(crate) fn without_repeats(mut vertices: Vec<DVec3>) -> Vec<DVec3> {
    if vertices.len() < 2 {
        return vertices;
    }
    let near =
        1e-14 * vertices.iter().map(|v| v.abs().max_element()).fold(0.0, f64::max);
    vertices.dedup_by(|b, a| a.distance(*b) <= near);
    while vertices.len() > 1 && vertices[0].distance(*vertices.last().unwrap()) <= near
    {
        vertices.pop();
    }
    vertices
}
