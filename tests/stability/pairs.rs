//! Pinned failures of factors between two polygons, row by row of the table of failures:
//! samples, quadratures, closed forms and outlines that go wrong, and by how much. The
//! curves: `failures/pairs.rs` and `failures/outlines.rs`.

use crate::common::{cases, within};
use crate::failures::exact::{CORNER, FACING};
use crate::failures::outlines::{
    self, cut_along, to_the_floor, twisted_corners, wall_from,
};
use crate::failures::pairs::{
    self, by_pairs, corner, leaning, plain_contour, printed, rms,
};
use crate::failures::rooms::{black, box_walls, moved, rectangle, rows, unit_square};
use crate::failures::shapes::lid;
use glam::{DVec3, dvec3};
use radiosity::form_factor::Accuracy;
use radiosity::form_factor::analytic::{Analytic, exchange, lambert_polygon};
use radiosity::form_factor::area::{controlled, sampled};
use radiosity::form_factor::exchange_by_contour;
use radiosity::form_factor::named::parallel_rectangles;
use radiosity::geometry::{Polygon, split};
use radiosity::mesh::{ElementId, Mesh};
use radiosity::radiometry::solid_angle;
use radiosity::visibility::Visibility;
use std::f64::consts::{PI, TAU};

/// Pairs of random points have no variance at a common edge. The kernel's square goes as
/// 1/r² over r, so the largest of n samples grows as n^⅔, and a mean of a hundred times as
/// many is not ten times better, but 5 at best. Rays are as good there as anywhere.
#[test]
fn row_08_random_pairs_have_infinite_variance_at_an_edge() {
    let sweep = pairs::random_pairs();
    let gain = |method| sweep.by(method, 10_000.0) / sweep.by(method, 100.0);
    assert!(gain(0) > 0.15 && sweep.at(10_000.0) > 5.0, "{sweep:?}");
    assert!((0.08..0.12).contains(&gain(1)), "{sweep:?}");
    for n in [30.0, 100.0, 300.0, 1000.0, 3000.0, 10_000.0] {
        // The spread of a hundred runs is known to 7 %; three times that.
        let share = sweep.by(2, n) / sweep.expected(n);
        assert!((share - 1.0).abs() < 0.21, "{n}: {share}");
    }
    // Facing squares: .1 % at 1e5, as the table says.
    let at_1e5 = sweep.by(1, 10_000.0) / 10_f64.sqrt();
    assert!((0.08..0.13).contains(&at_1e5), "{at_1e5}");
    let largest = |samples| {
        let [_, wall] = corner();
        let mut largest: Vec<f64> =
            (0..100).map(|seed| by_pairs(&wall, samples, seed).1).collect();
        largest.sort_by(f64::total_cmp);
        largest[50]
    };
    let growth = largest(10_000) / largest(100);
    assert!((12.0..40.0).contains(&growth), "{growth}"); // 100^⅔ = 21.5
    assert!(by_pairs(&unit_square(1.0, false), 10_000, 0).1 <= 1.0 / PI);
}

/// Points that fill their space evenly do not help: a hundred times as many gain much less
/// than tenfold. A control that knows the unhidden factor leaves no error where nothing is
/// hidden.
#[test]
fn row_08_the_control_takes_the_variance_away() {
    let ([floor, wall], empty) = (corner(), Visibility::new([]));
    let off = |n| rms(CORNER, |seed| sampled(&floor, &wall, &empty, n, seed).exchange);
    let (few, many) = (off(300), off(30_000));
    assert!(many > few / 10.0 && many > 0.5, "{few} {many} %");
    let estimate = controlled(&floor, &wall, &empty, 100, 1);
    assert!((estimate.exchange - CORNER).abs() < 1e-12);
    assert_eq!(estimate.standard_error, 0.0);
}

/// Where edges touch, the contour integral has a logarithm that Gauss points do not
/// resolve: as many as give eleven digits of squares that face each other are off by 7.5e-3
/// on a wedge of any angle, and twice as many by half of that. Points that crowd at the
/// ends give all digits.
#[test]
fn row_09_touching_edges_want_a_better_rule() {
    let sweep = pairs::gauss_points();
    assert!((7e-3..8e-3).contains(&sweep.at(12.0)), "{sweep:?}");
    assert!(sweep.by(1, 12.0) < 1e-11, "{sweep:?}");
    for n in [3.0, 6.0, 12.0, 24.0, 48.0] {
        assert!((sweep.at(n) / sweep.expected(n) - 1.0).abs() < 1.0 / n, "{sweep:?}");
        assert!(sweep.by(2, n) < 1e-12, "{sweep:?}");
    }
    let ground = unit_square(0.0, true);
    for degrees in [60.0_f64, 90.0, 120.0, 150.0] {
        let leaning = leaning(degrees);
        let ours = exchange_by_contour(ground.vertices(), leaning.vertices());
        let [few, many] = [12, 24].map(|n| (plain_contour(&leaning, n) - ours).abs());
        assert!((7e-3..8e-3).contains(&few), "{degrees}: {few:e}");
        assert!((1.8..2.0).contains(&(few / many)), "{degrees}: {few:e} {many:e}");
    }
    let ours = exchange_by_contour(ground.vertices(), leaning(120.0).vertices());
    assert!((ours - 0.086_615_001_1).abs() < 5e-11, "{ours}");
}

