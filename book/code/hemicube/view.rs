//! What one place on the floor of the Cornell box sees through its hemicube.

use glam::{DVec3, dvec3};
use radiosity::film::{RgbImage, byte, hemicube_cross};
use radiosity::form_factor::Lost;
use radiosity::form_factor::hemicube::{CubeFace, Hemicube};
use radiosity::mesh::Mesh;
use radiosity::radiometry::projected_solid_angle;
use radiosity::raster::Seen;
use radiosity::scene::{Scene, built_in};
use std::f64::consts::PI;

/// Where the hemicube stands: on the floor, beside the blocks, in metres.
pub const EYE: DVec3 = dvec3(0.42, 0.0, 0.12);

/// The scene of the chapter.
pub fn scene() -> Scene {
    built_in("cornell").expect("`cornell` is built in")
}

/// What the eye sees: each cell in the colour of the paint that it shows.
///
/// Patches differ in brightness, so that each can be told from its neighbours; cells that
/// see nothing are dark blue, the corners of the picture are white.
pub fn items(resolution: u32) -> RgbImage {
    let scene = scene();
    let mesh = Mesh::whole(&scene);
    let cube = Hemicube::new(&mesh, resolution);
    hemicube_cross(&cube, EYE, DVec3::Y, 1, |_, _, seen| match seen {
        Seen::Front(id) => paint(&scene, id),
        Seen::Back(_) => [0; 3],
        Seen::Nothing => [24, 32, 72],
    })
}

/// The colour of a surface: that of its paint; patches differ in brightness.
pub(crate) fn paint(scene: &Scene, surface: u32) -> [u8; 3] {
    let material = scene.material(&scene.surfaces[surface as usize]);
    if material.emits() {
        return [255, 220, 64];
    }
    let shade = 0.4 + 0.15 * f64::from(surface * 3 % 5);
    (shade * material.diffuse()).to_array().map(byte)
}

/// The weights of the cells; the heaviest is white.
pub fn weights(resolution: u32) -> RgbImage {
    let mesh = Mesh::whole(&scene());
    let cube = Hemicube::new(&mesh, resolution);
    let weights = cube.weights();
    let heaviest = weights.of(CubeFace::Top).iter().copied().fold(0.0, f64::max);
    hemicube_cross(&cube, EYE, DVec3::Y, 1, |face, cell, _| {
        [byte(weights.of(face)[cell] / heaviest); 3]
    })
}

/// The form factors from the eye.
pub struct Factors {
    /// To the lamp.
    pub lamp: f64,
    /// To the red wall, all its pieces.
    pub red: f64,
    /// To the green wall.
    pub green: f64,
    /// What reaches nothing.
    pub lost: Lost,
}

/// The form factors from the eye, by a hemicube of this resolution.
pub fn factors(resolution: u32) -> Factors {
    let scene = scene();
    let mesh = Mesh::whole(&scene);
    let mut row = vec![0.0; mesh.elements.len()];
    let lost = Hemicube::new(&mesh, resolution).at(EYE, DVec3::Y, &mut row);
    let to = |name: &str| {
        let made_of = |k: &usize| scene.material(&scene.surfaces[*k]).name() == name;
        (0..row.len()).filter(made_of).map(|k| row[k]).sum()
    };
    Factors { lamp: to("lamp"), red: to("red"), green: to("green"), lost }
}

/// The exact factor from the eye to the lamp, all of which it sees.
pub fn lamp() -> f64 {
    let scene = scene();
    let lamps = scene.surfaces.iter().filter(|s| scene.material(s).emits());
    let solid = |s: &radiosity::scene::Surface| {
        projected_solid_angle(EYE, DVec3::Y, s.polygon.vertices())
    };
    lamps.map(solid).sum::<f64>() / PI
}

/// The caption of the opening picture: parameters and numbers.
pub fn caption(resolution: u32) -> String {
    let f = factors(resolution);
    let cells = 3 * resolution * resolution;
    format!(
        "Scene <code>cornell</code>, eye at ({}, {}, {}) m on the floor, resolution \
         {resolution}: {cells} cells. The lamp takes {:.2} % of what leaves here, the red \
         wall {:.1} %, the green one {:.1} %; {:.1} % leave by the open front (dark blue).",
        EYE.x,
        EYE.y,
        EYE.z,
        100.0 * f.lamp,
        100.0 * f.red,
        100.0 * f.green,
        100.0 * f.lost.escaped
    )
}

/// The caption under one of the three settings.
pub fn lamp_caption(resolution: u32) -> String {
    let got = factors(resolution).lamp;
    let error = 100.0 * (got / lamp() - 1.0);
    format!("Resolution {resolution}: lamp {got:.5}, off by {error:+.1} %")
}
