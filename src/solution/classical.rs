//! Pass 1 as a whole: mesh, factors, solver, certificate - and finer, until it suffices.

use crate::certificate::{Certificate, Sampling, certify};
use crate::form_factor::analytic::Analytic;
use crate::form_factor::cast::Cast;
use crate::form_factor::hemicube::Hemicube;
use crate::form_factor::{Cached, FormFactors};
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::scene::Scene;
use crate::solve::hierarchy::{Hierarchical, HierarchyOptions, solve_hierarchy};
use crate::solve::{
    Brightest, Enclosure, GaussSeidel, Ledger, Shoot, Solver, Step, contraction,
    error_bound,
};
use crate::virtual_world::{
    ExtendedAnalytic, ExtendedCast, ExtendedHemicube, VirtualWorld,
};
use crate::work::Progress;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How the equation is solved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Method {
    /// Gauss–Seidel over the whole matrix.
    Gather,
    /// Progressive shooting.
    #[default]
    Shoot,
    /// Links between nodes of any size, which bring their own mesh and form factors; on a
    /// mesh that is given, as [`Method::Gather`].
    Hierarchy,
}

/// How form factors are computed.
///
/// By default hemicubes of 256: on a mesh that suits a picture their error is small beside
/// the mesh's own, and a row takes a millisecond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Factors {
    /// Lambert's formula and cut blockers.
    Analytic,
    /// Rays: so many from each element.
    Sampling(usize),
    /// Hemicubes of this resolution.
    Hemicube(u32),
}

impl Default for Factors {
    fn default() -> Factors {
        Factors::Hemicube(256)
    }
}

/// What is asked of a solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The solver.
    pub method: Method,
    /// The form factors.
    pub factors: Factors,
    /// The largest certified error asked for, relative; see [`Certificate`].
    pub tolerance: f64,
    /// The most elements that may be used to reach it.
    pub most_elements: usize,
    /// Names the random streams.
    pub seed: u64,
    /// How many reflections in flat mirrors are followed: one, as in the lecture.
    pub levels: u32,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            method: Method::default(),
            factors: Factors::default(),
            tolerance: 0.01,
            most_elements: 4000,
            seed: 0,
            levels: 1,
        }
    }
}

/// The light of a scene.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The elements.
    pub mesh: Mesh,
    /// How many patches shone on each other: as many as elements, unless they were
    /// substructured.
    pub patches: usize,
    /// `B`, W/m², per element.
    pub radiosity: Vec<Rgb>,
    /// `H`, W/m², per element, on the front.
    pub irradiance: Vec<Rgb>,
    /// `B`, W/m², per vertex of the mesh: what smooth shading shows, and is certified.
    pub vertex_radiosity: Vec<Rgb>,
    /// `B` with the ambient guess, per element: for display only.
    pub displayed: Vec<Rgb>,
    /// Where the light went.
    pub ledger: Ledger,
    /// `‖r‖/‖B − E‖` of the discrete system.
    pub solver_residual: f64,
    /// How many sweeps or shots.
    pub steps: usize,
    /// How far the smooth field is from the truth.
    pub certificate: Certificate,
    /// Is the certified error below the tolerance asked for?
    pub converged: bool,
}

/// The solver's own error may be this share of the tolerance; the mesh has the rest.
const SOLVER_SHARE: f64 = 0.1;

/// Solves a scene: from a coarse mesh to ever finer ones, until the certificate meets the
/// tolerance or a finer mesh would have too many elements.
///
/// Deterministic: the same at any number of threads.
pub fn solve(scene: &Scene, options: &Options, progress: Progress) -> Solution {
    if options.method == Method::Hierarchy {
        return by_links(scene, options, progress);
    }
    let area: f64 = scene.surfaces.iter().map(|s| s.polygon.area()).sum();
    // 400 elements to begin with, or what the scene has anyway.
    let mut edge = (area / 400.0).sqrt();
    loop {
        let mesh = Mesh::uniform(scene, edge);
        let solution = solve_on(scene, mesh, options, progress);
        // The error of a field on a mesh of edge h falls no faster than h.
        let share = (options.tolerance / solution.certificate.high).clamp(0.4, 0.8);
        let mut finer = share * edge;
        while finer < edge
            && Mesh::count_uniform(scene, finer) > options.most_elements as f64
        {
            finer *= 1.02; // the finest mesh that is allowed
        }
        if solution.converged || finer > 0.9 * edge {
            return solution;
        }
        edge = finer;
    }
}

