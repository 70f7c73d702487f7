//! Conjugate gradients without what they rest on.

use radiosity::chart::{Chart, Line, Mark};
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::{FormFactors, Lost, Matrix, Row, close};
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use radiosity::solve::{ConjugateGradients, Enclosure};

/// Rays of each element.
const RAYS: usize = 64;

/// Steps that are drawn.
const STEPS: usize = 100;

/// Residuals below this are rounding.
const LEAST: f64 = 1e-13;

/// Residuals of conjugate gradients in a bright cube of which four elements shine, step by
/// step, with factors by rays, at element centres, and by rays but repaired.
pub fn residuals() -> [(&'static str, Vec<f64>); 3] {
    let scene = built_in("furnace:0.999").expect("it is a reflectance");
    let mesh = Mesh::uniform(&scene, 0.25);
    let mut room = Enclosure::of(&scene, &mesh);
    room.emission[4..].fill(Rgb::ZERO);
    let rays = Cast::new(&mesh, RAYS, 1).matrix(&|| ());
    let centres = Hemicube::new(&mesh, 16).matrix(&|| ());
    let mut rows: Vec<_> = rays.rows().iter().map(|r| r.factors().to_vec()).collect();
    close(&mut rows, &room.area);
    let rows = rows.into_iter().map(|row| Row::new(row, Lost::default()));
    let repaired = Matrix::from_rows(rows.collect());
    let run = |factors: &Matrix| {
        let solver = ConjugateGradients::new(&room, factors);
        solver.take(STEPS).map(|step| step.residual).collect()
    };
    [
        ("64 rays", run(&rays)),
        ("element centres", run(&centres)),
        ("rays, repaired", run(&repaired)),
    ]
}

/// The residuals over the steps.
pub fn svg() -> String {
    let line = |(name, residuals): (&str, Vec<f64>)| {
        let end = residuals.iter().position(|&r| r < LEAST).map_or(STEPS, |k| k + 1);
        let marks = residuals.iter().take(end).enumerate();
        let mark = |(k, &y): (usize, &f64)| Mark {
            x: (k + 1) as f64,
            y,
            label: String::new(),
        };
        Line { name: name.into(), marks: marks.map(mark).collect() }
    };
    Chart {
        title: "Residual of conjugate gradients with three kinds of form factors"
            .into(),
        across: "steps".into(),
        upward: "relative residual".into(),
        least: LEAST,
        lines: residuals().map(line).into(),
        ..Chart::default()
    }
    .svg()
}

/// What that says.
pub fn text() -> String {
    let [rays, centres, repaired] = residuals().map(|(_, residuals)| residuals);
    let least = |from: &[f64]| from.iter().copied().fold(f64::INFINITY, f64::min);
    let grown = (1..20).map(|k| centres[k] / least(&centres[..k])).fold(0.0, f64::max);
    let steps = |of: &[f64]| 1 + of.iter().position(|&r| r < 1e-8).unwrap_or(of.len());
    format!(
        "With factors by {RAYS} rays it stalls at {:.0e}. With those of element centres, \
         which are nearly reciprocal, it grows up to {grown:.0}-fold between steps and needs \
         {} steps to 1e-8; with the rays' factors made reciprocal and closed, {}.\n",
        least(&rays),
        steps(&centres),
        steps(&repaired)
    )
}
