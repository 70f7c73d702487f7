//! How many bounces an answer takes.

use crate::chart::{self, Point};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use radiosity::solve::Enclosure;

/// The reflectances of the chart.
pub const REFLECTANCES: [f64; 3] = [0.5, 0.9, 0.99];

/// Errors are drawn down to this one.
const ENOUGH: f64 = 1e-4;

/// The error after 1, 2, 4, … bounces in a closed cube, one wall of which emits, until
/// it is enough: `‖B_k − B‖/‖B − E‖` in the area norm.
pub fn errors(reflectance: f64) -> Vec<(u32, f64)> {
    let scene = built_in("furnace").expect("`furnace` is built in");
    let mesh = Mesh::uniform(&scene, 0.5);
    let matrix = Analytic::new(&scene, &mesh, 1e-12, 0).matrix(&|| ());
    let mut room = Enclosure::of(&scene, &mesh);
    room.reflectance.fill(Rgb::splat(reflectance));
    for (emission, element) in room.emission.iter_mut().zip(&mesh.elements) {
        *emission = if element.patch.0 == 0 { Rgb::ONE } else { Rgb::ZERO };
    }
    let emission = &room.emission;
    let mut b = emission.clone();
    let mut series = vec![b.clone()];
    // Until the rest, ρ^k, is far below what is drawn.
    while reflectance.powi(series.len() as i32) > 1e-9 {
        let gather = |(row, &e): (&radiosity::form_factor::Row, &Rgb)| {
            let arriving: Rgb =
                row.factors().iter().map(|&(j, f)| f * b[j as usize]).sum();
            e + reflectance * arriving
        };
        b = matrix.rows().iter().zip(emission).map(gather).collect();
        series.push(b.clone());
    }
    let norm = |of: &[Rgb], from: &[Rgb]| {
        room.norm_squared(of.iter().zip(from).map(|(&x, &y)| x - y)).x.sqrt()
    };
    let error = |k: usize| norm(&series[k], &b) / norm(&b, emission);
    let mut errors = Vec::new();
    let mut k = 1;
    while k < series.len() {
        errors.push((k as u32, error(k)));
        if error(k) < ENOUGH {
            break;
        }
        k *= 2;
    }
    errors
}

/// The chart as SVG; its columns stand in the places of time and error.
pub fn svg() -> String {
    let points = |reflectance: f64| {
        errors(reflectance).into_iter().map(move |(bounces, error)| Point {
            method: format!("ρ = {reflectance}"),
            setting: format!("{bounces} bounces"),
            milliseconds: f64::from(bounces),
            error,
        })
    };
    let points: Vec<Point> = REFLECTANCES.into_iter().flat_map(points).collect();
    chart::svg(
        "Relative error of the reflected light against the number of bounces",
        &points,
        "bounces",
        "relative error of the reflected light",
    )
}

/// What the chart says.
pub fn text() -> String {
    let [low, middle, high] = REFLECTANCES.map(|rho| 10f64.ln() / -rho.ln());
    format!(
        "Each bounce multiplies the error by ρ or less. So a digit costs ln 10/(−ln \
         ρ) bounces: {low:.1}, {middle:.0} and {high:.0} for the three rooms. \
         **Bright rooms are expensive**, not large ones.\n"
    )
}
