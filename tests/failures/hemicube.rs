//! Failures of the hemicube's cells: rows 18 to 22.

use super::rooms::{rectangle, scene};
use super::shapes::mesh_of;
use super::{Found, Row, Shown, Sweep, curve};
use glam::{DVec2, DVec3, dvec3};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::{Analytic, lambert_polygon};
use radiosity::form_factor::hemicube::{CubeFace, Hemicube, Weights};
use radiosity::geometry::{Frame, Polygon};
use radiosity::mesh::Mesh;
use radiosity::random::Stream;
use radiosity::raster::{ItemBuffer, Seen};
use radiosity::solve::{Brightest, Enclosure, Shoot, Solver};
use std::f64::consts::{PI, TAU};

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 18,
        name: "Aliasing",
        why: "A cell shows what its centre sees, all or nothing: a patch of few cells has \
              a number of them that depends on where it lies.",
        size: "A square a third of a cell wide is off by 230 % in root mean square, of 1.6 \
               cells by 19 %, of 6.4 by 2.3 %: 0.45 k^(−3/2) at most.",
        remedy: "Ask for the resolution by this law, or take small patches exactly.",
        tests: &["hemicube::row_18_small_patches_alias"],
        shown: Shown::Curve(aliasing),
    },
    Row {
        number: 19,
        name: "The small lamp that nobody sees",
        why: "A patch between the centres of the cells is not there at all.",
        size: "A lamp of side 0.02 that faces the element at distance 1, in any direction, is \
               missed in 81 % of all cases by a hemicube of 32, in 31 % by one of 64.",
        remedy: "Shoot from small lamps instead of gathering; or take them exactly.",
        tests: &["hemicube::row_19_a_small_lamp_is_missed"],
        shown: Shown::Curve(missed),
    },
    Row {
        number: 20,
        name: "More than there is, through one cell",
        why: "Shooting turns a factor round by A_i/A_j, and a cell's whole weight may go to \
              a speck.",
        size: "A cell at the zenith weighs 1/804 at 32²: a speck of less than 1/804 of the \
               wall gets more than the wall sends to all; at 1/111 111, 138 times.",
        remedy: "Gather at what is small, or bound what one cell may give.",
        tests: &[
            "hemicube::row_20_a_speck_gets_more_than_there_is",
            "hemicube::row_20_one_cell_limits_the_ratio_of_areas",
        ],
        shown: Shown::Curve(speck),
    },
    Row {
        number: 21,
        name: "Weights that do not sum to one",
        why: "The classic weight is the integrand at the cell's centre times its area.",
        size: "The sum is off by .0021 at 16, .00053 at 32, .00013 at 64: a quarter each \
               time. It is not the error that matters.",
        remedy: "Integrate over the cell: a closed form.",
        tests: &["hemicube::row_21_classic_weights_miss_one_by_little"],
        shown: Shown::Curve(delta_sum),
    },
    Row {
        number: 22,
        name: "Grids that beat",
        why: "Patches in a row along the cells cross their borders all together.",
        size: "The light of 38 lamps in step with the cells spreads by 132 % over receivers, \
               by 6 % at 20° to them; with turned hemicubes by 40 % everywhere.",
        remedy: "Turn each hemicube by an angle of its own: streaks become noise.",
        tests: &["hemicube::row_22_turning_breaks_the_beat"],
        shown: Shown::Curve(beat),
    },
];

/// The factor from the origin, looking along +Z, to one polygon, cell by cell.
pub fn by_cells(weights: &Weights, resolution: u32, polygon: &Polygon) -> f64 {
    let frame = Frame::about(DVec3::Z);
    let mut cells = ItemBuffer::new(1, 1);
    let of_face = |face: CubeFace| {
        let (width, height) = face.size(resolution);
        cells.reset(width, height);
        cells.draw(&face.view(DVec3::ZERO, &frame), polygon, 0);
        let seen = cells.pixels().zip(weights.of(face));
        seen.filter(|s| s.0 == Seen::Front(0)).map(|s| s.1).sum::<f64>()
    };
    CubeFace::ALL.into_iter().map(of_face).sum()
}

/// A square of this side that faces the origin, one away, in a random direction above the
/// horizon, rolled at random; and its factor, by Lambert's formula.
fn somewhere(side: f64, random: &mut Stream) -> (Polygon, f64) {
    let z = side + (1.0 - side) * random.next();
    let (around, roll) = (TAU * random.next(), TAU * random.next());
    let r = (1.0 - z * z).sqrt();
    let centre = dvec3(r * around.cos(), r * around.sin(), z);
    let facing = Frame::about(-centre);
    let (sin, cos) = roll.sin_cos();
    let a = side * (facing.x * cos + facing.y * sin);
    let b = -facing.z.cross(a);
    let square = rectangle(centre - (a + b) / 2.0, b, a);
    let exact = lambert_polygon(DVec3::ZERO, DVec3::Z, &square);
    (square, exact)
}