/// Solves a scene on a given mesh.
pub fn solve_on(
    scene: &Scene,
    mesh: Mesh,
    options: &Options,
    progress: Progress,
) -> Solution {
    let enclosure = Enclosure::of(scene, &mesh);
    let n = mesh.elements.len();
    let world = VirtualWorld::of(scene, options.levels);
    let solve_by = match options.method {
        Method::Gather | Method::Hierarchy => gather,
        Method::Shoot => shoot,
    };
    let solved = |channel: usize| {
        let method = method_of(scene, &mesh, &world, channel, options);
        solve_by(&enclosure, method.as_ref(), options, progress)
    };
    // Coloured mirrors: other factors for each colour.
    let light = match world.is_grey() {
        true => solved(0),
        false => Light::of_channels([0, 1, 2].map(solved)),
    };
    let Light { radiosity, irradiance, displayed, last, steps } = light;
    let vertex_radiosity = mesh.vertex_values(&radiosity);
    progress("certifying", 0, 1);
    let field = |id, x| mesh.value_at(mesh.element(id), x, &vertex_radiosity);
    let sampling = Sampling { seed: options.seed, ..Sampling::default() };
    let certificate = certify(scene, &mesh, &field, sampling);
    progress("certifying", 1, 1);
    Solution {
        patches: n,
        mesh,
        radiosity,
        irradiance,
        vertex_radiosity,
        displayed,
        ledger: last.ledger,
        solver_residual: last.residual,
        steps,
        certificate,
        converged: certificate.high <= options.tolerance,
    }
}

/// The form factors that are asked for: extended ones where there is a mirror or a pane.
fn method_of<'a>(
    scene: &Scene,
    mesh: &'a Mesh,
    world: &'a VirtualWorld,
    channel: usize,
    options: &Options,
) -> Box<dyn FormFactors + 'a> {
    let (seed, tolerance) = (options.seed, 0.02 / mesh.elements.len() as f64);
    if world.is_empty() {
        return match options.factors {
            Factors::Analytic => {
                Box::new(Analytic::new(scene, mesh, tolerance, seed).sharp())
            }
            Factors::Sampling(rays) => Box::new(Cast::new(mesh, rays, seed)),
            Factors::Hemicube(resolution) => Box::new(Hemicube::new(mesh, resolution)),
        };
    }
    match options.factors {
        Factors::Analytic => Box::new(ExtendedAnalytic::new(
            scene, mesh, world, channel, tolerance, seed,
        )),
        Factors::Sampling(rays) => {
            Box::new(ExtendedCast::new(mesh, world, channel, rays, seed))
        }
        Factors::Hemicube(resolution) => {
            Box::new(ExtendedHemicube::new(mesh, world, channel, resolution))
        }
    }
}

/// Links make do with so many times the elements that a matrix can have.
const MORE_BY_LINKS: usize = 25;

/// Solves over links, for ever smaller errors, until the certificate meets the tolerance
/// or there may be no more elements.
fn by_links(scene: &Scene, options: &Options, progress: Progress) -> Solution {
    let mut error = 2.0 * options.tolerance;
    loop {
        let asked = HierarchyOptions {
            most_elements: MORE_BY_LINKS.saturating_mul(options.most_elements),
            seed: options.seed,
            ..HierarchyOptions::aiming_at(error, scene)
        };
        let found = solve_hierarchy(scene, &asked, progress);
        let Hierarchical { mesh, radiosity, vertex_radiosity, .. } = found;
        progress("certifying", 0, 1);
        let field = |id, x| mesh.value_at(mesh.element(id), x, &vertex_radiosity);
        let sampling = Sampling { seed: options.seed, ..Sampling::default() };
        let certificate = certify(scene, &mesh, &field, sampling);
        progress("certifying", 1, 1);
        let converged = certificate.high <= options.tolerance;
        if converged || mesh.elements.len() >= asked.most_elements {
            return Solution {
                patches: mesh.elements.len(),
                mesh,
                displayed: radiosity.clone(),
                radiosity,
                irradiance: found.irradiance,
                vertex_radiosity,
                ledger: found.ledger,
                solver_residual: found.solver_residual,
                steps: found.steps,
                certificate,
                converged,
            };
        }
        error *= (options.tolerance / certificate.high).clamp(0.4, 0.8);
    }
}

