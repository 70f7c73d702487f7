//! Drawings: the unfolded hemicube, and outlines of elements.

use crate::form_factor::hemicube::{CubeFace, Hemicube};
use crate::mesh::Mesh;
use crate::raster::{ItemBuffer, Seen, View};
use glam::{DVec2, DVec3, dvec2};
use image::RgbImage;
use tiny_skia::{Color, Paint, PathBuilder, Pixmap, Rect, Stroke, Transform};

/// A colour for an id, in sRGB bytes: neighbours in number are far apart in hue.
pub fn colour_of_id(id: u32) -> [u8; 3] {
    let golden = 0.618_033_988_749_895; // the turn that never comes back near
    let hue = (f64::from(id) * golden).fract();
    let light = [0.95, 0.8, 0.65][id as usize % 3];
    let channel = |offset: f64| {
        let ramp = ((hue + offset).fract() * 6.0 - 3.0).abs() - 1.0;
        (255.0 * light * (0.35 + 0.65 * ramp.clamp(0.0, 1.0)) + 0.5) as u8
    };
    [channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0)]
}

/// The hemicube at `point`, cut open along its upright edges and laid flat: the top in
/// the middle, the sides hinged on it, the horizon all around.
///
/// Each cell is a square of `cell` pixels (from 4 on with a gap) in the colour (sRGB
/// bytes) that `colour` gives for its face, its index there and what it shows.
pub fn hemicube_cross(
    cube: &Hemicube,
    point: DVec3,
    normal: DVec3,
    cell: u32,
    colour: impl Fn(CubeFace, usize, Seen) -> [u8; 3],
) -> RgbImage {
    let n = cube.resolution();
    let half = n / 2;
    let gap = if cell >= 4 { 1 } else { 0 };
    let mut page = Page::white(2 * n * cell, 2 * n * cell);
    cube.faces(point, normal, |face, cells| {
        for (k, seen) in cells.pixels().enumerate() {
            let (x, y) = (k as u32 % n, k as u32 / n);
            let (x, y) = match face {
                CubeFace::Top => (half + x, half + y),
                CubeFace::South => (half + x, half + n + y),
                CubeFace::North => (half + n - 1 - x, half - 1 - y),
                CubeFace::East => (half + n + y, half + n - 1 - x),
                CubeFace::West => (half - 1 - y, half + x),
            };
            page.square(x * cell, y * cell, cell - gap, colour(face, k, seen));
        }
    });
    page.picture()
}

/// The outlines of all elements that `items` shows, over `picture`.
///
/// An outline is drawn where one of the nine pixels about it shows its element: hidden
/// lines stay hidden.
pub(super) fn outlines(
    picture: RgbImage,
    mesh: &Mesh,
    view: &View,
    items: &ItemBuffer,
) -> RgbImage {
    let mut shown: Vec<u32> = items
        .runs()
        .filter_map(|(seen, _, _)| match seen {
            Seen::Front(id) | Seen::Back(id) => Some(id),
            Seen::Nothing => None,
        })
        .collect();
    shown.sort_unstable();
    shown.dedup();
    let mut path = PathBuilder::new();
    for id in shown {
        for (a, b) in mesh.elements[id as usize].polygon.edges() {
            visible_parts(&mut path, view, items, id, [a, b]);
        }
    }
    let mut page = Page::of(&picture);
    page.lines(path, [0; 3], 1.0);
    page.picture()
}

/// Adds to `path` the parts of the edge from `a` to `b` where `items` shows `id`.
fn visible_parts(
    path: &mut PathBuilder,
    view: &View,
    items: &ItemBuffer,
    id: u32,
    [a, b]: [DVec3; 2],
) {
    let (width, height) = (items.width(), items.height());
    let place = |p: DVec3| {
        let v = view.clip_from_world(p);
        let on_page = dvec2(1.0 + v.x / v.z, 1.0 - v.y / v.z) * 0.5;
        (v.z > 0.0).then_some(on_page * dvec2(width as f64, height as f64))
    };
    let shows = |at: DVec2| {
        let near = |offset: f64, size: u32, x: f64| {
            let pixel = (x + offset).floor();
            (pixel >= 0.0 && pixel < size as f64).then_some(pixel as u32)
        };
        [-1.0, 0.0, 1.0].iter().any(|&dy| {
            [-1.0, 0.0, 1.0].iter().any(|&dx| {
                let pixel = near(dx, width, at.x).zip(near(dy, height, at.y));
                let seen = pixel.map(|(x, y)| items.seen(x, y));
                seen == Some(Seen::Front(id)) || seen == Some(Seen::Back(id))
            })
        })
    };
    // A step a pixel; a picture's width of them when an end is behind the eye.
    let length = place(a).zip(place(b)).map_or(f64::INFINITY, |(a, b)| a.distance(b));
    let steps = length.clamp(1.0, (width + height) as f64).ceil();
    let mut pen_down = false;
    for k in 0..=steps as u32 {
        let at = place(a.lerp(b, k as f64 / steps)).filter(|&at| shows(at));
        match at {
            Some(at) if pen_down => path.line_to(at.x as f32, at.y as f32),
            Some(at) => path.move_to(at.x as f32, at.y as f32),
            None => {}
        }
        pen_down = at.is_some();
    }
}

/// A sheet to draw on.
struct Page(Pixmap);

impl Page {
    /// # Panics
    /// When a side is 0, or the sheet has 2³¹ bytes.
    fn white(width: u32, height: u32) -> Page {
        let Some(mut pixmap) = Pixmap::new(width, height) else {
            panic!("no sheet of {width} x {height} pixels can be drawn on");
        };
        pixmap.fill(Color::WHITE);
        Page(pixmap)
    }

    fn of(picture: &RgbImage) -> Page {
        let mut page = Page::white(picture.width(), picture.height());
        for (to, from) in page.0.data_mut().chunks_exact_mut(4).zip(picture.pixels()) {
            to[..3].copy_from_slice(&from.0);
        }
        page
    }

    fn picture(self) -> RgbImage {
        let (width, height) = (self.0.width(), self.0.height());
        RgbImage::from_fn(width, height, |x, y| {
            let k = 4 * (y as usize * width as usize + x as usize);
            let data = self.0.data();
            image::Rgb([data[k], data[k + 1], data[k + 2]])
        })
    }

    fn square(&mut self, x: u32, y: u32, side: u32, [r, g, b]: [u8; 3]) {
        let mut paint = Paint { anti_alias: false, ..Paint::default() };
        paint.set_color_rgba8(r, g, b, 255);
        let rect = Rect::from_xywh(x as f32, y as f32, side as f32, side as f32);
        if let Some(rect) = rect {
            self.0.fill_rect(rect, &paint, Transform::identity(), None);
        }
    }

    fn lines(&mut self, path: PathBuilder, [r, g, b]: [u8; 3], width: f32) {
        let mut paint = Paint::default();
        paint.set_color_rgba8(r, g, b, 160);
        let stroke = Stroke { width, ..Stroke::default() };
        if let Some(path) = path.finish() {
            self.0.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
        }
    }
}
