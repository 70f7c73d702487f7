//! Outlines that are no polygon: what becomes of them, and which are refused.

use glam::{DQuat, DVec2, DVec3, dvec2, dvec3};
use proptest::prelude::*;
use radiosity::geometry::{MAX_CORNERS, Polygon, PolygonError, split};
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Corners around the origin at these distances: simple, and star-shaped.
fn star(radii: &[f64]) -> Vec<DVec2> {
    let step = TAU / radii.len() as f64;
    let corner = |(k, r): (usize, &f64)| DVec2::from_angle(k as f64 * step) * *r;
    radii.iter().enumerate().map(corner).collect()
}

fn shoelace(flat: &[DVec2]) -> f64 {
    (0..flat.len()).map(|k| 0.5 * flat[k].perp_dot(flat[(k + 1) % flat.len()])).sum()
}

fn flat(corners: &[(f64, f64)]) -> Vec<DVec3> {
    corners.iter().map(|&(x, y)| dvec3(x, y, 0.0)).collect()
}

fn area(pieces: &[Polygon]) -> f64 {
    pieces.iter().map(Polygon::area).sum()
}

/// Every edge of the outline is walked once, every other edge once each way.
fn fills(outline: &[DVec3], pieces: &[Polygon]) -> bool {
    let bits = |v: DVec3| v.to_array().map(f64::to_bits);
    let mut edges: HashMap<_, i32> = HashMap::new();
    let closing =
        (0..outline.len()).map(|k| (outline[(k + 1) % outline.len()], outline[k]));
    for (a, b) in pieces.iter().flat_map(Polygon::edges).chain(closing) {
        *edges.entry((bits(a), bits(b))).or_default() += 1;
        *edges.entry((bits(b), bits(a))).or_default() -= 1;
    }
    edges.values().all(|&n| n == 0)
}

fn radii() -> impl Strategy<Value = Vec<f64>> {
    proptest::collection::vec(0.1..1.0, 3..24)
}

/// Where an outline is put: turned, scaled, moved.
fn pose() -> impl Strategy<Value = (DQuat, f64, DVec3)> {
    (
        prop::array::uniform4(-1.0..1.0f64),
        -3.0..3.0f64,
        prop::array::uniform3(-9.0..9.0f64),
    )
        .prop_filter("a rotation", |(q, ..)| DVec3::from_slice(q).length() > 0.1)
        .prop_map(|(q, decade, shift)| {
            let scale = 10f64.powf(decade);
            (DQuat::from_array(q).normalize(), scale, scale * DVec3::from_array(shift))
        })
}

proptest! {
    /// Planar outlines keep their area, front and edges, wherever they lie.
    #[test]
    fn planar_outlines_are_filled(radii in radii(), (turn, scale, shift) in pose()) {
        let star = star(&radii);
        let place = |v: &DVec2| turn * (scale * v.extend(0.0)) + shift;
        let outline: Vec<DVec3> = star.iter().map(place).collect();
        let pieces = split(&outline).unwrap();
        let expected = scale * scale * shoelace(&star);
        // Corners at 30 times the size are rounded to 30 ulps of it.
        prop_assert!((area(&pieces) - expected).abs() <= 1e-13 * scale * scale * 30.0);
        prop_assert!(fills(&outline, &pieces));
        for piece in &pieces {
            prop_assert!(piece.normal().dot(turn * DVec3::Z) > 1.0 - 1e-6);
            prop_assert!(Polygon::new(piece.vertices().to_vec()).is_ok());
        }
        // Merging leaves less than one piece a corner that turns inwards, twice over, and
        // one: Hertel & Mehlhorn's bound.
        let n = star.len();
        let inwards = (0..n).filter(|&k| {
            let (a, b, c) = (star[k], star[(k + 1) % n], star[(k + 2) % n]);
            (b - a).perp_dot(c - b) < 0.0
        });
        prop_assert!(pieces.len() <= 2 * inwards.count() + 1);
    }

    /// Twisted outlines become a surface with the same rim, seen from the same side.
    #[test]
    fn twisted_outlines_are_folded(
        corners in proptest::collection::vec((0.3..1.0, -0.2..0.2), 4..12),
    ) {
        let (radii, heights): (Vec<f64>, Vec<f64>) = corners.into_iter().unzip();
        let outline: Vec<DVec3> =
            star(&radii).iter().zip(heights).map(|(v, z)| v.extend(z)).collect();
        // Seen slantwise an inward corner may hide another edge: then it is refused.
        if let Ok(pieces) = split(&outline) {
            prop_assert!(fills(&outline, &pieces));
            let front: DVec3 = (0..outline.len())
                .map(|k| outline[k].cross(outline[(k + 1) % outline.len()]))
                .sum();
            for piece in &pieces {
                prop_assert!(piece.normal().dot(front) > 0.0);
            }
        }
    }

    /// Two edges exchanged by swapping their ends cross, in any convex outline.
    #[test]
    fn crossed_outlines_are_refused(n in 4usize..20, at in 0usize..20, turn in pose()) {
        let mut star = star(&vec![1.0; n]);
        star.swap(at % n, (at + 1) % n);
        let place = |v: &DVec2| turn.0 * (turn.1 * v.extend(0.0)) + turn.2;
        let outline: Vec<DVec3> = star.iter().map(place).collect();
        prop_assert_eq!(split(&outline), Err(PolygonError::SelfIntersecting));
    }

    /// Whatever the numbers, there is an answer and no panic.
    #[test]
    fn any_corners_have_an_answer(
        corners in proptest::collection::vec(prop::array::uniform3(any::<f64>()), 0..9),
    ) {
        let outline: Vec<DVec3> = corners.into_iter().map(DVec3::from_array).collect();
        let _ = split(&outline);
    }

    /// Corners on a coarse grid meet every tie there is: repeats, spikes, touches.
    #[test]
    fn ties_are_decided(corners in proptest::collection::vec((0u8..4, 0u8..4), 3..10)) {
        let corners: Vec<_> =
            corners.into_iter().map(|(x, y)| (f64::from(x), f64::from(y))).collect();
        if let Ok(pieces) = split(&flat(&corners)) {
            let mut flat: Vec<DVec2> = corners.iter().map(|&c| DVec2::from(c)).collect();
            flat.dedup();
            // Whole numbers: the area is exact. It may be negative: seen from behind.
            prop_assert_eq!(area(&pieces), shoelace(&flat).abs());
        }
    }
}

