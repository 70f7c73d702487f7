//! Failures of form factors that are taken at points: rows 1 to 7.

use super::exact::CORNER;
use super::matrices::{by_rule, from_centre, lit_cube, spectral_radius};
use super::rooms::{black, exact_factors, rectangle, rows as all_rows};
use super::shapes::{floor, lid, mesh_of};
use super::{Found, Row, Shown, Sweep, curve};
use glam::DVec3;
use radiosity::form_factor::hemicube::Hemicube;
use radiosity::form_factor::named::parallel_rectangles;
use radiosity::form_factor::shortcuts::{point_to_disc, point_to_point};
use radiosity::geometry::Polygon;
use radiosity::mesh::Mesh;
use std::f64::consts::PI;

/// The rows of this family.
pub const ROWS: &[Row] = &[
    Row {
        number: 1,
        name: "The centre is not the mean",
        why: "One point speaks for a whole square, though near by its other points see \
              less.",
        size: "Up to 33 % too much, at half a side; 20 % at one side, 1.3 % at five. A \
               hemicube at the centre has the same error at any resolution.",
        remedy: "Cut near pairs smaller, or integrate over both (the exact method).",
        tests: &["form_factors::row_01_the_centre_is_not_the_mean"],
        shown: Shown::Curve(centre),
    },
    Row {
        number: 2,
        name: "Points for squares",
        why: "1/r² at two middle points has no upper bound, while a factor ends at 1.",
        size: "+59 % at one side, F = 5.1 at a quarter, F = 127 at a twentieth; rows of a \
               closed cube sum to as much as 1.59.",
        remedy: "Never use it nearer than five sizes.",
        tests: &[
            "form_factors::row_02_points_have_no_upper_bound",
            "form_factors::row_02_rows_of_the_point_rule_exceed_one",
        ],
        shown: Shown::Curve(points),
    },
    Row {
        number: 3,
        name: "Light that grows for ever",
        why: "Rows that sum to more than 1/ρ reflect more than they get.",
        size: "In a cube with ρ = 0.9 and 2 × 2 elements a wall the radius is 1.146: no \
               solution. With 6 × 6 it is .989, and the light 8.8 times what it should be.",
        remedy: "Factors whose rows sum to one; a solver that looks at its own books.",
        tests: &["form_factors::row_03_point_factors_make_light_grow"],
        shown: Shown::Curve(growth),
    },
    Row {
        number: 4,
        name: "A disc instead of the square",
        why: "A/(π r² + A) is exact for a disc straight above; it stays below 1, which is \
              not the same as being right.",
        size: "+35 % at half a side, +21 % at one: the error of the centre, and 1 % more.",
        remedy: "As for the centre: cut near pairs smaller.",
        tests: &["form_factors::row_04_a_disc_is_bounded_and_wrong"],
        shown: Shown::Curve(disc),
    },
    Row {
        number: 5,
        name: "Five times is far enough",
        why: "The engineer's rule takes a lamp for a point from five sizes on.",
        size: "It means 2.6 % between two points, 1.3 % when only one side is a point.",
        remedy: "Know what the rule promises; ten sizes give .7 %.",
        tests: &["form_factors::row_05_five_times_means_three_per_cent"],
        shown: Shown::Curve(five_times),
    },
    Row {
        number: 6,
        name: "Points beside a shared edge",
        why: "Where two walls meet, the factor falls steeply between the points that are \
              asked for it.",
        size: "−5.0 % with one point, and a quarter with each halving: −1.0, −.24, −.06 %.",
        remedy: "Second order is good enough: halve the elements along the edge.",
        tests: &["form_factors::row_06_points_beside_an_edge"],
        shown: Shown::Curve(one_side),
    },
    Row {
        number: 7,
        name: "Points on both sides of an edge",
        why: "The pairs next to the edge are always as near as they are large, however \
              small.",
        size: "+59 % with one pair, and only half of it with each halving: 32, 16.5, 8.4, \
               4.2 %.",
        remedy: "A closed form on one side at least.",
        tests: &["form_factors::row_07_pairs_of_points_beside_an_edge"],
        shown: Shown::Curve(both_sides),
    },
];

/// Distances in sides.
pub const DISTANCES: [f64; 9] = [0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0];

/// Two unit squares that face each other.
pub fn facing(distance: f64) -> [Polygon; 2] {
    [floor(1.0, DVec3::ZERO), lid(1.0, DVec3::Z * distance)]
}

fn exact(distance: f64) -> f64 {
    parallel_rectangles(1.0, 1.0, distance)
}

/// The excess in per cent of a rule for facing squares.
fn excess(distance: f64, rule: impl Fn(&Polygon, &Polygon) -> f64) -> f64 {
    let [i, j] = facing(distance);
    100.0 * (rule(&i, &j) / exact(distance) - 1.0)
}

/// The excess in per cent of a hemicube at the centre.
pub fn by_hemicube(distance: f64, resolution: u32) -> f64 {
    let mesh = mesh_of(&facing(distance)[1..], 99.0);
    let mut row = [0.0];
    Hemicube::new(&mesh, resolution).at(DVec3::ZERO, DVec3::Z, &mut row);
    100.0 * (row[0] / exact(distance) - 1.0)
}

