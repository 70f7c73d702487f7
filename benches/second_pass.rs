//! Error and time of a picture of the Cornell box with a mirror block: two passes, and the
//! path tracer. `cargo bench --bench second_pass` prints a record as CSV.
//!
//! The error of two passes is that of the radiance at the centres of 3000 pixels that show
//! no lamp, straight or mirrored: root mean square, relative to the mean. The right values
//! are found by unbiased walks from what the pixel shows, twice, so that their own noise
//! drops out: the mean of `(L − a)(L − b)`. Paths tell their error themselves.
//! Times are CPU seconds of one thread, for 512 × 512 pixels.

use cpu_time::ProcessTime;
use radiosity::film::Shot;
use radiosity::geometry::{Frame, Polygon, Ray, Rgb};
use radiosity::glam::{DVec3, dvec2};
use radiosity::material::Shine;
use radiosity::material::optics::reflect;
use radiosity::mesh::Mesh;
use radiosity::random::Stream;
use radiosity::raster::View;
use radiosity::scene::{Scene, built_in};
use radiosity::solve::{Ask, Solution, automatic, gather_unbiased, resolution_for};
use radiosity::trace::{Options, PathTracer, TwoPass};
use radiosity::visibility::Visibility;
use std::f64::consts::PI;

/// Pixels along an edge of the picture that is timed, and of the one by paths.
const FULL: u32 = 512;
const SMALL: u32 = 128;

/// Pixels that are held against walks, and walks for each, twice.
const PROBES: usize = 3000;
const WALKS: usize = 300;

fn main() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.expect("one thread can be had").install(measure);
}

fn measure() {
    let scene = built_in("cornell-mirror").expect("it is built in");
    let probes = Probes::of(&scene);
    println!("method,setting,cpu_seconds,rms_error,reference");
    for tolerance in [0.1, 0.05, 0.03, 0.02, 0.015, 0.01] {
        let start = ProcessTime::now();
        let how = resolution_for(&scene, tolerance);
        let (solution, _) = automatic(&scene, how, &ASK_ONCE, &|_, _, _| {});
        let first = start.elapsed().as_secs_f64();
        two_passes(&scene, &solution, tolerance, first, &probes);
    }
    for (name, scene) in [
        ("paths", scene),
        ("paths without mirror", built_in("cornell-regular").expect("it is built in")),
    ] {
        by_paths(name, &scene);
    }
}

/// One attempt, whatever its certificate says.
const ASK_ONCE: Ask =
    Ask { tolerance: 1e9, seed: 0, most_patches: 4000, most_elements: 60_000 };

fn two_passes(
    scene: &Scene,
    solution: &Solution,
    tolerance: f64,
    first: f64,
    probes: &Probes,
) {
    let start = ProcessTime::now();
    let (mesh, radiosity) = (&solution.mesh, &solution.vertex_radiosity);
    let two = TwoPass::of(scene, mesh, radiosity, Options::default());
    let camera = scene.camera;
    let shot = Shot { camera, width: FULL, height: FULL, samples: 3 };
    let shown = two.picture(&shot, &|_, _, _| {});
    let second = start.elapsed().as_secs_f64();
    let error = probes.error(&two);
    let seconds = first + second;
    println!("two passes,{tolerance},{seconds:.2},{error:.5},unbiased walks");
    let (elements, rays) = (mesh.elements.len(), shown.rays);
    eprintln!(
        "pass 1 {first:.2} s with its certificate, {elements} elements; pass 2 \
         {second:.2} s, {rays} rays"
    );
}

fn by_paths(name: &str, scene: &Scene) {
    let (tracer, counts) = (PathTracer::of(scene), without_lamps(scene));
    let camera = scene.camera;
    let shot = Shot { camera, width: SMALL, height: SMALL, samples: 1 };
    for samples in [4, 16, 64] {
        let start = ProcessTime::now();
        let found = tracer.picture(&shot, samples, 1, &|_, _, _| {});
        let seconds =
            start.elapsed().as_secs_f64() * f64::from(FULL * FULL / SMALL / SMALL);
        let (mut square, mut sum) = (0.0, 0.0);
        let mut n = 0.0;
        for (k, (l, e)) in found.picture.pixels.iter().zip(&found.error).enumerate() {
            if counts[k] {
                square += (*e * *e).element_sum();
                sum += l.element_sum();
                n += 3.0;
            }
        }
        let error = (square / n).sqrt() / (sum / n);
        println!("{name},{samples} samples,{seconds:.2},{error:.5},its own spread");
    }
}

