//! Error over work: how far off a solver is after so many shots.

use super::{Room, cornell};
use crate::chart::{self, Point};
use radiosity::geometry::Rgb;
use radiosity::solve::{Brightest, GaussSeidel, Shoot, Solver, Step};

/// After how many shots the error is taken.
const SHOTS: [usize; 14] =
    [2, 4, 10, 20, 40, 100, 200, 400, 700, 1000, 1500, 2000, 3000, 4500];

/// The error of a solver after each of `SHOTS`, until it is below 1e-3; `shown`
/// says what is looked at.
pub fn curve<S: Iterator<Item = Step>>(
    room: &Room,
    method: &str,
    mut solver: S,
    shown: impl Fn(&S) -> Vec<Rgb>,
) -> Vec<Point> {
    let (mut made, mut points) = (0, Vec::new());
    for shots in SHOTS {
        while made < shots && solver.next().is_some() {
            made += 1;
        }
        let error = room.error(&shown(&solver));
        points.push(point(method, shots as f64, shots.to_string(), error));
        if error < 1e-3 {
            break;
        }
    }
    points
}

fn point(method: &str, work: f64, setting: String, error: f64) -> Point {
    Point { method: method.into(), setting, milliseconds: work, error }
}

/// The Cornell box, by power and by radiosity, with and without ambient term, and by
/// sweeps of as many rows as there are elements.
fn points() -> Vec<Point> {
    let room = cornell();
    let shoot = |brightest| Shoot::new(&room.enclosure, &room.factors, brightest);
    let plain = |solver: &Shoot| solver.radiosity().to_vec();
    let mut points = curve(room, "by power", shoot(Brightest::ByPower), plain);
    let by_radiosity = shoot(Brightest::ByRadiosity);
    points.extend(curve(room, "by radiosity", by_radiosity, plain));
    let shown = |solver: &Shoot| solver.with_ambient();
    points.extend(curve(room, "with ambient", shoot(Brightest::ByPower), shown));
    let mut sweeps = GaussSeidel::new(&room.enclosure, &room.factors);
    for sweep in 1..=6 {
        sweeps.next();
        let (error, rows) =
            (room.error(sweeps.radiosity()), sweep * room.factors.rows().len());
        points.push(point("sweeps", rows as f64, rows.to_string(), error));
    }
    points
}

/// The chart of *Progressive refinement*.
pub fn svg() -> String {
    chart::svg(
        "Relative error of the radiosity against the number of shots",
        &points(),
        "rows of form factors used",
        "relative error",
    )
}

/// The first number of shots after which a curve is below `error`.
fn first_below(points: &[Point], method: &str, error: f64) -> f64 {
    let fits = |p: &&Point| p.method == method && p.error <= error;
    points.iter().find(fits).map_or(f64::INFINITY, |p| p.milliseconds)
}

/// What the chart says.
pub fn text() -> String {
    let points = points();
    let room = cornell();
    let at = |method: &str, shots: f64| {
        let fits = |p: &&Point| p.method == method && p.milliseconds == shots;
        points.iter().find(fits).map_or(1.0, |p| p.error)
    };
    format!(
        "{} elements. After 10 shots the radiosity is {:.0} % off, with the ambient \
         term {:.0} %. A first sweep of Gauss–Seidel, {} rows, leaves {:.0} %. To 1 \
         %, shooting takes some {} shots, and sweeping {} rows.\n",
        room.mesh.elements.len(),
        100.0 * at("by power", 10.0),
        100.0 * at("with ambient", 10.0),
        room.mesh.elements.len(),
        100.0 * at("sweeps", room.mesh.elements.len() as f64),
        first_below(&points, "by power", 0.01),
        first_below(&points, "sweeps", 0.01),
    )
}
