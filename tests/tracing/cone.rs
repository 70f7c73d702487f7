//! The cone about the reflection ray: tables and laws. (How it fails:
//! `tests/stability/rays.rs`.)

use crate::common::rooms::rectangle;
use crate::common::{cases, within};
use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::geometry::{Frame, Polygon};
use radiosity::material::Lobe;
use radiosity::radiometry::{projected_solid_angle, solid_angle_of_cap};
use radiosity::random::Stream;
use radiosity::trace::Cone;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A square of half-side `half` at `distance` along `axis`.
fn square(axis: DVec3, distance: f64, half: f64) -> Polygon {
    let frame = Frame::about(-axis);
    let (a, b) = (2.0 * half * frame.x, 2.0 * half * frame.y);
    rectangle(distance * axis - 0.5 * (a + b), a, b)
}

#[test]
fn cones_of_the_table() {
    let all = cases("G_mirror_glass").into_iter();
    let of_cones = all.filter(|c| c["kind"] == "cone_about_reflection_ray");
    let mut count = 0;
    for case in of_cones {
        let half_angle =
            case["params"]["half_angle_deg"].as_f64().unwrap().to_radians();
        let expected = |key: &str| case["expected"][key].as_f64().unwrap();
        let cone = Cone { axis: DVec3::Z, half_angle };
        let projected = expected("projected_solid_angle_on_axis");
        let solid = solid_angle_of_cap(half_angle);
        assert!(within(solid, expected("solid_angle"), 1e-13, 0.0), "{solid}");
        let got = cone.projected_solid_angle(DVec3::Z);
        assert!(within(got, projected, 1e-13, 0.0), "{got}");
        // All of it, through a square that is wider than the cone.
        let got =
            cone.overlap(DVec3::ZERO, DVec3::Z, square(DVec3::Z, 1.0, 1.0).vertices());
        assert!(within(got, projected, 1e-13, 0.0), "{got}");
        count += 1;
    }
    assert_eq!(count, 4);
}

/// What a fine grid of directions says.
fn counted(cone: &Cone, n: DVec3, polygon: &Polygon, steps: u32) -> f64 {
    let frame = Frame::about(cone.axis);
    let solid = solid_angle_of_cap(cone.half_angle);
    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(steps);
    let direction = |u: DVec2| {
        let cosine = 1.0 - u.x * (1.0 - cone.half_angle.cos());
        let sine = (1.0 - cosine * cosine).sqrt();
        let (s, c) = (TAU * u.y).sin_cos();
        frame.world_from_local(dvec3(sine * c, sine * s, cosine))
    };
    let hits = |w: DVec3| {
        let distance = polygon.plane().offset / polygon.normal().dot(w);
        distance > 0.0 && polygon.contains(distance * w, 0.0)
    };
    let cosine = |k: u32| {
        let w = direction(dvec2(at(k % steps), at(k / steps)));
        if hits(w) { w.dot(n).max(0.0) } else { 0.0 }
    };
    let sum: f64 = (0..steps * steps).map(cosine).sum();
    solid * sum / f64::from(steps * steps)
}

#[test]
fn overlaps_are_what_counting_finds() {
    let mut random = Stream::named(70, &[]);
    let mut point =
        || 2.0 * dvec3(random.next(), random.next(), random.next()) - DVec3::ONE;
    let mut kinds = [0; 3];
    for k in 0..200 {
        let (axis, n) = (point().normalize(), point().normalize());
        let half_angle = [0.05, 0.4, 1.0, FRAC_PI_2][k % 4];
        let c = point() + 1.2 * axis;
        let Ok(polygon) = Polygon::new(vec![c, c + 1.5 * point(), c + 1.5 * point()])
        else {
            continue;
        };
        let cone = Cone { axis, half_angle };
        let got = cone.overlap(DVec3::ZERO, n, polygon.vertices());
        let near = counted(&cone, n, &polygon, 400);
        let whole = cone.projected_solid_angle(n);
        let seen = projected_solid_angle(DVec3::ZERO, n, polygon.vertices());
        assert!(got >= 0.0 && got <= whole.min(seen) + 1e-12, "{got} {whole} {seen}");
        let error = (got - near).abs() / solid_angle_of_cap(half_angle);
        assert!(error < 4e-3, "{k}: {got} {near}");
        kinds[if got == 0.0 {
            0
        } else if got > seen - 1e-12 {
            1
        } else {
            2
        }] += 1;
    }
    assert!(kinds.iter().all(|&count| count > 10), "{kinds:?}");
}

#[test]
fn a_cone_holds_the_share_of_the_lobe_that_it_is_made_for() {
    for exponent in [0.0, 1.0, 20.0, 1000.0] {
        for share in [0.1, 0.5, 0.95] {
            let cone = Cone::holding(share, exponent, DVec3::Z);
            let held = 1.0 - cone.half_angle.cos().powf(exponent + 1.0);
            assert!((held - share).abs() < 1e-9, "{exponent} {share}: {held}");
        }
    }
}

/// The stack of cones is the lobe: under an even sky it reflects the albedo.
#[test]
fn a_stack_of_cones_has_the_albedo_of_the_lobe() {
    let k = 4000;
    for exponent in [0.5, 3.0, 50.0, 2000.0] {
        for cosine in [1.0, 0.7, 0.2, 0.01_f64] {
            let axis = dvec3((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
            let of_level = |j: usize| {
                // In the root of the level: the widest cones grow without end.
                let v = (j as f64 + 0.5) / k as f64;
                let cone = Cone::above(v * v, exponent, axis);
                2.0 * v * cone.projected_solid_angle(DVec3::Z)
            };
            let mean = (0..k).map(of_level).sum::<f64>() / k as f64;
            let got = (exponent + 2.0) / TAU * mean;
            let albedo = Lobe::Phong { exponent }.albedo(cosine);
            assert!((got - albedo).abs() < 2e-5, "{exponent} {cosine}: {got} {albedo}");
        }
    }
}
