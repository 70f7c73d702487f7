//! The certificate: how sharply it tells an error, and how far it is off itself.

use crate::certificate::{Certificate, Judged, Sampling, certify};
use crate::chart::{
    Bench, ChartView, Column, Contest, Method, Suite, Trial, Verdict, WorkDone,
};
use crate::field::{Classical, Factors};
use crate::mesh::{ElementId, Mesh};
use crate::room::Room;
use crate::scene::built_in;
use crate::solution::{Goal, solve_on};
use glam::DVec3;

/// This suite.
pub const SUITE: Suite = Suite {
    name: "certificate",
    about: "the error of a solution of the Cornell box, asked of points and rays",
    measure,
    views: &[ChartView {
        file: "certificate",
        title: "Half the width of the certificate's interval against time",
        across: (Column::Seconds, "CPU seconds, one thread"),
        upward: (Column::Error, "half width / error"),
        least: 1e-3,
        shows: |t| t.scene == WIDTH || t.scene == OFF,
    }],
};

/// Half the width of the interval, relative to the error that it holds.
pub const WIDTH: &str = "half width";
/// How far the likely error is off from a finer one, relative to that.
pub const OFF: &str = "off in fact";

/// Points of the certificate.
const POINTS: [f64; 3] = [800.0, 3200.0, 12_800.0];

/// The finer one: so many certificates of the largest kind.
const FINE: u64 = 12;

fn measure(bench: &Bench) -> Vec<Trial> {
    audit(0.05, &POINTS, FINE, bench)
}

/// The Cornell box in elements with edges of at most `edge`, solved by hemicubes, audited
/// at so many `points`; the mean of `fine` audits at the most of them counts as true.
pub fn audit(edge: f64, points: &[f64], fine: u64, bench: &Bench) -> Vec<Trial> {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let (room, mesh) = (Room::of(&scene), Mesh::uniform(&scene, edge));
    let (method, quiet) =
        (Classical::by(Factors::Hemicube(128)), crate::work::Work::quiet());
    let solution = solve_on(&room, &method, mesh, &Goal::default(), &quiet);
    let solution = solution.expect("hemicubes know the Cornell box");
    let field = &solution.field;
    let [front, behind] = field.vertex_irradiance();
    let at =
        |id: ElementId, x: DVec3| [field.at(id, x, &front), field.at(id, x, &behind)];
    let field = Judged { mesh: &field.mesh, irradiance: &at };
    let ask = |points: f64, rays: usize, seed: u64| {
        let points = points as usize;
        let found = {
            let sampling = Sampling { points, rays, seed, ..Sampling::default() };
            certify(&scene, room.visibility(), &field, sampling)
        };
        // Two gathers at each point, for two independent residuals.
        let rays = 2 * (points * rays) as u64;
        (found, WorkDone { rays, ..WorkDone::default() })
    };
    let method = |rays: usize| {
        let name = format!("{rays} rays");
        Method::random(&name, points, move |n, seed| ask(n, rays, seed)).seeds(4)
    };
    let width = |c: &Certificate| Verdict::of(0.5 * (c.high - c.low) / c.error);
    let widths = Contest::new(WIDTH, 0.0, width)
        .with(method(16))
        .with(method(64))
        .with(method(256));

    let most = points.iter().copied().fold(16.0, f64::max);
    let found = (0..fine).map(|k| ask(most, 64, 1000 + k).0.error);
    let found: Vec<f64> = found.collect();
    let (mean, spread) = mean_and_spread(&found);
    let off = move |c: &Certificate| Verdict::of((c.error / mean - 1.0).abs());
    let offs = Contest::new(OFF, spread / mean, off).with(method(64));
    [widths.run(SUITE.name, bench), offs.run(SUITE.name, bench)].concat()
}

/// The mean, and its standard error.
fn mean_and_spread(found: &[f64]) -> (f64, f64) {
    let n = found.len() as f64;
    let mean = found.iter().sum::<f64>() / n;
    let squares: f64 = found.iter().map(|v| (v - mean).powi(2)).sum();
    (mean, (squares / (n - 1.0) / n).sqrt())
}
