//! Aliasing: what the places of a floor find of a small lamp above it.

use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::film::{Picture, RgbImage};
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::Mesh;
use radiosity::radiometry::projected_solid_angle;
use radiosity::scene::{Face, MaterialId, Scene};
use std::f64::consts::PI;

/// Places along an edge of the sheet.
pub const PLACES: u32 = 64;

/// Half the edge of the sheet, in lamp heights. No simple fraction of a cell.
const HALF: f64 = 0.77;

/// A square lamp of this side, 1 above the origin, looking down.
pub fn lamp(side: f64) -> Scene {
    let corner = dvec3(-side / 2.0, -side / 2.0, 1.0);
    let (a, b) = (side * DVec3::Y, side * DVec3::X);
    let outline = vec![corner, corner + a, corner + a + b, corner + b];
    let light = Material::new("lamp", Coefficients::default());
    let light = light.expect("a black material is passive");
    let face = Face { outline, material: MaterialId(0) };
    let scene = Scene::assemble("lamp", vec![light], vec![face], None);
    scene.expect("a square is a fit face").0
}

/// What a hemicube finds of the lamp, over what there is: 1 is right, 0 is missed.
pub fn ratio(cube: &Hemicube, lamp: &Polygon, at: DVec2) -> f64 {
    let point = at.extend(0.0);
    let mut row = [0.0];
    cube.at(point, DVec3::Z, &mut row);
    row[0] * PI / projected_solid_angle(point, DVec3::Z, lamp.vertices())
}

/// [`ratio`] over the sheet, row by row.
pub fn ratios(resolution: u32, side: f64) -> Vec<f64> {
    let scene = lamp(side);
    let mesh = Mesh::whole(&scene);
    let cube = Hemicube::new(&mesh, resolution);
    let along = |k: u32| HALF * (f64::from(2 * k + 1) / f64::from(PLACES) - 1.0);
    let place = |k: u32| dvec2(along(k % PLACES), along(k / PLACES));
    let lamp = &scene.surfaces[0].polygon;
    (0..PLACES * PLACES).map(|k| ratio(&cube, lamp, place(k))).collect()
}

/// The sheet as a picture: black is missed, middle grey is right, white is twice or more.
pub fn picture(ratios: &[f64]) -> RgbImage {
    let mut picture = Picture::new(PLACES, PLACES);
    for (pixel, ratio) in picture.pixels.iter_mut().zip(ratios) {
        *pixel = Rgb::splat(*ratio);
    }
    picture.map(|ratio| [(127.5 * ratio.x).min(255.0) as u8; 3])
}

/// The caption under one sheet.
pub fn caption(resolution: u32, side: f64) -> String {
    let ratios = ratios(resolution, side);
    let missed = ratios.iter().filter(|&&r| r == 0.0).count() as f64;
    let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
    format!(
        "Resolution {resolution}: {:.0} % of the places miss the lamp; on average {:.2} \
         of its light is found",
        100.0 * missed / ratios.len() as f64,
        mean
    )
}
