//! Form factors of patches whose light changes linearly across them.
//!
//! ```text
//! B(s, t) = b₀ + b₁ s + b₂ t + b₃ s t          on a patch, s and t from its middle
//! H(x) = Σ_patches Σ_k b_k m_k                 m = (Σ ΔF, Σ ΔF s, Σ ΔF t, Σ ΔF s t)
//! ```
//! A hemicube at `x` knows not only how much of a patch it sees, but also where. With these
//! four *moments* instead of one factor, a patch next to the point need not be constant:
//! its bright end lights the corner, its dark end does not. A patch that is nearer than
//! its own size is drawn element by element, since there its shadow edges show.
//!
//! Sources: Max & Allison 1992 (linear radiosity by vertex hemicubes).

use super::Lost;
use super::hemicube::{Face, Weights};
use super::painter::Painter;
use crate::geometry::{Frame, Polygon, Rgb};
use crate::mesh::Mesh;
use crate::raster::{ItemBuffer, Seen, View};
use glam::{DMat4, DVec3, DVec4, dvec4};
use std::ops::Range;

/// Light that is linear across a piece: the coefficients of `1, s, t, s t`, W/m².
pub type Slopes = [Rgb; 4];

/// The moments of a piece, as a point sees it.
pub type Moments = [f64; 4];

// ANCHOR: sent
/// `Σ_k b_k m_k`, W/m².
pub fn sent(b: &Slopes, m: &Moments) -> Rgb {
    m[0] * b[0] + m[1] * b[1] + m[2] * b[2] + m[3] * b[3]
}
// ANCHOR_END: sent

/// What a point sees: how much of each patch, and where.
#[derive(Clone, Debug, Default)]
pub struct Sight {
    /// Each patch that is seen, with its moments.
    pub patches: Vec<(u32, Moments)>,
    /// The patches among them (by their place in the list) that were drawn whole.
    pub whole: Vec<u32>,
    /// The elements of all others, with their moments.
    pub elements: Vec<(u32, Moments)>,
    /// Where rays go on: unit directions, and what each cell counts.
    pub onwards: Vec<(DVec3, f64)>,
    /// Where the sky is seen.
    pub sky: Vec<(DVec3, f64)>,
    /// The shares that reach no front.
    pub lost: Lost,
}

/// A patch is near when its middle is closer than this many of its diameters.
const NEAR: f64 = 1.5;

/// Hemicubes that see where on a patch they look.
pub struct Linear<'m> {
    patches: &'m Mesh,
    elements: &'m Mesh,
    painter: Painter<'m>,
    resolution: u32,
    weights: Weights,
    of_patches: Vec<Chart>,
    of_elements: Vec<Chart>,
    diameters: Vec<f64>,
    /// Where rays go on, by patch.
    onwards: Onwards,
}

/// What of a hemicube is not at its end where it is drawn.
#[derive(Clone, Debug, Default)]
pub struct Onwards {
    /// Patches whose fronts shine: they are drawn, and their cells told.
    pub fronts: Vec<bool>,
    /// Patches that light goes through from behind.
    pub backs: Vec<bool>,
    /// Is there light where nothing is?
    pub sky: bool,
}

