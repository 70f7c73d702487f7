//! The ground beside a block in the sun, by directions drawn in three ways.

use super::court::scene;
use super::skies::{Kind, sun_texel, sunny};
use crate::map::{self, PLACES};
use glam::{DVec3, dvec2, dvec3};
pub use radiosity::chart::suites::sky::Draw;
use radiosity::film::{Picture, RgbImage};
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::random::Stream;
use radiosity::sky::Sky;
use radiosity::visibility::Visibility;
use std::f64::consts::TAU;

/// Directions for each pixel.
pub const RAYS: usize = 64;

/// The ground of the court as seen from above, 4 m × 4 m, lit by `rays` directions to
/// each pixel; the blocks are cut out.
pub fn picture(draw: Draw) -> RgbImage {
    let scene = scene(Kind::Sunny, 3.0);
    let sky = scene.sky.as_ref().expect("it has one");
    let solid: Vec<&Polygon> = scene.surfaces.iter().map(|s| &s.polygon).collect();
    let visibility = Visibility::new(solid);
    let mut picture = Picture::new(PLACES, PLACES);
    for k in 0..PLACES * PLACES {
        let at = |k: u32| 4.0 * (f64::from(k) + 0.5) / f64::from(PLACES) - 2.0;
        let origin = dvec3(at(k % PLACES), 0.0, at(k / PLACES));
        let mut stream = Stream::named(0, &[21, u64::from(k)]);
        let mut sum = Rgb::ZERO;
        for [u, v] in stream.points(RAYS) {
            let (direction, light) = draw.light(sky, dvec2(u, v));
            let ray = Ray { origin, direction };
            if light != Rgb::ZERO && visibility.closest(&ray, Some(0)).is_none() {
                sum += light / RAYS as f64;
            }
        }
        picture.pixels[k as usize] = sum;
    }
    picture.display(1.0 / 130.0)
}

/// Root mean square of the error of an unshaded point, relative, with [`RAYS`]
/// directions.
fn error(draw: Draw) -> f64 {
    let sky = Sky::panorama(sunny(), DVec3::Y);
    let exact = sky.irradiance(DVec3::Y).x;
    let runs = 4000;
    let one = |seed: u64| {
        let mut stream = Stream::named(seed, &[]);
        let mut ray = || draw.light(&sky, dvec2(stream.next(), stream.next())).1.x;
        let mean = (0..RAYS).map(|_| ray()).sum::<f64>() / RAYS as f64;
        (mean / exact - 1.0).powi(2)
    };
    ((0..runs).map(one).sum::<f64>() / runs as f64).sqrt()
}

/// What is said below the map.
pub fn caption(draw: Draw) -> String {
    let name = draw.name();
    format!("{name}: off by {}\n", map::per_cent((error(draw) * 100.0).round() / 100.0))
}

/// How small and how bright the sun is.
pub fn of_the_sun() -> String {
    let panorama = sunny();
    let k = sun_texel(&panorama);
    let omega = panorama.solid_angle(k / panorama.width());
    let brighter = panorama.texels()[k].y / panorama.texels()[k + 2].y;
    let chance = 1.0 - (1.0 - omega / TAU).powi(RAYS as i32);
    format!(
        "The sun's texel covers {:.5} sr, one part in {:.0} of the hemisphere, and is {:.0} \
         times as bright as the sky two texels on. Of {RAYS} even directions the chance \
         that any meets it is {:.1} %.\n",
        omega,
        TAU / omega,
        brighter,
        100.0 * chance
    )
}
