//! Solid angles against exact values that nobody here computed.

use crate::common::{cases, point, within};
use glam::DVec3;
use radiosity::geometry::Polygon;
use radiosity::radiometry as r;
use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, PI};

/// The cases of one kind, each with what we find for it.
fn check(kind: &str, key: &str, count: usize, find: impl Fn(&Value) -> f64) {
    let all = cases("I_brdf_solid_angle");
    let of_kind: Vec<&Value> = all.iter().filter(|c| c["kind"] == kind).collect();
    assert_eq!(of_kind.len(), count, "{kind}");
    for case in of_kind {
        let (got, expected) = (find(case), case["expected"][key].as_f64().unwrap());
        // The gate of the tables is 1e-9; ours is twelve digits.
        assert!(within(got, expected, 1e-12, 0.0), "{}: {got}, {expected}", case["id"]);
    }
}

fn number(case: &Value, key: &str) -> f64 {
    case["params"][key].as_f64().unwrap()
}

#[test]
fn triangles() {
    check("solid_angle_triangle", "solid_angle", 5, |case| {
        let eye = point(&case["point"]);
        let [a, b, c] = [0, 1, 2].map(|k| point(&case["triangle"][k]) - eye);
        let signed = r::solid_angle_triangle(a, b, c);
        assert_eq!(signed, -r::solid_angle_triangle(a, c, b));
        let polygon = Polygon::new(vec![a, b, c]).unwrap();
        assert_eq!(signed.abs(), r::solid_angle(DVec3::ZERO, &polygon));
        signed.abs()
    });
}

#[test]
fn caps() {
    check("solid_angle_cap", "solid_angle", 4, |case| {
        r::solid_angle_of_cap(number(case, "half_angle_deg").to_radians())
    });
}

#[test]
fn rectangles() {
    check("solid_angle_rectangle_on_axis", "solid_angle", 3, |case| {
        let [a, b, d] = ["a", "b", "d"].map(|key| number(case, key));
        let corner = r::solid_angle_of_corner(a / 2.0, b / 2.0, d);
        let got = r::solid_angle_of_rectangle(a, b, d);
        assert_eq!(got, 4.0 * corner);
        got
    });
}

#[test]
fn boxes() {
    check("solid_angle_box", "solid_angle", 3, |case| {
        let [p, low, high] =
            ["point", "lo", "hi"].map(|key| point(&case["params"][key]));
        r::solid_angle_of_box(p, low, high)
    });
}

#[test]
fn projected_caps() {
    check("projected_cap", "projected_solid_angle", 2, |case| {
        let [beta, tilt] = ["half_angle_deg", "tilt_deg"].map(|key| number(case, key));
        r::projected_solid_angle_of_cap(beta.to_radians(), tilt.to_radians())
    });
}

#[test]
fn powers_of_the_cosine() {
    check("hemisphere_cosine_power", "integral", 3, |case| {
        r::cosine_power_integral(number(case, "k"))
    });
}

/// A sphere sends light evenly in all directions: its factor to anything is a solid angle
/// over 4π. And what faces a sphere gets the projected solid angle of a cap, over π.
#[test]
fn factors_of_spheres_are_solid_angles() {
    let mut met = 0;
    for case in &cases("A_discs_spheres") {
        let got = match case["kind"].as_str().unwrap() {
            "sphere_to_coaxial_disc" => {
                let rim = number(case, "r_disc").atan2(number(case, "h_center"));
                r::solid_angle_of_cap(rim) / (4.0 * PI)
            }
            "sphere_to_rectangle_corner" => {
                let [a, b, h] = ["a", "b", "h"].map(|key| number(case, key));
                r::solid_angle_of_corner(a, b, h) / (4.0 * PI)
            }
            "element_to_sphere_facing" => {
                let rim = (number(case, "R") / number(case, "d")).asin();
                r::projected_solid_angle_of_cap(rim, 0.0) / PI
            }
            _ => continue,
        };
        let expected = case["expected"]["F12"].as_f64().unwrap();
        assert!(within(got, expected, 1e-14, 0.0), "{}: {got}, {expected}", case["id"]);
        met += 1;
    }
    assert_eq!(met, 10);
}

/// One thing, seen ever farther away and ever nearer, from 1e-8 sr to 4π: every way of
/// measuring it agrees.
#[test]
fn from_a_speck_to_the_whole_sphere() {
    for k in -8..=8 {
        let half = 10f64.powf(f64::from(k) / 2.0); // of a square one away
        let corner = |x: f64, y: f64| DVec3::new(x * half, y * half, 1.0);
        let corners = [(-1., -1.), (1., -1.), (1., 1.), (-1., 1.)];
        let square = Polygon::new(corners.map(|(x, y)| corner(x, y)).to_vec()).unwrap();
        let on_axis = r::solid_angle_of_rectangle(2.0 * half, 2.0 * half, 1.0);
        let by_triangles = r::solid_angle(DVec3::ZERO, &square);
        // Wide ones lose as many digits as they are wider than near.
        let rounding = 1e-14 + 1e-15 * half;
        assert!(within(by_triangles, on_axis, rounding, 0.0), "{k}: {by_triangles}");
        // As the front of a box, and, with the other five sides, as all around.
        let low = DVec3::new(-half, -half, 1.0);
        let outside = r::solid_angle_of_box(DVec3::ZERO, low, low + 2.0 * half);
        assert!(within(outside, on_axis, 1e-12 + rounding, 0.0), "{k}: {outside}");
        let low = DVec3::new(-half, -half, -1.0);
        assert_eq!(r::solid_angle_of_box(DVec3::ZERO, low, -low), 4.0 * PI);
        // Never more than all, never more than the cap around it.
        let around = r::solid_angle_of_cap((half * 2f64.sqrt()).atan());
        assert!(by_triangles < around && around < 2.0 * PI, "{k}: {around}");
    }
    assert_eq!(r::solid_angle_of_cap(PI), 4.0 * PI);
    assert_eq!(r::solid_angle_of_corner(1.0, 1.0, 0.0), FRAC_PI_2);
}
