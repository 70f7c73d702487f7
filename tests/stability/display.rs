//! Pinned failures of what is shown of a solution, row by row of the table of failures:
//! each asserts how large the failure is, or that the trap is avoided.

use crate::failures::Sweep;
use crate::failures::meshing::fields::{
    EDGES, OnLine, flat_and_smooth, kinks, mean_of_codes,
};
use crate::failures::meshing::shadows::{
    beside_a_wall, floating, leak, light_leak, light_of_spot, lit_share, missed_spot,
    shadow_begins, spot, stairs, uncut,
};
use glam::dvec3;
use radiosity::geometry::Rgb;
use radiosity::mesh::Mesh;
use radiosity::room::Direct;
use radiosity::solve::Oracle;

/// Two digits.
fn shown(got: f64, expected: f64) -> bool {
    (got - expected).abs() < 0.035 * expected
}

/// What a method gave, at all places.
fn line(sweep: &Sweep, method: usize) -> Vec<f64> {
    sweep.found[method].points.iter().map(|p| p[1]).collect()
}

/// Row 40, Mach bands: the eye sees where the slope changes. Half the element does not
/// mean half the kink: it first grows, since the coarse mesh had missed how steep the
/// light is.
#[test]
fn row_40_kinks_get_worse_before_they_get_better() {
    let sweep = kinks();
    for (h, expected) in EDGES.into_iter().zip([0.93, 1.49, 1.36, 0.81, 0.42]) {
        let kink = sweep.at(h);
        assert!((kink - expected).abs() < 0.006, "{h}: {kink}");
        assert!(kink < sweep.expected(h), "{h}: {kink}");
    }
    // Far below theory at first, at it in the end.
    let share = |h: f64| sweep.at(h) / sweep.expected(h);
    assert!(share(0.5) < 0.15 && share(0.0625) > 0.94 && share(0.03125) > 0.98);
}

/// Row 41: one number for an element errs as its size; what is linear between exact
/// corners errs as the square of it, in the end, and half as much as between means of
/// neighbours.
#[test]
fn row_41_flat_is_of_first_order_and_smooth_of_second() {
    let flat = [0.186, 0.101, 0.060, 0.032, 0.016];
    let averaged = [0.187, 0.088, 0.034, 0.012, 0.0032];
    let linear = [0.070, 0.021, 0.018, 0.0060, 0.0016];
    let sweep = flat_and_smooth();
    for (method, expected) in [flat, averaged, linear].iter().enumerate() {
        for (got, &expected) in line(&sweep, method).into_iter().zip(expected) {
            assert!(shown(got, expected), "{method}: {got} for {expected}");
        }
    }
    let end = sweep.at(0.03125) / sweep.expected(0.03125);
    assert!((end - 1.0).abs() < 0.01, "{end}");
    let order = |of: fn(&OnLine) -> f64, h: f64| {
        (of(&OnLine::of(h)) / of(&OnLine::of(0.5 * h))).log2()
    };
    for h in [0.02, 0.01] {
        assert!((order(|on| on.flat, h) - 1.0).abs() < 0.05);
        assert!((order(|on| on.linear, h) - 2.0).abs() < 0.1);
        assert!((order(|on| on.averaged, h) - 2.0).abs() < 0.1);
        let on = OnLine::of(h);
        assert!((on.averaged / on.linear - 2.0).abs() < 0.1);
        assert!((order(|on| on.kink, h) - 1.0).abs() < 0.05);
    }
}

/// Row 35: halve an element that straddles a wall, and the leak gets narrower, but no
/// less bright: what falls is its area. Cut along the wall, none is left.
#[test]
fn row_35_a_leak_falls_in_area_and_not_in_height() {
    let sweep = light_leak();
    for (rounds, share) in [(1, 0.8), (2, 0.6), (3, 0.2), (4, 0.4), (5, 0.8)] {
        let h = 0.5_f64.powi(rounds);
        assert!(
            (lit_share(h) - share).abs() < 1e-6 && sweep.expected(h) == lit_share(h)
        );
        let [height, area, ours] = [0, 1, 2].map(|method| sweep.by(method, h));
        assert!((area - (1.0 - share) * h).abs() < 1e-9, "{rounds}: {area}");
        assert!((height / share - 1.0).abs() < 0.1, "{rounds}: {height}");
        assert_eq!(ours, 0.0);
    }
    for edge in [0.5, 0.3, 0.1] {
        assert_eq!(leak(&Mesh::uniform(&beside_a_wall(0.9), edge)), [0.0, 0.0]);
    }
}