impl<'m> Linear<'m> {
    /// Hemicubes of this resolution. The elements of `patches` are the patches of
    /// `elements`, in the same order.
    ///
    /// # Panics
    /// As [`super::hemicube::Hemicube::new`], and when the meshes do not match.
    pub fn new(patches: &'m Mesh, elements: &'m Mesh, resolution: u32) -> Linear<'m> {
        assert_eq!(patches.elements.len(), elements.patches.len(), "other patches");
        Linear {
            patches,
            elements,
            painter: Painter::new(patches),
            resolution,
            weights: Weights::exact(resolution),
            of_patches: patches.polygons().map(Chart::of).collect(),
            of_elements: elements.polygons().map(Chart::of).collect(),
            diameters: patches.polygons().map(Polygon::diameter).collect(),
            onwards: Onwards::default(),
        }
    }

    /// The same, telling where rays go on ([`Sight::onwards`]).
    pub fn telling(self, onwards: Onwards) -> Linear<'m> {
        Linear { onwards, ..self }
    }

    /// Does the ray through a cell that shows this go on?
    fn goes_on(&self, seen: Seen) -> bool {
        let patch =
            |id: u32| match (id as usize).checked_sub(self.patches.elements.len()) {
                None => id as usize,
                Some(e) => self.elements.elements[e].patch.0 as usize,
            };
        let marked = |of: &[bool], id| of.get(patch(id)).is_some_and(|&m| m);
        match seen {
            Seen::Nothing => self.onwards.sky,
            Seen::Front(id) => marked(&self.onwards.fronts, id),
            Seen::Back(id) => marked(&self.onwards.backs, id),
        }
    }

    /// What a point with this unit normal sees.
    pub fn seen_from(&self, point: DVec3, normal: DVec3) -> Sight {
        let patches = self.patches.elements.len();
        let near = |k: usize| {
            let middle = self.of_patches[k].middle;
            point.distance_squared(middle) < (NEAR * self.diameters[k]).powi(2)
        };
        // Patches have their own ids, the elements of near ones follow.
        let mut ids: Vec<(u32, &Polygon)> = Vec::with_capacity(patches);
        for (k, patch) in self.patches.elements.iter().enumerate() {
            let elements = &self.elements.patches[k].elements;
            if elements.len() > 1 && near(k) {
                let part = |e: u32| {
                    (patches as u32 + e, &self.elements.elements[e as usize].polygon)
                };
                ids.extend(elements.clone().map(part));
            } else {
                ids.push((k as u32, &patch.polygon));
            }
        }
        let mut of_patches = vec![[0.0; 4]; patches];
        let mut of_elements: Vec<(u32, Moments)> = Vec::new();
        let (mut onwards, mut sky) = (Vec::new(), Vec::new());
        let mut lost = Lost::default();
        let frame = Frame::about(normal);
        self.painter.with_buffer(|buffer| {
            for face in Face::ALL {
                let (width, height) = face.size(self.resolution);
                let view = face.view(point, &frame);
                buffer.reset(width, height);
                ids.iter().for_each(|&(id, polygon)| buffer.draw(&view, polygon, id));
                let weights = self.weights.of(face);
                for (seen, first, end) in buffer.runs() {
                    let goes_on = self.goes_on(seen);
                    if goes_on {
                        let into = match seen {
                            Seen::Nothing => &mut sky,
                            _ => &mut onwards,
                        };
                        into.extend((first..end).map(|cell| {
                            let (x, y) = (cell as u32 % width, cell as u32 / width);
                            let at = View::pixel_centre(x, y, width, height);
                            (view.direction(at).normalize(), weights[cell])
                        }));
                    }
                    let share = || weights[first..end].iter().sum::<f64>();
                    let id = match seen {
                        Seen::Nothing | Seen::Back(_) if goes_on => continue,
                        Seen::Nothing => {
                            lost.escaped += share();
                            continue;
                        }
                        Seen::Back(_) => {
                            lost.absorbed += share();
                            continue;
                        }
                        Seen::Front(id) => id as usize,
                    };
                    let found = |chart, polygon| {
                        Found::new(&view, polygon, chart).moments(
                            buffer,
                            weights,
                            first..end,
                        )
                    };
                    let patch = match id.checked_sub(patches) {
                        None => id,
                        Some(e) => {
                            let element = &self.elements.elements[e];
                            let m = found(&self.of_elements[e], &element.polygon);
                            of_elements.push((e as u32, m));
                            element.patch.0 as usize
                        }
                    };
                    let polygon = &self.patches.elements[patch].polygon;
                    add(
                        &mut of_patches[patch],
                        found(&self.of_patches[patch], polygon),
                    );
                }
            }
        });
        of_elements.sort_unstable_by_key(|e| e.0);
        of_elements.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                add(&mut kept.1, next.1);
            }
            same
        });
        let seen = (0u32..).zip(of_patches).filter(|(_, m)| m[0] != 0.0);
        let seen: Vec<(u32, Moments)> = seen.collect();
        let is_whole =
            |k: usize| self.elements.patches[k].elements.len() <= 1 || !near(k);
        let whole = (0u32..).zip(&seen).filter(|(_, (k, _))| is_whole(*k as usize));
        let whole = whole.map(|(place, _)| place).collect();
        Sight { patches: seen, whole, elements: of_elements, onwards, sky, lost }
    }

    /// The light of patch `k` that has these values at its corners.
    pub fn of_patch(&self, k: usize, of_vertices: &[Rgb]) -> Slopes {
        let corners = &self.patches.elements[k].corners;
        self.of_patches[k].slopes(corners.iter().map(|c| of_vertices[c.0 as usize]))
    }

    /// The moments of a ray that meets patch `k` at `p`.
    pub fn moments_at(&self, k: usize, p: DVec3) -> Moments {
        let (s, t) = self.of_patches[k].place(p);
        [1.0, s, t, s * t]
    }

    /// The light of element `k` that has these values at its corners.
    pub fn of_element(&self, k: usize, of_vertices: &[Rgb]) -> Slopes {
        let corners = &self.elements.elements[k].corners;
        self.of_elements[k].slopes(corners.iter().map(|c| of_vertices[c.0 as usize]))
    }

    /// The mean over patch `k` of light with these slopes.
    pub fn mean(&self, k: usize, b: &Slopes) -> Rgb {
        b[0] + self.of_patches[k].mean_product * b[3]
    }
}

