//! Hierarchy against full matrix: time, links and memory beside error, as CSV; what it comes
//! to follows on standard error. `cargo bench --bench hierarchy > book/data/links-DATE.csv`
//!
//! Everything that is timed runs on one thread, and times are those of the processor.
//! Errors are of the radiosity shown, flat or smooth, in root mean square over the area and
//! relative to the reflected light: against a solution with analytic factors on a fine even
//! mesh, gathered once more at each of 1500 points by Lambert's formula past all blockers.

use cpu_time::ThreadTime;
use radiosity::form_factor::analytic::Analytic;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::{Blockers, FormFactors, Matrix, lambert_visible};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::Mesh;
use radiosity::prelude::*;
use radiosity::random::Stream;
use radiosity::scene::{Face, MaterialId, Scene, built_in};
use radiosity::solve::hierarchy::{Hierarchical, HierarchyOptions, solve_hierarchy};
use radiosity::solve::{Enclosure, GaussSeidel, Solver, contraction};
use rayon::prelude::*;

fn main() {
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    println!("scene,method,elements,links,seconds,flat,smooth");
    let cornell = || built_in("cornell-regular").expect("built in");
    one.install(|| memory(&cornell()));
    for (name, scene, fine) in
        [("cube", lit_cube(), 0.04), ("cornell-regular", cornell(), 0.22)]
    {
        let reference = Reference::of(&scene, fine);
        one.install(|| {
            let links = links(name, &scene, &reference);
            let full = full(name, &scene, &reference);
            conclude(name, &links, &full);
        });
    }
}

/// The most memory used so far, where the system tells, with the hierarchy of 100 000
/// elements.
fn memory(scene: &Scene) {
    let options = HierarchyOptions::aiming_at(0.007, scene);
    let found = solve_hierarchy(scene, &options, &|_, _, _| {});
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let most =
        status.lines().find(|line| line.starts_with("VmHWM")).unwrap_or("unknown");
    eprintln!("{} elements, {} links: {most}", found.mesh.elements.len(), found.links);
}

/// One run.
struct Run {
    method: &'static str,
    elements: usize,
    links: usize,
    seconds: f64,
    errors: [f64; 2],
}

impl Run {
    fn print(&self, scene: &str) {
        let Run { method, elements, links, seconds, errors: [flat, smooth] } = self;
        println!(
            "{scene},{method},{elements},{links},{seconds:.3},{flat:.3e},{smooth:.3e}"
        );
    }
}

/// How fast links grow, and how many times sooner the hierarchy has the error of each
/// matrix.
fn conclude(name: &str, links: &[Run], full: &[Run]) {
    let slope = |a: &Run, b: &Run| {
        let ratio = |a: usize, b: usize| (b as f64 / a as f64).ln();
        ratio(a.links, b.links) / ratio(a.elements, b.elements)
    };
    let first = links.iter().find(|r| r.elements >= 500).expect("measured");
    let last = links.last().expect("measured");
    eprintln!("{name}: links grow as elements to the {:.2}", slope(first, last));
    for (what, k) in [("flat", 0), ("smooth", 1)] {
        for run in full.iter().filter(|r| r.elements >= 2000) {
            let better = links.windows(2).find(|w| w[1].errors[k] <= run.errors[k]);
            let Some([a, b]) = better else { continue };
            let t =
                (run.errors[k] / a.errors[k]).ln() / (b.errors[k] / a.errors[k]).ln();
            let seconds = a.seconds * (b.seconds / a.seconds).powf(t.max(0.0));
            eprintln!(
                "{name}: {} {} elements, {what} error {:.2e} in {:.2} s; links in {seconds:.2} \
                 s, {:.1} times sooner",
                run.method,
                run.elements,
                run.errors[k],
                run.seconds,
                run.seconds / seconds
            );
        }
    }
}

/// The closed unit cube of reflectance ½ whose top emits 1 W/m².
fn lit_cube() -> Scene {
    let cube = built_in("furnace").expect("a built-in scene");
    let grey = |emission| {
        let diffuse = Rgb::splat(0.5);
        let coefficients = Coefficients { emission, diffuse, ..Default::default() };
        Material::new("grey", coefficients).expect("passive")
    };
    let lit = |f: &Face| f.outline.iter().all(|v| v.z > 0.5);
    let face = |f: Face| Face { material: MaterialId(lit(&f).into()), ..f };
    let faces = cube.faces.into_iter().map(face).collect();
    let materials = vec![grey(Rgb::ZERO), grey(Rgb::ONE)];
    Scene::assemble("lit cube", materials, faces, None).expect("fit").0
}

/// What the light truly is at some points.
struct Reference {
    points: Vec<(u32, DVec3, f64, Rgb)>,
    reflected: Rgb,
}

