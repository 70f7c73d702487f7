//! Lambert's and Phong's lobes against exact values that nobody here computed.

use crate::common::{cases, within};
use glam::{DVec2, DVec3, dvec2, dvec3};
use radiosity::geometry::Rgb;
use radiosity::material::{Brdf, Coefficients, Lobe, Material, Shine};
use radiosity::radiometry::cosine_power_integral;
use serde_json::Value;
use std::f64::consts::PI;

/// The gate of the tables is 1e-9; ours is twelve digits.
const TOLERANCE: f64 = 1e-12;

fn of_kind(kind: &str, count: usize) -> Vec<Value> {
    let all = cases("I_brdf_solid_angle").into_iter().filter(|c| c["kind"] == kind);
    let all: Vec<Value> = all.collect();
    assert_eq!(all.len(), count, "{kind}");
    all
}

fn number(case: &Value, key: &str) -> f64 {
    case["params"][key].as_f64().unwrap()
}

fn assert_expected(case: &Value, key: &str, got: f64) {
    let expected = case["expected"][key].as_f64().unwrap();
    let fits = within(got, expected, TOLERANCE, 0.0);
    assert!(fits, "{}, {key}: {got}, {expected}", case["id"]);
}

fn cosine(case: &Value) -> f64 {
    number(case, "theta_deg").to_radians().cos()
}

fn brdf(diffuse: f64, specular: f64, exponent: f64) -> Brdf {
    let coefficients = Coefficients {
        diffuse: Rgb::splat(diffuse),
        shine: Shine::Gloss { reflectance: Rgb::splat(specular), exponent },
        ..Coefficients::default()
    };
    Material::new("of the table", coefficients).unwrap().brdf()
}

/// In a glow of radiance 1 from everywhere, what leaves towards `wo`: by even points
/// over the projected hemisphere.
fn in_a_furnace(brdf: &Brdf, wo: DVec3) -> f64 {
    const N: u32 = 300;
    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(N);
    let of = |k: u32| {
        let u: DVec2 = dvec2(at(k % N), at(k / N));
        brdf.value(radiosity::radiometry::cosine_direction(u), wo).x
    };
    PI * (0..N * N).map(of).sum::<f64>() / f64::from(N * N)
}

#[test]
fn phong_albedos() {
    for case in of_kind("modified_phong_directional_albedo", 33) {
        let lobe = Lobe::Phong { exponent: number(&case, "n") };
        assert_expected(
            &case,
            "albedo",
            number(&case, "ks") * lobe.albedo(cosine(&case)),
        );
    }
}

/// The constants in front of the lobes. The table's third, for halfway vectors, is of a
/// lobe that is not here.
#[test]
fn normalisations() {
    for case in of_kind("lobe_normalisation", 3) {
        let n = number(&case, "n");
        let lobe = Lobe::Phong { exponent: n };
        let [brdf, density] =
            [lobe.value(DVec3::Z, DVec3::Z), lobe.pdf(DVec3::Z, DVec3::Z)];
        assert_expected(&case, "phong_energy_norm (n+2)/2pi", brdf);
        assert_expected(&case, "phong_lobe_norm (n+1)/2pi", density);
        assert_expected(&case, "integral cos^n dw", cosine_power_integral(n));
        assert_expected(&case, "integral cos^n cos dw", lobe.albedo(1.0) / brdf);
        assert_expected(&case, "integral cos^n cos dw", cosine_power_integral(n + 1.0));
    }
}

#[test]
fn lambert() {
    for case in of_kind("lambert", 3) {
        let rho = number(&case, "rho");
        let wo = dvec3(0.6, 0.0, 0.8);
        assert_expected(&case, "brdf", rho * Lobe::Lambert.value(DVec3::Z, wo));
        assert_expected(&case, "directional_albedo", rho * Lobe::Lambert.albedo(wo.z));
        if rho < 1.0 {
            // A material of reflectance 1 is refused.
            let glow = in_a_furnace(&brdf(rho, 0.0, 1.0), wo);
            let expected =
                case["expected"]["white_furnace_radiance_L1"].as_f64().unwrap();
            assert!(within(glow, expected, 1e-9, 0.0), "{glow}, {expected}");
        }
    }
}

#[test]
fn lambert_plus_phong() {
    for case in of_kind("lambert_plus_phong", 2) {
        let brdf = brdf(number(&case, "kd"), number(&case, "ks"), number(&case, "n"));
        let z = cosine(&case);
        assert_expected(&case, "directional_albedo", brdf.albedo(z).x);
        // The furnace by 300 × 300 points: the horizon cuts cells, and leaves some 1/300².
        let glow = in_a_furnace(&brdf, dvec3((1.0 - z * z).sqrt(), 0.0, z));
        let expected = case["expected"]["white_furnace_radiance_L1"].as_f64().unwrap();
        assert!((glow - expected).abs() < 1e-4, "{glow}, {expected}");
    }
}
