//! Error maps: the floor below a lamp, element by element, method against exact.

use crate::map;
use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::film::RgbImage;
use radiosity::form_factor::analytic::{exchange, lambert_polygon};
use radiosity::form_factor::cast::Cast;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::{FormFactors, shortcuts};
use radiosity::geometry::Polygon;
use radiosity::mesh::{ElementId, Mesh};

/// The floor is a unit square of so many elements to a side.
const ELEMENTS: u32 = 16;

/// How high the lamp hangs, a unit square too.
const HEIGHT: f64 = 0.5;

/// The range of the colours, as relative errors.
const RANGE: (f64, f64) = (1e-4, 1.0);

/// The methods that are mapped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// The lamp taken for a disc at its middle.
    Disc,
    /// A thousand rays from each element.
    Rays,
    /// Hemicubes of resolution 64.
    Hemicube,
    /// Lambert's formula at the middle of the element.
    Middle,
}

impl Method {
    /// All of them, the worst first.
    pub const ALL: [Method; 4] =
        [Method::Disc, Method::Rays, Method::Hemicube, Method::Middle];

    /// Its part of a file's name.
    pub fn file(self) -> &'static str {
        match self {
            Method::Disc => "disc",
            Method::Rays => "rays",
            Method::Hemicube => "hemicube",
            Method::Middle => "middle",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Method::Disc => "Point to disc",
            Method::Rays => "1000 rays",
            Method::Hemicube => "Hemicube, 64",
            Method::Middle => "Lambert at the middle",
        }
    }
}

/// The lamp first, then the elements of the floor, row by row.
fn polygons() -> Vec<Polygon> {
    let step = 1.0 / f64::from(ELEMENTS);
    let element = |k: u32| {
        let (x, y) = (f64::from(k % ELEMENTS) + 0.5, f64::from(k / ELEMENTS) + 0.5);
        let middle = dvec3(x * step - 0.5, 0.5 - y * step, 0.0);
        map::square(step, middle).flipped()
    };
    let lamp = map::square(1.0, HEIGHT * DVec3::Z);
    [lamp].into_iter().chain((0..ELEMENTS * ELEMENTS).map(element)).collect()
}

/// Relative errors of the factors from the elements to the lamp.
pub fn errors(method: Method) -> Vec<f64> {
    let polygons = polygons();
    let mesh = Mesh::whole(&map::black(&polygons));
    let (rays, cube) = (Cast::new(&mesh, 1000, 1), Hemicube::new(&mesh, 64));
    let lamp = &polygons[0];
    let mut row = vec![0.0; polygons.len()];
    let mut first = |factors: &dyn FormFactors, k: usize| {
        factors.row(ElementId(k as u32), &mut row);
        row[0]
    };
    let mut error = |(k, element): (usize, &Polygon)| {
        let found = match method {
            Method::Disc => shortcuts::point_to_disc(element, lamp),
            Method::Rays => first(&rays, k),
            Method::Hemicube => first(&cube, k),
            Method::Middle => {
                lambert_polygon(element.centroid(), element.normal(), lamp)
            }
        };
        found * element.area() / exchange(element, lamp, 1e-14) - 1.0
    };
    polygons.iter().enumerate().skip(1).map(&mut error).collect()
}

/// The root mean square of the errors.
pub fn rms(errors: &[f64]) -> f64 {
    (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt()
}

/// The map of the errors.
pub fn picture(method: Method) -> RgbImage {
    let errors = errors(method);
    let values = map::over(DVec2::ZERO, dvec2(1.0, 1.0), |DVec2 { x, y }| {
        let cell = |v: f64| (v * f64::from(ELEMENTS)) as usize;
        errors[cell(1.0 - y) * ELEMENTS as usize + cell(x)]
    });
    map::draw(&values, RANGE.0, RANGE.1)
}

/// The caption under one map.
pub fn caption(method: Method) -> String {
    let errors = errors(method);
    let worst = errors.iter().fold(0.0, |worst: f64, e| worst.max(e.abs()));
    format!(
        "{}: {:.2} % off, {:.2} % at the worst",
        method.name(),
        100.0 * rms(&errors),
        100.0 * worst
    )
}

/// The key to the maps.
pub fn key() -> String {
    map::key(RANGE.0, RANGE.1, 5, map::per_cent)
}
