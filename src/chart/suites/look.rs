//! One look at a scene, and who finds what it shows: radiosity, two passes, ray tracing,
//! paths. All are asked the same: the radiance in the middle of each pixel.

use super::truth::PictureTruth;
use crate::chart::{Contest, Method, WorkDone};
use crate::field::{Pass1, Smooth, gather_unbiased};
use crate::film::{Picture, Shot};
use crate::geometry::{Frame, Polygon, Ray, Rgb};
use crate::mesh::Mesh;
use crate::random::Stream;
use crate::raster::View;
use crate::room::Room;
use crate::scene::{Scene, built_in};
use crate::solution::{Goal, Solution, solve_from};
use crate::trace::{Look, PathTracer, Strategy, TwoPass, Whitted};
use crate::ways::{Branching, Met, Specular};
use glam::DVec3;
use std::f64::consts::PI;

/// A scene as its camera sees it, and what it should show.
#[derive(Debug)]
pub struct Onlooker {
    scene: Scene,
    shot: Shot,
    truth: PictureTruth,
}

impl Onlooker {
    /// At a built-in scene in `size × size` pixels. About so many of them, evenly spread,
    /// are held against unbiased walks, twice so many for each.
    ///
    /// What shows a lamp, straight or mirrored, is left out: everyone knows how bright it
    /// is. The scene has no gloss: it has no single point from which its light comes.
    pub fn at(name: &str, size: u32, pixels: usize, walks: usize) -> Onlooker {
        let scene = built_in(name).unwrap_or_else(|error| panic!("{error}"));
        let camera = scene.camera;
        let shot = Shot { camera, width: size, height: size, samples: 1 };
        let all = (size * size) as usize;
        let step = all as f64 * GOLDEN;
        let place = |k: usize| (k as f64 * step) as usize % all;
        let chosen =
            (0..pixels.min(all)).map(|k| if pixels < all { place(k) } else { k });
        let room = Room::of(&scene);
        let rays = Specular::through(&scene, room.visibility(), room.solids());
        let rays = rays.branching(Branching::Both(FAINT));
        let eye = Eye { scene: &scene, rays };
        let ends: Vec<(usize, Vec<End>)> =
            chosen.filter_map(|k| Some((k, eye.ends(&ray(&shot, k))?))).collect();
        let pixels = ends.iter().map(|(k, _)| *k).collect();
        let truth = PictureTruth::new(pixels, |seed| eye.radiance(&ends, walks, seed));
        Onlooker { scene, shot, truth }
    }

    /// A contest on this look, in the name of its scene.
    pub fn contest(&self, name: &str) -> Contest<'_, Picture> {
        let judge = |seen: &Picture| self.truth.judge(seen);
        Contest::new(name, self.truth.uncertainty(), judge)
    }

    /// Is there anything that a second pass would see?
    pub fn shines(&self) -> bool {
        self.scene.shines()
    }

    /// Radiosity as it began, at tolerances: all that shines scatters evenly.
    pub fn dulled(&self, tolerances: &[f64]) -> Method<'_, Picture> {
        let dull = self.scene.dulled();
        Method::new("classical radiosity", tolerances, move |tolerance, _| {
            self.first(&dull, tolerance)
        })
    }

    /// Pass 1 alone, at tolerances: what shines shows its diffuse light only.
    pub fn radiosity(&self, tolerances: &[f64]) -> Method<'_, Picture> {
        Method::new("radiosity", tolerances, |tolerance, _| {
            self.first(&self.scene, tolerance)
        })
    }

    fn first(&self, scene: &Scene, tolerance: f64) -> (Picture, WorkDone) {
        let (solution, work) = solved(scene, tolerance);
        (self.shot.smooth(&solution.field.mesh, &solution.vertex_radiosity), work)
    }

    /// Both passes, at tolerances of pass 1.
    pub fn two_passes(&self, tolerances: &[f64]) -> Method<'_, Picture> {
        Method::new("two passes", tolerances, |tolerance, _| {
            self.both(tolerance, Look::default())
        })
    }

    /// Both passes; of the light of diffuse surfaces pass 1 at this tolerance tells only
    /// what comes from far away, for so many rays gather it anew.
    pub fn gathered(&self, tolerance: f64, rays: &[f64]) -> Method<'_, Picture> {
        Method::new("light gathered anew", rays, move |rays, _| {
            self.both(tolerance, Look { gather: rays as usize, ..Look::default() })
        })
    }

    fn both(&self, tolerance: f64, options: Look) -> (Picture, WorkDone) {
        let (solution, work) = solved(&self.scene, tolerance);
        let (mesh, light) = (&solution.field.mesh, &solution.vertex_radiosity);
        let two = TwoPass::showing(&Room::of(&self.scene), mesh, light, options);
        let shown = two.picture(&self.shot, &|_, _, _| {});
        (shown.picture, WorkDone { rays: shown.rays, ..work })
    }

    /// Classical ray tracing, cut after so many bounces.
    pub fn ray_tracing(&self, depths: &[f64]) -> Method<'_, Picture> {
        Method::new("ray tracing", depths, |depth, _| {
            let look = Look { depth: depth as u32, ..Look::default() };
            let tracer = Whitted::of(&Room::of(&self.scene), look);
            let mut work = WorkDone::default();
            let picture = self.each(|ray, _| {
                let along = tracer.along(&ray);
                work.rays += along.rays;
                along.radiance
            });
            (picture, work)
        })
    }

    /// So many random paths through each pixel, in this way.
    pub fn paths(
        &self,
        name: &str,
        strategy: Strategy,
        samples: &[f64],
    ) -> Method<'_, Picture> {
        Method::random(name, samples, move |samples, seed| {
            let tracer = PathTracer::of(&Room::of(&self.scene)).by(strategy);
            let picture = self.each(|ray, k| {
                let mut random = Stream::named(seed, &[k as u64, samples as u64]);
                let path = |_| tracer.radiance(ray, &mut random);
                (0..samples as u64).map(path).sum::<Rgb>() / samples
            });
            let rays = samples as u64 * picture.pixels.len() as u64;
            (picture, WorkDone { rays, ..WorkDone::default() })
        })
        .seeds(2) // a picture has many pixels
    }

    fn each(&self, mut radiance: impl FnMut(Ray, usize) -> Rgb) -> Picture {
        let mut picture = Picture::new(self.shot.width, self.shot.height);
        let pixels = picture.pixels.iter_mut().enumerate();
        pixels.for_each(|(k, pixel)| *pixel = radiance(ray(&self.shot, k), k));
        picture
    }
}

