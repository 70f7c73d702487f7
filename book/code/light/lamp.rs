//! A square lamp over a floor: flux, irradiance, radiosity and radiance of one scene.

use crate::{ledger, map};
use glam::{DVec2, DVec3, dvec2};
use radiosity::field::Classical;
use radiosity::field::Factors;
use radiosity::film::RgbImage;
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::Mesh;
use radiosity::radiometry::{
    irradiance, projected_solid_angle, radiance_from_radiosity, radiosity_from_flux,
    reflected, solid_angle,
};
use radiosity::room::Room;
use radiosity::scene::{Face, MaterialId, Scene};
use radiosity::solution::Goal;
use radiosity::solution::solve_on;
use radiosity::work::Work;

/// The lamp's power, W.
pub const FLUX: f64 = 60.0;

/// Its side, m.
const SIDE: f64 = 0.3;

/// Half of the floor's side, m.
const HALF: f64 = 2.0;

/// The floor's reflectance.
const REFLECTANCE: f64 = 0.5;

/// The three heights of the lamp, m.
pub const HEIGHTS: [f64; 3] = [0.5, 1.0, 2.0];

/// The range of the colours, W/m².
const RANGE: (f64, f64) = (0.1, 100.0);

fn lamp(height: f64) -> Polygon {
    map::square(SIDE, height * DVec3::Z)
}

/// The lamp's radiosity, W/m², and radiance, W/(m² sr).
pub fn lamp_light() -> (f64, f64) {
    let radiosity = radiosity_from_flux(Rgb::splat(FLUX), lamp(1.0).area());
    (radiosity.x, radiance_from_radiosity(radiosity).x)
}

/// How the irradiance is computed, right and wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// `H = L Ω⊥`.
    Right,
    /// `L Ω`: the cosine at the floor is forgotten.
    NoCosine,
    /// `B Ω⊥`: radiosity is taken for radiance.
    NoPi,
}

impl Rule {
    /// All three, the right one first.
    pub const ALL: [Rule; 3] = [Rule::Right, Rule::NoCosine, Rule::NoPi];
}

/// The irradiance, W/m², at a place on the floor.
pub fn at(place: DVec2, height: f64, rule: Rule) -> f64 {
    let (p, lamp) = (place.extend(0.0), lamp(height));
    let (radiosity, radiance) = lamp_light();
    let projected = projected_solid_angle(p, DVec3::Z, lamp.vertices());
    match rule {
        Rule::Right => irradiance(Rgb::splat(radiance), projected).x,
        Rule::NoCosine => radiance * solid_angle(p, &lamp),
        Rule::NoPi => radiosity * projected,
    }
}

/// The irradiance over the floor.
pub fn picture(height: f64, rule: Rule) -> RgbImage {
    let (low, high) = (DVec2::splat(-HALF), DVec2::splat(HALF));
    let values = map::over(low, high, |place| at(place, height, rule));
    map::draw(&values, RANGE.0, RANGE.1)
}

/// The key to the maps.
pub fn key() -> String {
    map::key(RANGE.0, RANGE.1, 4, |v| format!("{} W/m²", (v * 10.0).round() / 10.0))
}

/// The caption of the opening picture.
pub fn caption() -> String {
    let (radiosity, radiance) = lamp_light();
    let below = at(DVec2::ZERO, 1.0, Rule::Right);
    let leaving = reflected(Rgb::splat(below), Rgb::splat(REFLECTANCE));
    format!(
        "A lamp of {SIDE} × {SIDE} m sends **{FLUX} W** downward: that is {radiosity:.0} \
         W/m² of lamp, and {radiance:.0} W/(m² sr) in each direction. It hangs 1 m over a \
         floor of 4 × 4 m. Straight below {below:.1} W/m² arrive. The floor reflects a \
         half, {:.1} W/m², and so looks as bright as {:.2} W/(m² sr).",
        leaving.x,
        radiance_from_radiosity(leaving).x
    )
}

/// The caption under one of the three heights.
pub fn height_caption(height: f64) -> String {
    let p = dvec2(0.0, 0.0).extend(0.0);
    let size = solid_angle(p, &lamp(height));
    let below = at(DVec2::ZERO, height, Rule::Right);
    let (_, radiance) = lamp_light();
    format!(
        "{height} m: lamp of {size:.3} sr and {radiance:.0} W/(m² sr); {below:.1} W/m² \
         below it"
    )
}

/// What the wrong rules find, over what is right, below the lamp and in a corner.
pub fn wrong(rule: Rule) -> [f64; 2] {
    [DVec2::ZERO, DVec2::splat(HALF)]
        .map(|place| at(place, 1.0, rule) / at(place, 1.0, Rule::Right))
}

/// The caption under one of the three rules.
pub fn wrong_caption(rule: Rule) -> String {
    let [below, corner] = wrong(rule);
    let name = match rule {
        Rule::Right => "Right",
        Rule::NoCosine => "Cosine forgotten",
        Rule::NoPi => "π forgotten",
    };
    match rule {
        Rule::Right => format!("{name}: H = L Ω⊥"),
        _ => format!("{name}: ×{below:.2} below the lamp, ×{corner:.2} in the corners"),
    }
}

/// The ledger of lamp and floor, in the void.
pub fn ledger() -> String {
    let paint = |name: &str, emission: f64, diffuse: f64| {
        let coefficients = Coefficients {
            emission: Rgb::splat(emission),
            diffuse: Rgb::splat(diffuse),
            ..Coefficients::default()
        };
        Material::new(name, coefficients).expect("both are passive")
    };
    let floor = map::square(2.0 * HALF, DVec3::ZERO).flipped();
    let face = |(k, polygon): (usize, Polygon)| Face {
        outline: polygon.vertices().to_vec(),
        material: MaterialId(k as u32),
    };
    let materials =
        vec![paint("lamp", lamp_light().0, 0.0), paint("floor", 0.0, REFLECTANCE)];
    let faces = [lamp(1.0), floor].into_iter().enumerate().map(face).collect();
    let scene = Scene::assemble("lamp over floor", materials, faces, None);
    let scene = scene.expect("squares are fit faces").0;
    let mesh = Mesh::uniform(&scene, 0.25);
    let method = Classical::by(Factors::Analytic);
    ledger::table(
        &solve_on(&Room::of(&scene), &method, mesh, &Goal::default(), &Work::quiet())
            .unwrap(),
    )
}
