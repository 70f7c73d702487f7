//! Textbook closed forms and approximations against exact values that nobody here computed.

use super::closed;
use crate::common::{cases, has_tag, within};
use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::form_factor::analytic::{exchange, lambert_polygon};
use radiosity::form_factor::{Accuracy, named, shortcuts};
use radiosity::geometry::Polygon;
use serde_json::Value;

fn number(v: &Value) -> f64 {
    v.as_f64().expect("a number")
}

fn segment(v: &Value) -> [DVec2; 2] {
    let end = |k: usize| dvec2(number(&v[k][0]), number(&v[k][1]));
    [end(0), end(1)]
}

fn params<const N: usize>(case: &Value, keys: [&str; N]) -> [f64; N] {
    keys.map(|key| number(&case["params"][key]))
}

/// Unit squares face to face, the lower at the origin, the upper at this height.
fn facing(distance: f64) -> [Polygon; 2] {
    let at = |z: f64| {
        let corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)];
        Polygon::new(corners.map(|(x, y)| dvec3(x, y, z)).to_vec()).unwrap()
    };
    [at(0.0), at(distance).flipped()]
}

#[test]
fn crossed_strings_in_the_open() {
    let all = cases("A_hottel_2d");
    assert_eq!(all.len(), 11);
    for case in &all {
        let (a, b) = (segment(&case["seg_A"]), segment(&case["seg_B"]));
        let got = closed::crossed_strings(a, b);
        let expected = number(&case["expected"]["F_AB"]);
        assert!(within(got, expected, 1e-12, 0.0), "{}: {got} {expected}", case["id"]);
        // The same strings, pulled taut around nothing.
        let past = closed::crossed_strings_past(a, b, None, None);
        assert!((past - got).abs() < 1e-12, "{}: {past}", case["id"]);
        // Reciprocity: L_a F_ab = L_b F_ba.
        let back = closed::crossed_strings(b, a);
        let ratio = b[0].distance(b[1]) / a[0].distance(a[1]);
        assert!(within(back * ratio, got, 1e-13, 0.0), "{}", case["id"]);
    }
}

/// Screens with gaps, and fins that stand on a segment: all cases of the table.
#[test]
fn crossed_strings_past_screens() {
    let all = cases("B_occluded_2d");
    assert_eq!(all.len(), 9);
    for case in &all {
        let (a, b) = (segment(&case["seg_A"]), segment(&case["seg_B"]));
        let screens: Vec<[DVec2; 2]> =
            case["occluder_segments"].as_array().unwrap().iter().map(segment).collect();
        let got = match &screens[..] {
            // A fin that stands on `a`: each part of `a` looks past its tip.
            [[foot, tip]] if foot.y == 0.0 => past_a_fin(a, b, *foot, *tip),
            _ => past_a_screen(a, b, &screens),
        };
        let expected = number(&case["expected"]["F_AB"]);
        assert!(
            within(got, expected, 1e-11, 1e-15),
            "{}: {got} {expected}",
            case["id"]
        );
    }
}

/// Screens in one line across, from left to right: the sum over the gaps between them.
fn past_a_screen(a: [DVec2; 2], b: [DVec2; 2], screens: &[[DVec2; 2]]) -> f64 {
    let rights = std::iter::once(None).chain(screens.iter().map(|s| Some(s[1])));
    let lefts = screens.iter().map(|s| Some(s[0])).chain([None]);
    rights.zip(lefts).map(|(l, r)| closed::crossed_strings_past(a, b, l, r)).sum()
}

fn past_a_fin(a: [DVec2; 2], b: [DVec2; 2], foot: DVec2, tip: DVec2) -> f64 {
    let part = |ends: [DVec2; 2], left, right| {
        let share = ends[0].distance(ends[1]) / a[0].distance(a[1]);
        share * closed::crossed_strings_past(ends, b, left, right)
    };
    // Seen along the strings, which go up, the fin is right of the part on its left.
    part([a[0], foot], None, Some(tip)) + part([foot, a[1]], Some(tip), None)
}

#[test]
fn named_rectangles() {
    let mut met = 0;
    for case in &cases("A_polygon_pairs") {
        let family = case["family"].as_str().unwrap();
        let got = if family.starts_with("C-11") {
            let [a, b, c] = params(case, ["a", "b", "c"]);
            named::parallel_rectangles(a, b, c)
        } else if family.starts_with("C-14") {
            let [w, h, l] = params(case, ["w", "h", "l"]);
            named::perpendicular_rectangles(w, h, l)
        } else {
            continue;
        };
        let expected = number(&case["expected"]["F_AB"]);
        let relative = if family.starts_with("C-11") { 1e-13 } else { 1e-11 };
        assert!(
            within(got, expected, relative, 0.0),
            "{}: {got} {expected}",
            case["id"]
        );
        met += 1;
    }
    assert_eq!(met, 30);
}

#[test]
fn named_discs_and_spheres() {
    let mut met = 0;
    for case in &cases("A_discs_spheres") {
        let got = match case["kind"].as_str().unwrap() {
            "coaxial_discs" => {
                let [r1, r2, h] = params(case, ["r1", "r2", "h"]);
                closed::parallel_discs(r1, r2, h)
            }
            "element_to_disc_parallel" if number(&case["params"]["r"]) == 0.0 => {
                let [radius, h] = params(case, ["R", "h"]);
                closed::point_to_disc_on_axis(radius, h)
            }
            "concentric_spheres_outer_self" => {
                let [r1, r2] = params(case, ["r1", "r2"]);
                1.0 - named::concentric_spheres(r1, r2)
            }
            _ => continue,
        };
        let expected = number(&case["expected"]["F12"]);
        assert!(within(got, expected, 1e-15, 0.0), "{}: {got} {expected}", case["id"]);
        met += 1;
    }
    assert!(met >= 10, "{met}");
}

