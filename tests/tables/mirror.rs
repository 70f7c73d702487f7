//! Mirrors, refraction and glass, against values computed by independent programs.

use crate::common::mirrored::{diffuse, factor, mirror, pane, scene_of};
use crate::common::rooms::{box_walls, rectangle};
use crate::common::{cases, point, polygon, within};
use glam::{DVec3, dvec3};
use radiosity::geometry::{Polygon, Rgb};
use radiosity::material::optics::{fresnel, reflect, refract, slab};
use radiosity::virtual_world::VirtualWorld;
use serde_json::Value;
use std::cell::Cell;

/// Runs the cases of one family; says how many there must be.
fn family(
    name: &str,
    count: usize,
    check: impl Fn(&Value, &Value, &dyn Fn(&str, f64)),
) {
    let all = cases("G_mirror_glass");
    let mine = all.iter().filter(|c| c["family"] == name);
    let done = Cell::new(0);
    for case in mine {
        let (params, expected) = (&case["params"], &case["expected"]);
        let relative = number(&case["tolerance"]["analytic_rel"]);
        let uncertainty = number(&case["uncertainty_abs"]);
        let meets = |key: &str, got: f64| {
            let want = number(&expected[key]);
            let fits = within(got, want, relative, uncertainty);
            assert!(fits, "{}: {key} {got} {want}", case["id"]);
        };
        check(case, params, &meets);
        done.set(done.get() + 1);
    }
    assert_eq!(done.get(), count, "{name}");
}

fn number(v: &Value) -> f64 {
    v.as_f64().expect("a number")
}

fn degrees(v: &Value) -> f64 {
    number(v).to_radians()
}

#[test]
fn fresnel_meets_the_table() {
    family("fresnel_dielectric", 46, |case, params, meets| {
        let eta = number(&params["n_incident"]) / number(&params["n_transmitted"]);
        let angle = degrees(&params["angle_deg"]);
        let got = fresnel(angle.cos(), eta);
        meets("Rs", got.s);
        meets("Rp", got.p);
        meets("R_unpolarised", got.mean());
        meets("T_unpolarised", 1.0 - got.mean());
        let down = dvec3(angle.sin(), 0.0, -angle.cos());
        let found = refract(down, DVec3::Z, eta);
        let total = case["expected"]["total_internal_reflection"] == true;
        assert_eq!(found.is_none(), total, "{}", case["id"]);
        if let Some(found) = found {
            let want =
                &case["expected"]["refracted_dir_for_incident(sin,0,-cos)_normal_z"];
            assert!(found.distance(point(want)) < 1e-9, "{}", case["id"]);
        }
    });
}

#[test]
fn critical_and_brewster_angles_are_where_they_belong() {
    family("critical_brewster", 4, |case, params, meets| {
        let eta = number(&params["n1"]) / number(&params["n2"]);
        let expected = &case["expected"];
        meets("R_normal", fresnel(1.0, eta).mean());
        let brewster = degrees(&expected["brewster_angle_deg"]);
        assert!(fresnel(brewster.cos(), eta).p < 1e-24, "{}", case["id"]);
        let critical = degrees(&expected["critical_angle_deg"]);
        let beyond = |angle: f64| fresnel(angle.cos(), eta).mean() == 1.0;
        assert!(beyond(critical + 1e-9) && !beyond(critical - 1e-9), "{}", case["id"]);
    });
}

#[test]
fn directions_meet_the_table() {
    family("reflect_refract_vectors", 7, |case, params, _| {
        let [incident, normal] =
            ["incident", "normal"].map(|key| point(&params[key]).normalize());
        let expected = &case["expected"];
        let mirrored = reflect(incident, normal);
        assert!(mirrored.distance(point(&expected["reflected"])) < 1e-9);
        let found = refract(incident, normal, number(&params["eta_i_over_t"]));
        assert_eq!(found.is_none(), expected["tir"] == true, "{}", case["id"]);
        if let Some(found) = found {
            assert!(found.distance(point(&expected["refracted"])) < 1e-9);
        }
    });
}

#[test]
fn slabs_meet_the_table() {
    family("window_slab", 33, |_, params, meets| {
        let cosine = degrees(&params["angle_deg"]).cos();
        let absorption = number(&params["absorption_times_thickness"]);
        let (r, t) = slab(cosine, number(&params["n"]), absorption);
        meets("R_polarisation_averaged", r);
        meets("T_polarisation_averaged", t);
        meets("A", 1.0 - r - t);
    });
}

