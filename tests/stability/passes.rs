//! Light that two passes count twice, or lose: rows 64, 65, 66 and 73 of the failures.

use crate::common::paths::{by_chance, dull, mirror, shiny};
use crate::common::rooms::rectangle;
use crate::common::{cases, point, polygon};
use crate::failures::passes::{
    FACING, between, booked_as_absorbed, counted_twice, cut_at_a_depth, hall, hall_of,
    lost_light,
};
use glam::{DVec3, dvec3};
use radiosity::geometry::{Polygon, Ray, Rgb};
use radiosity::mesh::Mesh;
use radiosity::random::Stream;
use radiosity::room::Room;
use radiosity::scene::Scene;
use radiosity::trace::{Class, Light, Look, PathTracer, TwoPass, Whitted};
use std::f64::consts::PI;

const RHO: f64 = 0.5;

/// A floor below a lamp beside a mirror, from the table: the scene, the middle of the
/// floor, its irradiance straight from the lamp, and that by way of the mirror,
/// exactly.
fn floor_lamp_and_mirror() -> (Scene, DVec3, f64, f64) {
    let cases = cases("G_mirror_glass");
    let case = cases.iter().find(|c| c["id"] == "G7-mirror-point-wall-finite").unwrap();
    let number = |v: &serde_json::Value| v.as_f64().unwrap();
    let (lamp, glass) = (polygon(&case["emitter"]), polygon(&case["mirror"]));
    let x = point(&case["point"]);
    let facing = |p: Polygon| if p.plane().height(x) < 0.0 { p.flipped() } else { p };
    let ground = rectangle(x - dvec3(0.05, 0.05, 0.0), 0.1 * DVec3::X, 0.1 * DVec3::Y);
    let reflectance = number(&case["params"]["mirror_reflectance"]);
    let scene = shiny([
        (ground, dull(0.0, RHO)),
        (facing(lamp), dull(PI, 0.0)),
        (facing(glass), mirror(reflectance)),
    ]);
    let all = number(&case["expected"]["irradiance_for_unit_radiance_emitter"]);
    let straight = PI * number(&case["expected"]["F_direct"]);
    (scene, x, straight, all - straight)
}

/// From above, a little aslant: past the lamp.
fn look_at(x: DVec3) -> Ray {
    let origin = x + dvec3(0.3, 1.5, 1.0);
    Ray { origin, direction: (x - origin).normalize() }
}

/// Row 65: classical ray tracing asks lamps straight, so that what a mirror throws on
/// the floor is lost: exactly the factor of the lamp's image. Paths find both, each in
/// its class. Row 64: a second pass that adds this light to a radiosity that has it
/// counts the class `EDS⁺L` twice, here 12 % of the floor's light, and no other.
#[test]
fn rows_64_and_65_a_mirrored_lamp_lost_or_twice() {
    let (scene, x, straight, mirrored) = floor_lamp_and_mirror();
    let seen =
        Whitted::of(&Room::of(&scene), Look::default()).along(&look_at(x)).radiance;
    let right = RHO * (straight + mirrored) / PI;
    let lost = right - seen.x;
    assert!((lost - RHO * mirrored / PI).abs() < 1e-9, "{lost}");

    let tracer = PathTracer::of(&Room::of(&scene));
    let mut random = Stream::named(65, &[]);
    let (mut sums, n) = ([(0.0, 0.0); 2], 200_000);
    for _ in 0..n {
        let mut found = [0.0; 2];
        tracer.radiance_by_class(
            look_at(x),
            &mut random,
            &mut |class, l| match class {
                Class { mirrored: false, light: Light::Direct } => found[0] += l.x,
                Class { mirrored: false, light: Light::Caustic } => found[1] += l.x,
                other => panic!("{other:?}"),
            },
        );
        for (sum, found) in sums.iter_mut().zip(found) {
            *sum = (sum.0 + found, sum.1 + found * found);
        }
    }
    let estimate = |what, (sum, squares): (f64, f64), right| {
        let mean = sum / f64::from(n);
        let error = ((squares / f64::from(n) - mean * mean) / f64::from(n)).sqrt();
        (what, mean, error, right)
    };
    by_chance(&[
        estimate("straight", sums[0], RHO * straight / PI),
        estimate("by the mirror", sums[1], RHO * mirrored / PI),
    ]);
    let twice = (straight + 2.0 * mirrored) / (straight + mirrored);
    assert!((1.11..1.12).contains(&twice), "{twice}");

    // The same beside a mirror that reflects more and more.
    for sweep in [counted_twice(), lost_light()] {
        for [share, right] in &sweep.theory {
            let (wrong, ours) = (sweep.at(*share), sweep.by(1, *share));
            assert!((wrong - right).abs() < 1e-7, "{share}: {wrong} {right}");
            assert!(ours.abs() < 1e-7, "{share}: {ours}");
        }
        assert!((5.4..5.9).contains(&sweep.at(1.0)), "{}", sweep.at(1.0));
    }
}

