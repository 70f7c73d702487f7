//! What rays find between two mirrors that are cut after some bounces.

use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::glam::{DVec3, dvec3};
use radiosity::material::{Coefficients, Material, Shine};
use radiosity::room::Room;
use radiosity::scene::{Face, MaterialId, Scene};
use radiosity::trace::{Look, Whitted};
use std::f64::consts::PI;
use std::fmt::Write;

/// The radiance along a ray between two mirrors that shine with radiance 1.
pub fn seen(reflectance: f64, depth: u32) -> f64 {
    let coefficients = Coefficients {
        emission: Rgb::splat(PI),
        shine: Shine::Mirror { reflectance: Rgb::splat(reflectance) },
        ..Coefficients::default()
    };
    let mirror = Material::new("mirror", coefficients).expect("it is passive");
    let corner = |x: f64, y: f64, z: f64| dvec3(99.0 * x, 99.0 * y, z);
    let low =
        [(-1., -1.), (1., -1.), (1., 1.), (-1., 1.)].map(|(x, y)| corner(x, y, 0.));
    let high =
        [(-1., -1.), (-1., 1.), (1., 1.), (1., -1.)].map(|(x, y)| corner(x, y, 1.));
    let face = |outline: [DVec3; 4]| Face {
        outline: Polygon::new(outline.to_vec()).expect("a square").vertices().to_vec(),
        material: MaterialId(0),
    };
    let faces = vec![face(low), face(high)];
    let scene = Scene::assemble("hall", vec![mirror], faces, None).expect("sound").0;
    let direction = dvec3(0.3, 0.1, 1.0).normalize();
    let ray = Ray { origin: dvec3(0.0, 0.0, 0.5), direction };
    Whitted::of(&Room::of(&scene), Look::following(depth, 0.0)).along(&ray).radiance.x
}

/// The table of the chapter.
pub fn markdown() -> String {
    let depths = [0, 1, 2, 5, 10, 24];
    let mut text = String::from("| Ks | all of it |");
    depths.iter().for_each(|d| write!(text, " {d} |").expect("text grows"));
    text += "\n|---|---|---|---|---|---|---|---|\n";
    for r in [0.5, 0.9, 0.99] {
        let all = 1.0 / (1.0 - r);
        write!(text, "| {r} | {all:.0} |").expect("text grows");
        for depth in depths {
            let missing = 100.0 * (1.0 - seen(r, depth) / all);
            write!(text, " {missing:.2} % |").expect("text grows");
        }
        text.push('\n');
    }
    text
}
