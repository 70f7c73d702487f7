//! Scaling: time and memory against the size of the scene. What doubles when the scene
//! doubles, what grows fourfold, and what hardly at all.
//!
//! ```text
//! time ~ sizeᵖ         p by least squares of the logarithms
//! ```
//! Nothing is judged here: errors stand as NaN.

use crate::chart::{
    Bench, ChartView, Column, Contest, Method, Suite, Trial, Verdict, WorkDone,
};
use crate::field::{Pass1, Smooth};
use crate::film::Shot;
use crate::form_factor::analytic::Analytic;
use crate::form_factor::hemicube::Hemicube;
use crate::form_factor::{FormFactors, Matrix, ray_from};
use crate::geometry::{Frame, Polygon, Ray, Rgb};
use crate::mesh::{ElementId, Mesh};
use crate::random::Stream;
use crate::room::Room;
use crate::scene::{Face, MaterialId, Scene, built_in};
use crate::solve::hierarchy::{HierarchyOptions, Link, solve_hierarchy};
use crate::solve::{Enclosure, GaussSeidel, Solver};
use crate::visibility::Visibility;

/// This suite.
pub const SUITE: Suite = Suite {
    name: "scaling",
    about: "time and memory against the size of the scene",
    measure,
    views: &[
        view("scaling-stages", "Time of each stage of the pipeline", |t| {
            t.scene == STAGES[0]
        }),
        ChartView {
            upward: (Column::Memory, "bytes held at most"),
            ..view("scaling-memory", "Memory of each stage of the pipeline", |t| {
                t.scene == STAGES[0]
            })
        },
        ChartView {
            across: (Column::Setting, "faces"),
            upward: (Column::Seconds, "CPU seconds for 40 rows"),
            ..view("scaling-rows", "Time to find rows of form factors", |t| {
                ROWS.contains(&t.scene.as_str())
            })
        },
        ChartView {
            across: (Column::Setting, "triangles"),
            ..view(
                "scaling-rays",
                "Time of 20 000 rays, and of making them ready",
                |t| t.scene == TRIANGLES,
            )
        },
        ChartView {
            across: (Column::Setting, "surfaces"),
            ..view("scaling-surfaces", "Time to solve a room of many surfaces", |t| {
                t.scene == SURFACES
            })
        },
    ],
};

const fn view(
    file: &'static str,
    title: &'static str,
    shows: fn(&Trial) -> bool,
) -> ChartView {
    ChartView {
        file,
        title,
        across: (Column::Setting, "elements"),
        upward: (Column::Seconds, "CPU seconds"),
        least: 0.0,
        shows,
    }
}

/// Scenes whose stages are timed, and their names among the built-in ones.
pub const STAGES: [&str; 2] = ["Cornell box", "indirect room"];
const BUILT_IN: [&str; 2] = ["cornell", "indirect-room"];

/// The stages, in order.
pub const STAGE: [&str; 4] = ["split", "form factors", "solve", "render"];

/// Tiled scenes whose rows are timed: with nothing in the way, and with two blocks.
pub const ROWS: [&str; 2] = ["empty box", "Cornell room"];
const TILED: [&str; 2] = ["furnace", "cornell-regular"];

/// Tiles that rays are cast at.
pub const TRIANGLES: &str = "tiles of the Cornell room";

/// Tiles that are surfaces of their own, and solved.
pub const SURFACES: &str = "Cornell room of tiles";

/// Rows in a trial.
pub const ROWS_TIMED: usize = 40;

/// Rays in a trial.
pub const RAYS: usize = 20_000;

fn measure(bench: &Bench) -> Vec<Trial> {
    let mut trials = vec![];
    for (name, of) in STAGES.into_iter().zip(BUILT_IN) {
        let sizes = if of == BUILT_IN[0] { &ELEMENTS[..] } else { &ELEMENTS[..5] };
        trials.extend(stages(name, &built(of), sizes, bench));
    }
    for (name, of) in ROWS.into_iter().zip(TILED) {
        let sizes = [100.0, 300.0, 1e3, 3e3, 1e4, 2e4];
        trials.extend(rows(name, &built(of), &sizes, bench));
    }
    let room = built(TILED[1]);
    trials.extend(rays(&room, &[100.0, 1e3, 1e4, 1e5], bench));
    trials.extend(surfaces(&room, &[30.0, 100.0, 300.0, 700.0], bench));
    trials
}

fn built(name: &str) -> Scene {
    built_in(name).expect("it is built in")
}

/// Scaling asks for no truth.
fn contest<'a>(scene: &str) -> Contest<'a, ()> {
    Contest::new(scene, 0.0, |()| Verdict::of(f64::NAN))
}

/// Scenes, meshes or whatever is made ready, each with its size.
type BySize<T> = Vec<(usize, T)>;

