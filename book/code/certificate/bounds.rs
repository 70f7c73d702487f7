//! The certificate against the truth, and against the bound of the worst case.

use super::cube::Cube;
use crate::chart::{self, Point};
use radiosity::certificate::{Certificate, Judged, Sampling, irradiance_of};
use radiosity::room::Room;
use radiosity::solution::audited;
use std::fmt::Write;

/// Elements along an edge, in the chart.
pub const CELLS: [u32; 4] = [1, 2, 4, 6];

/// Reflectances, in the table.
pub const REFLECTANCES: [f64; 4] = [0.2, 0.5, 0.8, 0.95];

/// Elements along an edge of the cube that stands for the truth.
const FINE: u32 = 10;

/// One field, its true error, its certificate, and `‖r‖/‖B − E‖`.
pub struct Case {
    /// Elements in all.
    pub elements: usize,
    /// `‖B − B*‖/‖B* − E‖`.
    pub truth: f64,
    /// What is said of it.
    pub certificate: Certificate,
    /// The residual, known exactly.
    pub residual: f64,
}

/// The cube of this reflectance in each of these fineness.
pub fn cases(reflectance: f64, cells: &[u32]) -> Vec<Case> {
    let fine = Cube::of(reflectance, FINE);
    let case = |&cells: &u32| {
        let cube = Cube::of(reflectance, cells);
        let field = |id: radiosity::mesh::ElementId, _| cube.radiosity[id];
        let irradiance = irradiance_of(&cube.scene, &cube.mesh, field);
        let judged = Judged { mesh: &cube.mesh, irradiance: &irradiance };
        let room = Room::of(&cube.scene);
        let certificate = audited(&room, &judged, Sampling::default()).certificate;
        let (mut r, mut reflected) = (0.0, 0.0);
        for (id, x) in cube.points(2000) {
            let e = cube.enclosure.emission[id].x;
            let b = cube.stored(id);
            r += (e + reflectance * cube.irradiance(&cube, id, x) - b).powi(2);
            reflected += (b - e).powi(2);
        }
        Case {
            elements: cube.mesh.elements.len(),
            truth: cube.true_error(&fine),
            certificate,
            residual: f64::sqrt(r / reflected),
        }
    };
    cells.iter().map(case).collect()
}

/// The chart: truth and bounds against the number of elements.
pub fn svg() -> String {
    let cases = cases(0.5, &CELLS);
    let line = |method: &str, error: &dyn Fn(&Case) -> f64| -> Vec<Point> {
        let point = |case: &Case| Point {
            method: method.into(),
            setting: format!("{} elements", case.elements),
            milliseconds: case.elements as f64,
            error: error(case),
        };
        cases.iter().map(point).collect()
    };
    let points = [
        line("at most", &|c| c.certificate.high),
        line("truth", &|c| c.truth),
        line("at least", &|c| c.certificate.low),
    ];
    chart::svg(
        "True error and certified bounds against the number of elements",
        &points.concat(),
        "elements",
        "relative error of the reflected light",
    )
}

/// What the worst case says, and the certificate, in units of the truth.
pub fn table() -> String {
    let mut text = String::from(
        "| ρ | true error | ‖r‖/(1 − ρ) | certified at most | certified at least |\n\
         |---|---|---|---|---|\n",
    );
    for rho in REFLECTANCES {
        for case in cases(rho, &[2]) {
            let times = |error: f64| error / case.truth;
            let _ = writeln!(
                text,
                "| {rho} | {:.1} % | × {:.1} | × {:.2} | × {:.2} |",
                100.0 * case.truth,
                times(case.residual / (1.0 - rho)),
                times(case.certificate.high),
                times(case.certificate.low)
            );
        }
    }
    text
}
