//! Failures of two passes and of recursion: rows 64 to 66 and 73.

use super::mirrored::{factor, lamp, spot};
use super::paths::{dull, mirror, shiny};
use super::rooms::rectangle;
use super::{Found, Row, Shown, Sweep, curve};
use glam::{DVec3, dvec3};
use radiosity::form_factor::FormFactors;
use radiosity::form_factor::analytic::Analytic;
use radiosity::geometry::{Ray, Rgb};
use radiosity::material::Coefficients;
use radiosity::mesh::Mesh;
use radiosity::room::Room;
use radiosity::scene::{Scene, built_in};
use radiosity::solve::{Enclosure, GaussSeidel};
use radiosity::trace::{Along, Look, TwoPass, Whitted};
use radiosity::virtual_world::VirtualWorld;
use std::f64::consts::PI;

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 64,
        name: "Light that both passes add",
        why: "Pass 1 holds what mirrors throw on walls; a second pass that follows \
              light from lamps by mirrors adds it again.",
        size: "Beside a perfect mirror the floor is 5.5 % too bright, by exactly the \
               class `EDS⁺L`; ours is right to 1e-9.",
        remedy: "Give each class of paths to one pass, in writing, and let a test \
                 count every class.",
        tests: &["passes::rows_64_and_65_a_mirrored_lamp_lost_or_twice"],
        shown: Shown::Curve(counted_twice),
    },
    Row {
        number: 65,
        name: "Light that neither pass has",
        why: "Classical ray tracing asks lamps straight from the floor; what a mirror \
              throws there comes by no ray that it follows.",
        size: "Beside a perfect mirror the floor lacks 5.5 %: the factor of the lamp's \
               image, to 1e-9; two passes lack nothing.",
        remedy: "Virtual worlds in pass 1, or paths that find lamps by chance.",
        tests: &["passes::rows_64_and_65_a_mirrored_lamp_lost_or_twice"],
        shown: Shown::Curve(lost_light),
    },
    Row {
        number: 66,
        name: "Ray tracing bolted on plain radiosity",
        why: "For plain radiosity a mirror is a black wall: what it reflects is booked \
              as absorbed, whatever the second pass shows.",
        size: "Of a lamp before a mirror of share k the ledger books k·F·Φ too much as \
               absorbed: 16 % of the power at k = 0.8.",
        remedy: "Mirrors belong in pass 1 too; the ledger shows at once whether they \
                 are.",
        tests: &["passes::row_66_plain_radiosity_takes_mirrors_for_black"],
        shown: Shown::Curve(booked_as_absorbed),
    },
    Row {
        number: 73,
        name: "Recursion cut at a depth",
        why: "A mirror in a mirror is a geometric series, and a depth its number of \
              terms.",
        size: "Of mirrors of share r a depth d leaves out r^(d+1): 41 % at depth 3 and \
               0.4 % at 24 for r = 0.8; ours tells what it cut, to rounding.",
        remedy: "Cut by weight and not by depth, and state what was cut.",
        tests: &["passes::row_73_recursion_is_cut_at_its_depth"],
        shown: Shown::Curve(cut_at_a_depth),
    },
];

/// The floor beside a mirror `x = 1` of this share, below the unit square that is the
/// lamp.
fn beside_a_mirror(share: f64) -> Scene {
    let wall = rectangle(dvec3(1.0, -50.0, -50.0), 100.0 * DVec3::Z, 100.0 * DVec3::Y);
    shiny([(spot(), dull(0.0, 0.5)), (lamp(), dull(PI, 0.0)), (wall, mirror(share))])
}

/// From above, past the lamp.
fn look() -> Ray {
    let origin = dvec3(0.0, 0.9, 0.9);
    Ray { origin, direction: -origin.normalize() }
}

/// The floor as two passes show it, pass 1 with its mirror; as a factor: `πL/(ρE)`.
fn of_two_passes(share: f64) -> f64 {
    let scene = beside_a_mirror(share);
    let world = VirtualWorld::of(&scene, 1);
    let mesh = Mesh::whole(&scene);
    let b = 0.5 * PI * factor(&world, DVec3::ZERO, &spot(), &lamp()).x;
    let corners = vec![Rgb::splat(b); mesh.vertices.len()];
    let two = TwoPass::showing(&Room::of(&scene), &mesh, &corners, Look::default());
    2.0 * two.along(&look()).radiance.x
}

/// Straight from the lamp, and by a perfect mirror, in closed form.
fn straight_and_mirrored() -> [f64; 2] {
    use super::mirrors::from_origin;
    [from_origin(-0.5, 0.5), from_origin(1.5, 2.5)]
}

const SHARES: [f64; 6] = [0.0, 0.2, 0.4, 0.6, 0.8, 1.0];

