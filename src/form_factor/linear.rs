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
use super::coordinates::{InView, PatchCoordinates};
use super::hemicube::{CubeFace, Weights};
use super::painter::Painter;
use crate::geometry::{Frame, Polygon, Rgb};
use crate::mesh::{Element, ElementId, PatchId, TwoLevels};
use crate::raster::{ItemBuffer, Seen, View};
use glam::DVec3;

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

/// What is seen from a point, the corner of a patch as a rule: how much of each patch, and
/// where.
#[derive(Clone, Debug, Default)]
pub struct CornerView {
    /// Each patch that is seen, with its moments.
    pub patches: Vec<(PatchId, Moments)>,
    /// The patches among them (by their place in the list) that were drawn whole.
    pub whole: Vec<usize>,
    /// The elements of all others, with their moments.
    pub elements: Vec<(ElementId, Moments)>,
    /// Cells whose rays go on from a patch: unit directions, and what each cell counts.
    pub followed: Vec<(DVec3, f64)>,
    /// Cells that see the sky.
    pub sky: Vec<(DVec3, f64)>,
    /// The shares that reach no front.
    pub lost: Lost,
}

/// A patch is near when its middle is closer than this many of its diameters.
const NEAR: f64 = 1.5;

/// Hemicubes that see where on a patch they look.
#[derive(Debug)]
pub struct Linear<'m> {
    levels: &'m TwoLevels<'m>,
    painter: Painter<'m>,
    resolution: u32,
    weights: Weights,
    on_patches: Vec<PatchCoordinates>,
    on_elements: Vec<PatchCoordinates>,
    diameters: Vec<f64>,
    followed: Followed,
}

/// What is not the end of a ray where a hemicube sees it.
#[derive(Clone, Debug, Default)]
pub struct Followed {
    /// Patches whose fronts mirror, gloss or let light through.
    pub fronts: Vec<bool>,
    /// Patches that light goes through from behind.
    pub backs: Vec<bool>,
    /// Is there light where nothing is?
    pub sky: bool,
}

impl Followed {
    fn goes_on(&self, seen: Seen, levels: &TwoLevels) -> bool {
        let marked = |of: &[bool], id| {
            let patch = Drawn::decode(id, levels).patch(levels);
            of.get(patch.0 as usize).is_some_and(|&m| m)
        };
        match seen {
            Seen::Nothing => self.sky,
            Seen::Front(id) => marked(&self.fronts, id),
            Seen::Back(id) => marked(&self.backs, id),
        }
    }
}

/// What a picture shows: patches have their own ids, those of elements follow.
#[derive(Clone, Copy)]
enum Drawn {
    Patch(PatchId),
    Element(ElementId),
}

impl Drawn {
    fn id(self, levels: &TwoLevels) -> u32 {
        match self {
            Drawn::Patch(PatchId(k)) => k,
            Drawn::Element(ElementId(e)) => levels.patches().elements.len() as u32 + e,
        }
    }

    fn decode(id: u32, levels: &TwoLevels) -> Drawn {
        match id.checked_sub(levels.patches().elements.len() as u32) {
            None => Drawn::Patch(PatchId(id)),
            Some(e) => Drawn::Element(ElementId(e)),
        }
    }

    fn patch(self, levels: &TwoLevels) -> PatchId {
        match self {
            Drawn::Patch(patch) => patch,
            Drawn::Element(e) => levels.elements().element(e).patch,
        }
    }
}

/// Sums over the faces of a hemicube.
struct Sums {
    /// Of every patch.
    patches: Vec<Moments>,
    /// Of elements, one after the other as they were found.
    elements: Vec<(ElementId, Moments)>,
    followed: Vec<(DVec3, f64)>,
    sky: Vec<(DVec3, f64)>,
    lost: Lost,
}