fn add(sum: &mut Moments, m: Moments) {
    sum.iter_mut().zip(m).for_each(|(sum, m)| *sum += m);
}

/// Coordinates `s`, `t` on a patch, from −1 to 1 on a parallelogram.
struct Chart {
    middle: DVec3,
    along: DVec3,
    across: DVec3,
    /// For each corner, what its value adds to the four coefficients.
    fit: Vec<DVec4>,
    /// The mean of `s t` over the patch; those of `s` and `t` are 0.
    mean_product: f64,
}

impl Chart {
    fn place(&self, p: DVec3) -> (f64, f64) {
        let from_middle = p - self.middle;
        (self.along.dot(from_middle), self.across.dot(from_middle))
    }

    fn of(polygon: &Polygon) -> Chart {
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
        Chart {
            middle,
            along,
            across,
            fit: v.iter().map(|&corner| fit(corner)).collect(),
            mean_product: triangles.map(product).sum::<f64>() / polygon.area(),
        }
    }
}

impl Chart {
    fn slopes(&self, of_corners: impl Iterator<Item = Rgb>) -> Slopes {
        let mut b = [Rgb::ZERO; 4];
        for (value, weights) in of_corners.zip(&self.fit) {
            for (b, weight) in b.iter_mut().zip(weights.to_array()) {
                *b += weight * value;
            }
        }
        b
    }
}

/// A patch as it stands in a picture: `s = s₀ + α·(x, y, 1)/η·(x, y, 1)`.
struct Found {
    s: (f64, DVec3),
    t: (f64, DVec3),
    nearness: DVec3,
}

impl Found {
    fn new(view: &View, polygon: &Polygon, chart: &Chart) -> Found {
        let from_middle = view.eye() - chart.middle;
        let of = |axis: DVec3| (axis.dot(from_middle), view.plane_from_world(axis));
        let height = polygon.plane().height(view.eye());
        let nearness = -view.plane_from_world(polygon.normal()) / height;
        Found { s: of(chart.along), t: of(chart.across), nearness }
    }

    /// The moments of the cells `run`.
    fn moments(
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