/// `2 ∫ f(c) c dc` over cosines: the share of light that comes from everywhere. The points
/// crowd at both ends, where roots end.
fn from_everywhere(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let step = 1.0 / 32.0;
    let at = |k: i32| {
        let t = step * f64::from(k);
        let x = 1.0 / (1.0 + (-std::f64::consts::PI * t.sinh()).exp());
        let weight = step * std::f64::consts::PI * t.cosh() * x * (1.0 - x);
        let c = low + (high - low) * x;
        2.0 * (high - low) * weight * c * f(c)
    };
    (-110..=110).map(at).sum()
}

#[test]
fn diffuse_light_meets_glass_as_the_table_says() {
    family("hemispherical_fresnel", 2, |_, params, meets| {
        let n = number(&params["n"]);
        let critical = (1.0 - 1.0 / (n * n)).sqrt();
        meets(
            "R_diffuse_external",
            from_everywhere(0.0, 1.0, |c| fresnel(c, 1.0 / n).mean()),
        );
        let inside = |low, high| from_everywhere(low, high, |c| fresnel(c, n).mean());
        meets("R_diffuse_internal", inside(0.0, critical) + inside(critical, 1.0));
        let passes = from_everywhere(0.0, 1.0, |c| slab(c, n, 0.0).1);
        meets("T_slab_diffuse_non_absorbing", passes);
    });
}

/// A ray into a thick plate and out of it again is shifted, and not turned.
#[test]
fn a_thick_plate_shifts_a_ray() {
    family("slab_lateral_shift", 2, |_, params, meets| {
        let (n, thickness) = (number(&params["n"]), number(&params["thickness"]));
        let angle = degrees(&params["angle_deg"]);
        let down = dvec3(angle.sin(), 0.0, -angle.cos());
        let inside = refract(down, DVec3::Z, 1.0 / n).unwrap();
        let out = refract(inside, DVec3::Z, n).unwrap();
        assert!(out.distance(down) < 1e-14);
        let exit = inside * (thickness / -inside.z);
        meets("lateral_shift", exit.reject_from_normalized(down).length());
    });
}

/// A small square about a point, with this normal.
fn about(x: DVec3, n: DVec3) -> Polygon {
    let frame = radiosity::geometry::Frame::about(n);
    let (a, b) = (1e-3 * frame.x, 1e-3 * frame.y);
    Polygon::new(vec![x - a - b, x + a - b, x + a + b, x - a + b]).unwrap()
}

#[test]
fn a_point_sees_a_lamp_in_a_mirror() {
    family("mirror_point", 2, |case, params, meets| {
        let [lamp, wall] = ["emitter", "mirror"].map(|key| polygon(&case[key]));
        // The emitter is to look down, the mirror at the point.
        let lamp = if lamp.normal().z > 0.0 { lamp.flipped() } else { lamp };
        let (x, n) = (point(&case["point"]), point(&case["normal"]));
        let wall = if wall.plane().height(x) < 0.0 { wall.flipped() } else { wall };
        let share = number(&params["mirror_reflectance"]);
        let scene = scene_of([
            (lamp.clone(), diffuse(1.0, 0.0)),
            (wall, mirror(share)),
            (about(x, n), diffuse(0.0, 0.5)),
        ]);
        let world = VirtualWorld::of(&scene, 1);
        let sights = world.sights(&about(x, n), &lamp);
        let by = |level: u32| -> f64 {
            let mine = sights.iter().filter(|s| s.level() == level);
            mine.map(|s| s.factor(x, n).x).sum()
        };
        meets("F_direct", by(0));
        meets("F_via_mirror (geometric, reflectance not applied)", by(1) / share);
        meets("F_total", by(0) + by(1));
        let irradiance = std::f64::consts::PI * (by(0) + by(1));
        meets("irradiance_for_unit_radiance_emitter", irradiance);
    });
}

#[test]
fn a_perfect_mirror_doubles_what_stands_on_it() {
    family("mirror_doubling", 1, |_, _, meets| {
        let lamp = rectangle(dvec3(0.0, -0.5, 2.0), DVec3::Y, DVec3::X);
        let wall =
            rectangle(dvec3(0.0, -50.0, -50.0), 100.0 * DVec3::Y, 100.0 * DVec3::Z);
        let (x, piece) =
            (dvec3(1e-13, 0.0, 0.0), rectangle(DVec3::ZERO, DVec3::X, DVec3::Y));
        let scene = scene_of([
            (lamp.clone(), diffuse(1.0, 0.0)),
            (wall, mirror(1.0)),
            (piece.clone(), diffuse(0.0, 0.5)),
        ]);
        let none = factor(&VirtualWorld::of(&scene, 0), x, &piece, &lamp).x;
        let one = factor(&VirtualWorld::of(&scene, 1), x, &piece, &lamp).x;
        meets("F_direct", none);
        meets("F_with_perfect_mirror", one);
        meets("ratio", one / none);
    });
}