/// Root mean square of the relative error of such squares' factors over so many places, and
/// the share of places where they are missed.
pub fn over_places(resolution: u32, side: f64, places: u64) -> (f64, f64) {
    let weights = Weights::exact(resolution);
    let mut random = Stream::named(1, &[u64::from(resolution)]);
    let (mut squares, mut missed) = (0.0, 0.0);
    for _ in 0..places {
        let (polygon, exact) = somewhere(side, &mut random);
        let got = by_cells(&weights, resolution, &polygon);
        squares += (got / exact - 1.0).powi(2);
        missed += f64::from(u8::from(got == 0.0));
    }
    ((squares / places as f64).sqrt(), missed / places as f64)
}

/// Row 18.
pub fn aliasing() -> Sweep {
    let cells = [0.32, 0.64, 1.6, 3.2, 6.4, 12.8];
    let of = |resolution: u32| {
        move |k: f64| {
            100.0 * over_places(resolution, 2.0 * k / f64::from(resolution), 300).0
        }
    };
    Sweep {
        knob: "side of the patch / side of a cell",
        quantity: "error of F, %",
        logarithmic: [true, true],
        found: vec![
            Found::over("hemicube of 32", &cells[..4], of(32)),
            Found::over("hemicube of 64", &cells[..5], of(64)),
            Found::over("hemicube of 128", &cells[3..], of(128)),
        ],
        theory: curve(&cells, |k| 45.0 * k.powf(-1.5)),
        law: "0.45 k^(−3/2): of 4k cells on the outline each is off by a third",
    }
}

/// Row 19.
pub fn missed() -> Sweep {
    let sides = [0.005, 0.01, 0.02, 0.03, 0.05, 0.08];
    let of = |resolution: u32| {
        move |side: f64| 100.0 * over_places(resolution, side, 1000).1
    };
    Sweep {
        knob: "side of the lamp / distance",
        quantity: "places where it is missed, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("hemicube of 32", &sides, of(32)),
            Found::over("hemicube of 64", &sides, of(64)),
        ],
        theory: curve(&sides, |side| {
            // 3 · 32² centres of cells in a solid angle of 2π
            100.0 * (1.0 - side * side * 3.0 * 1024.0 / TAU).max(0.0)
        }),
        law: "1 − (centres of cells in its solid angle), of 32; at least that is missed",
    }
}

/// The irradiance of a square speck of this side at distance 1 under one cell beside the
/// zenith of a hemicube of 32, when a wall of 10 × 10 shoots 1 W/m²; by cells and exactly.
pub fn on_a_speck(side: f64, by_cells: bool) -> f64 {
    let wall = rectangle(dvec3(-5.0, -5.0, 0.0), DVec3::X * 10.0, DVec3::Y * 10.0);
    let corner = dvec3(0.02, 0.02, 1.0);
    let speck = rectangle(corner, DVec3::Y * side, DVec3::X * side);
    let scene = scene([(wall, 1.0, 0.0), (speck, 0.0, 0.5)]);
    let mesh = Mesh::whole(&scene);
    let enclosure = Enclosure::of(&scene, &mesh);
    let shot = |factors: &dyn FormFactors| {
        let mut solver = Shoot::new(&enclosure, factors, Brightest::ByPower);
        solver.next();
        solver.irradiance()[1].x
    };
    match by_cells {
        true => shot(&Hemicube::new(&mesh, 32)),
        false => shot(&Analytic::new(&scene, &mesh, 1e-6, 0)),
    }
}

/// Row 20.
pub fn speck() -> Sweep {
    let ratios: Vec<f64> = [1.0, 0.5, 0.25, 0.125, 0.03, 0.02, 0.0125_f64]
        .map(|side| 100.0 / (side * side))
        .to_vec();
    let side = |ratio: f64| (100.0 / ratio).sqrt();
    Sweep {
        knob: "area of the wall / area of the speck",
        quantity: "light on the speck / light of the wall",
        logarithmic: [true, true],
        found: vec![
            Found::over("hemicube of 32", &ratios, |r| on_a_speck(side(r), true)),
            Found::over("exact factor", &ratios, |r| on_a_speck(side(r), false)),
        ],
        theory: curve(&ratios[4..], |ratio| ratio * 4.0 / (PI * 1024.0)),
        law: "smaller than a cell: ratio × weight of one cell, 4/(π 32²)",
    }
}