/// What a solver leaves behind.
struct Light {
    radiosity: Vec<Rgb>,
    irradiance: Vec<Rgb>,
    displayed: Vec<Rgb>,
    last: Step,
    steps: usize,
}

impl Light {
    /// Of each of three solutions one channel.
    fn of_channels(all: [Light; 3]) -> Light {
        let [red, green, blue] = &all;
        let one = |x: Rgb, y: Rgb, z: Rgb| Rgb::new(x.x, y.y, z.z);
        let merged = |of: &dyn Fn(&Light) -> &[Rgb]| -> Vec<Rgb> {
            let pairs = of(red).iter().zip(of(green)).zip(of(blue));
            pairs.map(|((&x, &y), &z)| one(x, y, z)).collect()
        };
        let ledger = |of: fn(&Ledger) -> Rgb| {
            let [x, y, z] = [red, green, blue].map(|light| of(&light.last.ledger));
            one(x, y, z)
        };
        let worst = |m: f64, light: &Light| m.max(light.last.residual);
        Light {
            radiosity: merged(&|light| &light.radiosity),
            irradiance: merged(&|light| &light.irradiance),
            displayed: merged(&|light| &light.displayed),
            last: Step {
                ledger: Ledger {
                    emitted: ledger(|l| l.emitted),
                    absorbed: ledger(|l| l.absorbed),
                    escaped: ledger(|l| l.escaped),
                    unshot: ledger(|l| l.unshot),
                    imbalance: ledger(|l| l.imbalance),
                },
                residual: all.iter().fold(0.0, worst),
                shot: None,
            },
            steps: all.iter().map(|light| light.steps).sum(),
        }
    }
}

/// Steps a solver takes at the most, sweeps or shots.
const MOST_STEPS: usize = 200_000;

/// Is the solver's own error small beside what is asked for?
fn suffices(step: &Step, enclosure: &Enclosure, options: &Options) -> bool {
    let contraction = enclosure.largest_reflectance().max_element();
    let bound = error_bound(step.residual, contraction);
    bound <= SOLVER_SHARE * options.tolerance
}

fn gather(
    enclosure: &Enclosure,
    method: &dyn FormFactors,
    options: &Options,
    progress: Progress,
) -> Light {
    let n = enclosure.len();
    let rows = AtomicUsize::new(0);
    let matrix = method.matrix(&|| {
        progress("form factors", rows.fetch_add(1, Ordering::Relaxed) + 1, n);
    });
    let mut solver = GaussSeidel::new(enclosure, &matrix);
    let accuracy = SOLVER_SHARE * options.tolerance;
    let run = solver.run(contraction(enclosure, &matrix), accuracy, MOST_STEPS);
    let radiosity = solver.radiosity().to_vec();
    let irradiance = solver.irradiance().to_vec();
    let displayed = radiosity.clone();
    Light { displayed, radiosity, irradiance, last: run.last, steps: run.steps }
}

/// Rows are computed for this many of the brightest elements at once, one a thread.
const AHEAD: usize = 16;

fn shoot(
    enclosure: &Enclosure,
    method: &dyn FormFactors,
    options: &Options,
    progress: Progress,
) -> Light {
    let n = enclosure.len();
    let cached = Cached::new(method);
    let mut solver = Shoot::new(enclosure, &cached, Brightest::ByPower);
    let (mut last, mut steps) = (Step::default(), 0);
    while steps < MOST_STEPS {
        if steps % AHEAD == 0 {
            cached.prepare(&solver.brightest(AHEAD));
            progress("shooting", cached.computed(), n);
        }
        let Some(step) = solver.next() else { break };
        (last, steps) = (step, steps + 1);
        if suffices(&step, enclosure, options) {
            break;
        }
    }
    Light {
        radiosity: solver.radiosity().to_vec(),
        irradiance: solver.irradiance().to_vec(),
        displayed: solver.with_ambient(),
        last,
        steps,
    }
}
