//! Overshooting: what it gains, what it owes, and how it fails without its bound.

use super::work::curve;
use super::{Room, beside, cornell};
use crate::chart::{self, Point};
use crate::{ledger, map};
use glam::DVec3;
use radiosity::film::RgbImage;
use radiosity::geometry::Rgb;
use radiosity::mesh::ElementId;
use radiosity::scene::{Scene, built_in};
use radiosity::solve::{Brightest, Enclosure, Overshoot, Shoot, Solver};
use std::fmt::Write;
use std::sync::OnceLock;

/// After how many shots we look.
pub const STAGES: [usize; 3] = [30, 100, 300];

fn overshoot(room: &Room) -> Overshoot<'_> {
    Overshoot::new(&room.enclosure, &room.factors)
}

fn shoot(room: &Room) -> Shoot<'_> {
    Shoot::new(&room.enclosure, &room.factors, Brightest::ByPower)
}

/// What is shown, what is unshot, and what is owed.
pub fn picture(shots: usize) -> RgbImage {
    let room = cornell();
    let mut solver = overshoot(room);
    solver.by_ref().take(shots).for_each(drop);
    let unshot = solver.state().unshot();
    let left: Vec<Rgb> = unshot.iter().map(|u| u.max(Rgb::ZERO)).collect();
    let owed: Vec<Rgb> = unshot.iter().map(|u| -u.min(Rgb::ZERO)).collect();
    beside(&[
        room.panel(solver.radiosity(), 1.0),
        room.panel(&left, super::steps::LIFT),
        room.panel(&owed, super::steps::LIFT),
    ])
}

/// Errors of overshooting and of shooting after so many shots.
pub fn errors(shots: usize) -> [f64; 2] {
    let room = cornell();
    let (mut ahead, mut plain) = (overshoot(room), shoot(room));
    ahead.by_ref().take(shots).for_each(drop);
    plain.by_ref().take(shots).for_each(drop);
    [room.error(ahead.radiosity()), room.error(plain.radiosity())]
}

/// The caption under a strip.
pub fn caption(shots: usize) -> String {
    let [ahead, plain] = errors(shots).map(|error| 100.0 * error);
    format!("After {shots} shots: {ahead:.0} % off; without overshooting, {plain:.0} %")
}

/// A unit cube whose first wall emits, all walls with this reflectance.
fn cube(rho: f64) -> Room {
    let scene = built_in(&format!("furnace:{rho}")).expect("`furnace` is built in");
    let mut room = Room::of(&scene, 0.25);
    let wall = room.mesh.elements.len() / 6;
    room.enclosure.emission[wall..].fill(Rgb::ZERO);
    room.solve();
    room
}

/// A white room: [`cube`] of 0.9.
fn white() -> &'static Room {
    static ROOM: OnceLock<Room> = OnceLock::new();
    ROOM.get_or_init(|| cube(0.9))
}

/// Error over shots, in the Cornell box and in a white room.
pub fn work_svg() -> String {
    let mut points = Vec::new();
    for (name, room) in [("Cornell", cornell()), ("white", white())] {
        let plain = |solver: &Shoot| solver.radiosity().to_vec();
        points.extend(curve(room, &format!("{name}: shoot"), shoot(room), plain));
        let ahead = |solver: &Overshoot| solver.radiosity().to_vec();
        points.extend(curve(room, &format!("{name}: over"), overshoot(room), ahead));
    }
    chart::svg(
        "Relative error of the radiosity against the number of shots, with and without \
         overshooting, in the Cornell box and in a white room",
        &points,
        "shots",
        "relative error",
    )
}

/// Shots until the solver's bound is 1e-4, of shooting and of overshooting.
pub fn shots(room: &Room) -> [usize; 2] {
    let rho = room.enclosure.largest_reflectance().max_element();
    let mut solvers = (shoot(room), overshoot(room));
    [solvers.0.run(rho, 1e-4, 200_000).steps, solvers.1.run(rho, 1e-4, 200_000).steps]
}

