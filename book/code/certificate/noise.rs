//! What the noise of a gather does to the square of a residual.

use super::cube::Cube;
use radiosity::form_factor::ray_from;
use radiosity::geometry::Frame;
use radiosity::random::Stream;
use radiosity::visibility::Visibility;
use std::fmt::Write;

/// Rays of a gather, in the table.
pub const RAYS: [usize; 4] = [4, 16, 64, 256];

/// Root mean squares of the residual over that of the reflected light.
pub struct Residual {
    /// By the square of one gather.
    pub square: f64,
    /// By the product of two; 0 where noise makes it less.
    pub product: f64,
    /// By an exact gather.
    pub exact: f64,
    /// Standard deviation of one gather.
    pub noise: f64,
}

/// Those of the cube with four elements along an edge.
pub fn residual(rays: usize) -> Residual {
    let cube = Cube::of(0.5, 4);
    let all = Visibility::new(cube.mesh.polygons());
    let points = cube.points(2000);
    let (mut square, mut product, mut exact) = (0.0, 0.0, 0.0);
    let (mut noise, mut reflected) = (0.0, 0.0);
    for (k, &(id, x)) in points.iter().enumerate() {
        let polygon = &cube.mesh.element(id).polygon;
        let frame = Frame::about(polygon.normal());
        let b = cube.stored(id);
        let e = cube.enclosure.emission[id].x;
        let residual = |h: f64| e + 0.5 * h - b;
        let gather = |set: u64| {
            let mut random = Stream::named(11, &[k as u64, set]);
            let mut seen = |_| {
                // Independent rays, so that the noise falls as the textbook says.
                let u = [0.0, 0.0, random.next(), random.next()];
                let mut ray = ray_from(polygon, &frame, u);
                ray.origin = x;
                let hit = all.closest(&ray, Some(id.0));
                hit.map_or(0.0, |hit| cube.radiosity[hit.item as usize].x)
            };
            (0..rays).map(&mut seen).sum::<f64>() / rays as f64
        };
        let [first, second] = [1, 2].map(|set| residual(gather(set)));
        square += first * first;
        product += first * second;
        noise += 0.5 * (first - second).powi(2);
        exact += residual(cube.irradiance(&cube, id, x)).powi(2);
        reflected += (b - e).powi(2);
    }
    let root = |sum: f64| (sum.max(0.0) / reflected).sqrt();
    Residual {
        square: root(square),
        product: root(product),
        exact: root(exact),
        noise: root(noise),
    }
}

/// One squared, two multiplied, and the truth.
pub fn table() -> String {
    let mut text = String::from(
        "| rays | noise of a gather | one, squared | two, multiplied | truth |\n\
         |---|---|---|---|---|\n",
    );
    for rays in RAYS {
        let Residual { square, product, exact, noise } = residual(rays);
        let [noise, square, product, exact] =
            [noise, square, product, exact].map(|x| 100.0 * x);
        let _ = writeln!(
            text,
            "| {rays} | {noise:.1} % | {square:.1} % | {product:.1} % | {exact:.1} % |"
        );
    }
    text
}