impl<'m> Linear<'m> {
    /// Hemicubes of this resolution that look at patches, and at the elements of near ones.
    ///
    /// # Panics
    /// As [`super::hemicube::Hemicube::new`].
    pub fn new(levels: &'m TwoLevels<'m>, resolution: u32) -> Linear<'m> {
        let patches = levels.patches();
        let on_elements = levels.elements().polygons().map(PatchCoordinates::of);
        Linear {
            levels,
            painter: Painter::new(patches),
            resolution,
            weights: Weights::exact(resolution),
            on_patches: patches.polygons().map(PatchCoordinates::of).collect(),
            on_elements: on_elements.collect(),
            diameters: patches.polygons().map(Polygon::diameter).collect(),
            followed: Followed::default(),
        }
    }

    /// The same, telling where rays go on ([`CornerView::followed`]).
    pub fn following(self, followed: Followed) -> Linear<'m> {
        Linear { followed, ..self }
    }

    /// What a point with this unit normal sees.
    pub fn seen_from(&self, point: DVec3, normal: DVec3) -> CornerView {
        let all = 0..self.on_patches.len() as u32;
        let in_parts: Vec<bool> =
            all.map(|k| self.is_seen_in_parts(PatchId(k), point)).collect();
        let drawn = self.drawn(&in_parts);
        let mut sums = Sums {
            patches: vec![[0.0; 4]; in_parts.len()],
            elements: Vec::new(),
            followed: Vec::new(),
            sky: Vec::new(),
            lost: Lost::default(),
        };
        let frame = Frame::about(normal);
        self.painter.with_buffer(|buffer| {
            for face in CubeFace::ALL {
                let (width, height) = face.size(self.resolution);
                let view = face.view(point, &frame);
                buffer.reset(width, height);
                drawn.iter().for_each(|&(id, polygon)| buffer.draw(&view, polygon, id));
                self.add_cells(&view, buffer, self.weights.of(face), &mut sums);
            }
        });
        sums.view(&in_parts)
    }

    /// Is the patch so near to the point that its elements are to be told apart?
    fn is_seen_in_parts(&self, id: PatchId, point: DVec3) -> bool {
        let distance_squared = point.distance_squared(self.on_patches[id].middle);
        self.levels.is_divided(id)
            && distance_squared < (NEAR * self.diameters[id]).powi(2)
    }

    /// What is drawn, with its ids: patches, or the elements of those seen in parts.
    fn drawn(&self, in_parts: &[bool]) -> Vec<(u32, &'m Polygon)> {
        let mut drawn = Vec::with_capacity(in_parts.len());
        for (k, &in_parts) in (0u32..).zip(in_parts) {
            let patch = PatchId(k);
            if in_parts {
                let elements = self.levels.elements_of(patch);
                drawn.extend(elements.map(|(e, element)| {
                    (Drawn::Element(e).id(self.levels), &element.polygon)
                }));
            } else {
                let id = Drawn::Patch(patch).id(self.levels);
                drawn.push((id, &self.levels.patch(patch).polygon));
            }
        }
        drawn
    }

    /// Adds up what the cells of one face show.
    fn add_cells(
        &self,
        view: &View,
        cells: &ItemBuffer,
        weights: &[f64],
        sums: &mut Sums,
    ) {
        for (seen, first, end) in cells.runs() {
            let goes_on = self.followed.goes_on(seen, self.levels);
            if goes_on {
                let (width, height) = (cells.width(), cells.height());
                let cell = |cell: usize| {
                    let (x, y) = (cell as u32 % width, cell as u32 / width);
                    let at = View::pixel_centre(x, y, width, height);
                    (view.direction(at).normalize(), weights[cell])
                };
                let into = match seen {
                    Seen::Nothing => &mut sums.sky,
                    _ => &mut sums.followed,
                };
                into.extend((first..end).map(cell));
            }
            let share = || weights[first..end].iter().sum::<f64>();
            match seen {
                Seen::Nothing | Seen::Back(_) if goes_on => {}
                Seen::Nothing => sums.lost.escaped += share(),
                Seen::Back(_) => sums.lost.absorbed += share(),
                Seen::Front(id) => {
                    let drawn = Drawn::decode(id, self.levels);
                    let moments = |piece: &Element, coordinates| {
                        let piece = InView::new(view, &piece.polygon, coordinates);
                        piece.moments(cells, weights, first..end)
                    };
                    if let Drawn::Element(e) = drawn {
                        let element = self.levels.elements().element(e);
                        sums.elements.push((e, moments(element, &self.on_elements[e])));
                    }
                    let k = drawn.patch(self.levels);
                    let of_patch = moments(self.levels.patch(k), &self.on_patches[k]);
                    add(&mut sums.patches[k], of_patch);
                }
            }
        }
    }

    /// The light of a patch that has these values at its corners.
    pub fn of_patch(&self, id: PatchId, of_vertices: &[Rgb]) -> Slopes {
        let corners = &self.levels.patch(id).corners;
        self.on_patches[id].slopes(corners.iter().map(|&c| of_vertices[c]))
    }

    /// The moments of a ray that meets a patch at `p`.
    pub fn moments_at(&self, id: PatchId, p: DVec3) -> Moments {
        let (s, t) = self.on_patches[id].place(p);
        [1.0, s, t, s * t]
    }

    /// The light of an element that has these values at its corners.
    pub fn of_element(&self, id: ElementId, of_vertices: &[Rgb]) -> Slopes {
        let corners = &self.levels.elements().element(id).corners;
        self.on_elements[id].slopes(corners.iter().map(|&c| of_vertices[c]))
    }

    /// The mean over a patch of light with these slopes.
    pub fn mean(&self, id: PatchId, b: &Slopes) -> Rgb {
        b[0] + self.on_patches[id].mean_product * b[3]
    }
}

impl Sums {
    /// The sums as a view in which those patches are `in_parts`.
    fn view(self, in_parts: &[bool]) -> CornerView {
        let Sums { patches, mut elements, followed, sky, lost } = self;
        elements.sort_unstable_by_key(|e| e.0);
        elements.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                add(&mut kept.1, next.1);
            }
            same
        });
        let ids = (0..).map(PatchId);
        let seen = ids.zip(patches).filter(|(_, m)| m[0] != 0.0);
        let patches: Vec<(PatchId, Moments)> = seen.collect();
        let whole = (0..patches.len()).filter(|&place| !in_parts[patches[place].0]);
        CornerView { whole: whole.collect(), patches, elements, followed, sky, lost }
    }
}

fn add(sum: &mut Moments, m: Moments) {
    sum.iter_mut().zip(m).for_each(|(sum, m)| *sum += m);
}