/// What overshooting gains, as a Markdown table.
pub fn gain() -> String {
    let mut text =
        String::from("| room | shots | overshooting | gain |\n|---|---|---|---|\n");
    let mut line = |name: &str, room: &Room| {
        let [plain, ahead] = shots(room);
        let gain = plain as f64 / ahead as f64;
        let _ = writeln!(text, "| {name} | {plain} | {ahead} | {gain:.1} |");
    };
    let mut squares = Room::of(&squares(0.9), 0.1);
    squares.solve();
    line("two squares, ρ = 0.9, open on all sides", &squares);
    line("the Cornell box, open in front", cornell());
    line("a closed cube, ρ = 0.5", &cube(0.5));
    line("the same, ρ = 0.9", white());
    line("the same, ρ = 0.99", &cube(0.99));
    text
}

/// Two unit squares face to face at the distance 1; the lower one emits.
fn squares(rho: f64) -> Scene {
    let squares = [map::square(1.0, DVec3::ZERO).flipped(), map::square(1.0, DVec3::Z)];
    map::grey(squares.into_iter().zip([1.0, 0.0]).map(|(square, e)| (square, e, rho)))
}

/// How much an element shoots, of its unshot light and the ambient light it would
/// reflect.
type Rule = fn(f64, f64) -> f64;

/// The rules of the chart.
pub const RULES: [(&str, Rule); 3] = [
    ("no bound", |unshot, ambient| unshot + ambient),
    ("2.1 times", |unshot, _| 2.1 * unshot),
    ("safe bound", |unshot, ambient| {
        let most = Overshoot::SAFE * unshot;
        (unshot + ambient).clamp(most.min(0.0), most.max(0.0))
    }),
];

/// The light that is owed, as a share of what is emitted, after each of `shots`.
pub fn debt(rule: Rule, shots: usize) -> Vec<f64> {
    static ROOM: OnceLock<Room> = OnceLock::new();
    let room = ROOM.get_or_init(|| Room::of(&squares(0.99), 0.25));
    let Enclosure { area, reflectance, .. } = &room.enclosure;
    let mut solver = shoot(room);
    let step = |_| {
        let ambient = solver.ambient().x;
        let amount = |i: usize| rule(solver.unshot()[i].x, reflectance[i].x * ambient);
        let most = |&i: &usize, &j: &usize| {
            let power = |i: usize| area[i] * amount(i).abs();
            power(i).total_cmp(&power(j)).then(j.cmp(&i))
        };
        let most = (0..area.len()).max_by(most).unwrap_or(0);
        let amount = Rgb::splat(amount(most));
        solver.send(ElementId(most as u32), amount);
        let owed: Vec<Rgb> =
            solver.unshot().iter().map(|u| -u.min(Rgb::ZERO)).collect();
        room.share(&owed)
    };
    (0..shots).map(step).collect()
}

/// The debt after ever more shots.
pub fn debt_svg() -> String {
    let mut points = Vec::new();
    for (name, rule) in RULES {
        let debt = debt(rule, 1000);
        for shots in [2, 5, 7, 10, 15, 20, 30, 50, 70, 100, 150, 200, 400, 700, 1000] {
            let (setting, error) = (shots.to_string(), debt[shots - 1]);
            if (1e-7..1e6).contains(&error) {
                let method = name.into();
                points.push(Point {
                    method,
                    setting,
                    milliseconds: shots as f64,
                    error,
                });
            }
        }
    }
    chart::svg(
        "Light that is owed against the number of shots, by three rules",
        &points,
        "shots",
        "light owed, as a share of the light emitted",
    )
}

/// Where the light is after a hundred shots.
pub fn ledger() -> String {
    let last = overshoot(cornell()).nth(99).unwrap_or_default();
    ledger::of(&last.ledger)
}
