//! Failures at the outlines and the weights of polygons: rows 12 to 14.

use super::exact::above_corner;
use super::rooms::{rectangle, unit_square};
use super::shapes::lid;
use super::{Found, Row, Shown, Sweep, curve};
use glam::{DVec3, dvec3};
use radiosity::form_factor::Accuracy;
use radiosity::form_factor::analytic::{exchange, lambert_polygon};
use radiosity::form_factor::exchange_by_contour;
use radiosity::form_factor::named::perpendicular_rectangles;
use radiosity::geometry::Polygon;
use radiosity::radiometry::solid_angle;
use std::f64::consts::TAU;

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 12,
        name: "What is behind, not cut away",
        why: "The contour integral counts with a sign: what lies below the horizon cancels \
              what lies above.",
        size: "A wall sunk to its half has the factor 0 instead of .146.",
        remedy: "Clip each polygon to the front of the other first.",
        tests: &["pairs::row_12_what_is_behind_must_be_cut_away"],
        shown: Shown::Curve(sunken),
    },
    Row {
        number: 13,
        name: "Two answers for a twisted face",
        why: "Four corners that are not in a plane bound no polygon; each diagonal makes \
              another pair of triangles.",
        size: "Both exchange the same light (Stokes) but differ in area, and so in factor: \
               1.75 % at a twist of .6.",
        remedy: "Refuse it as a polygon, split it by a rule, and say so.",
        tests: &["pairs::row_13_a_twisted_face_has_two_areas"],
        shown: Shown::Curve(twisted),
    },
    Row {
        number: 14,
        name: "Weights without a cosine",
        why: "Solid angles fill the half-space as well as factors do: the row sums to 1.",
        size: "A square of side 1 at distance 1 gets .128 instead of .239; one that is \
               very wide gets what it should.",
        remedy: "Test one patch whose factor is known.",
        tests: &["pairs::row_14_rows_do_not_show_wrong_weights"],
        shown: Shown::Curve(without_cosine),
    },
];

/// A unit wall on the ground's edge x = 1 that begins at this height.
pub fn wall_from(z: f64) -> Polygon {
    rectangle(dvec3(1.0, 0.0, z), DVec3::Z, DVec3::Y)
}

/// Row 12.
pub fn sunken() -> Sweep {
    let knobs = [0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0];
    let ground = unit_square(0.0, true);
    Sweep {
        knob: "depth of the wall's foot below the floor",
        quantity: "F",
        logarithmic: [false, false],
        found: vec![
            Found::over("not cut", &knobs, |z| {
                exchange_by_contour(ground.vertices(), wall_from(-z).vertices())
            }),
            Found::over("ours", &knobs, |z| {
                exchange(&ground, &wall_from(-z), Accuracy::Best)
            }),
        ],
        theory: curve(&knobs, |z| match 1.0 - z {
            0.0 => 0.0,
            left => perpendicular_rectangles(1.0, left, 1.0),
        }),
        law: "closed form of the part above the floor",
    }
}

/// Four corners, the last of them lifted by `twist` out of the plane of the others.
pub fn twisted_corners(twist: f64) -> [DVec3; 4] {
    [
        dvec3(0.0, 0.0, 1.0),
        dvec3(0.0, 1.0, 1.0),
        dvec3(1.0, 1.0, 1.0),
        dvec3(1.2, -0.2, 1.0 + twist),
    ]
}

/// What such pieces exchange with the floor below, and their factor.
pub fn to_the_floor(pieces: &[Polygon]) -> (f64, f64) {
    let floor = unit_square(0.0, true);
    let exchanged: f64 =
        pieces.iter().map(|p| exchange(p, &floor, Accuracy::Best)).sum();
    let area: f64 = pieces.iter().map(Polygon::area).sum();
    (exchanged, exchanged / area)
}

/// The two triangles on one diagonal, or on the other.
pub fn cut_along(corners: &[DVec3; 4], other: bool) -> [Polygon; 2] {
    let ids = if other { [[1, 2, 3], [1, 3, 0]] } else { [[0, 1, 2], [0, 2, 3]] };
    ids.map(|ids| {
        let corners = ids.map(|k: usize| corners[k]).to_vec();
        Polygon::new(corners).expect("three corners hold an area")
    })
}

/// Row 13.
pub fn twisted() -> Sweep {
    let knobs = [0.0, 0.15, 0.3, 0.6, 0.9, 1.2];
    let apart = |twist: f64| {
        let corners = twisted_corners(twist);
        let of = |other| to_the_floor(&cut_along(&corners, other)).1;
        100.0 * (of(false) / of(true) - 1.0)
    };
    let area = |corners: &[DVec3; 4], ids: [[usize; 3]; 2]| {
        let twice = ids.map(|[a, b, c]| {
            (corners[b] - corners[a]).cross(corners[c] - corners[a]).length()
        });
        0.5 * (twice[0] + twice[1])
    };
    let law = |twist: f64| {
        let corners = twisted_corners(twist);
        let one = area(&corners, [[0, 1, 2], [0, 2, 3]]);
        100.0 * (area(&corners, [[1, 2, 3], [1, 3, 0]]) / one - 1.0)
    };
    Sweep {
        knob: "how far the corner is out of the plane",
        quantity: "F by one diagonal over F by the other, %",
        logarithmic: [false, false],
        found: vec![Found::over("two triangles each", &knobs, apart)],
        theory: curve(&knobs, law),
        law: "the two areas: what is exchanged is the same (Stokes)",
    }
}

/// Row 14.
pub fn without_cosine() -> Sweep {
    let knobs = [0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0];
    let above = |side: f64| lid(side, DVec3::Z);
    Sweep {
        knob: "side / distance",
        quantity: "F of a square straight above",
        logarithmic: [true, false],
        found: vec![
            Found::over("solid angle / 2π", &knobs, |side| {
                solid_angle(DVec3::ZERO, &above(side)) / TAU
            }),
            Found::over("with the cosine", &knobs, |side| {
                lambert_polygon(DVec3::ZERO, DVec3::Z, &above(side))
            }),
        ],
        theory: curve(&knobs, |side| 4.0 * above_corner(0.5 * side, 0.5 * side)),
        law: "closed form from the point (Howell B-3)",
    }
}
