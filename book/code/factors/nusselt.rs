//! Nusselt's analog: the hemisphere over a point, seen from straight below. Equal areas of
//! the disc are equal form factors.

use crate::hemicube::view::{EYE, paint, scene};
use glam::{DVec3, dvec2, dvec3};
use radiosity::film::{Picture, RgbImage};
use radiosity::form_factor::analytic::lambert_polygon;
use radiosity::geometry::{Frame, Polygon, Ray};
use radiosity::radiometry::solid_angle;
use radiosity::visibility::{Hit, Visibility};
use std::f64::consts::PI;

/// Pixels across the disc.
pub const SIZE: u32 = 96;

/// Where a surface is not.
pub const VOID: [u8; 3] = [24, 32, 72];

/// Where a lamp is.
pub const LAMP: [u8; 3] = [255, 220, 64];

/// How far the three lamps are from the zenith, in degrees.
pub const TILTS: [u32; 3] = [0, 50, 75];

/// The colours of the directions over the disc, local ones, with z up; white around it.
pub fn disc(colour: impl Fn(DVec3) -> [u8; 3]) -> RgbImage {
    let mut picture = Picture::new(SIZE, SIZE).map(|_| [255; 3]);
    for (pixel, direction) in picture.pixels_mut().zip(directions()) {
        if let Some(direction) = direction {
            pixel.0 = colour(direction);
        }
    }
    picture
}

/// The direction above each pixel of the disc; `None` outside.
pub fn directions() -> impl Iterator<Item = Option<DVec3>> {
    let along = |k: u32| 2.0 * (f64::from(k) + 0.5) / f64::from(SIZE) - 1.0;
    (0..SIZE * SIZE).map(move |k| {
        let foot = dvec2(along(k % SIZE), -along(k / SIZE));
        let square = foot.length_squared();
        (square < 1.0).then(|| foot.extend((1.0 - square).sqrt()))
    })
}

/// What of the disc `counts`, as a share.
pub fn counted(counts: impl Fn(DVec3) -> bool) -> f64 {
    let (mut all, mut found) = (0.0, 0.0);
    for direction in directions().flatten() {
        all += 1.0;
        found += f64::from(u8::from(counts(direction)));
    }
    found / all
}

/// Does a ray from the origin meet the polygon?
pub fn meets(polygon: &Polygon, direction: DVec3) -> bool {
    let plane = polygon.plane();
    let along = plane.offset / plane.normal.dot(direction);
    along > 0.0 && polygon.contains(direction * along, 0.0)
}

/// What the eye of the hemicube's chapter sees, in local directions.
fn look() -> impl Fn(DVec3) -> Option<Hit> {
    let visibility = Visibility::new(scene().surfaces.iter().map(|s| &s.polygon));
    let frame = Frame { x: DVec3::X, y: DVec3::NEG_Z, z: DVec3::Y };
    move |direction| {
        let direction = frame.world_from_local(direction);
        visibility.closest(&Ray { origin: EYE, direction }, None)
    }
}

/// The Cornell box from its floor.
pub fn cornell() -> RgbImage {
    let (scene, look) = (scene(), look());
    disc(|direction| match look(direction) {
        Some(hit) => paint(&scene, hit.item),
        None => VOID,
    })
}

/// The share of the lamp: counted, and exact.
pub fn lamp() -> (f64, f64) {
    let (scene, look) = (scene(), look());
    let emits = |item: u32| scene.material(&scene.surfaces[item as usize]).emits();
    let found = counted(|w| look(w).is_some_and(|hit| emits(hit.item)));
    (found, crate::hemicube::view::lamp())
}

/// The caption of the opening picture.
pub fn caption() -> String {
    let (counted, exact) = lamp();
    format!(
        "Scene <code>cornell</code>, eye at ({}, {}, {}) m on the floor, {SIZE} × {SIZE} \
         pixels. The lamp (yellow) fills {:.2} % of the disc. That is its form factor; \
         exact are {:.2} %. Dark blue: the open front.",
        EYE.x,
        EYE.y,
        EYE.z,
        100.0 * counted,
        100.0 * exact
    )
}

/// A square of side 0.8 at distance 1 that faces the origin, so far from the zenith.
pub fn tilted(degrees: u32) -> Polygon {
    let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
    let middle = dvec3(sine, 0.0, cosine);
    let (a, b) = (0.4 * dvec3(cosine, 0.0, -sine), 0.4 * DVec3::Y);
    let corners = [-a - b, b - a, a + b, a - b].map(|corner| middle + corner);
    Polygon::new(corners.to_vec()).expect("a square is a polygon")
}

/// One of the three lamps, as the disc shows it.
pub fn lamp_picture(tilt: u32) -> RgbImage {
    let lamp = tilted(tilt);
    disc(|direction| if meets(&lamp, direction) { LAMP } else { VOID })
}

/// The caption under it.
pub fn lamp_caption(tilt: u32) -> String {
    let lamp = tilted(tilt);
    let size = solid_angle(DVec3::ZERO, &lamp);
    let factor = lambert_polygon(DVec3::ZERO, DVec3::Z, &lamp);
    format!(
        "{tilt}° from the zenith: F = {factor:.3}, {:.0} % of Ω/π",
        100.0 * factor * PI / size
    )
}
