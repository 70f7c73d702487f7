//! The lecture's methods: form factors between the elements of an even mesh, and a solver.

use super::cannot::{Cannot, Dropped, Feature};
use super::{Field, Fineness, Pass1};
use crate::form_factor::analytic::Analytic;
use crate::form_factor::cast::Cast;
use crate::form_factor::hemicube::Hemicube;
use crate::form_factor::{Cached, FormFactors};
use crate::geometry::Rgb;
use crate::mesh::Mesh;
use crate::room::Room;
use crate::scene::Scene;
use crate::solve::{
    Brightest, Enclosure, GaussSeidel, Ledger, Shoot, Solver, Step, contraction,
    error_bound,
};
use crate::virtual_world::{
    ExtendedAnalytic, ExtendedCast, ExtendedHemicube, VirtualWorld,
};
use crate::work::Work;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How the matrix equation is solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MatrixSolver {
    /// Gauss–Seidel over the whole matrix.
    Gather,
    /// Progressive shooting.
    #[default]
    Shoot,
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

/// A method of the lecture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Classical {
    /// The solver.
    pub solver: MatrixSolver,
    /// The form factors.
    pub factors: Factors,
    /// How many reflections in flat mirrors are followed: one, as in the lecture.
    pub levels: u32,
}

impl Default for Classical {
    fn default() -> Classical {
        let (solver, factors) = (MatrixSolver::default(), Factors::default());
        Classical { solver, factors, levels: 1 }
    }
}

/// Elements of the first mesh, or what the scene has anyway.
const FIRST_ELEMENTS: f64 = 400.0;

/// The most elements: a matrix has their square.
const MOST_ELEMENTS: usize = 4000;

/// The solver's own error may be this share of the tolerance; the mesh has the rest.
const SOLVER_SHARE: f64 = 0.1;

impl Classical {
    /// The same with these form factors.
    pub fn by(factors: Factors) -> Classical {
        Classical { factors, ..Classical::default() }
    }

    /// The light on a given mesh; the solver may leave an error of `accuracy`.
    ///
    /// Deterministic: the same at any number of threads.
    pub fn on(&self, room: &Room, mesh: Mesh, how: &Fineness, work: &Work) -> Field {
        let scene = room.scene;
        let enclosure = Enclosure::of(scene, &mesh);
        let world = VirtualWorld::of(scene, self.levels);
        let between = Between { scene, mesh: &mesh, seed: how.seed };
        let factors = |channel: usize| match world.is_empty() {
            true => between.plain(self.factors),
            false => between.extended(self.factors, &world, channel),
        };
        let solved = |channel: usize| match self.solver {
            MatrixSolver::Gather => gather(&enclosure, &*factors(channel), how, work),
            MatrixSolver::Shoot => shoot(&enclosure, &*factors(channel), how, work),
        };
        // Coloured mirrors: other factors for each colour.
        let light = match world.is_grey() {
            true => solved(0),
            false => Arrived::of_channels([0, 1, 2].map(solved)),
        };
        let Arrived { irradiance, last, steps } = light;
        let rows = mesh.elements.len();
        Field {
            ledger: last.ledger,
            solver_residual: last.residual,
            steps,
            rows,
            ..Field::constant(scene, mesh, irradiance)
        }
    }
}

/// Between which elements form factors are asked for, and what names their rays.
struct Between<'a> {
    scene: &'a Scene,
    mesh: &'a Mesh,
    seed: u64,
}

impl<'a> Between<'a> {
    /// Form factors of elements that see nothing but each other.
    fn plain(&self, by: Factors) -> Box<dyn FormFactors + 'a> {
        match by {
            Factors::Analytic => Box::new(self.analytic().sharp()),
            Factors::Sampling(rays) => Box::new(Cast::new(self.mesh, rays, self.seed)),
            Factors::Hemicube(resolution) => {
                Box::new(Hemicube::new(self.mesh, resolution))
            }
        }
    }

    /// Those where there are mirrors or panes, as light of one colour meets them.
    fn extended(
        &self,
        by: Factors,
        world: &'a VirtualWorld,
        channel: usize,
    ) -> Box<dyn FormFactors + 'a> {
        let mesh = self.mesh;
        match by {
            Factors::Analytic => {
                Box::new(ExtendedAnalytic::of(self.analytic(), mesh, world, channel))
            }
            Factors::Sampling(rays) => {
                Box::new(ExtendedCast::new(mesh, world, channel, rays, self.seed))
            }
            Factors::Hemicube(resolution) => {
                Box::new(ExtendedHemicube::new(mesh, world, channel, resolution))
            }
        }
    }

    /// Lambert's formula, to a fiftieth of what two of the elements exchange on average.
    fn analytic(&self) -> Analytic {
        let accuracy = 0.02 / self.mesh.elements.len() as f64;
        Analytic::new(self.scene, self.mesh, accuracy, self.seed)
    }
}