/// Row 64: what a floor beside a mirror has too much when both passes add what comes by
/// it.
pub fn counted_twice() -> Sweep {
    let [straight, mirrored] = straight_and_mirrored();
    let right = |k: f64| straight + k * mirrored;
    let off = |got: f64, k: f64| 100.0 * (got / right(k) - 1.0);
    // What pass 1 found by the mirror, once more.
    let again = |k: f64| 2.0 * of_two_passes(k) - of_two_passes(0.0);
    Sweep {
        knob: "share of light that the mirror reflects",
        quantity: "light on the floor in excess, %",
        logarithmic: [false, false],
        found: vec![
            Found::over("the mirror's light in both", &SHARES, |k| off(again(k), k)),
            Found::over("ours: in pass 1", &SHARES, |k| off(of_two_passes(k), k)),
        ],
        theory: curve(&SHARES, |k| off(right(k) + k * mirrored, k)),
        law: "factor of the image over that of all",
    }
}

/// Row 65: what it lacks when rays ask lamps straight.
pub fn lost_light() -> Sweep {
    let [straight, mirrored] = straight_and_mirrored();
    let lacks = |got: f64, k: f64| 100.0 * (1.0 - got / (straight + k * mirrored));
    let classical = |k: f64| {
        let scene = beside_a_mirror(k);
        let whitted = Whitted::of(&Room::of(&scene), Look::default());
        2.0 * whitted.along(&look()).radiance.x
    };
    Sweep {
        knob: "share of light that the mirror reflects",
        quantity: "light on the floor that lacks, %",
        logarithmic: [false, false],
        found: vec![
            Found::over("classical ray tracing", &SHARES, |k| lacks(classical(k), k)),
            Found::over("ours: two passes", &SHARES, |k| lacks(of_two_passes(k), k)),
        ],
        theory: curve(&SHARES, |k| lacks(straight, k)),
        law: "factor of the image over that of all",
    }
}

/// The factor between opposed unit squares at distance 1.
pub const FACING: f64 = 0.199_824_895_698_387;

/// Row 66: what plain radiosity books as absorbed of a lamp of 1 W before a mirror,
/// both unit squares, and what the mirror really takes.
pub fn booked_as_absorbed() -> Sweep {
    let booked = |k: f64| {
        let squares = built_in("facing-squares").unwrap();
        let material = |s: &radiosity::scene::Surface| match squares.material(s).emits()
        {
            true => dull(1.0, 0.0),
            false => mirror(k),
        };
        let faces = squares.surfaces.iter().map(|s| (s.polygon.clone(), material(s)));
        let scene = shiny(faces);
        let mesh = Mesh::whole(&scene);
        let matrix = Analytic::new(&scene, &mesh, 1e-9, 0).matrix(&|| ());
        let enclosure = Enclosure::of(&scene, &mesh);
        let step = GaussSeidel::new(&enclosure, &matrix).next().unwrap();
        step.ledger.absorbed.x
    };
    Sweep {
        knob: "share of light that the mirror reflects",
        quantity: "absorbed, of the lamp's power, %",
        logarithmic: [false, false],
        found: vec![Found::over("plain radiosity", &SHARES, |k| 100.0 * booked(k))],
        theory: curve(&SHARES, |k| 100.0 * (1.0 - k) * FACING),
        law: "what the mirror takes: (1 − k)F",
    }
}

/// Two mirrors of share `r` that glow with radiance 1.
pub fn hall_of(r: f64) -> Scene {
    let glowing = Coefficients { emission: Rgb::splat(PI), ..mirror(r) };
    let low = rectangle(DVec3::ZERO, DVec3::X, DVec3::Y);
    let high = rectangle(DVec3::Z, DVec3::Y, DVec3::X);
    shiny([(low, glowing), (high, glowing)])
}

/// A ray that goes to and fro between them.
pub fn between() -> Ray {
    Ray { origin: dvec3(0.4, 0.3, 0.5), direction: DVec3::Z }
}

/// What a depth of recursion shows there, and what it says that it cut.
pub fn hall(r: f64, depth: u32) -> Along {
    let scene = hall_of(r);
    let mesh = Mesh::whole(&scene);
    let glow = vec![Rgb::splat(PI); mesh.vertices.len()];
    let look = Look::following(depth, 0.0);
    TwoPass::showing(&Room::of(&scene), &mesh, &glow, look).along(&between())
}

/// Row 73: what is missing of a hall of mirrors.
pub fn cut_at_a_depth() -> Sweep {
    let depths = [0.0, 1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 16.0, 24.0];
    let missing =
        |r: f64| move |d: f64| 100.0 * (1.0 - hall(r, d as u32).radiance.x * (1.0 - r));
    Sweep {
        knob: "depth of recursion",
        quantity: "light that is missing, %",
        logarithmic: [false, true],
        found: vec![
            Found::over("mirrors of 0.8", &depths, missing(0.8)),
            Found::over("of 0.5", &depths, missing(0.5)),
            Found::over("what ours says it cut, 0.8", &depths, |d| {
                100.0 * hall(0.8, d as u32).cut.x
            }),
        ],
        theory: curve(&depths, |d| 100.0 * 0.8f64.powf(d + 1.0)),
        law: "0.8ᵈ⁺¹",
    }
}