/// A method whose settings are the sizes of what is ready.
fn over<'a, T>(
    name: &str,
    ready: &'a BySize<T>,
    run: impl Fn(&T) -> WorkDone + 'a,
) -> Method<'a, ()> {
    let sizes: Vec<f64> = ready.iter().map(|(n, _)| *n as f64).collect();
    Method::new(name, &sizes, move |size, _| {
        let this = ready.iter().find(|(n, _)| *n as f64 == size);
        ((), run(&this.expect("it is a setting").1))
    })
}

/// Elements of the meshes, about.
const ELEMENTS: [f64; 6] = [60.0, 200.0, 400.0, 1200.0, 2500.0, 5000.0];

/// All that the stages find, for each to begin where the one before has ended.
struct Solved {
    /// As they were asked for.
    elements: f64,
    mesh: Mesh,
    enclosure: Enclosure,
    factors: Matrix,
    radiosity: Vec<Rgb>,
}

/// Cells along an edge of the hemicubes.
const RESOLUTION: u32 = 256;

/// The solver stops when its own error is below this.
const ACCURACY: f64 = 1e-3;

/// Split, form factors, solve and render, one by one.
pub fn stages(name: &str, scene: &Scene, sizes: &[f64], bench: &Bench) -> Vec<Trial> {
    let solved = |&elements: &f64| {
        let mesh = even(scene, elements);
        let enclosure = Enclosure::of(scene, &mesh);
        let factors = Hemicube::new(&mesh, RESOLUTION).matrix(&|| ());
        let radiosity = solve(&enclosure, &factors).0;
        let n = mesh.elements.len();
        (n, Solved { elements, mesh, enclosure, factors, radiosity })
    };
    let ready: BySize<Solved> = sizes.iter().map(solved).collect();
    let shot = Shot { camera: scene.camera, width: 512, height: 512, samples: 1 };
    contest(name)
        .with(over(STAGE[0], &ready, |r| {
            let n = even(scene, r.elements).elements.len();
            WorkDone {
                bytes: (n * size_of::<crate::mesh::Element>()) as u64,
                ..WorkDone::default()
            }
        }))
        .with(over(STAGE[1], &ready, |r| {
            let n = r.mesh.elements.len() as u64;
            let factors = Hemicube::new(&r.mesh, RESOLUTION).matrix(&|| ());
            let kept: usize = factors.rows().iter().map(|r| r.factors().len()).sum();
            let bytes = (kept * size_of::<(u32, f64)>()) as u64;
            WorkDone {
                factors: n * n,
                pixels: n * cells(RESOLUTION),
                bytes,
                ..WorkDone::default()
            }
        }))
        .with(over(STAGE[2], &ready, |r| {
            let steps = solve(&r.enclosure, &r.factors).1 as u64;
            WorkDone { steps, ..WorkDone::default() }
        }))
        .with(over(STAGE[3], &ready, |r| {
            let _ = shot.smooth(&r.mesh, &r.mesh.vertex_values(&r.radiosity));
            WorkDone { pixels: 512 * 512, ..WorkDone::default() }
        }))
        .run(SUITE.name, bench)
}

/// Cells of a hemicube.
fn cells(resolution: u32) -> u64 {
    3 * u64::from(resolution).pow(2)
}

fn solve(enclosure: &Enclosure, factors: &Matrix) -> (Vec<Rgb>, usize) {
    let contraction = enclosure.largest_reflectance().max_element();
    let mut solver = GaussSeidel::new(enclosure, factors);
    let done = solver.run(contraction, ACCURACY, 1000);
    (solver.radiosity().to_vec(), done.steps)
}

/// A scene of about so many faces: the elements of an even mesh, each a face of its own in
/// the material that it had.
pub fn tiled(scene: &Scene, faces: f64) -> Scene {
    let mesh = even(scene, faces);
    let face = |e: &crate::mesh::Element| Face {
        outline: e.polygon.vertices().to_vec(),
        material: MaterialId(mesh.patch_of(e).material.0),
    };
    let faces = mesh.elements.iter().map(face).collect();
    let materials = scene.materials.clone();
    let tiles = Scene::assemble("tiles", materials, faces, None);
    tiles.expect("elements are fit").0
}

fn even(scene: &Scene, elements: f64) -> Mesh {
    let area: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
    Mesh::uniform(scene, (area / elements).sqrt())
}

/// A scene of tiles, and its mesh of whole faces.
struct Tiles {
    scene: Scene,
    mesh: Mesh,
}

impl Tiles {
    fn analytic(&self) -> Analytic {
        Analytic::new(&self.scene, &self.mesh, 1e-5, 0).without_losses()
    }
}

/// The scene in tiles, about so many.
fn tiles(scene: &Scene, sizes: &[f64]) -> BySize<Tiles> {
    let of = |&faces: &f64| {
        let scene = tiled(scene, faces);
        let mesh = Mesh::whole(&scene);
        (mesh.elements.len(), Tiles { scene, mesh })
    };
    sizes.iter().map(of).collect()
}

