//! Light of the sky against exact values: uniform and overcast on tilted planes, the
//! general skies of the CIE, discs and panoramas.

use crate::common::{cases, point, within};
use glam::{DVec3, dvec3};
use radiosity::geometry::Rgb;
use radiosity::radiometry::{projected_solid_angle_of_cap, solid_angle_of_cap};
use radiosity::sky::{Panorama, Sky, cie_coefficients};
use serde_json::Value;
use std::f64::consts::PI;

const UP: DVec3 = DVec3::Z;

fn of_kind(kind: &str) -> Vec<Value> {
    let all = cases("H_sky").into_iter().filter(|case| case["kind"] == kind);
    let all: Vec<Value> = all.collect();
    assert!(!all.is_empty(), "{kind}");
    all
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// A plane that leans by so many degrees, towards x.
fn tilted(case: &Value) -> DVec3 {
    let tilt = number(&case["params"]["tilt_deg"]).to_radians();
    dvec3(tilt.sin(), 0.0, tilt.cos())
}

fn holds(case: &Value, what: &str, got: f64, expected: f64, gate: f64) {
    let own = number(&case["uncertainty_abs"]);
    assert!(
        within(got, expected, gate, own),
        "{} {what}: {got}, not {expected}",
        case["id"]
    );
}

/// `π L (1 + cosβ)/2` from the sky; what the ground sends back is a uniform sky from
/// below.
#[test]
fn a_uniform_sky_on_tilted_planes() {
    for case in of_kind("sky_uniform_tilt") {
        let radiance = Rgb::splat(number(&case["params"]["L"]));
        let sky = Sky::uniform(radiance, UP);
        let albedo = number(&case["params"]["ground_reflectance"]);
        let ground = Sky::uniform(albedo * sky.irradiance(UP) / PI, -UP);
        let normal = tilted(&case);
        let got = sky.irradiance(normal) + ground.irradiance(normal);
        holds(&case, "E", got.x, number(&case["expected"]["E"]), 1e-14);
    }
}

#[test]
fn an_overcast_sky_on_tilted_planes() {
    for case in of_kind("sky_overcast_tilt") {
        let sky = Sky::overcast(Rgb::splat(number(&case["params"]["Lz"])), UP);
        let got = sky.irradiance(tilted(&case)).x;
        holds(&case, "E", got, number(&case["expected"]["E_over_Lz"]), 1e-14);
        let share = got / sky.irradiance(UP).x;
        let expected = number(&case["expected"]["E_over_Ehorizontal"]);
        holds(&case, "share", share, expected, 1e-14);
    }
}

/// All fifteen, at two heights of the sun: radiance to rounding, irradiance to what the
/// table itself is good for.
#[test]
fn the_general_skies_of_the_cie() {
    for case in of_kind("sky_cie_general") {
        let params = &case["params"];
        let kind = params["type"].as_u64().unwrap() as usize;
        let given: Vec<f64> =
            params["abcde"].as_array().unwrap().iter().map(number).collect();
        let coefficients = cie_coefficients(kind).unwrap();
        assert_eq!(coefficients[..], given[..], "{}", case["id"]);
        let sun = number(&params["sun_elevation_deg"]).to_radians();
        let sun = dvec3(sun.cos(), 0.0, sun.sin());
        let sky = Sky::cie(coefficients, sun, Rgb::ONE, UP);
        for sample in case["expected"]["luminance_samples"].as_array().unwrap() {
            let zenith = number(&sample["zenith_deg"]).to_radians();
            let around = number(&sample["azimuth_from_sun_deg"]).to_radians();
            let flat = dvec3(around.cos(), around.sin(), 0.0);
            let got = sky.radiance(flat * zenith.sin() + DVec3::Z * zenith.cos());
            let expected = number(&sample["L_over_Lz"]);
            assert!(within(got.x, expected, 1e-12, 0.0), "{}: {got}", case["id"]);
        }
        for (key, normal) in [
            ("E_horizontal", UP),
            ("E_vertical_facing_sun", DVec3::X),
            ("E_vertical_away", DVec3::NEG_X),
            ("E_vertical_side", DVec3::Y),
        ] {
            let got = sky.irradiance(normal).x;
            holds(&case, key, got, number(&case["expected"][key]), 1e-9);
        }
    }
}

/// Two of the CIE's skies are others by another name.
#[test]
fn the_fifth_sky_is_uniform() {
    let fifth = Sky::cie(cie_coefficients(5).unwrap(), DVec3::X, Rgb::ONE, UP);
    let uniform = Sky::uniform(Rgb::ONE, UP);
    for normal in [UP, DVec3::X, dvec3(0.6, 0.0, -0.8), dvec3(0.0, 0.8, 0.6)] {
        let off = fifth.irradiance(normal).x - uniform.irradiance(normal).x;
        assert!(off.abs() < 1e-7 * PI, "{normal}: {off:e}");
    }
    assert_eq!(cie_coefficients(0), None);
    assert_eq!(cie_coefficients(16), None);
}

/// A disc about the normal: `π L sin²α`. As a panorama of that disc alone, the cap that
/// whole rows make of it.
#[test]
fn discs_about_the_zenith() {
    for case in of_kind("sun_disc") {
        let half = number(&case["params"]["half_angle_deg"]).to_radians();
        let expected = &case["expected"];
        let cap = projected_solid_angle_of_cap(half, 0.0);
        holds(&case, "E", cap, number(&expected["E"]), 1e-12);
        let omega = solid_angle_of_cap(half);
        holds(&case, "Ω", omega, number(&expected["solid_angle"]), 1e-12);
        let rows = (PI / half).round() as usize;
        if (PI / rows as f64 - half).abs() < 1e-12 {
            let disc = |row: usize| if row == 0 { Rgb::ONE } else { Rgb::ZERO };
            let texels = (0..rows * 8).map(|k| disc(k / 8)).collect();
            let panorama = Panorama::new(8, texels).unwrap();
            holds(
                &case,
                "Ω",
                panorama.total().x,
                number(&expected["solid_angle"]),
                1e-12,
            );
            let sky = Sky::panorama(panorama, UP);
            holds(&case, "E", sky.irradiance(UP).x, number(&expected["E"]), 1e-9);
        }
    }
}

/// The largest error of a panorama painted at the middle of each texel, over all
/// normals of a case.
fn worst(case: &Value, height: usize, up: DVec3) -> f64 {
    let radiance: fn(DVec3) -> f64 = match case["params"]["L"].as_str().unwrap() {
        "1" => |_| 1.0,
        "1+d.z" => |d| 1.0 + d.z,
        "d.x^2" => |d| d.x * d.x,
        other => panic!("{other}"),
    };
    // Painted with +Y up, it is turned with `up`: whoever paints asks what he will see.
    let turned = Sky::uniform(Rgb::ONE, up);
    let world = |d: DVec3| turned.direction(d.y.asin(), d.x.atan2(-d.z));
    let paint = |d: DVec3| Rgb::splat(radiance(world(d)));
    let panorama = Panorama::painted(2 * height, height, paint).unwrap();
    let sky = Sky::panorama(panorama, up);
    let all = case["expected"]["irradiance"].as_array().unwrap();
    let off =
        |at: &Value| (sky.irradiance(point(&at["normal"])).x - number(&at["E"])).abs();
    all.iter().map(off).fold(0.0, f64::max)
}

/// A constant map is right to 1e-6 (the texels that the horizon cuts), a smooth one to
/// about a tenth of the texel's size squared: piecewise constant, at the middle.
#[test]
fn panoramas_of_smooth_maps() {
    for case in of_kind("environment_map_closed_form") {
        for up in [DVec3::Y, DVec3::Z, dvec3(0.48, -0.64, 0.6)] {
            let [coarse, fine] = [64, 256].map(|height| worst(&case, height, up));
            let texel = PI / 256.0;
            if case["params"]["L"] == "1" {
                assert!(fine < 1e-6, "{fine:e}");
                continue;
            }
            assert!(fine < 0.3 * texel * texel, "{} {up}: {fine:e}", case["id"]);
            let ratio = coarse / fine;
            assert!((12.0..20.0).contains(&ratio), "{} {up}: {ratio}", case["id"]);
        }
    }
}