/// Closed forms cancel. The printed formula of parallel rectangles loses rounding times the
/// fourth power of the distance; the contour integral keeps 1e-12 absolute, which is
/// nothing of 3e-9; what we use far away keeps all.
#[test]
fn row_10_closed_forms_cancel_far_away() {
    let sweep = pairs::cancellation();
    for distance in [10.0, 100.0, 1e3, 1e4] {
        let share = sweep.at(distance) / sweep.expected(distance);
        assert!((0.3..5.0).contains(&share), "{distance}: {share}");
    }
    for distance in [1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6] {
        assert!(sweep.by(2, distance) < 1e-11, "{distance}");
    }
    assert!(sweep.at(1e5) > 0.99 && sweep.at(1e6) > 0.99);
    let mut met = 0;
    for case in cases("S_stability").iter().filter(|c| c["family"] == "C-11 naive") {
        let d = case["params"]["c"].as_f64().unwrap();
        let exact = case["expected"]["exact"].as_f64().unwrap();
        let published = case["naive"]["C11_f64"]["rel_error"].as_f64().unwrap();
        let got = (printed(d) / exact - 1.0).abs();
        // As much as published, give or take the order of rounding.
        assert!(got < 30.0 * published + 1e-15, "{d}: {got:e} {published:e}");
        assert!(got > published / 30.0 || published < 1e-11, "{d}: {got:e}");
        let (i, j) = (unit_square(0.0, true), unit_square(d, false));
        let ours = exchange(&i, &j, Accuracy::Best);
        assert!(within(ours, exact, 1e-11, 0.0), "{d}: {ours} {exact}");
        let contour = exchange_by_contour(i.vertices(), j.vertices());
        assert!((contour - exact).abs() < 1e-12 * d.max(1.0), "{d}: {contour}");
        met += 1;
    }
    assert_eq!(met, 6);
    // A tilt of 1e-9 makes edges almost parallel, and nothing jumps.
    let tilted = moved(&unit_square(1.0, false), |p| p + DVec3::Z * (1e-9 * p.x));
    let jump = exchange(&unit_square(0.0, true), &tilted, Accuracy::Best) - FACING;
    assert!(jump.abs() < 1e-9 && jump != 0.0, "{jump:e}");
}

/// Squares a hundredth of their side apart: middles and middles of quarters see nearly all,
/// and agree, though a strip along the rim does not. Whatever is asked for, down to 1e-3,
/// the rule stops at the second step, 1.9 % off.
#[test]
fn row_11_halving_converges_to_the_wrong_number() {
    let sweep = pairs::false_convergence();
    for asked in [1e-2, 3e-3, 1e-3] {
        assert!(
            (sweep.at(asked) - 0.01918).abs() < 1e-5,
            "{asked}: {}",
            sweep.at(asked)
        );
        assert!(sweep.at(asked) > 1.9 * sweep.expected(asked));
    }
    // Wider apart it errs by more, and is caught sooner. Ours needs no second step.
    for (method, distance, asked, given) in
        [(0, 0.01, 1e-3, 0.0192), (1, 0.03, 0.01, 0.0530), (2, 0.1, 0.1, 0.1253)]
    {
        let got = sweep.by(method, asked);
        assert!((got - given).abs() < 1e-4 && got > asked, "{distance}: {got}");
        let [i, j] = crate::failures::factors::facing(distance);
        let exact = parallel_rectangles(1.0, 1.0, distance);
        assert!((exchange(&i, &j, 1e-2) / exact - 1.0).abs() < 1e-12, "{distance}");
    }
}

/// An obstruction that touches the wall made an adaptive rule stop at F = 1.31, with a row
/// of 1.56. Ours stays below 1, between its bounds, and closes the room.
#[test]
fn row_11_touching_obstructions_do_no_harm() {
    let mut walls = box_walls([1.0, 1.0, 1.0]).to_vec();
    // A ledge on the wall x = 0, whose back lies in the wall, and a card that leans on it.
    let ledge = box_walls([0.3, 0.4, 0.1])
        .map(|wall| moved(&wall.flipped(), |p| p + dvec3(0.0, 0.3, 0.5)));
    walls.extend(ledge.into_iter().skip(1));
    walls.push(rectangle(dvec3(0.0, 0.0, 0.2), dvec3(0.2, 0.0, -0.2), DVec3::Y));
    let scene = black(walls);
    let mesh = Mesh::uniform(&scene, 0.5);
    let method = Analytic::new(&scene, &mesh, 1e-4, 1);
    for (i, (row, lost)) in rows(&method).iter().enumerate() {
        assert!(row.iter().all(|f| (0.0..=1.0).contains(f)), "row {i}");
        let seen: f64 = row.iter().sum();
        assert!(seen < 1.0 + 2e-3, "row {i}: {seen}");
        // What is lost is counted by 256 rays: to a few per cent.
        let all = seen + lost.escaped + lost.absorbed;
        assert!((all - 1.0).abs() < 0.06, "row {i}: {all}");
    }
    for i in 0..mesh.elements.len() as u32 {
        for j in 0..i {
            let (i, j) = (ElementId(i), ElementId(j));
            let (low, high) = method.bounds(i, j, 2);
            let found = method.exchange(i, j);
            assert!((low - 1e-4..=high + 1e-4).contains(&found), "{i:?} {j:?}");
        }
    }
}