#[test]
fn a_fit_outline_is_one_piece() {
    let square = flat(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    assert_eq!(split(&square).unwrap(), [Polygon::new(square).unwrap()]);
}

#[test]
fn a_twisted_quad_folds_along_its_shorter_diagonal() {
    // From the second to the fourth corner it is 1, the other way 2.
    let outline = [DVec3::X, dvec3(0.0, 0.5, 0.1), -DVec3::X, dvec3(0.0, -0.5, 0.1)];
    let pieces = split(&outline).unwrap();
    assert_eq!(pieces.len(), 2);
    for piece in pieces {
        assert!(piece.vertices().contains(&outline[1]));
        assert!(piece.vertices().contains(&outline[3]));
    }
}

#[test]
fn simple_shapes_have_few_pieces() {
    let l = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
    let arrow = [(0.0, 0.0), (2.0, 1.0), (0.0, 2.0), (1.0, 1.0)];
    // A corner within an edge is no corner to cut at.
    let dented =
        [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (1.0, 1.0), (0.0, 2.0)];
    for (shape, area_expected) in [(&l[..], 3.0), (&arrow, 1.0), (&dented, 3.0)] {
        let pieces = split(&flat(shape)).unwrap();
        assert_eq!((pieces.len(), area(&pieces)), (2, area_expected));
    }
}

#[test]
fn what_cannot_be_repaired_is_named() {
    use PolygonError::*;
    let bow_tie = [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)]; // of no net area
    let uneven = [(0.0, 0.0), (3.0, 1.0), (3.0, 0.0), (0.0, 2.0)];
    let pentagram: Vec<_> = (0..5)
        .map(|k| dvec2(0.0, 1.0).rotate(DVec2::from_angle(0.8 * TAU / 2.0 * k as f64)))
        .map(|v| (v.x, v.y))
        .collect();
    let spike = [(0.0, 0.0), (2.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let touching = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (1.0, 0.0), (0.0, 2.0)];
    for crossing in [&bow_tie[..], &uneven, &pentagram, &spike, &touching] {
        assert_eq!(split(&flat(crossing)), Err(SelfIntersecting), "{crossing:?}");
    }
    let line = [(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)];
    assert_eq!(split(&flat(&line[..3])), Err(ZeroArea));
    assert_eq!(split(&flat(&line)), Err(ZeroArea));
    assert_eq!(split(&flat(&line[..2])), Err(TooFewVertices(2)));
    assert_eq!(split(&[DVec3::ONE; 5]), Err(TooFewVertices(1)));
    assert_eq!(split(&[DVec3::X, DVec3::NAN, DVec3::Y]), Err(NotFinite { index: 1 }));
    let many = vec![DVec3::ZERO; MAX_CORNERS + 1];
    assert_eq!(split(&many), Err(TooManyVertices(MAX_CORNERS + 1)));
}

/// A comb has half its corners turning inwards: the dearest outline.
#[test]
fn the_longest_outline_is_split_in_reasonable_time() {
    let teeth = MAX_CORNERS / 2 - 1;
    let mut comb = vec![dvec3(teeth as f64, -1.0, 0.0)];
    for k in (0..teeth).rev() {
        comb.push(dvec3(k as f64 + 0.9, 1.0, 0.0));
        comb.push(dvec3(k as f64 + 0.5, 0.0, 0.0));
    }
    comb.push(dvec3(0.0, -1.0, 0.0));
    let pieces = split(&comb).unwrap();
    assert!(fills(&comb, &pieces));
}
