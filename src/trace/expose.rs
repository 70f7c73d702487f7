//! A picture, sample by sample: an item buffer says what the eye sees, rays the rest.

use super::tree::{Journey, Shade, Tally, Tree};
use crate::film::{Picture, Shot};
use crate::geometry::{Ray, Rgb};
use crate::mesh::Mesh;
use crate::raster::{ItemBuffer, Seen, View};
use crate::visibility::Hit;
use crate::ways::Meeting;
use crate::work::Progress;
use rayon::prelude::*;

/// A picture, and what it cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// The radiance.
    pub picture: Picture,
    /// How many rays were followed.
    pub rays: u64,
    /// The weight of what was cut at limits of a [`Look`](super::Look), in the mean over the pixels: times the
    /// largest radiance of the scene it is what the picture lacks at the most.
    pub cut: Rgb,
}

/// What comes against one ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Along {
    /// W/(m² sr).
    pub radiance: Rgb,
    /// How many rays were followed.
    pub rays: u64,
    /// The weight of what was cut, as in [`Shown::cut`].
    pub cut: Rgb,
}

impl Along {
    /// By a tree of rays that begins with this one.
    pub(super) fn of(tree: &Tree, ray: &Ray, seed: u64, shade: Shade) -> Along {
        let mut tally = Tally { seed, ..Tally::default() };
        let radiance = tree.arriving(ray, &Journey::start(), &mut tally, shade);
        Along { radiance, rays: tally.rays, cut: tally.cut }
    }
}

/// What a sample of a pixel sees first.
pub(super) enum First<'t> {
    /// The element with this index, there.
    Element(u32, Meeting<'t>),
    /// Nothing: the ray leaves the scene.
    Sky(glam::DVec3),
    /// Nothing that sends light.
    Dark,
}

/// What is looked at.
pub(super) struct Looked<'t, 's> {
    pub tree: &'t Tree<'s>,
    pub mesh: &'t Mesh,
    pub seed: u64,
}

/// The picture of a shot: `radiance` of what each sample sees of a mesh.
///
/// Deterministic: the same at any number of threads.
pub(super) fn expose(
    shot: &Shot,
    &Looked { tree, mesh, seed }: &Looked,
    radiance: &(dyn Fn(&First, &mut Tally) -> Rgb + Sync),
    progress: Progress,
) -> Shown {
    let (width, height) = (shot.width, shot.height);
    let mut picture = Picture::new(width, height);
    let mut items = ItemBuffer::new(width, height);
    let samples = shot.views().count();
    let (mut rays, mut cut) = (0, Rgb::ZERO);
    for (sample, view) in shot.views().enumerate() {
        progress("tracing", sample, samples);
        items.reset(width, height);
        mesh.polygons().zip(0..).for_each(|(p, id)| items.draw(&view, p, id));
        let rows = picture.pixels.par_chunks_mut(width as usize).enumerate();
        let row = |(y, row): (usize, &mut [Rgb])| {
            let mut tally = Tally { seed, sample: sample as u64, ..Tally::default() };
            for (x, pixel) in row.iter_mut().enumerate() {
                let first = first(tree, mesh, &view, &items, [x as u32, y as u32]);
                tally.pixel = y as u64 * u64::from(width) + x as u64;
                tally.draws = 0;
                *pixel += radiance(&first, &mut tally);
            }
            tally
        };
        let tallies: Vec<Tally> = rows.map(row).collect();
        rays += tallies.iter().map(|t| t.rays).sum::<u64>();
        cut += tallies.iter().map(|t| t.cut).sum::<Rgb>();
    }
    progress("tracing", samples, samples);
    picture.pixels.iter_mut().for_each(|pixel| *pixel /= samples as f64);
    let all = samples as f64 * picture.pixels.len() as f64;
    Shown { picture, rays, cut: cut / all }
}

/// What the eye sees in the middle of a pixel.
fn first<'t>(
    tree: &'t Tree,
    mesh: &Mesh,
    view: &View,
    items: &ItemBuffer,
    [x, y]: [u32; 2],
) -> First<'t> {
    let at = View::pixel_centre(x, y, items.width(), items.height());
    let direction = view.direction(at).normalize();
    let (element, front) = match items.seen(x, y) {
        Seen::Nothing => return First::Sky(direction),
        Seen::Front(element) => (element, true),
        Seen::Back(element) => (element, false),
    };
    let surface = mesh.surface_of(&mesh.elements[element as usize]);
    if !front && !tree.material(surface).shine().passes() {
        return First::Dark;
    }
    let plane = tree.scene.surfaces[surface as usize].polygon.plane();
    let distance = -plane.height(view.eye()) / plane.normal.dot(direction);
    let ray = Ray { origin: view.eye(), direction };
    let hit = Hit { item: surface, distance, front };
    First::Element(element, Meeting::of(tree.scene, &tree.solids, &ray, &hit))
}

/// The radiance of what was seen first, where nothing is stored about it.
pub(super) fn followed(
    tree: &Tree,
    first: &First,
    tally: &mut Tally,
    shade: Shade,
) -> Rgb {
    match first {
        First::Sky(direction) => tree.sky(*direction),
        First::Dark => Rgb::ZERO,
        First::Element(_, at) => tree.leaving(at, &Journey::start(), tally, shade),
    }
}