impl Reference {
    fn of(scene: &Scene, edge: f64) -> Reference {
        let mesh = Mesh::uniform(scene, edge);
        let n = mesh.elements.len();
        eprintln!("reference: {n} elements");
        let factors = Analytic::new(scene, &mesh, 0.02 / n as f64, 0).sharp();
        let factors = factors.without_losses().matrix(&|| {});
        let radiosity = gathered(scene, &mesh, &factors, 1e-6);
        let area: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
        let blockers = Blockers::of(scene);
        let surfaces = (0u32..).zip(&scene.surfaces);
        let lit = surfaces.filter(|(_, s)| scene.material(s).diffuse() != Rgb::ZERO);
        let places = lit.flat_map(|(id, s)| {
            let count = (1500.0 * s.polygon.area() / area).ceil() as usize;
            let places = Stream::named(7, &[id.into()]).points(count);
            let share = s.polygon.area() / count as f64;
            places.map(move |u| (id, s.polygon.point_at(u), share))
        });
        let places: Vec<(u32, DVec3, f64)> = places.collect();
        let truth = |(id, x, share): (u32, DVec3, f64)| {
            let surface = &scene.surfaces[id as usize];
            let n = surface.polygon.normal();
            let mut h = Rgb::ZERO;
            // Of its own surface a point sees nothing, but for rounding.
            for patch in mesh.patches.iter().filter(|p| p.surface != id) {
                let wall = &scene.surfaces[patch.surface as usize].polygon;
                let point = dot(x, n);
                let past = blockers.between(&point, wall);
                for k in patch.elements.clone() {
                    let e = &mesh.elements[k as usize].polygon;
                    h += lambert_visible(x, n, e, &past) * radiosity[k as usize];
                }
            }
            (id, x, share, scene.material(surface).diffuse() * h)
        };
        let points: Vec<_> = places.into_par_iter().map(truth).collect();
        let reflected = points.iter().map(|p| p.2 * p.3 * p.3).sum();
        Reference { points, reflected }
    }

    /// The errors of the flat and of the smooth field, worst channel.
    fn errors(
        &self,
        scene: &Scene,
        mesh: &Mesh,
        radiosity: &[Rgb],
        smooth: &[Rgb],
    ) -> [f64; 2] {
        let mut of_surface = vec![Vec::new(); scene.surfaces.len()];
        for (k, e) in mesh.elements.iter().enumerate() {
            of_surface[mesh.surface_of(e) as usize].push(k);
        }
        let mut sums = [Rgb::ZERO; 2];
        for &(id, x, share, truth) in &self.points {
            let own = &of_surface[id as usize];
            let holds = |&&k: &&usize| mesh.elements[k].polygon.contains(x, 1e-9);
            let k = *own.iter().find(holds).expect("elements cover surfaces");
            let e = scene.material(&scene.surfaces[id as usize]).emission();
            let shown = mesh.value_at(&mesh.elements[k], x, smooth);
            for (sum, b) in sums.iter_mut().zip([radiosity[k], shown]) {
                let off = b - e - truth;
                *sum += share * off * off;
            }
        }
        sums.map(|sum| (sum / self.reflected).max_element().sqrt())
    }
}

/// A surface so small that it is a point.
fn dot(x: DVec3, n: DVec3) -> Polygon {
    let frame = Frame::about(n);
    let corner = |k: f64| {
        let (s, c) = (k * std::f64::consts::TAU / 3.0).sin_cos();
        x + 1e-6 * (c * frame.x + s * frame.y)
    };
    Polygon::new([0.0, 1.0, 2.0].map(corner).to_vec()).expect("three corners")
}

fn gathered(scene: &Scene, mesh: &Mesh, factors: &Matrix, accuracy: f64) -> Vec<Rgb> {
    let enclosure = Enclosure::of(scene, mesh);
    let mut solver = GaussSeidel::new(&enclosure, factors);
    solver.run(contraction(&enclosure, factors), accuracy, 10_000);
    solver.radiosity().to_vec()
}

/// What some work leaves, and its processor seconds.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = ThreadTime::now();
    let done = work();
    (done, start.elapsed().as_secs_f64())
}

fn links(name: &str, scene: &Scene, reference: &Reference) -> Vec<Run> {
    let run = |error: f64| {
        let options = HierarchyOptions::aiming_at(error, scene);
        let (found, seconds) =
            timed(|| solve_hierarchy(scene, &options, &|_, _, _| {}));
        let Hierarchical { mesh, radiosity, vertex_radiosity, links, .. } = &found;
        let errors = reference.errors(scene, mesh, radiosity, vertex_radiosity);
        let (method, elements) = ("links", mesh.elements.len());
        let run = Run { method, elements, links: *links, seconds, errors };
        run.print(name);
        run
    };
    [0.16, 0.11, 0.08, 0.057, 0.04, 0.028, 0.02, 0.014, 0.01, 0.007].map(run).into()
}

fn full(name: &str, scene: &Scene, reference: &Reference) -> Vec<Run> {
    let area: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
    let mut runs = Vec::new();
    for method in ["analytic matrix", "hemicube matrix"] {
        for elements in [250.0, 500.0, 1000.0, 2000.0, 4000.0_f64] {
            let run = || {
                let mesh = Mesh::uniform(scene, (area / elements).sqrt());
                let n = mesh.elements.len();
                let factors = if method == "analytic matrix" {
                    let tolerance = 0.02 / n as f64;
                    Analytic::new(scene, &mesh, tolerance, 0).sharp().matrix(&|| {})
                } else {
                    Hemicube::new(&mesh, 256).matrix(&|| {})
                };
                let radiosity = gathered(scene, &mesh, &factors, 1e-3);
                let links = factors.rows().iter().map(|r| r.factors().len()).sum();
                (mesh, radiosity, links)
            };
            let ((mesh, radiosity, links), seconds) = timed(run);
            let smooth = mesh.vertex_values(&radiosity);
            let errors = reference.errors(scene, &mesh, &radiosity, &smooth);
            let elements = mesh.elements.len();
            let run = Run { method, elements, links, seconds, errors };
            run.print(name);
            runs.push(run);
        }
    }
    runs
}
