//! What the student hands in; and the methods that are to be broken.
//!
//! None of these methods is faulty. Each is used where what it assumes does not hold.

use crate::shapes::rectangle;
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::{exchange, lambert_polygon};
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::shortcuts::point_to_point;
use radiosity::form_factor::{Lost, Matrix, Row};
use radiosity::material::{Coefficients, Material};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::prelude::{DVec3, Polygon, Rgb, dvec3};
use radiosity::random::Stream;
use radiosity::scene::{Face, MaterialId, Scene};
use radiosity::solve::{Enclosure, Jacobi, Solver};
use std::f64::consts::TAU;

pub use crate::gather::given::Room;

// ANCHOR: near
/// Two unit squares that face each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Near {
    /// How far apart, in their sides.
    pub distance: f64,
    /// By which share the factor between their middles is too large: 0.1 for 10 %.
    pub error: f64,
}
// ANCHOR_END: near

// ANCHOR: hidden
/// A lamp that hides from a hemicube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hidden {
    /// Its side, in m.
    pub side: f64,
    /// Its factor in the hemicube over the right one: the mean of all places where
    /// it is seen.
    pub brightness: f64,
}
// ANCHOR_END: hidden

// ANCHOR: slow
/// A room in which light lasts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slow {
    /// ρ of all walls.
    pub reflectance: f64,
    /// The light that is missing in the end, over what the last bounce has added.
    pub behind: f64,
}
// ANCHOR_END: slow

/// By which share the factor between unit squares at this distance is too large when
/// both are taken at their middles.
pub fn too_near(distance: f64) -> f64 {
    let low = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let high = rectangle(DVec3::Z * distance, DVec3::Y, DVec3::X);
    point_to_point(&low, &high) / exchange(&low, &high, 1e-12) - 1.0
}

/// Puts a lamp above a hemicube, at `rows` × `rows` places, each random in its square of
/// a chessboard of 1 m, and each time turned otherwise: the share of places at which it
/// is missed, and how bright it is at the others, over how bright it should be. NaN when
/// it is seen nowhere.
pub fn search(cells: u32, side: f64, rows: usize, stream: &mut Stream) -> [f64; 2] {
    let floor = rectangle(dvec3(-1e-3, -1e-3, 0.0), DVec3::X * 2e-3, DVec3::Y * 2e-3);
    let mut seen = Vec::new();
    for k in 0..rows * rows {
        let [x, y] = [k % rows, k / rows]
            .map(|place| (place as f64 + stream.next()) / rows as f64 - 0.5);
        let (s, c) = (TAU * stream.next()).sin_cos();
        let [a, b] = [dvec3(c, s, 0.0), dvec3(-s, c, 0.0)].map(|edge| side * edge);
        let lamp = rectangle(dvec3(x, y, 1.0) - 0.5 * (a + b), b, a);
        let right = lambert_polygon(DVec3::ZERO, DVec3::Z, &lamp);
        let found = by_hemicube(&floor, &lamp, cells);
        if found > 0.0 {
            seen.push(found / right);
        }
    }
    let missed = 1.0 - seen.len() as f64 / (rows * rows) as f64;
    [missed, seen.iter().sum::<f64>() / seen.len() as f64]
}

/// The factor between two faces of a scene that has no others.
fn by_hemicube(from: &Polygon, to: &Polygon, cells: u32) -> f64 {
    let black =
        Material::new("black", Coefficients::default()).expect("black is passive");
    let face = |p: &Polygon| {
        let material = MaterialId(0);
        Face { outline: p.vertices().to_vec(), material }
    };
    let faces = vec![face(from), face(to)];
    let scene = Scene::assemble("two", vec![black], faces, None);
    let mesh = Mesh::whole(&scene.expect("two rectangles").0);
    let mut row = [0.0; 2];
    Hemicube::new(&mesh, cells).row(ElementId(0), &mut row);
    row[1]
}

/// Factors between the elements of a box, each wall in `k` × `k`, by their middles.
pub fn by_middles([w, d, h]: [f64; 3], k: usize) -> Vec<Vec<f64>> {
    let (x, y, z, o) = (DVec3::X * w, DVec3::Y * d, DVec3::Z * h, DVec3::ZERO);
    let walls = [(o, y, z), (x, z, y), (o, z, x), (y, x, z), (o, x, y), (z, y, x)];
    let step = 1.0 / k as f64;
    let piece = |m: usize| {
        let (corner, a, b) = walls[m / (k * k)];
        let [i, j] = [m % k, m / k % k].map(|c| c as f64 * step);
        rectangle(corner + i * a + j * b, step * a, step * b)
    };
    let pieces: Vec<Polygon> = (0..6 * k * k).map(piece).collect();
    let row = |i: &Polygon| pieces.iter().map(|j| point_to_point(i, j)).collect();
    // A piece of a wall does not see itself, nor others of its wall: their cosines are
    // 0.
    let mut rows: Vec<Vec<f64>> = pieces.iter().map(row).collect();
    for (i, row) in rows.iter_mut().enumerate() {
        let wall = i / (k * k) * k * k;
        row[wall..wall + k * k].fill(0.0);
    }
    rows
}

/// Jacobi's iteration by the crate: what it finds after each sweep, summed over all
/// elements as if they had the area 1. Element 0 is a lamp of 1.
pub fn jacobi(factors: &[Vec<f64>], reflectance: f64, sweeps: usize) -> Vec<f64> {
    let mut emission = vec![Rgb::ZERO; factors.len()];
    emission[0] = Rgb::ONE;
    let room = Enclosure {
        area: vec![1.0; factors.len()],
        emission,
        reflectance: vec![Rgb::splat(reflectance); factors.len()],
        ..Default::default()
    };
    let rows = factors.iter().map(|row| Row::of(row, Lost::default())).collect();
    let matrix = Matrix::from_rows(rows);
    let mut solver = Jacobi::new(&room, &matrix);
    let sum = |_| {
        solver.next();
        solver.radiosity().iter().map(|b| b.x).sum()
    };
    (0..sweeps).map(sum).collect()
}