impl Pass1 for Classical {
    /// Flat mirrors, panes and sheets; neither the sky nor solid glass.
    fn knows(&self, room: &Room) -> Result<(), Cannot> {
        let name = match self.solver {
            MatrixSolver::Gather => "gather",
            MatrixSolver::Shoot => "shoot",
        };
        Cannot::check(name, room, &[Feature::Sky, Feature::Glass])
    }

    fn drops(&self, room: &Room) -> Option<Dropped> {
        Dropped::gloss(room)
    }

    fn first(&self, room: &Room, tolerance: f64) -> Fineness {
        let area = Mesh::area_in_scale(room.scene);
        Fineness {
            patch: (area / FIRST_ELEMENTS).sqrt(),
            solver: SOLVER_SHARE * tolerance,
            most_elements: MOST_ELEMENTS,
            ..super::Smooth.first(room, tolerance)
        }
    }

    /// The error of a field on a mesh of edge h falls no faster than h.
    fn finer(&self, room: &Room, last: &Fineness, share: f64) -> Option<Fineness> {
        let mut patch = share * last.patch;
        let count = |patch| Mesh::count_uniform(room.scene, patch);
        while patch < last.patch && count(patch) > last.most_elements as f64 {
            patch *= 1.02; // the finest mesh that is allowed
        }
        (patch <= 0.9 * last.patch).then_some(Fineness { patch, ..*last })
    }

    fn field(&self, room: &Room, how: &Fineness, work: &Work) -> Field {
        self.on(room, Mesh::uniform(room.scene, how.patch), how, work)
    }
}

/// What has arrived when a solver stops.
struct Arrived {
    irradiance: Vec<Rgb>,
    last: Step,
    steps: usize,
}

impl Arrived {
    /// Of each of three solutions one channel.
    fn of_channels(all: [Arrived; 3]) -> Arrived {
        let [red, green, blue] = &all;
        let one = |x: Rgb, y: Rgb, z: Rgb| Rgb::new(x.x, y.y, z.z);
        let ledger = |of: fn(&Ledger) -> Rgb| {
            let [x, y, z] = [red, green, blue].map(|light| of(&light.last.ledger));
            one(x, y, z)
        };
        let worst = |m: f64, light: &Arrived| m.max(light.last.residual);
        let [reds, greens, blues] = [red, green, blue].map(|light| &light.irradiance);
        let channels = reds.iter().zip(greens).zip(blues);
        Arrived {
            irradiance: channels.map(|((&x, &y), &z)| one(x, y, z)).collect(),
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

/// Is the solver's own error small enough?
fn suffices(step: &Step, enclosure: &Enclosure, how: &Fineness) -> bool {
    let contraction = enclosure.largest_reflectance().max_element();
    error_bound(step.residual, contraction) <= how.solver
}

fn gather(
    enclosure: &Enclosure,
    factors: &dyn FormFactors,
    how: &Fineness,
    work: &Work,
) -> Arrived {
    let n = enclosure.len();
    let rows = AtomicUsize::new(0);
    let matrix = factors.matrix(&|| {
        work.tell("form factors", rows.fetch_add(1, Ordering::Relaxed) + 1, n);
    });
    work.count(n);
    let mut solver = GaussSeidel::new(enclosure, &matrix);
    let run = solver.run(contraction(enclosure, &matrix), how.solver, MOST_STEPS);
    let irradiance = solver.irradiance().to_vec();
    Arrived { irradiance, last: run.last, steps: run.steps }
}

/// Rows are computed for this many of the brightest elements at once, one a thread.
const AHEAD: usize = 16;

fn shoot(
    enclosure: &Enclosure,
    factors: &dyn FormFactors,
    how: &Fineness,
    work: &Work,
) -> Arrived {
    let n = enclosure.len();
    let cached = Cached::new(factors);
    let mut solver = Shoot::new(enclosure, &cached, Brightest::ByPower);
    let (mut last, mut steps) = (Step::default(), 0);
    while steps < MOST_STEPS {
        if steps % AHEAD == 0 {
            cached.prepare(&solver.brightest(AHEAD));
            work.tell("shooting", cached.computed(), n);
        }
        let Some(step) = solver.next() else { break };
        (last, steps) = (step, steps + 1);
        if suffices(&step, enclosure, how) {
            break;
        }
    }
    work.count(cached.computed());
    Arrived { irradiance: solver.irradiance().to_vec(), last, steps }
}