/// Row 21.
pub fn delta_sum() -> Sweep {
    let knobs = [16.0, 32.0, 64.0, 128.0, 256.0];
    let off = |weights: Weights| (weights.sum() - 1.0).abs().max(1e-16);
    Sweep {
        knob: "resolution",
        quantity: "|ΣΔF − 1|",
        logarithmic: [true, true],
        found: vec![
            Found::over("at the centres", &knobs, |n| {
                off(Weights::at_centres(n as u32))
            }),
            Found::over("exact", &knobs, |n| off(Weights::exact(n as u32))),
        ],
        theory: curve(&knobs, |n| 0.002_123 * (16.0 / n).powi(2)),
        law: "a quarter with each doubling, through the published .0021 at 16",
    }
}

/// The side of a lamp, by that of a cell.
const LAMP: f64 = 0.6;
/// A cell of a hemicube of 40.
const CELL: f64 = 0.05;
/// Where the lamps stand in their row.
fn row_of_lamps() -> impl Iterator<Item = f64> + Clone {
    (0..38).map(|k| CELL * (f64::from(k) - 18.5))
}

/// The spread, in per cent, of the light of a row of 38 lamps at this angle to the cells of
/// a hemicube of 40, over 400 receivers within a cell. The lamps follow each other in step
/// with the cells.
pub fn spread(degrees: f64, turned: bool) -> f64 {
    let along = DVec2::from_angle(degrees.to_radians()).extend(0.0);
    let (a, b) = (LAMP * CELL * along, LAMP * CELL * DVec3::Z.cross(along));
    let lamp = |place: f64| rectangle(place * along + DVec3::Z - (a + b) / 2.0, b, a);
    let mesh = mesh_of(&row_of_lamps().map(lamp).collect::<Vec<_>>(), 1.0);
    let straight = Hemicube::new(&mesh, 40);
    let cube = if turned { straight.turned(1) } else { straight };
    let mut row = vec![0.0; mesh.elements.len()];
    let sums: Vec<f64> = Stream::named(22, &[])
        .points(400)
        .map(|[x, y]: [f64; 2]| {
            cube.at(dvec3(CELL * x, CELL * y, 0.0), DVec3::Z, &mut row);
            row.iter().sum()
        })
        .collect();
    let mean = sums.iter().sum::<f64>() / sums.len() as f64;
    let squares = sums.iter().map(|s| (s / mean - 1.0).powi(2)).sum::<f64>();
    100.0 * (squares / sums.len() as f64).sqrt()
}

/// The same by Fourier's series: what a lattice of cells counts of a shape varies by the
/// shape's spectrum at the frequencies of the lattice.
fn expected_spread(degrees: f64) -> f64 {
    const TERMS: i32 = 30;
    let along = DVec2::from_angle(degrees.to_radians());
    let sinc = |x: f64| if x == 0.0 { 1.0 } else { x.sin() / x };
    let weight = |place: f64| (1.0 + place * place).powi(-2);
    let all: f64 = row_of_lamps().map(weight).sum();
    let mut variance = 0.0;
    for m in -TERMS..=TERMS {
        for n in -TERMS..=TERMS {
            let frequency = TAU * DVec2::new(f64::from(m), f64::from(n));
            let (u, v) = (frequency.dot(along), frequency.perp_dot(along));
            let lamp = sinc(0.5 * LAMP * u) * sinc(0.5 * LAMP * v);
            let wave = |place: f64| weight(place) * DVec2::from_angle(u * place / CELL);
            let row: DVec2 = row_of_lamps().map(wave).sum::<DVec2>() / all;
            variance += lamp * lamp * row.length_squared();
        }
    }
    100.0 * (variance - 1.0).sqrt() // less the mean, at frequency 0
}

/// Row 22.
pub fn beat() -> Sweep {
    let angles = [0.0, 2.0, 5.0, 10.0, 20.0, 30.0, 45.0];
    Sweep {
        knob: "angle between the row and the cells, °",
        quantity: "spread of the light over receivers, %",
        logarithmic: [false, false],
        found: vec![
            Found::over("hemicubes of 40", &angles, |a| spread(a, false)),
            Found::over("turned, each by its own angle", &angles, |a| spread(a, true)),
        ],
        theory: curve(&angles, expected_spread),
        law: "the lamps' spectrum at the frequencies of the cells",
    }
}
