//! A picture taken apart: one for each class of paths.

use crate::ledger as books;
use radiosity::field::Pass1;
use radiosity::field::Smooth;
use radiosity::film::{Picture, RgbImage, Shot};
use radiosity::geometry::Rgb;
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in};
use radiosity::trace::{ByClass, Class, Light, Look, Owner, PathTracer, Table};
use std::fmt::Write;
use std::sync::OnceLock;

/// Pixels along an edge of a panel.
const PANEL: u32 = 144;

/// The error asked of pass 1.
const TOLERANCE: f64 = 0.02;

/// Paths in each pixel of the table's picture, which is smaller.
const PATHS: usize = 256;
const SMALL: u32 = 48;

/// The scene of the figures.
pub fn scene() -> Scene {
    built_in("cornell-mirror").expect("`cornell-mirror` is built in")
}

fn shot(scene: &Scene, size: u32) -> Shot {
    Shot { camera: scene.camera, width: size, height: size, samples: 2 }
}

/// The picture by both passes, class by class; computed once.
pub fn by_class() -> &'static ByClass {
    static PARTS: OnceLock<ByClass> = OnceLock::new();
    PARTS.get_or_init(|| {
        let (scene, options) = (scene(), Look::default());
        let how = Smooth.first(&Room::of(&scene), TOLERANCE);
        ByClass::of(&scene, &shot(&scene, PANEL), &how, &options, &|_, _, _| {})
    })
}

/// The same light by paths; computed once.
fn by_paths() -> &'static Table {
    static PATHS_TABLE: OnceLock<Table> = OnceLock::new();
    PATHS_TABLE.get_or_init(|| {
        let scene = scene();
        let shot = shot(&scene, SMALL);
        PathTracer::of(&Room::of(&scene))
            .picture(&shot, PATHS, 15, &|_, _, _| {})
            .classes
    })
}

/// The picture whose classes satisfy `wanted`.
fn sum(wanted: impl Fn(Class) -> bool) -> Picture {
    let mut sum = Picture::new(PANEL, PANEL);
    for (class, part) in Class::all().zip(&by_class().pictures) {
        if wanted(class) {
            for (pixel, &more) in sum.pixels.iter_mut().zip(&part.pixels) {
                *pixel += more.max(Rgb::ZERO);
            }
        }
    }
    sum
}

/// The exposure of all pictures: that of the whole.
fn exposure() -> f64 {
    sum(|_| true).auto_exposure()
}

/// The whole picture.
pub fn whole() -> RgbImage {
    sum(|_| true).display(exposure())
}

/// The ten parts, as [`Class::all`] counts them: five seen straight, five mirrored below.
/// What is seen straight, lamps apart, is shown as it counts; faint parts four times brighter.
pub fn sheet() -> RgbImage {
    let gap = 4;
    let mut page = RgbImage::new(5 * PANEL + 4 * gap, 2 * PANEL + gap);
    page.pixels_mut().for_each(|p| p.0 = [255; 3]);
    for (k, class) in Class::all().enumerate() {
        let brighter = if is_faint(class) { FAINT } else { 1.0 };
        let panel = sum(|other| other == class).display(brighter * exposure());
        let (column, row) = (k as u32 % 5, k as u32 / 5);
        for (x, y, pixel) in panel.enumerate_pixels() {
            let (left, top) = (column * (PANEL + gap), row * (PANEL + gap));
            page.put_pixel(left + x, top + y, *pixel);
        }
    }
    page
}

/// How much brighter the faint parts are shown.
pub const FAINT: f64 = 4.0;

/// Is the class shown brighter?
pub fn is_faint(class: Class) -> bool {
    matches!(class.light, Light::Caustic | Light::Mixed)
}

fn luminance(light: Rgb) -> f64 {
    radiosity::film::luminance(light)
}

/// Each class: its word, its owner, its share of the picture's light by both methods.
pub fn table() -> String {
    let (passes, paths) = (by_class().table(), by_paths());
    let mut text = String::from(
        "| word | what it is | carried by | both passes | paths |\n|---|---|---|---|---|\n",
    );
    let share =
        |light: Rgb, of: &Table| 100.0 * luminance(light) / luminance(of.total());
    for (row, path) in passes.rows().zip(paths.rows()) {
        let class = row.class;
        let error = 100.0 * luminance(path.error) / luminance(paths.total());
        let _ = writeln!(
            text,
            "| `{}` | {} | {} | {:.1} % | {:.1} ± {error:.1} % |",
            class.word().replace('|', "\\|"),
            class.name(),
            class.owner().name(),
            share(row.mean, &passes).max(0.0),
            share(path.mean, paths),
        );
    }
    text
}

/// The share of the picture's light, lamps apart, whose owner or class is `wanted`.
fn share(wanted: impl Fn(Class) -> bool) -> f64 {
    let table = by_class().table();
    let of = |wanted: &dyn Fn(Class) -> bool| {
        let rows = table.rows().filter(|row| wanted(row.class));
        rows.map(|row| luminance(row.mean)).sum::<f64>()
    };
    let diffuse = |class: Class| class.light != Light::Lamp;
    of(&|class| diffuse(class) && wanted(class)) / of(&diffuse)
}

/// What the pictures show.
pub fn caption() -> String {
    format!(
        "The Cornell box with a mirror for its tall block, by `radiosity render \
         cornell-mirror`; pass 1 to {:.0} %. Pass 1 alone owns {:.0} % of the light that \
         diffuse surfaces send to the eye; the other {:.0} % the second pass brings on.\n",
        100.0 * TOLERANCE,
        100.0 * share(|class| class.owner() == Owner::First),
        100.0 * share(|class| class.owner() == Owner::Both),
    )
}

/// What is lost, or counted twice, by programs that divide the work differently.
pub fn wrong() -> String {
    let per_cent = |wanted: &dyn Fn(Class) -> bool| 100.0 * share(wanted);
    format!(
        "| program | what goes wrong | of the light of diffuse surfaces |\n|---|---|---|\n\
         | plain radiosity | nothing is mirrored at all | {:.0} % lost |\n\
         | ray tracing with lamps only | light that is reflected diffusely is lost, and \
           what mirrors throw | {:.0} % lost |\n\
         | ray tracing bolted on plain radiosity | mirrors are seen, but throw no light | \
           {:.1} % lost |\n\
         | two passes that both follow lamps by mirrors | caustics twice | {:.1} % too much \
           |\n",
        per_cent(&|c| {
            c.mirrored || matches!(c.light, Light::Caustic | Light::Mixed)
        }),
        per_cent(&|c| c.light != Light::Direct),
        per_cent(&is_faint),
        per_cent(&|c| c.light == Light::Caustic),
    )
}

/// Where the light of pass 1 went.
pub fn ledger() -> String {
    let scene = scene();
    let light = Smooth::once(&Room::of(&scene), TOLERANCE);
    books::of(&light.ledger)
}
