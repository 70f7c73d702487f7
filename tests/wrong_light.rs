//! Light that was wrong, and certified: suns behind walls, panes in their openings, ground
//! that reaches far. Inputs in `tests/data/light`.

use radiosity::geometry::Rgb;
use radiosity::obj;
use radiosity::scene::Scene;
use radiosity::sky::{Panorama, Sky};
use radiosity::solve::{Ask, Solution, automatic, resolution_for};
use std::path::PathBuf;

fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/light").join(name)
}

fn scene(name: &str, sky: Option<Sky>) -> Scene {
    let (scene, _) = obj::load(data(&format!("{name}.obj"))).expect(name);
    Scene { sky, ..scene }
}

fn panorama(name: &str) -> Sky {
    let panorama = Panorama::read(&data(&format!("{name}.hdr"))).expect(name);
    Sky::panorama(panorama, glam::DVec3::Y)
}

fn solved(scene: &Scene, tolerance: f64) -> Solution {
    let ask = Ask { tolerance, ..Ask::default() };
    automatic(scene, resolution_for(scene, tolerance), &ask, &|_, _, _| {}).0
}

/// Mean irradiance of a face, W/m², in the first channel.
fn irradiance(solution: &Solution, face: u32) -> f64 {
    let mesh = &solution.mesh;
    let (mut power, mut area) = (0.0, 0.0);
    for (element, h) in mesh.elements.iter().zip(&solution.irradiance) {
        if mesh.patch_of(element).face.0 == face {
            power += element.polygon.area() * h.x;
            area += element.polygon.area();
        }
    }
    power / area
}

/// A sun that a panorama holds is a lamp far away: all walls of the scene stand before it,
/// also those that have the whole scene on one side, which hide nothing within.
#[test]
fn no_sun_shines_into_a_closed_room() {
    for sun in ["sun-behind", "sun-front"] {
        let solution = solved(&scene("sun-closed", Some(panorama(sun))), 0.3);
        let most = solution.irradiance.iter().fold(Rgb::ZERO, |m, &h| m.max(h));
        assert_eq!((most, solution.ledger.emitted), (Rgb::ZERO, Rgb::ZERO), "{sun}");
    }
}

/// The sun stands behind the wall that faces the window; the rest of the sky has
/// L = 0.01 W/(m² sr), and no point of the floor sees more than half of the sky: H is less
/// than 0.01 π/(1 − 0.5).
#[test]
fn no_sun_shines_through_the_wall_behind() {
    let solution = solved(&scene("sun-window", Some(panorama("sun-behind"))), 0.3);
    let h = irradiance(&solution, 0);
    assert!(h > 0.0 && h < 0.03, "{h}");
}

/// In front of the window it does shine in.
#[test]
fn the_sun_shines_in_through_the_window() {
    let solution = solved(&scene("sun-window", Some(panorama("sun-front"))), 0.3);
    assert!(irradiance(&solution, 0) > 0.3);
}
