//! What each solver has after the same work.

use crate::ledger;
use crate::shooting::Room;
use radiosity::chart::race::contestants;
use radiosity::chart::{Chart, Line, Mark};
use radiosity::film::RgbImage;
use radiosity::geometry::Rgb;
use radiosity::scene::built_in;
use radiosity::solve::{ConjugateGradients, Solver};
use std::sync::OnceLock;

/// Brighter than paint is: here it shows who waits for the light to die out.
pub const REFLECTANCE: f64 = 0.97;

/// Longest edge of an element, m.
const MAX_EDGE: f64 = 0.4;

/// The solvers that are shown, and what their pictures are called.
pub const SHOWN: [(&str, &str); 3] = [
    ("Jacobi", "jacobi"),
    ("Gauss-Seidel", "sweeps"),
    ("conjugate gradients", "gradients"),
];

/// The work after which they are looked at, in gathers over the whole matrix.
pub const WORK: f64 = 8.0;

/// Exposure of the pictures.
const EXPOSURE: f64 = 0.02;

/// The L-shaped room in white paint all over; computed once.
pub fn room() -> &'static Room {
    static ROOM: OnceLock<Room> = OnceLock::new();
    ROOM.get_or_init(|| {
        let scene = built_in("l-room").expect("the room is built in");
        let mut room = Room::of(&scene, MAX_EDGE);
        room.enclosure.reflectance.fill(Rgb::splat(REFLECTANCE));
        room.solve();
        room
    })
}

/// What a solver has once it has done so much work: a light for each `work`.
fn after(name: &str, work: &[f64]) -> Vec<Vec<Rgb>> {
    let room = room();
    let contestants = contestants();
    let contestant =
        contestants.iter().find(|c| c.name == name).expect("it is in the race");
    let length = |k: usize| room.factors.rows()[k].factors().len() as f64;
    let all: f64 = (0..room.mesh.elements.len()).map(length).sum();
    let mut solver = (contestant.start)(&room.enclosure, &room.factors);
    let mut done = 0.0;
    let until = |&work: &f64| {
        while done < work - 1e-9
            && let Some(step) = solver.next()
        {
            done += step.shot.map_or(1.0, |from| length(from.0 as usize) / all);
        }
        solver.radiosity().to_vec()
    };
    work.iter().map(until).collect()
}

/// The room as a solver has it after [`WORK`].
pub fn picture(name: &str) -> RgbImage {
    room().panel(&after(name, &[WORK])[0], EXPOSURE)
}

/// The room with all of its light.
pub fn solved() -> RgbImage {
    room().panel(&room().solution, EXPOSURE)
}

/// How far a solver is off after [`WORK`].
pub fn error(name: &str) -> f64 {
    room().error(&after(name, &[WORK])[0])
}

/// The caption under its picture.
pub fn caption(name: &str) -> String {
    format!("{name}: {:.1} % off", 100.0 * error(name))
}

/// What the pictures show.
pub fn view() -> String {
    format!(
        "Scene <code>l-room</code>, {} elements with edges up to {MAX_EDGE} m, all walls of \
         reflectance {REFLECTANCE}, analytic form factors, exposure {EXPOSURE}, flat. After \
         the work of {WORK} gathers over the whole matrix, and the solution.",
        room().mesh.elements.len()
    )
}

const MILESTONES: [f64; 13] =
    [1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 11.0, 16.0, 24.0, 36.0, 50.0, 75.0, 100.0];

/// Errors below this are not drawn.
const LEAST: f64 = 1e-7;

/// The error of each solver over its work.
pub fn svg() -> String {
    let line = |name: &str| {
        let errors = after(name, &MILESTONES);
        let errors = errors.iter().map(|b| room().error(b));
        let mark = |(&x, y)| Mark { x, y, label: String::new() };
        let mut marks: Vec<Mark> = MILESTONES.iter().zip(errors).map(mark).collect();
        let end = marks.iter().position(|m| m.y < LEAST).unwrap_or(marks.len());
        marks.truncate(end);
        Line { name: name.into(), marks }
    };
    Chart {
        title: "Error of each solver against its work".into(),
        across: "work, in gathers over the whole matrix".into(),
        upward: "relative error".into(),
        least: LEAST,
        lines: contestants().iter().map(|c| line(c.name)).collect(),
        ..Chart::default()
    }
    .svg()
}

/// What the curves say.
pub fn text() -> String {
    let needed = |name: &str| {
        let work: Vec<f64> = (1..=400).map(f64::from).collect();
        let found = after(name, &work);
        let enough = found.iter().position(|b| room().error(b) < 0.01);
        enough.map_or("more than 400".into(), |k| (k + 1).to_string())
    };
    format!(
        "To be 1 % off Jacobi works for {} gathers, Gauss–Seidel for {}, shooting by power for \
         as much as {}, overshooting for {}, conjugate gradients for {}.\n",
        needed("Jacobi"),
        needed("Gauss-Seidel"),
        needed("shooting by power"),
        needed("overshooting"),
        needed("conjugate gradients")
    )
}

/// Where the light is when conjugate gradients are done.
pub fn ledger() -> String {
    let room = room();
    let mut solver = ConjugateGradients::new(&room.enclosure, &room.factors);
    ledger::of(&solver.run(REFLECTANCE, 1e-3, 100).last.ledger)
}
