//! Meshes: elements all alike, elements where they pay, links between nodes of any size, and
//! smooth light - the same rooms, held against the same light.

use super::field::{LinearLight, Truth};
use crate::chart::{Bench, ChartView, Column, Contest, Method, Suite, Trial, WorkDone};
use crate::field::{Pass1, Smooth};
use crate::form_factor::analytic::Analytic;
use crate::form_factor::hemicube::Hemicube;
use crate::form_factor::{FormFactors, Matrix};
use crate::geometry::Rgb;
use crate::material::{Coefficients, Material};
use crate::mesh::{Element, Mesh};
use crate::room::{Direct, Room};
use crate::scene::{Face, MaterialId, Scene, built_in};
use crate::solve::hierarchy::{HierarchyOptions, Link, solve_hierarchy};
use crate::solve::{
    Enclosure, GaussSeidel, OnElements, Oracle, Solver, Substructure, contraction,
};

/// This suite.
pub const SUITE: Suite = Suite {
    name: "meshes",
    about: "uniform, adaptive and hierarchical meshes of the same rooms",
    measure,
    views: &[
        time("meshes-cornell", |t| t.scene == CORNELL && t.method != ALL),
        time("meshes-indirect", |t| t.scene == INDIRECT && t.method != ALL),
        time("meshes-cube", |t| t.scene == CUBE && t.method != ALL),
        ChartView {
            title: "Relative error of the light shown against the number of elements, when \
                    all are split and when those are that the oracle marks",
            across: (Column::Setting, "elements"),
            ..time("meshes-elements", |t| {
                t.scene != CUBE && [ALL, MARKED].contains(&t.method.as_str())
            })
        },
        ChartView {
            title: "Links, and factors, against the number of elements",
            across: (Column::Setting, "elements"),
            upward: (Column::Factors, "links or factors"),
            ..time("meshes-links", |t| {
                t.scene == CORNELL
                    && [HEMICUBES, MARKED, LINKS].contains(&t.method.as_str())
            })
        },
        ChartView {
            title: "Relative error of the light shown against the memory to find it",
            across: (Column::Memory, "bytes held at most"),
            ..time("meshes-memory", |t| t.scene == CORNELL && t.method != ALL)
        },
    ],
};

const fn time(file: &'static str, shows: fn(&Trial) -> bool) -> ChartView {
    ChartView {
        file,
        title: "Relative error of the light shown against the time to find it; marks are \
                labelled by elements",
        across: (Column::Seconds, "CPU seconds"),
        upward: (Column::Error, "relative error"),
        least: 1e-4,
        shows,
    }
}

/// Scenes of the suite.
pub const CORNELL: &str = "Cornell box";
/// See [`CORNELL`].
pub const INDIRECT: &str = "indirect room";
/// See [`CORNELL`].
pub const CUBE: &str = "lit cube";

/// Methods of the suite: even elements and all factors.
pub const ANALYTIC: &str = "analytic matrix";
/// See [`ANALYTIC`].
pub const HEMICUBES: &str = "hemicube matrix";
/// Patches, and elements of one size.
pub const ALL: &str = "all are split";
/// Patches, and elements split where the oracle says.
pub const MARKED: &str = "marked are split";
/// The hierarchy.
pub const LINKS: &str = "links";
/// Direct light exactly, the rest linear across patches.
pub const SMOOTH: &str = "smooth light";

/// The scene of that name.
pub fn scene(name: &str) -> Option<Scene> {
    match name {
        CORNELL => built_in("cornell").ok(),
        INDIRECT => built_in("indirect-room").ok(),
        CUBE => Some(lit_cube()),
        _ => None,
    }
}

/// The closed unit cube of reflectance ½ whose top emits 1 W/m²: nothing hides anything.
fn lit_cube() -> Scene {
    let cube = built_in("furnace").expect("`furnace` is built in");
    let grey = |emission| {
        let diffuse = Rgb::splat(0.5);
        let coefficients = Coefficients { emission, diffuse, ..Default::default() };
        Material::new("grey", coefficients).expect("a half is passive")
    };
    let lit = |f: &Face| f.outline.iter().all(|v| v.z > 0.5);
    let face = |f: Face| Face { material: MaterialId(lit(&f).into()), ..f };
    let faces = cube.faces.into_iter().map(face).collect();
    let materials = vec![grey(Rgb::ZERO), grey(Rgb::ONE)];
    Scene::assemble("lit cube", materials, faces, None).expect("cubes are fit").0
}

/// How far each method goes: its finest settings are left out in tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// The error asked for of the truth.
    pub truth: f64,
    /// Elements of even meshes at most, about.
    pub even: f64,
    /// Rounds of splitting.
    pub rounds: usize,
    /// The smallest error that links and smooth light are asked for.
    pub finest: f64,
}

