//! The item buffer: a z-buffer that keeps, in each pixel, the id of what is seen there.
//!
//! ```text
//! (X, Y, W) = M (p − eye)           homogeneous picture coordinates of a world point p
//! |X| ≤ W,  |Y| ≤ W                 the pyramid that the picture sees
//! 1/W = (n · (X/W, Y/W, 1)) / h     linear across the picture, so it is what we store
//! ```
//! Here `n · (p − eye) = h` is the plane of the polygon, `n` carried to picture
//! coordinates.
//!
//! A polygon goes through three steps: it is **clipped** to the pyramid, its corners
//! are **snapped** to a grid that is much finer than a pixel, and its rows are
//! **filled** by integer arithmetic. A pixel belongs to the polygon that holds its
//! centre; on an edge the left and the top one own it. Neighbours that share corners
//! therefore leave no pinhole between them, and no pixel is drawn by both.
//!
//! | a pixel asks        | the answer                                           |
//! |---------------------|------------------------------------------------------|
//! | what is nearest?    | the largest `1/W`, in f64                            |
//! | two equally near?   | the front before the back, then the smaller id       |
//! | which side is it?   | [`Seen::Front`] or [`Seen::Back`]: a back blocks too |
//! | and the near plane? | there is none: the pyramid begins at the eye         |
//!
//! A near plane would cut the wall that touches the floor just beside the eye. We need
//! none: a point of the pyramid with `W = 0` is the eye, and a polygon through the eye
//! is seen edge-on and covers nothing. (Such polygons are skipped.)
//!
//! ```
//! use radiosity::prelude::*;
//! use radiosity::raster::{ItemBuffer, Seen, View};
//! let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
//! let at = |z: f64| Polygon::new(corners.map(|(x, y)| dvec3(x, y, z)).to_vec()).unwrap();
//! let view = View::new(DVec3::ZERO, DVec3::X, DVec3::Y, -DVec3::Z); // 45° each way
//! let mut items = ItemBuffer::new(8, 8);
//! items.draw(&view, &at(-2.0), 1); // takes the middle half of the picture
//! items.draw(&view, &at(-4.0), 2); // lies behind
//! assert_eq!(items.seen(4, 4), Seen::Front(1));
//! assert_eq!(items.pixels().filter(|seen| *seen == Seen::Front(1)).count(), 16);
//! ```
//!
//! **Not here:** colours ([`crate::film`]); hemicube weights
//! ([`crate::form_factor::hemicube`]). Chapters *The picture* (L09) and *The
//! hemicube* (L10). Sources: Catmull 1974 (z-buffer); Weghorst, Hooper & Greenberg 1984
//! (item buffer); Blinn & Newell 1978 (homogeneous clipping).

mod scan;
mod view;

pub use view::View;

use crate::geometry::Polygon;
use glam::DVec3;
use scan::Spans;

/// Marks the ids of backs.
const BACK: u32 = 1 << 31;

/// Nothing is seen here.
const EMPTY: u32 = u32::MAX;

/// The largest id that can be drawn: 2³¹ − 2.
pub const MAX_ID: u32 = BACK - 2;

/// The largest width and height, in pixels: the integer arithmetic is exact up to here.
pub const MAX_SIZE: u32 = 1 << 14;

/// A plane that passes the eye closer than this, relative to the polygon's farthest
/// corner, is seen edge-on. Rounding of an eye on the polygon is 1e-16 of the scene's
/// coordinates; a sheet that hangs 1e-6 before the eye is still seen.
const EDGE_ON: f64 = 1e-9;

/// A back is drawn deeper by this share, so that of two faces back to back in one place
/// the one that looks at us wins.
const BEHIND: f64 = 1.0 - 1e-9;

/// What a pixel shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// No polygon.
    Nothing,
    /// The front of the polygon that was drawn with this id.
    Front(u32),
    /// The back of the polygon that was drawn with this id.
    Back(u32),
}

impl Seen {
    fn decode(item: u32) -> Seen {
        match item {
            EMPTY => Seen::Nothing,
            id if id < BACK => Seen::Front(id),
            id => Seen::Back(id & !BACK),
        }
    }
}

/// A picture of ids. Row 0 is on top.
#[derive(Clone, Debug)]
pub struct ItemBuffer {
    width: u32,
    height: u32,
    items: Vec<u32>,
    /// `1/W` of each pixel, in 1/(scene units); 0 is infinitely far.
    nearness: Vec<f64>,
    outline: Vec<DVec3>,
    clipped: Vec<DVec3>,
    spans: Spans,
}

impl ItemBuffer {
    /// An empty buffer.
    ///
    /// # Panics
    /// When a side is 0 or exceeds [`MAX_SIZE`].
    pub fn new(width: u32, height: u32) -> ItemBuffer {
        let mut buffer = ItemBuffer {
            width: 0,
            height: 0,
            items: Vec::new(),
            nearness: Vec::new(),
            outline: Vec::new(),
            clipped: Vec::new(),
            spans: Spans::default(),
        };
        buffer.reset(width, height);
        buffer
    }

    /// Empties the buffer and gives it a new size; keeps its memory.
    ///
    /// # Panics
    /// As [`ItemBuffer::new`].
    pub fn reset(&mut self, width: u32, height: u32) {
        let fits = |side: u32| (1..=MAX_SIZE).contains(&side);
        assert!(
            fits(width) && fits(height),
            "{width} x {height} pixels: not 1..={MAX_SIZE}"
        );
        let pixels = width as usize * height as usize;
        (self.width, self.height) = (width, height);
        self.items.clear();
        self.items.resize(pixels, EMPTY);
        self.nearness.clear();
        self.nearness.resize(pixels, 0.0);
    }