/// Row 36, floating objects: the shadow of what stands on the floor begins where the
/// first element begins whose middle is dark, up to half an element beyond the foot (it
/// floats) or before it (a shadow leak). Elements that are cut where they touch leave
/// no gap.
#[test]
fn row_36_things_float_above_coarse_floors() {
    let sweep = floating();
    for &[place, expected] in &sweep.theory {
        let (gap, ours) = (sweep.at(place), sweep.by(1, place));
        assert!((gap - expected).abs() < 1e-9 && gap.abs() < 0.5, "{place}: {gap}");
        assert!(ours.abs() < 4e-7, "{place}: {ours}");
    }
    for (foot, rounds, gap) in
        [(0.26, 1, 0.24), (0.74, 1, -0.24), (0.64, 2, 0.11), (0.33, 4, -0.0175)]
    {
        let scene = beside_a_wall(foot);
        let start = shadow_begins(&scene, &uncut(&scene, rounds));
        assert!((start - foot - gap).abs() < 1e-9, "{foot} {rounds}: {start}");
        assert!(gap.abs() <= 0.5 * 0.5_f64.powi(rounds as i32));
        for edge in [0.5, 0.25, 0.125] {
            let begin = shadow_begins(&scene, &Mesh::uniform(&scene, edge));
            assert!((begin - foot).abs() < 1e-7, "{begin}");
        }
    }
}

/// Row 37, jagged shadows: with one number for an element the edge of a shadow runs
/// along the grid, in steps. It is out of place by a quarter of an element in the mean,
/// and halves with it: first order only, however exact the light.
#[test]
fn row_37_shadow_edges_are_stairs() {
    let sweep = stairs();
    for &[h, expected] in &sweep.theory {
        let off = sweep.at(h) / expected - 1.0;
        assert!(off.abs() < 0.05, "{h}: {off}");
        assert!((expected / h - 0.24).abs() < 1e-3);
    }
}

/// Row 38: a spot of light smaller than an element is missed when no middle lies in it,
/// and is as large as all elements whose middle does.
#[test]
fn row_38_a_spot_between_the_places_is_not_there() {
    let sweep = missed_spot();
    for &[h, expected] in &sweep.theory {
        let got = sweep.at(h);
        // The lamp's light varies over the spot.
        assert!(
            (got - expected).abs() <= 0.04 * expected,
            "{h}: {got}, not {expected}"
        );
    }
    // Elements of 1 and .5 m, and smaller ones: nothing is seen. Of .25 m: too much.
    assert_eq!([10.0, 5.0, 1.25].map(|h| sweep.at(h)), [0.0; 3]);
    assert!((sweep.at(2.5) - 6.25).abs() < 1e-9);
}

/// Row 43: of that spot an oracle that looks at the same places knows no more: it marks
/// nothing, where the error is the whole of the spot.
#[test]
fn row_43_an_oracle_of_points_marks_nothing() {
    let scene = spot();
    let direct = Direct::of(&scene);
    let oracle = Oracle { tolerance: 1e-3, smallest: 1e-4 };
    let look = |edge: f64| {
        let mesh = Mesh::patched(&scene, edge);
        let radiosity = light_of_spot(&direct, &mesh);
        let floor = mesh.elements.iter().zip(&radiosity);
        let floor = floor.filter(|(e, _)| mesh.surface_of(e) == 0);
        let brightest = floor.map(|(_, b)| b.x).fold(0.0, f64::max);
        let marks =
            oracle.marks(&scene, &mesh, &radiosity, &|e| direct.rise(&e.polygon));
        (brightest, marks.iter().filter(|mark| **mark).count())
    };
    let whole = Mesh::whole(&scene);
    let there = direct.on(&whole.elements[0].polygon);
    let truth = 0.5 * there.irradiance(dvec3(0.125, 0.125, 0.0)).x;
    assert!(truth > 0.5, "{truth}");
    assert!(there.irradiance(dvec3(0.25, 0.25, 0.0)) == Rgb::ZERO);
    // Elements of 1, .5: the spot lies beside the middle, .25, and the corner, 0.
    for edge in [1.0, 0.5] {
        assert_eq!(look(edge), (0.0, 0), "{edge}");
    }
    // Elements of .25, whose middle it is.
    let (brightest, marked) = look(0.25);
    assert!((brightest / truth - 1.0).abs() < 1e-9 && marked > 0, "{brightest}");
}

/// Row 46: a floor of bright and dark tiles as one mean reflectance. The mean of the
/// reflectances gives the light of the room; that of the numbers in an sRGB picture,
/// which are not proportional to light, loses up to a fifth of what is reflected.
#[test]
fn row_46_the_mean_of_a_texture_is_taken_in_linear_light() {
    let sweep = mean_of_codes();
    for &[dark, expected] in &sweep.theory {
        let (codes, ours) = (sweep.at(dark), sweep.by(1, dark));
        assert!((codes - expected).abs() < 1e-4, "{dark}: {codes} {expected}");
        assert!(ours.abs() < 1e-6, "{dark}: {ours}");
    }
    assert!((sweep.at(0.1) - 8.36).abs() < 0.01 && (sweep.at(0.0) - 18.1).abs() < 0.1);
}