impl Reach {
    /// That of the charts.
    pub const WHOLE: Reach =
        Reach { truth: 0.003, even: 2000.0, rounds: 4, finest: 0.01 };
}

fn measure(bench: &Bench) -> Vec<Trial> {
    let all = [CORNELL, INDIRECT, CUBE];
    all.iter().flat_map(|name| contest(name, Reach::WHOLE, bench)).collect()
}

/// All methods on the scene of this name.
pub fn contest(name: &str, reach: Reach, bench: &Bench) -> Vec<Trial> {
    let Some(scene) = scene(name) else { return vec![] };
    let truth = Truth::of(&scene, reach.truth);
    Contest::new(name, truth.uncertainty, |light: &LinearLight| truth.judge(light))
        .with(even(&scene, ANALYTIC, 0.5 * reach.even))
        .with(even(&scene, HEMICUBES, reach.even))
        .with(substructured(&scene, ALL, reach.rounds.min(3)))
        .with(substructured(&scene, MARKED, reach.rounds))
        .with(linked(&scene, 2.0 * reach.finest))
        .with(smoothed(&scene, reach.finest))
        .run(SUITE.name, bench)
}

/// A method whose settings are elements, though it is asked otherwise: for each number of
/// elements what it is asked.
fn by_elements<'a, Q: 'a>(
    name: &str,
    mut asked: Vec<(usize, Q)>,
    run: impl Fn(&Q) -> (LinearLight, WorkDone) + 'a,
) -> Method<'a, LinearLight> {
    asked.dedup_by_key(|(n, _)| *n);
    let settings: Vec<f64> = asked.iter().map(|(n, _)| *n as f64).collect();
    Method::new(name, &settings, move |elements, _| {
        let this = asked.iter().find(|(n, _)| *n as f64 == elements);
        run(&this.expect("it is a setting").1)
    })
}

/// Elements of one size, and all factors between them.
fn even<'a>(
    scene: &'a Scene,
    name: &'static str,
    most: f64,
) -> Method<'a, LinearLight> {
    let area: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
    let counts = [250.0, 500.0, 1000.0, 2000.0].into_iter();
    let edges = counts.filter(|n| *n <= most).map(|n| (area / n).sqrt());
    let asked = edges.map(|edge| (Mesh::uniform(scene, edge).elements.len(), edge));
    by_elements(name, asked.collect(), move |&edge| {
        let mesh = Mesh::uniform(scene, edge);
        let n = mesh.elements.len() as u64;
        let (factors, pixels) = match name {
            ANALYTIC => {
                let tolerance = 0.02 / n as f64;
                (Analytic::new(scene, &mesh, tolerance, 0).sharp().matrix(&|| {}), 0)
            }
            _ => (Hemicube::new(&mesh, 256).matrix(&|| {}), n * cells(256)),
        };
        let kept: usize = factors.rows().iter().map(|r| r.factors().len()).sum();
        let bytes = (kept * size_of::<(u32, f64)>()) as u64;
        let (light, steps) = gathered(scene, mesh, &factors);
        (
            light,
            WorkDone { factors: n * n, pixels, steps, bytes, ..WorkDone::default() },
        )
    })
}

/// Cells of a hemicube.
fn cells(resolution: u32) -> u64 {
    3 * u64::from(resolution).pow(2)
}

/// The solver's own error, far below that of any mesh here.
const ACCURACY: f64 = 1e-3;

fn gathered(scene: &Scene, mesh: Mesh, factors: &Matrix) -> (LinearLight, u64) {
    let enclosure = Enclosure::of(scene, &mesh);
    let mut solver = GaussSeidel::new(&enclosure, factors);
    let done = solver.run(contraction(&enclosure, factors), ACCURACY, 10_000);
    let radiosity = mesh.vertex_values(solver.radiosity());
    (LinearLight { mesh, radiosity, ledger: done.last.ledger }, done.steps as u64)
}

// ANCHOR: rounds
/// Patches of the scene, split `rounds` times; stops when nothing is marked.
#[derive(Debug)]
pub struct Rounds<'a> {
    scene: &'a Scene,
    patches: Mesh,
    oracle: Option<Oracle>,
}
// ANCHOR_END: rounds

/// After some rounds.
#[derive(Debug)]
pub struct Round {
    /// Patches and elements.
    pub mesh: Mesh,
    /// Their light.
    pub light: OnElements,
    /// The factors that were computed until then.
    pub factors: usize,
}

/// Longest edge of a patch, relative to the scene's diagonal.
pub const EDGE: f64 = 0.12;

/// Cells along an edge of the hemicubes of elements.
pub const RESOLUTION: u32 = 128;

