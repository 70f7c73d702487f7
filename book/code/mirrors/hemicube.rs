//! What an element sees in mirrors: the top of its hemicube, the virtual world drawn in.

use crate::ledger as books;
use crate::shooting::beside;
use radiosity::field::Classical;
use radiosity::field::Factors;
use radiosity::field::MatrixSolver;
use radiosity::film::{Picture, RgbImage};
use radiosity::form_factor::hemicube::{CubeFace, Weights};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::raster::Seen;
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in};
use radiosity::solution::Goal;
use radiosity::solution::{Solution, solve_on};
use radiosity::virtual_world::{ExtendedHemicube, VirtualWorld};
use radiosity::work::Work;
use std::f64::consts::PI;
use std::sync::OnceLock;

/// The levels of the panels.
pub const LEVELS: [u32; 3] = [0, 1, 4];

/// Cells along the edge of the top.
const RESOLUTION: u32 = 128;

/// Of the picture.
const EXPOSURE: f64 = 0.14;

fn corridor() -> &'static (Scene, Solution) {
    static SOLVED: OnceLock<(Scene, Solution)> = OnceLock::new();
    SOLVED.get_or_init(|| {
        let scene = built_in("mirror-corridor").expect("it is built in");
        let mesh = Mesh::uniform(&scene, 0.3);
        let factors = Factors::Sampling(400);
        let method = Classical { solver: MatrixSolver::Gather, factors, levels: 4 };
        let solution = solve_on(
            &Room::of(&scene),
            &method,
            mesh,
            &Goal::default(),
            &Work::quiet(),
        )
        .unwrap();
        (scene, solution)
    })
}

/// An element in the middle of the blue wall, which looks along the corridor.
fn looking() -> ElementId {
    let (scene, solution) = corridor();
    let to = glam::dvec3(1.0, 1.5, 0.0);
    let off = |k: &usize| {
        let element = &solution.field.mesh.elements[*k];
        let surface = &scene.surfaces[solution.field.mesh.surface_of(element) as usize];
        let away = if scene.material(surface).name() == "blue" { 0.0 } else { 1e9 };
        away + element.polygon.centroid().distance(to)
    };
    let all = 0..solution.field.mesh.elements.len();
    let nearest = all.min_by(|a, b| off(a).total_cmp(&off(b)));
    ElementId(nearest.expect("there are elements") as u32)
}

/// What the top shows with so many levels, and how many pictures the row takes.
fn panel(levels: u32) -> (RgbImage, usize) {
    let (scene, solution) = corridor();
    let world = VirtualWorld::of(scene, levels);
    let cube = ExtendedHemicube::new(&solution.field.mesh, &world, 0, RESOLUTION);
    let weights = Weights::exact(RESOLUTION);
    let whole = weights.of(CubeFace::Top);
    let mut picture = Picture::new(RESOLUTION, RESOLUTION);
    let mut drawn = 0;
    cube.pictures(looking(), |face, cells, counts| {
        drawn += 1;
        if face != CubeFace::Top {
            return;
        }
        for (cell, seen) in cells.pixels().enumerate() {
            if let Seen::Front(element) = seen {
                let share = counts[cell] / whole[cell];
                let light = solution.radiosity[element as usize] / PI;
                picture.pixels[cell] += share * light;
            }
        }
    });
    (picture.display(EXPOSURE), drawn)
}

/// The panels.
pub fn picture() -> RgbImage {
    beside(&LEVELS.map(|levels| panel(levels).0))
}

/// The caption under them.
pub fn caption() -> String {
    let [none, one, four] = LEVELS.map(|levels| panel(levels).1);
    format!(
        "The top of the hemicube of an element on the end wall of `mirror-corridor`: without a \
         virtual world, with one level, with four. Its five faces take {none}, {one} and \
         {four} pictures.\n"
    )
}

/// Where the light of the corridor goes.
pub fn ledger() -> String {
    books::table(&corridor().1)
}