/// Where the printed forms lose their digits, the rearranged ones keep them.
#[test]
fn named_pairs_are_stable() {
    for case in &cases("S_stability") {
        let (got, relative) = match case["family"].as_str().unwrap() {
            "C-11 naive" => {
                let [a, b, c] = params(case, ["a", "b", "c"]);
                (named::parallel_rectangles(a, b, c), 1e-14)
            }
            "C-14 naive" => {
                let [w, h, l] = params(case, ["w", "h", "l"]);
                (named::perpendicular_rectangles(w, h, l), 1e-11)
            }
            "C-41 naive vs rationalised" => {
                let [r1, r2, h] = params(case, ["r1", "r2", "h"]);
                (closed::parallel_discs(r1, r2, h), 1e-15)
            }
            _ => continue,
        };
        let expected = number(&case["expected"]["exact"]);
        let error = (got / expected - 1.0).abs();
        assert!(error <= relative, "{}: {got} {expected} {error:e}", case["id"]);
    }
}

/// The oracles and the exact method share no code and agree.
#[test]
fn named_pairs_agree_with_the_exact_method() {
    for k in -6..=6 {
        let distance = 10f64.powf(f64::from(k) / 2.0);
        let [i, j] = facing(distance);
        let (got, named) = (
            exchange(&i, &j, Accuracy::Best),
            named::parallel_rectangles(1.0, 1.0, distance),
        );
        assert!(within(got, named, 1e-11, 0.0), "{distance}: {got} {named}");
        let wall = [dvec3(0., 0., 0.), DVec3::X, dvec3(1., 0., distance)];
        let wall = [&wall[..], &[dvec3(0., 0., distance)]].concat();
        let wall = Polygon::new(wall).unwrap().flipped();
        let floor = [DVec3::ZERO, DVec3::X, dvec3(1., 1., 0.), DVec3::Y];
        let floor = Polygon::new(floor.to_vec()).unwrap();
        let got = exchange(&floor, &wall, Accuracy::Best);
        let named = named::perpendicular_rectangles(1.0, distance, 1.0);
        assert!(within(got, named, 1e-11, 0.0), "wall {distance}: {got} {named}");
    }
}

/// Each shortcut errs by what the table says, digit by digit.
#[test]
fn shortcuts_err_as_the_table_says() {
    let all = cases("S_stability");
    let approximations: Vec<&Value> =
        all.iter().filter(|c| c["kind"] == "approximation_error").collect();
    assert_eq!(approximations.len(), 5);
    for case in approximations {
        let [distance] = params(case, ["d"]);
        let [i, j] = facing(distance);
        let centre = lambert_polygon(i.centroid(), i.normal(), &j);
        for (got, key) in [
            (shortcuts::point_to_point(&i, &j), "centre_to_centre cos cos A/(pi r^2)"),
            (shortcuts::point_to_disc(&i, &j), "centre_disc_approx A/(pi r^2+A)"),
            (centre, "centre_point_to_polygon"),
            (named::parallel_rectangles(1.0, 1.0, distance), "F_exact"),
        ] {
            let expected = number(&case["expected"][key]);
            assert!(within(got, expected, 1e-13, 0.0), "{distance} {key}: {got}");
        }
    }
}

/// The shadow on the disc: Lambert's number, from below, with an error that falls with the
/// square of the steps.
#[test]
fn nusselt_tends_to_lambert() {
    for case in &cases("A_point_polygon") {
        if has_tag(case, "extreme") {
            continue;
        }
        let (p, n) = (
            crate::common::point(&case["point"]),
            crate::common::point(&case["normal"]),
        );
        let polygon = crate::common::polygon(&case["B"]);
        let exact = number(&case["expected"]["F_dA_B"]);
        let at = |steps: u32| shortcuts::nusselt(p, n, &polygon, steps);
        assert!((at(4096) - exact).abs() < 1e-6, "{}: {}", case["id"], at(4096));
        let (coarse, fine) = ((at(64) - exact).abs(), (at(128) - exact).abs());
        assert!(fine < 0.3 * coarse + 1e-12, "{}: {coarse:e} {fine:e}", case["id"]);
    }
    // The whole sky throws its shadow on the whole disc.
    let [_, sky] = facing(1e-6);
    let got = shortcuts::nusselt(DVec3::ZERO, DVec3::Z, &sky, 1000);
    assert!((got - 1.0).abs() < 1e-3, "{got}");
    assert!(shortcuts::nusselt_outline(DVec3::ZERO, -DVec3::Z, &sky, 9).is_empty());
}

#[test]
fn the_size_is_the_longer_side() {
    let [square, _] = facing(5.0);
    assert!((shortcuts::size(&square) - 1.0).abs() < 1e-15);
    let lamp = [dvec3(0., 0., 0.), dvec3(3., 4., 0.), dvec3(2.2, 4.6, 0.)];
    let lamp = Polygon::new([&lamp[..], &[dvec3(-0.8, 0.6, 0.)]].concat()).unwrap();
    assert!((shortcuts::size(&lamp) - 5.0).abs() < 1e-14);
}
