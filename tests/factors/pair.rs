//! The form factor of two polygons, alone and past blockers.

use crate::common::rooms::{moved, rectangle, unit_square};
use glam::{DVec3, dvec3};
use radiosity::form_factor::{
    Accuracy, form_factor, form_factor_past, named::parallel_rectangles,
};
use radiosity::geometry::Polygon;

fn floor_and_lid() -> (Polygon, Polygon) {
    (unit_square(0.0, true), unit_square(1.0, false))
}

/// A wall from floor to lid, at `x = ½`: left sees left, right sees right.
#[test]
fn a_dividing_wall_leaves_the_halves() {
    let (floor, lid) = floor_and_lid();
    let wall = rectangle(0.5 * DVec3::X, DVec3::Y, DVec3::Z);
    let halves = (0.5, 1.0); // of half the area, twice
    let expected = parallel_rectangles(halves.0, halves.1, 1.0);
    for digits in 1..=6 {
        let accuracy = 0.1_f64.powi(digits);
        for wall in [wall.clone(), wall.flipped()] {
            let got = form_factor_past(&floor, &lid, &[wall], accuracy);
            assert!(
                (got - expected).abs() <= accuracy,
                "{accuracy:e}: {got} {expected}"
            );
        }
    }
}

#[test]
fn scale_and_place_do_not_matter() {
    let (floor, lid) = floor_and_lid();
    let screen = rectangle(dvec3(0.2, 0.3, 0.4), 0.5 * DVec3::X, 0.4 * DVec3::Y);
    let open = form_factor(&floor, &lid);
    let past = form_factor_past(&floor, &lid, std::slice::from_ref(&screen), 1e-5);
    assert!(0.0 < past && past < open);
    for scale in [1e-12, 1e-3, 1e3, 1e12] {
        let there = |p: &Polygon| moved(p, |v| scale * (v + dvec3(3.0, -2.0, 1.0)));
        let (a, b, c) = (there(&floor), there(&lid), there(&screen));
        assert!((form_factor(&a, &b) - open).abs() < 1e-12);
        assert!((form_factor_past(&a, &b, &[c], 1e-5) - past).abs() < 1e-5);
    }
}

#[test]
fn degenerate_pairs_see_nothing_and_degenerate_blockers_hide_nothing() {
    let (floor, lid) = floor_and_lid();
    let beside = moved(&floor, |v| v + DVec3::X);
    for other in [&floor, &floor.flipped(), &beside, &beside.flipped(), &lid.flipped()]
    {
        assert_eq!(form_factor(&floor, other), 0.0);
        assert_eq!(form_factor_past(&floor, other, &[], Accuracy::Best), 0.0);
    }
    let open = form_factor(&floor, &lid);
    let wall = rectangle(DVec3::ZERO, DVec3::Y, DVec3::Z); // along a side
    let blockers = [floor.clone(), floor.flipped(), lid.clone(), beside, wall];
    let past = form_factor_past(&floor, &lid, &blockers, 1e-6);
    assert!((past - open).abs() <= 1e-6, "{past} {open}");
    let all = rectangle(dvec3(-1.0, -1.0, 0.5), 3.0 * DVec3::X, 3.0 * DVec3::Y);
    assert_eq!(form_factor_past(&floor, &lid, &[all], 1e-6), 0.0);
}