/// Row 66: ray tracing bolted on plain radiosity, for which a mirror is a black wall.
/// The floor lacks what the mirror throws on it, whatever the second pass does; and the
/// ledger books as absorbed what the mirror reflects, Ks F Φ of the power.
#[test]
fn row_66_plain_radiosity_takes_mirrors_for_black() {
    let (scene, x, straight, _) = floor_lamp_and_mirror();
    let mesh = Mesh::whole(&scene);
    // The floor as plain radiosity has it: lit straight.
    let of = |k: usize| match mesh.patch_of(&mesh.elements[k]).face.0 {
        0 => RHO * straight,
        1 => PI,
        _ => 0.0,
    };
    let mut plain = vec![Rgb::ZERO; mesh.vertices.len()];
    for (k, element) in mesh.elements.iter().enumerate() {
        for corner in &element.corners {
            plain[corner.0 as usize] = Rgb::splat(of(k));
        }
    }
    let second = TwoPass::showing(&Room::of(&scene), &mesh, &plain, Look::default());
    let seen = second.along(&look_at(x)).radiance;
    assert!((seen.x - RHO * straight / PI).abs() < 1e-12, "{seen}");

    // A lamp of 1 W before a mirror, both unit squares: of the lamp's light the mirror
    // gets F and takes (1 − Ks) F.
    let sweep = booked_as_absorbed();
    for [ks, really] in &sweep.theory {
        let gap = sweep.at(*ks) - really;
        assert!((gap - 100.0 * ks * FACING).abs() < 1e-6, "{ks}: {gap}");
    }
}

/// Row 73: between two mirrors that glow and keep the share r, a recursion of depth d
/// sees the first d + 1 terms of a geometric series; paths, which end by chance, see
/// all of it.
#[test]
fn row_73_recursion_is_cut_at_its_depth() {
    let mut met = 0;
    for case in cases("G_mirror_glass") {
        if case["kind"] != "mirror_recursion" {
            continue;
        }
        let number = |v: &serde_json::Value| v.as_f64().unwrap();
        let r = number(&case["params"]["r"]);
        let depth = number(&case["params"]["depth"]) as u32;
        let seen = hall(r, depth).radiance;
        let truncated = number(&case["expected"]["radiance_truncated"]);
        assert!(
            (seen.x - truncated).abs() < 1e-9 * truncated,
            "{}: {seen}",
            case["id"]
        );

        let (scene, ray) = (hall_of(r), between());
        let tracer = PathTracer::of(&Room::of(&scene));
        let mut random = Stream::named(73, &[u64::from(depth)]);
        let n = 20_000;
        let all: Vec<f64> =
            (0..n).map(|_| tracer.radiance(ray, &mut random).x).collect();
        let mean = all.iter().sum::<f64>() / f64::from(n);
        let spread = all.iter().map(|l| (l - mean).powi(2)).sum::<f64>();
        let error = spread.sqrt() / f64::from(n);
        let right = number(&case["expected"]["radiance_full"]);
        by_chance(&[(case["id"].to_string(), mean, error, right)]);
        met += 1;
    }
    assert_eq!(met, 2);
    let sweep = cut_at_a_depth();
    for [depth, right] in &sweep.theory {
        let half = 100.0 * 0.5_f64.powf(depth + 1.0);
        for (method, right) in [(0, *right), (1, half), (2, *right)] {
            let got = sweep.by(method, *depth);
            assert!(
                (got - right).abs() < 1e-9 * right + 1e-12,
                "{depth}: {got} {right}"
            );
        }
    }
}