/// Rows of factors, once all is ready to find them.
pub fn rows(name: &str, scene: &Scene, sizes: &[f64], bench: &Bench) -> Vec<Trial> {
    let tiles = tiles(scene, sizes);
    let analytic: BySize<Analytic> =
        tiles.iter().map(|(n, t)| (*n, t.analytic())).collect();
    let cubes: BySize<Hemicube> =
        tiles.iter().map(|(n, t)| (*n, Hemicube::new(&t.mesh, RESOLUTION))).collect();
    let pixels = ROWS_TIMED as u64 * cells(RESOLUTION);
    contest(name)
        .with(over("analytic", &analytic, |factors| some_rows(factors)))
        .with(over("hemicubes", &cubes, |factors| WorkDone {
            pixels,
            ..some_rows(factors)
        }))
        .run(SUITE.name, bench)
}

/// Some of all rows, spread evenly.
fn some_rows(factors: &dyn FormFactors) -> WorkDone {
    let n = factors.len();
    let mut row = vec![0.0; n];
    for k in 0..ROWS_TIMED {
        factors.row(ElementId((k * n / ROWS_TIMED) as u32), &mut row);
    }
    WorkDone { factors: (ROWS_TIMED * n) as u64, ..WorkDone::default() }
}

/// Triangles, and rays that start on them.
struct Targets {
    polygons: Vec<Polygon>,
    all: Visibility,
    rays: Vec<(u32, Ray)>,
}

/// The scene in about so many polygons, and how many triangles that is.
fn targets(scene: &Scene, polygons: f64) -> (usize, Targets) {
    let polygons: Vec<Polygon> = even(scene, polygons).polygons().cloned().collect();
    let all = Visibility::new(&polygons);
    let ray = |[which, a, b, c, d]: [f64; 5]| {
        let k = (which * polygons.len() as f64) as usize;
        let frame = Frame::about(polygons[k].normal());
        (k as u32, ray_from(&polygons[k], &frame, [a, b, c, d]))
    };
    let rays = Stream::named(0, &[]).points(RAYS).map(ray).collect();
    let triangles = polygons.iter().map(|p| p.vertices().len() - 2).sum();
    (triangles, Targets { rays, all, polygons })
}

/// Rays to the first thing that they meet.
pub fn rays(scene: &Scene, sizes: &[f64], bench: &Bench) -> Vec<Trial> {
    let ready: BySize<Targets> = sizes.iter().map(|n| targets(scene, *n)).collect();
    contest(TRIANGLES)
        .with(over("making ready", &ready, |t| {
            Visibility::new(&t.polygons);
            WorkDone::default()
        }))
        .with(over("rays", &ready, |t| {
            let met = |(k, ray): &&(u32, Ray)| t.all.closest(ray, Some(*k)).is_some();
            let met = t.rays.iter().filter(met).count();
            WorkDone { rays: met as u64, ..WorkDone::default() }
        }))
        .run(SUITE.name, bench)
}

/// The error asked for where surfaces are counted.
const ASKED: f64 = 0.1;

/// Rooms of ever more surfaces, asked for the same error.
pub fn surfaces(scene: &Scene, sizes: &[f64], bench: &Bench) -> Vec<Trial> {
    let tiles = tiles(scene, sizes);
    contest(SURFACES)
        .with(over("links", &tiles, |t| {
            let options = HierarchyOptions::aiming_at(ASKED, &t.scene);
            let found = solve_hierarchy(&t.scene, &options, &|_, _, _| {});
            let (factors, steps) = (found.links as u64, found.steps as u64);
            let bytes = (found.links * size_of::<Link>()) as u64;
            WorkDone { factors, steps, bytes, ..WorkDone::default() }
        }))
        .with(over("smooth light", &tiles, |t| {
            let room = Room::of(&t.scene);
            let how = Smooth.first(&room, ASKED);
            let found = Smooth.field(&room, &how, &crate::work::Work::quiet());
            let (cubes, patches) = (found.rows as u64, found.patches as u64);
            let pixels = cubes * cells(how.hemicube);
            let steps = found.steps as u64;
            WorkDone { factors: cubes * patches, pixels, steps, ..WorkDone::default() }
        }))
        .with(over("hemicube matrix", &tiles, |t| {
            let enclosure = Enclosure::of(&t.scene, &t.mesh);
            let factors = Hemicube::new(&t.mesh, RESOLUTION).matrix(&|| ());
            let steps = solve(&enclosure, &factors).1 as u64;
            let n = t.mesh.elements.len() as u64;
            WorkDone {
                factors: n * n,
                pixels: n * cells(RESOLUTION),
                steps,
                ..WorkDone::default()
            }
        }))
        .run(SUITE.name, bench)
}