    /// Width in pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// What the pixel in column `x` of row `y` shows.
    pub fn seen(&self, x: u32, y: u32) -> Seen {
        debug_assert!(x < self.width && y < self.height, "no pixel ({x}, {y})");
        Seen::decode(self.items[(y * self.width + x) as usize])
    }

    /// What the pixels show, row by row from the top, each from the left.
    pub fn pixels(&self) -> impl Iterator<Item = Seen> + '_ {
        self.items.iter().map(|&item| Seen::decode(item))
    }

    /// The pixels as runs `(what, first, end)` that show one thing, in order of
    /// [`ItemBuffer::pixels`]; a run may go on in the next row.
    pub fn runs(&self) -> impl Iterator<Item = (Seen, usize, usize)> + '_ {
        let mut first = 0;
        self.items.chunk_by(|a, b| a == b).map(move |run| {
            let start = first;
            first += run.len();
            (Seen::decode(run[0]), start, first)
        })
    }

    // ANCHOR: draw
    /// Draws `polygon` as `view` sees it; its pixels remember `id` and the side.
    ///
    /// Draws nothing where the polygon lies outside the pyramid, behind what is there,
    /// or edge-on to the eye. The order of drawing does not matter.
    pub fn draw(&mut self, view: &View, polygon: &Polygon, id: u32) {
        debug_assert!(id <= MAX_ID, "id {id} exceeds {MAX_ID}");
        let (mut all, mut any, mut reach) = (Outside::ALL, Outside::NONE, 0.0_f64);
        self.outline.clear();
        for &vertex in polygon.vertices() {
            let v = view.clip_from_world(vertex);
            let outside = Outside::of(v);
            (all, any) = (all.and(outside), any.or(outside));
            reach = reach.max(vertex.distance_squared(view.eye()));
            self.outline.push(v);
        }
        // The plane is n·(p − eye) = h; h is negative when the eye is in front of it.
        let h = polygon.normal().dot(polygon.vertices()[0] - view.eye());
        if all != Outside::NONE || h * h <= EDGE_ON * EDGE_ON * reach {
            return;
        }
        self.clip(any);
        let (item, bias) = if h < 0.0 { (id, 1.0) } else { (id | BACK, BEHIND) };
        let nearness = view.plane_from_world(polygon.normal()) * (bias / h);
        self.fill(item, nearness);
    }
    // ANCHOR_END: draw

    /// Clips `self.outline` to the sides of the pyramid that `any` names.
    fn clip(&mut self, any: Outside) {
        for side in 0..4 {
            if any.0 & (1 << side) != 0 {
                clip(&self.outline, side, &mut self.clipped);
                std::mem::swap(&mut self.outline, &mut self.clipped);
            }
        }
    }

    // ANCHOR: fill
    /// Fills the pixels of `self.outline` that are nearer than what is there. `plane`
    /// gives `1/W` at `(X/W, Y/W, 1)`.
    fn fill(&mut self, item: u32, plane: DVec3) {
        let (width, height) = (self.width as f64, self.height as f64);
        let (dx, dy) = (2.0 * plane.x / width, -2.0 * plane.y / height);
        // at the centre of pixel (0, 0)
        let corner = plane.z - plane.x + plane.y + 0.5 * (dx + dy);
        for (y, columns) in self.spans.of(&self.outline, self.width, self.height) {
            let pixels = y * self.width as usize + columns.start
                ..y * self.width as usize + columns.end;
            let left = corner + dy * y as f64;
            // ANCHOR: nearest
            let mut x = columns.start as f64;
            let row = self.items[pixels.clone()].iter_mut();
            for (old, nearest) in row.zip(&mut self.nearness[pixels]) {
                let near = left + dx * x;
                if near > *nearest || (near == *nearest && item < *old) {
                    (*old, *nearest) = (item, near);
                }
                x += 1.0;
            }
            // ANCHOR_END: nearest
        }
    }
    // ANCHOR_END: fill
}

/// Outside which sides of the pyramid a point lies: one bit for each (Cohen &
/// Sutherland).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Outside(u8);

impl Outside {
    const NONE: Outside = Outside(0);
    const ALL: Outside = Outside(0b1111);

    fn of(v: DVec3) -> Outside {
        Outside((0..4).map(|side| u8::from(inside(v, side) < 0.0) << side).sum())
    }

    fn and(self, other: Outside) -> Outside {
        Outside(self.0 & other.0)
    }

    fn or(self, other: Outside) -> Outside {
        Outside(self.0 | other.0)
    }
}

/// How far `v` lies inside a side of the pyramid: `W ± X`, `W ± Y`.
fn inside(v: DVec3, side: usize) -> f64 {
    match side {
        0 => v.z + v.x,
        1 => v.z - v.x,
        2 => v.z + v.y,
        _ => v.z - v.y,
    }
}

/// What of `outline` lies inside a side of the pyramid (Sutherland & Hodgman 1974).
fn clip(outline: &[DVec3], side: usize, kept: &mut Vec<DVec3>) {
    kept.clear();
    for (k, &a) in outline.iter().enumerate() {
        let b = outline[(k + 1) % outline.len()];
        let (ha, hb) = (inside(a, side), inside(b, side));
        if ha >= 0.0 {
            kept.push(a);
        }
        if (ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0) {
            // From the outer end inwards, whichever way the edge runs: both neighbours
            // of a shared edge compute the very same point.
            let (out, ho, inner, hi) =
                if ha < hb { (a, ha, b, hb) } else { (b, hb, a, ha) };
            kept.push(out + (inner - out) * (ho / (ho - hi)));
        }
    }
}