/// Its multiples leave no gap, modulo 1, for long.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// Pass 1, once, with its certificate.
pub fn solved(scene: &Scene, tolerance: f64) -> (Solution, WorkDone) {
    // One attempt, whatever its certificate says.
    let (room, goal) = (Room::of(scene), Goal::within(1e9));
    let first = Smooth.first(&room, tolerance);
    let quiet = crate::work::Work::quiet();
    let solution = solve_from(&room, &Smooth, first, &goal, &quiet);
    let solution = solution.expect("the scene has faces");
    let factors = (solution.field.rows * solution.field.patches) as u64;
    let bytes = size_of_val(&solution.vertex_radiosity[..]) as u64;
    let steps = solution.field.steps as u64;
    (solution, WorkDone { factors, steps, bytes, ..WorkDone::default() })
}

/// Through the middle of the `k`th pixel.
fn ray(shot: &Shot, k: usize) -> Ray {
    let (x, y) = (k as u32 % shot.width, k as u32 / shot.width);
    let view = shot.view();
    let at = View::pixel_centre(x, y, shot.width, shot.height);
    Ray { origin: view.eye(), direction: view.direction(at).normalize() }
}

/// A diffuse surface that a pixel shows, straight, in mirrors or through panes.
struct End {
    surface: u32,
    point: DVec3,
    weight: Rgb,
}

/// Follows what a pixel shows.
struct Eye<'s> {
    scene: &'s Scene,
    rays: Specular<'s>,
}

/// Branches that count less are left to chance, and are not drawn here: they are lost.
const FAINT: f64 = 1e-4;

impl Eye<'_> {
    /// All that a ray shows; `None` if a lamp is among it.
    fn ends(&self, ray: &Ray) -> Option<Vec<End>> {
        let (mut ends, mut lit) = (vec![], false);
        let mut random = Stream::named(0, &[]);
        self.rays.follow((*ray, None), &mut random, &mut |arrival| {
            if let Met::Surface { surface, point, front: true, .. } = arrival.met {
                let material = self.material(surface);
                lit |= material.emits();
                if material.diffuse() != Rgb::ZERO {
                    ends.push(End { surface, point, weight: arrival.weight });
                }
            }
        });
        (!lit && !ends.is_empty()).then_some(ends)
    }

    /// Of each pixel, W/(m² sr).
    fn radiance(&self, all: &[(usize, Vec<End>)], walks: usize, seed: u64) -> Vec<Rgb> {
        let pieces = all.iter().flat_map(|(_, ends)| ends);
        let pieces = pieces.map(|end| (end.surface, vec![self.piece(end)]));
        let mesh = Mesh::of_pieces(self.scene, pieces);
        let mut light =
            gather_unbiased(&Room::of(self.scene), &mesh, walks, seed).into_iter();
        let mut of = |end: &End| {
            let found = light.next().expect("one for each piece");
            end.weight * self.material(end.surface).diffuse() * found.irradiance / PI
        };
        all.iter().map(|(_, ends)| ends.iter().map(&mut of).sum()).collect()
    }

    fn material(&self, surface: u32) -> &crate::material::Material {
        self.scene.material(&self.scene.surfaces[surface as usize])
    }

    /// A square about it, so small that light is the same all over.
    fn piece(&self, end: &End) -> Polygon {
        let normal = self.scene.surfaces[end.surface as usize].polygon.normal();
        let Frame { x, y, .. } = Frame::about(normal);
        let side = 1e-6 * self.scene.diagonal();
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(u, v)| end.point + side * (u * x + v * y));
        Polygon::new(corners.to_vec()).expect("a square is fit")
    }
}
