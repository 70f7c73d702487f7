//! How wide, in cells, a patch must be: the measured rule.

use super::sheet::{lamp, ratio};
use glam::{DVec2, dvec2};
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::mesh::Mesh;
use radiosity::random::Stream;

/// Sides of the lamp in heights above the floor, each halving the one before.
const SIDES: [f64; 4] = [0.4, 0.2, 0.1, 0.05];

/// Resolutions of the hemicube.
const RESOLUTIONS: [u32; 3] = [32, 64, 128];

/// Places that each entry averages over.
const PLACES: usize = 2000;

/// The root mean square of the relative error, over random places of the floor.
pub fn rms(resolution: u32, side: f64) -> f64 {
    let scene = lamp(side);
    let mesh = Mesh::whole(&scene);
    let cube = Hemicube::new(&mesh, resolution);
    let lamp = &scene.surfaces[0].polygon;
    let places =
        Stream::named(1, &[]).points(PLACES).map(|[x, y]: [f64; 2]| dvec2(x, y));
    let error = |u: DVec2| ratio(&cube, lamp, 2.0 * u - DVec2::ONE) - 1.0;
    (places.map(|u| error(u).powi(2)).sum::<f64>() / PLACES as f64).sqrt()
}

/// The cells that a lamp of this side covers, along an edge, when it is overhead.
pub fn cells_across(resolution: u32, side: f64) -> f64 {
    side * f64::from(resolution) / 2.0
}

/// The table as Markdown.
pub fn markdown() -> String {
    let mut text = String::from("| cells across |");
    for resolution in RESOLUTIONS {
        text.push_str(&format!(" resolution {resolution} |"));
    }
    text.push_str("\n|---|---|---|---|\n");
    for across in [0.8, 1.6, 3.2, 6.4, 12.8, 25.6] {
        text.push_str(&format!("| {across} |"));
        for resolution in RESOLUTIONS {
            let near = |&&side: &&f64| {
                (cells_across(resolution, side) / across - 1.0).abs() < 1e-9
            };
            match SIDES.iter().find(near) {
                Some(&side) => {
                    text.push_str(&format!(
                        " {:.1} % |",
                        100.0 * rms(resolution, side)
                    ));
                }
                None => text.push_str(" |"),
            }
        }
        text.push('\n');
    }
    text
}