#[test]
fn squares_exchange_light_by_a_mirror() {
    family("extended_form_factor_mirror", 2, |case, _, meets| {
        let [a, b, wall] = ["A", "B", "mirror"].map(|key| polygon(&case[key]));
        let faces = [(a.clone(), diffuse(1.0, 0.0)), (b.clone(), diffuse(0.0, 0.5))];
        let wall = if wall.normal().z > 0.0 { wall.flipped() } else { wall };
        let scene = scene_of(faces.into_iter().chain([(wall, mirror(1.0))]));
        let world = VirtualWorld::of(&scene, 1);
        let found = world.exchange(&a, &b, 0, 1e-12);
        meets("F_AB_via_mirror", found.all.x / a.area());
        assert_eq!(world.exchange(&a, &b, 1, 1e-12), found);
    });
}

/// The walls of a unit cube, one of them a mirror, exchange by one image what the table
/// says.
#[test]
fn a_cube_with_a_mirror_wall_meets_the_table() {
    family("mirror_room_radiosity", 2, |case, params, _| {
        let walls = box_walls([1.0; 3]);
        let share = number(&params["mirror_reflectance"]);
        let of = |k: usize| if k == 0 { mirror(share) } else { diffuse(0.0, 0.5) };
        let scene = scene_of((0..6).map(|k| (walls[k].clone(), of(k))));
        let world = VirtualWorld::of(&scene, 1);
        for i in 1..6 {
            for j in 1..6 {
                let found = world.exchange(&walls[i], &walls[j], 0, 1e-12).all.x;
                let want = number(&case["expected"]["F_extended"][i - 1][j - 1]);
                assert!(
                    (found - want).abs() < 1e-11,
                    "{} {i} {j} {found} {want}",
                    case["id"]
                );
            }
        }
    });
}

/// Two large mirrors face to face that both glow: after `d` reflections, so many terms of
/// the geometric series are seen.
#[test]
fn a_hall_of_glowing_mirrors_is_a_geometric_series() {
    family("mirror_recursion", 2, |_, params, meets| {
        let (r, depth) =
            (number(&params["r"]), params["depth"].as_u64().unwrap() as u32);
        let size = 1e6;
        let corner = dvec3(-size, -size, 0.0);
        let low = rectangle(corner, 2.0 * size * DVec3::X, 2.0 * size * DVec3::Y);
        let high =
            rectangle(corner + DVec3::Z, 2.0 * size * DVec3::Y, 2.0 * size * DVec3::X);
        let scene = scene_of([(low.clone(), mirror(r)), (high.clone(), mirror(r))]);
        let world = VirtualWorld::of(&scene, depth);
        let piece = about(dvec3(0.0, 0.0, 0.0), DVec3::Z);
        let seen: Rgb = [&low, &high]
            .map(|m| factor(&world, DVec3::ZERO, &piece, m))
            .into_iter()
            .sum();
        meets("radiance_truncated", seen.x);
        meets("radiance_full", 1.0 / (1.0 - r));
    });
}

/// Through a clear pane, a lamp straight above is weakened by the pane's transmittance.
#[test]
fn a_pane_weakens_by_the_angle() {
    let lamp = rectangle(dvec3(-0.01, -0.01, 10.0), 0.02 * DVec3::Y, 0.02 * DVec3::X);
    let glass = rectangle(dvec3(-5.0, -5.0, 5.0), 10.0 * DVec3::X, 10.0 * DVec3::Y);
    for (x, angle) in [(0.0, 0.0), (10.0, 45.0_f64), (17.320508, 60.0)] {
        let at = dvec3(x, 0.0, 0.0);
        let glass = crate::common::rooms::moved(&glass, |v| v + at * 0.5);
        let scene = scene_of([(lamp.clone(), diffuse(1.0, 0.0)), (glass, pane(1.5))]);
        let world = VirtualWorld::of(&scene, 0);
        let open = scene_of([(lamp.clone(), diffuse(1.0, 0.0))]);
        let open = factor(&VirtualWorld::of(&open, 0), at, &about(at, DVec3::Z), &lamp);
        let seen = factor(&world, at, &about(at, DVec3::Z), &lamp);
        let want = slab(angle.to_radians().cos(), 1.5, 0.0).1;
        assert!((seen.x / open.x - want).abs() < 1e-6, "{angle}");
    }
}