/// Row 1.
pub fn centre() -> Sweep {
    let law = |d: f64| {
        let half = 0.5 / d;
        100.0 * (4.0 * super::exact::above_corner(half, half) / exact(d) - 1.0)
    };
    Sweep {
        knob: "distance / side",
        quantity: "error of F, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("centre", &DISTANCES, |d| excess(d, from_centre)),
            Found::over("hemicube of 256", &DISTANCES[..6], |d| by_hemicube(d, 256)),
        ],
        theory: curve(&DISTANCES, law),
        law: "closed form from the centre over that between squares",
    }
}

/// Row 2.
pub fn points() -> Sweep {
    let rule = |d: f64| point_to_point(&facing(d)[0], &facing(d)[1]);
    Sweep {
        knob: "distance / side",
        quantity: "F",
        logarithmic: [true, true],
        found: vec![Found::over("point to point", &DISTANCES, rule)],
        theory: curve(&DISTANCES, exact),
        law: "F between the squares, closed form: never above 1",
    }
}

/// Row 3.
pub fn growth() -> Sweep {
    const RHO: f64 = 0.9;
    let by_points = |k: f64| {
        RHO * spectral_radius(&by_rule(&lit_cube(k as usize, RHO).0, point_to_point))
    };
    let by_closed_form = |k: f64| {
        let rows = all_rows(&exact_factors(&lit_cube(k as usize, RHO).0));
        RHO * spectral_radius(&rows.into_iter().map(|row| row.0).collect::<Vec<_>>())
    };
    let all = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0];
    Sweep {
        knob: "elements along a wall",
        quantity: "spectral radius of ρF",
        logarithmic: [true, false],
        found: vec![
            Found::over("point to point", &all, by_points),
            Found::over("exact factors", &all[..4], by_closed_form),
        ],
        theory: curve(&all, |_| 1.0),
        law: "above 1 the light grows without end",
    }
}

/// Row 4.
pub fn disc() -> Sweep {
    Sweep {
        knob: "distance / side",
        quantity: "error of F, %",
        logarithmic: [true, false],
        found: vec![
            Found::over("point to disc", &DISTANCES, |d| excess(d, point_to_disc)),
            Found::over("centre", &DISTANCES, |d| excess(d, from_centre)),
        ],
        theory: curve(&DISTANCES, |d| {
            100.0 * (1.0 / (PI * d * d + 1.0) / exact(d) - 1.0)
        }),
        law: "1/(π d² + 1) over the closed form",
    }
}

/// Row 5.
pub fn five_times() -> Sweep {
    let far = [1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 20.0];
    Sweep {
        knob: "distance / side",
        quantity: "error of F, %",
        logarithmic: [true, true],
        found: vec![
            Found::over("point to point", &far, |d| excess(d, point_to_point)),
            Found::over("point to square", &far, |d| excess(d, from_centre)),
        ],
        theory: curve(&far, |d| 100.0 * 2.0 / 3.0 / (d * d)),
        law: "⅔ (side/distance)², the first term; half of it with one point",
    }
}

/// A unit floor and a wall on one of its edges, each in `k × k` pieces.
fn corner_in_pieces(k: f64) -> [Vec<Polygon>; 2] {
    let pair = [
        rectangle(DVec3::ZERO, DVec3::X, DVec3::Y),
        rectangle(DVec3::ZERO, DVec3::Z, DVec3::X),
    ];
    pair.map(|polygon| {
        let mesh = Mesh::uniform(&black([polygon]), 1.0 / k);
        mesh.polygons().cloned().collect()
    })
}

/// Row 6.
pub fn one_side() -> Sweep {
    let wall = rectangle(DVec3::ZERO, DVec3::Z, DVec3::X);
    let off = |k: f64| {
        let [floor, _] = corner_in_pieces(k);
        let sum: f64 = floor.iter().map(|p| p.area() * from_centre(p, &wall)).sum();
        100.0 * (1.0 - sum / CORNER)
    };
    let knobs = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0];
    Sweep {
        knob: "points along the edge",
        quantity: "F missing, %",
        logarithmic: [true, true],
        found: vec![Found::over("centre to wall", &knobs, off)],
        theory: curve(&knobs, |k| 0.06 * (8.0 / k).powi(2)),
        law: "a quarter with each halving, through the published .06 % at 8",
    }
}

/// Row 7.
pub fn both_sides() -> Sweep {
    let off = |k: f64| {
        let [floor, wall] = corner_in_pieces(k);
        let to_wall = |p: &Polygon| {
            p.area() * wall.iter().map(|q| point_to_point(p, q)).sum::<f64>()
        };
        100.0 * (floor.iter().map(to_wall).sum::<f64>() / CORNER - 1.0)
    };
    let knobs = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0];
    Sweep {
        knob: "points along the edge",
        quantity: "F in excess, %",
        logarithmic: [true, true],
        found: vec![Found::over("point to point", &knobs, off)],
        theory: curve(&knobs, |k| 2.1 * 32.0 / k),
        law: "one half with each halving, through the published 2.1 % at 32",
    }
}