/// The error that the oracle allows.
pub const TOLERANCE: f64 = 0.04;

/// How often a patch may be split.
pub const DEPTH: i32 = 4;

impl<'a> Rounds<'a> {
    /// All elements are split, or those that the oracle marks.
    pub fn new(scene: &'a Scene, marked: bool) -> Rounds<'a> {
        let edge = EDGE * scene.diagonal();
        let smallest = 1.01 * edge * edge / 4_f64.powi(DEPTH);
        let oracle = marked.then_some(Oracle { tolerance: TOLERANCE, smallest });
        Rounds { scene, patches: Mesh::patched(scene, edge), oracle }
    }

    /// What stands after each of `rounds`, the first of which splits nothing.
    pub fn run(&self, rounds: usize) -> Vec<Round> {
        let cube = Hemicube::new(&self.patches, RESOLUTION).turned(1);
        let sees = |e: &Element, row: &mut [f64]| {
            cube.at(e.polygon.centroid(), e.polygon.normal(), row)
        };
        let mut both = Substructure::new(self.scene, self.patches.clone(), &sees);
        let direct = Direct::of(self.scene);
        let mut done = Vec::new();
        loop {
            let light = both.solve(1e-4);
            let marks = match self.oracle {
                None => vec![true; both.mesh().elements.len()],
                Some(oracle) => {
                    let rise = |e: &Element| direct.rise(&e.polygon);
                    oracle.marks(self.scene, both.mesh(), &light.radiosity, &rise)
                }
            };
            let (mesh, factors) = (both.mesh().clone(), both.factors_computed());
            done.push(Round { mesh, light, factors });
            if done.len() == rounds || !marks.contains(&true) {
                return done;
            }
            both.split(&marks);
        }
    }
}

fn substructured<'a>(
    scene: &'a Scene,
    name: &str,
    rounds: usize,
) -> Method<'a, LinearLight> {
    let splits = Rounds::new(scene, name == MARKED);
    let sizes = splits.run(rounds).into_iter().map(|r| r.mesh.elements.len());
    let asked = sizes.zip(1..).collect();
    by_elements(name, asked, move |&round| {
        let last = splits.run(round).pop().expect("there is a round");
        let Round { mesh, light, factors } = last;
        let rows = (factors / mesh.patches.len()) as u64;
        let kept = mesh.elements.len() * mesh.patches.len();
        let work = WorkDone {
            factors: factors as u64,
            pixels: rows * cells(RESOLUTION),
            steps: light.outcome.steps as u64,
            bytes: (kept * size_of::<(u32, f64)>()) as u64,
            ..WorkDone::default()
        };
        let radiosity = mesh.vertex_values(&light.radiosity);
        (LinearLight { mesh, radiosity, ledger: light.outcome.last.ledger }, work)
    })
}

/// Errors that links are asked for.
const LINKED: [f64; 6] = [0.16, 0.11, 0.08, 0.057, 0.04, 0.02];

fn linked(scene: &Scene, finest: f64) -> Method<'_, LinearLight> {
    let solved = |error: f64| {
        let options = HierarchyOptions::aiming_at(error, scene);
        solve_hierarchy(scene, &options, &|_, _, _| {})
    };
    let errors = LINKED.into_iter().filter(|e| *e >= finest);
    let asked = errors.map(|e| (solved(e).mesh.elements.len(), e)).collect();
    by_elements(LINKS, asked, move |&error| {
        let found = solved(error);
        let work = WorkDone {
            factors: found.links as u64,
            steps: found.steps as u64,
            bytes: (found.links * size_of::<Link>()) as u64,
            ..WorkDone::default()
        };
        let radiosity = found.vertex_radiosity;
        (LinearLight { mesh: found.mesh, radiosity, ledger: found.ledger }, work)
    })
}

/// Errors that smooth light is asked for.
const SMOOTHED: [f64; 5] = [0.2, 0.1, 0.05, 0.02, 0.01];

fn smoothed(scene: &Scene, finest: f64) -> Method<'_, LinearLight> {
    let solved = |error: f64| Smooth::once(&Room::of(scene), error);
    let errors = SMOOTHED.into_iter().filter(|e| *e >= finest);
    let asked = errors.map(|e| (solved(e).mesh.elements.len(), e)).collect();
    by_elements(SMOOTH, asked, move |&error| {
        let found = solved(error);
        let cubes = found.rows as u64;
        let work = WorkDone {
            factors: cubes * found.patches as u64,
            pixels: cubes * cells(Smooth.first(&Room::of(scene), error).hemicube),
            steps: found.steps as u64,
            ..WorkDone::default()
        };
        (LinearLight::smooth(scene, found), work)
    })
}
