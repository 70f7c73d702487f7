//! What the charts of the chapters on surfaces say.

use crate::chart::{find, trials};
use radiosity::chart::Trial;
use radiosity::chart::suites::light::ALBEDO;
use radiosity::mesh::Mesh;
use radiosity::scene::built_in;
use std::fmt::Write;

fn light() -> Vec<Trial> {
    trials(include_str!("../../data/light.csv"))
}

/// What the chart of *BRDF* says.
pub fn samples_text() -> String {
    let trials = light();
    let error = |drawn: &str| 100.0 * find(&trials, ALBEDO, drawn, 1000.0).error;
    let (lobe, cosine, even) =
        ("drawn from the lobe", "drawn by the cosine", "drawn evenly");
    // To one digit: errors of 16 runs are known to a sixth.
    let samples = |drawn: &str| {
        let ratio = (error(drawn) / error(lobe)).powi(2);
        let unit = 10f64.powf(ratio.log10().floor());
        (ratio / unit).round() * unit
    };
    format!(
        "Of 1000 directions, those drawn from the lobe leave an error of {:.1} %, those by \
         the cosine {:.1} %, even ones {:.1} %. All errors fall as one over the root, so \
         that it takes about {:.0} directions by the cosine, or {:.0} even ones, to replace one \
         from the lobe. The narrower the lobe, the more.\n",
        error(lobe),
        error(cosine),
        error(even),
        samples(cosine),
        samples(even),
    )
}

/// What the chart of *Albedo* says.
pub fn albedo_text() -> String {
    let trials = light();
    let exact = find(&trials, ALBEDO, "closed form", 1.0).seconds;
    let [coarse, grid] = [4.0, 8.0].map(|rings| find(&trials, ALBEDO, "grid", rings));
    format!(
        "The closed form takes {:.2} µs. A grid of 8 × 32 directions takes {:.0} times as \
         long, and is off by {:.0e}; one of 4 × 16, by {:.0} %. The lobe is smooth: once its \
         cells are narrower than the lobe, a grid finds it to rounding, and samples cannot \
         follow.\n",
        1e6 * exact,
        grid.seconds / exact,
        grid.error,
        100.0 * coarse.error,
    )
}

/// What it costs to keep more of a surface than its albedo, in numbers to be found.
pub fn numbers() -> String {
    let scene = built_in("cornell").expect("`cornell` is built in");
    let elements = Mesh::uniform(&scene, 0.05).elements.len() as f64;
    let mut text = format!(
        "| kept of a surface | numbers for each element | unknowns, {elements} elements | \
         pairs |\n|---|---|---|---|\n"
    );
    for (what, directions) in
        [("albedo", 1.0), ("radiance in 64 directions", 64.0), ("in 1024", 1024.0)]
    {
        let unknowns = elements * directions;
        let _ = writeln!(
            text,
            "| {what} | {directions} | {unknowns} | {:.0e} |",
            unknowns * unknowns
        );
    }
    text
}
