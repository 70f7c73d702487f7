//! What the page says of its charts, from measurements that are kept with their date.

use crate::chart;
use radiosity::chart::suites::meshes::{ANALYTIC, CORNELL, CUBE, HEMICUBES, LINKS};
use radiosity::chart::suites::scaling::SURFACES;
use radiosity::chart::{Column, Trial, exponent};

/// What `radiosity chart meshes` wrote.
const CSV: &str = include_str!("../../data/meshes.csv");

/// What `radiosity chart scaling` wrote.
const SCALING: &str = include_str!("../../data/scaling.csv");

/// The trials of a method on a scene, in order.
fn line<'t>(trials: &'t [Trial], scene: &str, method: &str) -> Vec<&'t Trial> {
    trials.iter().filter(|t| t.scene == scene && t.method == method).collect()
}

/// By which power of the number of elements links grow, from 500 elements on.
fn growth(trials: &[Trial], scene: &str) -> f64 {
    let mut links = line(trials, scene, LINKS);
    links.retain(|t| t.setting > 500.0);
    exponent(&links, Column::Setting, Column::Factors)
}

/// The finest matrix, and how many times sooner links have its error.
fn gain(trials: &[Trial], scene: &str, method: &str) -> (f64, f64) {
    let matrix = *line(trials, scene, method).last().expect("it was measured");
    let links = line(trials, scene, LINKS);
    let sooner = links.iter().find(|t| t.error <= matrix.error);
    (matrix.setting, sooner.map_or(f64::NAN, |t| matrix.seconds / t.seconds))
}

/// What the charts say.
pub fn text() -> String {
    let trials = chart::trials(CSV);
    let (of_exact, exact) = gain(&trials, CORNELL, ANALYTIC);
    let (of_cubes, cubes) = gain(&trials, CORNELL, HEMICUBES);
    let (of_cube, cube) = gain(&trials, CUBE, HEMICUBES);
    format!(
        "Links grow as elements to the power {:.2} in the Cornell box and {:.2} in a closed \
         cube; factors as the square. The error that a matrix of {of_exact} elements has, \
         links have **{exact:.1} times sooner** than analytic factors; that of {of_cubes} \
         elements {cubes:.1} times sooner than hemicubes; and in the cube, where nothing hides \
         anything, {cube:.1} times sooner than a matrix of {of_cube}.\n",
        growth(&trials, CORNELL),
        growth(&trials, CUBE),
    )
}

/// What the most elements take, and what their matrix would.
pub fn memory() -> String {
    let trials = chart::trials(CSV);
    let last = *line(&trials, CORNELL, LINKS).last().expect("it was measured");
    let matrix = last.setting.powi(2) * size_of::<(u32, f64)>() as f64;
    format!(
        "{:.0} thousand elements take {:.0} megabytes; their matrix would take {:.0}.\n",
        last.setting / 1e3,
        last.memory as f64 / 1e6,
        matrix / 1e6
    )
}

/// How times grow with the number of surfaces, from a hundred on.
pub fn surfaces() -> String {
    let trials = chart::trials(SCALING);
    let power = |method: &str| {
        let mut all = line(&trials, SURFACES, method);
        all.retain(|t| t.setting > 90.0);
        exponent(&all, Column::Setting, Column::Seconds)
    };
    let [links, smooth, matrix] = [LINKS, "smooth light", "hemicube matrix"].map(power);
    format!(
        "From a hundred surfaces on, links take time as surfaces to the power {links:.1}, \
         smooth light {smooth:.1}, the matrix {matrix:.1}.\n"
    )
}