/// A polygon that the other's plane cuts. Without clipping half a wall cancels the other
/// half; coplanar and averted pairs have the factor 0, with no sign.
#[test]
fn row_12_what_is_behind_must_be_cut_away() {
    let sweep = outlines::sunken();
    for depth in [0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0] {
        let (ours, exact) = (sweep.by(1, depth), sweep.expected(depth));
        assert!((ours - exact).abs() < 1e-11, "{depth}: {ours}, not {exact}");
    }
    for (depth, exact, uncut) in [(0.1, 0.19286, 0.14961), (0.5, 0.14619, 0.0)] {
        assert!((sweep.by(1, depth) - exact).abs() < 1e-5, "{}", sweep.by(1, depth));
        assert!((sweep.at(depth) - uncut).abs() < 1e-5, "{}", sweep.at(depth));
    }
    let ground = unit_square(0.0, true);
    let beside = moved(&ground, |p| p + 2.0 * DVec3::X);
    for other in [beside, unit_square(1.0, true), unit_square(-1.0, false)] {
        assert_eq!(exchange(&ground, &other, Accuracy::Best), 0.0);
    }
    assert_eq!(exchange(&ground, &wall_from(-1.0), Accuracy::Best), 0.0);
}

/// A twisted quadrilateral is no polygon: it is refused, and split along its shorter
/// diagonal. The other diagonal bounds the same outline, so it exchanges the same light with
/// all that sees its front (Stokes) - but it has another area, hence another factor.
#[test]
fn row_13_a_twisted_face_has_two_areas() {
    let sweep = outlines::twisted();
    assert!((sweep.at(0.6) - 1.75).abs() < 0.01, "{}", sweep.at(0.6));
    for twist in [0.0, 0.15, 0.3, 0.6, 0.9, 1.2] {
        let (got, areas) = (sweep.at(twist), sweep.expected(twist));
        assert!((got - areas).abs() < 1e-10, "{twist}: {got} {areas}");
    }
    let corners = twisted_corners(0.6);
    assert!(Polygon::new(corners.to_vec()).is_err());
    let [one, other] = [false, true].map(|d| to_the_floor(&cut_along(&corners, d)));
    assert!((one.0 - other.0).abs() < 1e-14, "{one:?} {other:?}");
    let split = to_the_floor(&split(&corners).unwrap());
    assert!((split.1 - one.1).abs() < 1e-14, "{split:?}"); // 0 to 2 is the shorter
}

/// Weights without the cosine sum to 1 all the same. Only a patch whose factor is known
/// shows it: .128 for .2395.
#[test]
fn row_14_rows_do_not_show_wrong_weights() {
    let sweep = outlines::without_cosine();
    assert!((sweep.at(1.0) - 0.128).abs() < 5e-4, "{}", sweep.at(1.0));
    for side in [0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0] {
        let (got, exact) = (sweep.by(1, side), sweep.expected(side));
        assert!((got - exact).abs() < 1e-14, "{side}: {got} {exact}");
    }
    let right = lambert_polygon(DVec3::ZERO, DVec3::Z, &lid(1.0, DVec3::Z));
    assert!((right - 0.239_456_470_460_774).abs() < 1e-15);
    // All faces of a half cube: 1, as it should be.
    let half_cube: f64 = [
        lid(2.0, DVec3::Z),
        rectangle(dvec3(1.0, -1.0, 0.0), DVec3::Z, 2.0 * DVec3::Y),
        rectangle(dvec3(-1.0, -1.0, 0.0), 2.0 * DVec3::Y, DVec3::Z),
        rectangle(dvec3(-1.0, 1.0, 0.0), 2.0 * DVec3::X, DVec3::Z),
        rectangle(dvec3(-1.0, -1.0, 0.0), DVec3::Z, 2.0 * DVec3::X),
    ]
    .iter()
    .map(|face| solid_angle(DVec3::ZERO, face) / TAU)
    .sum();
    assert!((half_cube - 1.0).abs() < 1e-14, "{half_cube}");
}