/// Which pixels of a small picture show no lamp, straight or mirrored, nor a pixel beside
/// them: what shows the edge of a lamp says nothing but how bright the lamp is.
fn without_lamps(scene: &Scene) -> Vec<bool> {
    let surfaces = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
    let view = View::of_camera(&scene.camera, 1.0);
    let clear = |k: u32| {
        let centre = View::pixel_centre(k % SMALL, k / SMALL, SMALL, SMALL);
        (0..49).all(|place: u32| {
            let off = dvec2(f64::from(place % 7) - 3.0, f64::from(place / 7) - 3.0);
            let direction = view.direction(centre + off / f64::from(SMALL)).normalize();
            let ray = Ray { origin: view.eye(), direction };
            End::of(scene, &surfaces, ray).is_some()
        })
    };
    (0..SMALL * SMALL).map(clear).collect()
}

/// Rays to some pixels, and what unbiased walks say of them.
struct Probes {
    rays: Vec<Ray>,
    found: [Vec<Rgb>; 2],
}

impl Probes {
    fn of(scene: &Scene) -> Probes {
        let surfaces = Visibility::new(scene.surfaces.iter().map(|s| &s.polygon));
        let view = View::of_camera(&scene.camera, 1.0);
        let mut random = Stream::named(512, &[]);
        let (mut rays, mut ends) = (Vec::new(), Vec::new());
        while rays.len() < PROBES {
            let mut pixel = || ((random.next() * f64::from(FULL)) as u32).min(FULL - 1);
            let at = View::pixel_centre(pixel(), pixel(), FULL, FULL);
            let direction = view.direction(at).normalize();
            let ray = Ray { origin: view.eye(), direction };
            if let Some(end) = End::of(scene, &surfaces, ray) {
                rays.push(ray);
                ends.push(end);
            }
        }
        let piece = |end: &End| (end.surface, vec![end.piece(scene)]);
        let mesh = Mesh::of_pieces(scene, ends.iter().map(piece));
        let radiance = |seed: u64| {
            let light = gather_unbiased(scene, &mesh, WALKS, seed);
            let of = |(end, h): (&End, Rgb)| {
                let material = scene.material(&scene.surfaces[end.surface as usize]);
                end.weight * material.diffuse() * h / PI
            };
            ends.iter().zip(light.iter().map(|l| l.irradiance)).map(of).collect()
        };
        Probes { rays, found: [radiance(1), radiance(2)] }
    }

    fn error(&self, two: &TwoPass) -> f64 {
        let (mut square, mut sum) = (0.0, 0.0);
        for (k, ray) in self.rays.iter().enumerate() {
            let l = two.along(ray).radiance;
            let [a, b] = [self.found[0][k], self.found[1][k]];
            square += ((l - a) * (l - b)).element_sum();
            sum += (0.5 * (a + b)).element_sum();
        }
        let n = 3.0 * self.rays.len() as f64;
        (square.max(0.0) / n).sqrt() / (sum / n)
    }
}

/// The diffuse surface that a pixel shows, straight or in mirrors.
struct End {
    surface: u32,
    point: DVec3,
    weight: Rgb,
}

impl End {
    /// `None` for lamps, and what is black.
    fn of(scene: &Scene, surfaces: &Visibility, mut ray: Ray) -> Option<End> {
        let (mut weight, mut leaving) = (Rgb::ONE, None);
        loop {
            let hit = surfaces.closest(&ray, leaving).filter(|hit| hit.front)?;
            let point = ray.origin + hit.distance * ray.direction;
            let surface = &scene.surfaces[hit.item as usize];
            let material = scene.material(surface);
            let Shine::Mirror { reflectance } = material.shine() else {
                let end = End { surface: hit.item, point, weight };
                return (!material.emits()).then_some(end);
            };
            weight *= reflectance;
            leaving = Some(hit.item);
            let direction = reflect(ray.direction, surface.polygon.normal());
            ray = Ray { origin: point, direction };
        }
    }

    /// A square about it, so small that light is the same all over.
    fn piece(&self, scene: &Scene) -> Polygon {
        let normal = scene.surfaces[self.surface as usize].polygon.normal();
        let Frame { x, y, .. } = Frame::about(normal);
        let side = 1e-6 * scene.diagonal();
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(u, v)| self.point + side * (u * x + v * y));
        Polygon::new(corners.to_vec()).expect("a square is fit")
    }
}
